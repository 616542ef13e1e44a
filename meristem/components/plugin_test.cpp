// SPDX-License-Identifier: Apache-2.0
// Files that are rejected as plug-ins. The starter project (tests/consumer) tests a working plug-in.
#include "meristem/components/plugin.h"

#include <fstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "tests/support/temporary_folder.h"

namespace meristem::plugin_test {

std::string error_of(const std::string& path) {
  try {
    with_plugin(builtin_components(), path);
  } catch (const InputError& error) {
    return error.diagnostics()[0].text();
  }
  return "no fault";
}

TEST(Plugin, RefusesWhatIsNoLibrary) {
  const TemporaryFolder folder;
  const std::string text = (folder / "libthorn.so").string();
  EXPECT_EQ(error_of((folder / "libtorn.so").string()),
            (folder / "libtorn.so").string() + ": there is no such file; expected a plug-in, such as libthorn.so");
  std::ofstream(text) << "no library";
  EXPECT_EQ(error_of((folder / "libtorn.so").string()),
            (folder / "libtorn.so").string() +
                ": there is no such file; expected a plug-in, such as libthorn.so; did you mean '" + text + "'?");
  EXPECT_NE(error_of(text).find(": the library cannot be loaded: "), std::string::npos) << error_of(text);
  EXPECT_NE(error_of(folder.path().string()).find("this is not a regular file"), std::string::npos);
}

TEST(Plugin, RefusesALibraryThatIsNoPlugin) {
  // A library that exists on every machine with programs of this compiler.
  const std::string library = "/lib/x86_64-linux-gnu/libm.so.6";
  if (!std::ifstream(library)) GTEST_SKIP() << "there is no " << library;
  EXPECT_EQ(error_of(library), library +
                                   ": the library is not a plug-in: it has no 'meristem_plugin_interface'; expected a "
                                   "library with MERISTEM_PLUGIN(...) in one of its sources");
}

TEST(Plugin, TheInterfaceNamesTheVersion) {
  EXPECT_EQ(plugin_interface().find("Meristem " + std::string(version()) + ", plug-ins 1, "), 0U);
}

}  // namespace meristem::plugin_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/plugin.h"

#include <filesystem>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

/// Returns the shared libraries of a folder, for messages.
std::vector<std::string> libraries_beside(const fs::path& path) {
  constexpr std::size_t kMax = 1000;
  std::vector<std::string> names;
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end && names.size() < kMax;
       entry.increment(error)) {
    const fs::path name = entry->path().filename();
    if (name.extension() == ".so") names.push_back(path.has_parent_path() ? (folder / name).string() : name.string());
  }
  return names;
}

[[noreturn]] void fail(const std::string& path, std::string message, std::string expected, std::string nearest = {}) {
  throw InputError(Diagnostic{
      .message = std::move(message), .expected = std::move(expected), .nearest = std::move(nearest), .file = path});
}

template <class Function>
Function* find_function(void* library, const char* name, const std::string& path) {
  auto* function = reinterpret_cast<Function*>(::dlsym(library, name));
  if (function == nullptr) {
    fail(path, fmt::format("the library is not a plug-in: it has no '{}'", name),
         "a library with MERISTEM_PLUGIN(...) in one of its sources");
  }
  return function;
}

}  // namespace

std::vector<ComponentType> load_plugin(const std::string& path) {
  std::error_code error;
  const fs::path file(path);
  if (!fs::exists(file, error)) {
    fail(path, "there is no such file", "a plug-in, such as libthorn.so", nearest_name(path, libraries_beside(file)));
  }
  if (!fs::is_regular_file(file, error)) fail(path, "this is not a regular file", "a plug-in, such as libthorn.so");

  // Use the absolute path, because the loader would search other folders for a bare name. Keep the library loaded,
  // because types point into it.
  void* const library = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) {
    const char* reason = ::dlerror();
    fail(path, fmt::format("the library cannot be loaded: {}", reason == nullptr ? "no reason is given" : reason),
         "a plug-in that was built against this version of Meristem");
  }
  const char* (*const interface)() = find_function<const char*()>(library, "meristem_plugin_interface", path);
  const std::string theirs = interface();
  if (theirs != plugin_interface()) {
    fail(path, fmt::format("the plug-in was built for another interface: {}", theirs),
         fmt::format("one built against this program's headers: {}", plugin_interface()));
  }
  void (*const components)(void*) = find_function<void(void*)>(library, "meristem_plugin_components", path);
  std::vector<ComponentType> types;
  components(&types);
  if (types.empty()) fail(path, "the plug-in has no component types", "one or more");
  return types;
}

Registry with_plugin(const Registry& known, const std::string& path) {
  std::vector<ComponentType> types(known.types().begin(), known.types().end());
  for (ComponentType& type : load_plugin(path)) {
    if (type.name.empty()) fail(path, "a component type of the plug-in has no name", "a name for each");
    for (const ComponentType& other : types) {
      if (other.name == type.name) {
        fail(path, fmt::format("there is already a component type '{}'", type.name), "a type of another name");
      }
    }
    types.push_back(std::move(type));
  }
  return Registry(std::move(types));
}

}  // namespace meristem

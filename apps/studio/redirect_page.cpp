// SPDX-License-Identifier: Apache-2.0
#include "redirect_page.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPage = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0; url={0}">
<title>Meristem</title>
<p>The studio opens. If it does not, <a href="{0}">follow this link</a>.</p>
</html>
)";

std::string temporary_folder() {
  std::error_code error;
  const fs::path folder = fs::absolute(fs::temp_directory_path(error), error);
  if (error) throw MachineError("cannot find a folder for temporary files: " + error.message());
  return folder.string();
}

}  // namespace

RedirectPage::RedirectPage(const std::string& address)
    : folder_(temporary_folder(), "meristem-studio-"), path_((fs::path(folder_.path()) / "open.html").string()) {
  write_whole_file(path_, fmt::format(kPage, address));
  std::error_code error;
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write, error);
  if (error) throw MachineError(fmt::format("cannot make '{}' private: {}", path_, error.message()));
}

}  // namespace meristem::studio

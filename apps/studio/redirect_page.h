// SPDX-License-Identifier: Apache-2.0
// Opens the studio in a browser without showing its address in the arguments of a process.
#pragma once

#include <string>

#include "meristem/base/whole_file.h"

namespace meristem::studio {

/// A page on the disk that redirects a browser to an address. All users of the machine can read the arguments of each
/// process, and the address contains the studio's secret. The program that opens the browser therefore gets only the
/// path of this page, which only its user can read. The page is removed with this object.
class RedirectPage {
 public:
  /// Writes the page to a new private folder among the system's temporary files. Throws MachineError.
  explicit RedirectPage(const std::string& address);

  /// Returns the absolute path of the page.
  const std::string& path() const { return path_; }

 private:
  ScratchFolder folder_;
  std::string path_;
};

}  // namespace meristem::studio

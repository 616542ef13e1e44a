// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/document/grow.h"

namespace meristem {

/// A kind of file that a grown document can be written to.
struct Format {
  std::string_view ending;  ///< with its dot; may hold more than one
  std::string_view doc;     ///< one line
  void (*write)(const Document& document, const GrownDocument& grown, const std::string& path, Progress& progress);
  /// The file that is written beside it; null where there is none.
  std::string (*companion)(const std::string& path) = nullptr;
};

/// All formats, the default first.
std::span<const Format> formats();

/// The format of a path by its ending, the longest that fits (capitals count as equal); "-" is standard output in the
/// default format. Throws InputError that names the known endings, and the nearest.
const Format& format_of(const std::string& path);

}  // namespace meristem

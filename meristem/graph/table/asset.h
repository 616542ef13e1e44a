// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace meristem {

/// What a document names by a file, or has as a text: the path or the text as written, and what was read from it.
/// Copies share the content.
template <class T>
struct Asset {
  std::string path;
  std::shared_ptr<const T> content;  ///< null where no file is named, or it could not be read

  explicit operator bool() const { return content != nullptr; }
  const T& operator*() const { return *content; }
  const T* operator->() const { return content.get(); }
};

}  // namespace meristem

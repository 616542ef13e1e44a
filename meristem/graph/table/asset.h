// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace meristem {

/// What a document names by a file, or has as a text: the path or the text as written, and what was read from it.
/// Copies share the content.
template <class T>
struct Asset {
  std::string path;                  ///< as written in the document
  std::shared_ptr<const T> content;  ///< null where no file is named, or it could not be read

  explicit operator bool() const { return content != nullptr; }  ///< true if something was read
  const T& operator*() const { return *content; }                ///< the content, which must exist
  const T* operator->() const { return content.get(); }          ///< access to members of the content, which must exist
};

}  // namespace meristem

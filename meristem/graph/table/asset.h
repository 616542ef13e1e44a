// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace meristem {

/// The content of a file or of a text that a document gives, with its path or the text as written. Copies share the
/// content.
template <class T>
struct Asset {
  std::string path;                  ///< as written in the document
  std::shared_ptr<const T> content;  ///< null if no file is named, or if reading it failed

  explicit operator bool() const { return content != nullptr; }  ///< true if something was read
  const T& operator*() const { return *content; }                ///< the content, which must exist
  const T* operator->() const { return content.get(); }          ///< access to members of the content, which must exist
};

}  // namespace meristem

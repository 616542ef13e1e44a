// SPDX-License-Identifier: Apache-2.0
// Tells a page that another page, of this or another program of the same user, has its file open.
#pragma once

#include <memory>
#include <string>

#include "host.h"

namespace meristem::studio {

/// Marks a file as open for as long as it lives. The mark is a locked file in a private folder of the user: the system
/// unlocks it when the program ends, however it ends.
class OpenFile {
 public:
  /// `path` is absolute. Without a folder for marks nothing is marked, and no others are found.
  explicit OpenFile(const std::string& path);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Returns how many others have the file open. Removes marks that a killed program has left.
  int others() const;

 private:
  std::string folder_;
  std::string prefix_;  // of the marks of this file
  std::string mark_;    // name of this one; empty: there is none
  int descriptor_ = -1;
};

/// Looks every two seconds how many others have a file open, and sends news (`elsewhere`) when the number changes.
class OpenFileWatch : public std::enable_shared_from_this<OpenFileWatch> {
 public:
  /// `path` is below the root of `host`, which outlives it.
  OpenFileWatch(Host& host, std::shared_ptr<Outbox> outbox, const std::string& path);
  /// Takes the news back if some were sent.
  ~OpenFileWatch();
  OpenFileWatch(const OpenFileWatch&) = delete;
  OpenFileWatch& operator=(const OpenFileWatch&) = delete;

  /// Looks now, and then again and again on a thread of `host`. Called once.
  void begin() { look(); }

 private:
  void look();
  void send(int count);

  Host& host_;
  const std::shared_ptr<Outbox> outbox_;
  const std::string path_;
  const OpenFile file_;
  int count_ = 0;  // that the page knows
};

}  // namespace meristem::studio

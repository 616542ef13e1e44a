// SPDX-License-Identifier: Apache-2.0
// Notifies a page that another page of this user, in this or another program, has its file open.
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
  std::string prefix_;  // prefix of the marks of this file
  std::string mark_;    // name of this object's mark; empty: there is no mark
  int descriptor_ = -1;
};

/// Checks every two seconds how many other pages have a file open. Sends the message `elsewhere` when the number
/// changes.
class OpenFileWatch : public std::enable_shared_from_this<OpenFileWatch> {
 public:
  /// `path` is below the root of `host`, which must outlive this object.
  OpenFileWatch(Host& host, std::shared_ptr<Outbox> outbox, const std::string& path);
  /// Sends a count of 0 if the page knows another count.
  ~OpenFileWatch();
  OpenFileWatch(const OpenFileWatch&) = delete;
  OpenFileWatch& operator=(const OpenFileWatch&) = delete;

  /// Checks now, and then repeatedly on a thread of `host`. Must be called once.
  void begin() { look(); }

 private:
  void look();
  void send(int count);

  Host& host_;
  const std::shared_ptr<Outbox> outbox_;
  const std::string path_;
  const OpenFile file_;
  int count_ = 0;  // the number that the page knows
};

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// Which readings of a page's text are still wanted. A session handles the messages of its page one after another, while
// newer ones already arrive: a newer text makes the reading of an older one useless.
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string_view>

#include "meristem/base/progress.h"

namespace meristem::studio {

/// What a message does to the text that the session reads.
enum class MessageKind : std::uint8_t {
  other,  ///< nothing
  drag,   ///< reads the text with other values
  edit,   ///< changes the text; the page waits for the answer before it changes the text again
  text,   ///< changes the text, as typing does
  open    ///< another document
};

/// Calls from any thread.
class Readings {
 public:
  Readings() = default;
  Readings(const Readings&) = delete;
  Readings& operator=(const Readings&) = delete;

  /// A message has arrived, which the session will handle after all earlier ones. Stops the readings of earlier
  /// messages that this one makes useless, or that it cancels.
  void arrive(std::string_view message);
  /// The session begins to handle the next message that arrived.
  void begin_next();
  /// Stops all readings from now on.
  void close();
  bool is_closed() const;

  /// A reading for the message in hand, from its construction to its destruction. One at a time.
  class Reading {
   public:
    /// `request` is the number of the message's request, with which a `cancel` can name it.
    Reading(Readings& readings, double request, MessageKind kind);
    ~Reading();
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    const Progress& progress() const { return progress_; }

   private:
    friend class Readings;
    Readings& readings_;
    double request_;
    MessageKind kind_;
    Progress progress_;
  };

 private:
  bool is_useless(const Reading& reading) const;

  mutable std::mutex mutex_;  // of all below
  std::uint64_t arrived_ = 0;
  std::uint64_t handled_ = 0;
  std::uint64_t last_open_ = 0;  // numbers of the last messages of their kinds
  std::uint64_t last_text_ = 0;  // of those that give another text, documents that are opened included
  std::uint64_t last_drag_ = 0;  // and drags
  std::set<double> cancelled_;   // requests that a `cancel` has named while they waited or were in hand
  Reading* running_ = nullptr;
  bool is_closed_ = false;
};

/// The kind of a message. Messages that are no requests are of kind `other`.
MessageKind message_kind(std::string_view message);

}  // namespace meristem::studio

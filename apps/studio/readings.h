// SPDX-License-Identifier: Apache-2.0
// Decides which readings of a page's text are still needed. A session handles the messages of its page one after
// another. Newer messages may already have arrived, and a newer text makes the reading of an older one useless.
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string_view>

#include "meristem/base/progress.h"

namespace meristem::studio {

/// The effect of a message on the text that the session reads.
enum class MessageKind : std::uint8_t {
  other,  ///< nothing
  drag,   ///< reads the text with other values
  edit,   ///< changes the text; the page waits for the answer before it changes the text again
  text,   ///< changes the text, as typing does
  open    ///< another document
};

/// May be called from any thread.
class Readings {
 public:
  Readings() = default;
  Readings(const Readings&) = delete;
  Readings& operator=(const Readings&) = delete;

  /// Reports that a message has arrived. The session will handle it after all earlier messages. Stops readings for
  /// earlier messages that the new one makes useless or cancels.
  void arrive(std::string_view message);
  /// Reports that the session begins to handle the next message.
  void begin_next();
  /// Stops all readings from now on.
  void close();
  bool is_closed() const;

  /// A reading for the present message, during the lifetime of this object. Only one may exist at a time.
  class Reading {
   public:
    /// `request` is the number of the message's request, which a `cancel` can name.
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

  mutable std::mutex mutex_;  // guards everything below
  std::uint64_t arrived_ = 0;
  std::uint64_t handled_ = 0;
  std::uint64_t last_open_ = 0;  // numbers of the last messages of each kind
  std::uint64_t last_text_ = 0;  // last message with another text, including opened documents
  std::uint64_t last_drag_ = 0;  // last drag
  std::set<double> cancelled_;   // requests that a `cancel` has named before their answer
  Reading* running_ = nullptr;
  bool is_closed_ = false;
};

/// Returns the kind of a message. Returns `other` for messages that are no requests.
MessageKind message_kind(std::string_view message);

}  // namespace meristem::studio

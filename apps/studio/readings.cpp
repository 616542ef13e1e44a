// SPDX-License-Identifier: Apache-2.0
// Decides by the numbers of the last messages of each kind whether a reading is useless. A new message is classified by
// a scan of its text up to "do", because parsing a large document would take too long here.
#include "readings.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "refusal.h"
#include "request.h"

namespace meristem::studio {

namespace {

/// Returns the position after the text that begins at the quote at `at`.
std::size_t behind_text(std::string_view message, std::size_t at) {
  for (++at; at < message.size() && message[at] != '"'; ++at) {
    if (message[at] == '\\') ++at;
  }
  return std::min(at + 1, message.size());
}

/// Returns the "do" of a request. Scans the message only up to there, since the page writes this member first. Returns
/// an empty text for messages that are no requests.
std::string_view what_to_do(std::string_view message) {
  int depth = 0;
  for (std::size_t at = 0; at < message.size();) {
    const char c = message[at];
    if (c != '"') {
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      ++at;
      continue;
    }
    const std::size_t behind = behind_text(message, at);
    const bool is_do = depth == 1 && message.substr(at, behind - at) == "\"do\"";
    at = behind;
    if (!is_do) continue;
    const std::size_t value = message.find_first_not_of(" \t\r\n:", at);
    if (value == std::string_view::npos || message[value] != '"') continue;
    const std::size_t end = behind_text(message, value);
    return message.substr(value + 1, end - value - 2);
  }
  return {};
}

/// Returns the number of the request that a `cancel` names, or nothing for other messages.
std::optional<double> cancelled_request(std::string_view message) {
  try {
    const NumberedRequest request = read_request(message);
    const auto* cancel = std::get_if<CancelRequest>(&request.request);
    return cancel != nullptr ? cancel->re : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;  // the session reports the fault of the message
  }
}

}  // namespace

MessageKind message_kind(std::string_view message) {
  const std::string_view what = what_to_do(message);
  if (what == "open") return MessageKind::open;
  if (what == "splice" || what == "text") return MessageKind::text;
  if (what == "edit") return MessageKind::edit;
  return what == "drag" ? MessageKind::drag : MessageKind::other;
}

void Readings::arrive(std::string_view message) {
  const MessageKind kind = message_kind(message);
  const bool is_cancel = kind == MessageKind::other && what_to_do(message) == "cancel";
  const std::optional<double> cancelled = is_cancel ? cancelled_request(message) : std::nullopt;
  const std::lock_guard lock(mutex_);
  if (arrived_ == handled_ && running_ == nullptr) cancelled_.clear();
  ++arrived_;
  if (kind == MessageKind::open) last_open_ = arrived_;
  if (kind == MessageKind::open || kind == MessageKind::text) last_text_ = arrived_;
  if (kind != MessageKind::other) last_drag_ = arrived_;
  if (cancelled) cancelled_.insert(*cancelled);
  if (running_ != nullptr && is_useless(*running_)) running_->progress_.cancel();
}

void Readings::begin_next() {
  const std::lock_guard lock(mutex_);
  ++handled_;
}

void Readings::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  if (running_ != nullptr) running_->progress_.cancel();
}

bool Readings::is_closed() const {
  const std::lock_guard lock(mutex_);
  return is_closed_;
}

/// Returns true if a reading for the present message is no longer needed.
bool Readings::is_useless(const Reading& reading) const {
  if (is_closed_ || last_open_ > handled_ || cancelled_.contains(reading.request_)) return true;
  const bool is_of_text = reading.kind_ == MessageKind::text || reading.kind_ == MessageKind::drag;
  if (is_of_text && last_text_ > handled_) return true;
  return reading.kind_ == MessageKind::drag && last_drag_ > handled_;
}

Readings::Reading::Reading(Readings& readings, double request, MessageKind kind)
    : readings_(readings), request_(request), kind_(kind) {
  const std::lock_guard lock(readings_.mutex_);
  readings_.running_ = this;
  if (readings_.is_useless(*this)) progress_.cancel();
}

Readings::Reading::~Reading() {
  const std::lock_guard lock(readings_.mutex_);
  readings_.running_ = nullptr;
}

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// Why something that the page asked for is not done.
#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

class Refusal : public std::exception {
 public:
  /// `members` join the answer: {"stale", true}, {"limit", "message_bytes"}.
  explicit Refusal(std::string message, Value::Object members = {})
      : message_(std::move(message)), members_(std::move(members)) {}

  const char* what() const noexcept override { return message_.c_str(); }
  const Value::Object& members() const { return members_; }

 private:
  std::string message_;
  Value::Object members_;
};

/// A limit of the studio was reached; `name` is that of the limit in protocol.md.
inline Refusal limit_refusal(std::string message, const char* name) {
  return Refusal(std::move(message), {{"limit", name}});
}

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// The reason why a request of the page is refused.
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
  /// `members` are added to the answer, for example {"stale", true} or {"limit", "message_bytes"}.
  explicit Refusal(std::string message, Value::Object members = {})
      : message_(std::move(message)), members_(std::move(members)) {}

  const char* what() const noexcept override { return message_.c_str(); }
  const Value::Object& members() const { return members_; }

 private:
  std::string message_;
  Value::Object members_;
};

/// Returns the refusal for a limit of the studio. `name` is the limit's name in protocol.md.
inline Refusal limit_refusal(std::string message, const char* name) {
  return Refusal(std::move(message), {{"limit", name}});
}

}  // namespace meristem::studio

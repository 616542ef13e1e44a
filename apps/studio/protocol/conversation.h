// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>

#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// Compares the messages of one connection with the description of the protocol, for tests and for recorded sessions.
class Conversation {
 public:
  /// Takes the next message of the page or of the server, or the head of a scene packet. Throws a Refusal if a message
  /// of the server is not as described. Requests are not checked, because the server answers wrong ones too.
  void take(const Value& message);

  /// Returns true if the number belongs to a request that was taken.
  bool knows(double request) const { return requests_.contains(request); }
  /// Returns the names of all requests that were answered, and were not refused.
  const std::set<std::string>& answered() const { return answered_; }

 private:
  std::map<double, std::string> requests_;  // names by number
  std::set<std::string> answered_;
};

}  // namespace meristem::studio

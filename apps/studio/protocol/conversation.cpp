// SPDX-License-Identifier: Apache-2.0
#include "protocol/conversation.h"

#include "protocol/protocol.h"

namespace meristem::studio {

void Conversation::take(const Value& message) {
  const Value* name = message.find("do");
  const Value* id = message.find("id");
  if (name != nullptr && name->text() != nullptr && id != nullptr && id->number() != nullptr) {
    requests_[*id->number()] = *name->text();
    return;
  }
  const Value* is = message.find("is");
  if (is == nullptr) return check_packet_head(message);
  const Value* re = message.find("re");
  const auto request = re != nullptr && re->number() != nullptr ? requests_.find(*re->number()) : requests_.end();
  check_server_message(message, request != requests_.end() ? request->second : "");
  if (request != requests_.end() && *is == Value("done")) answered_.insert(request->second);
}

}  // namespace meristem::studio

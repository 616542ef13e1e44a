// SPDX-License-Identifier: Apache-2.0
#include "protocol/protocol.h"

#include <algorithm>
#include <array>

#include "protocol/common_records.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

std::string text_of(const Value& message, const char* name) {
  const Value* member = message.find(name);
  return member != nullptr && member->text() != nullptr ? *member->text() : "";
}

/// Returns the members of a message of the server, or null if its kind is unknown.
const Record* members_of(const std::string& is, std::string_view request) {
  if (is == "refused") return &refused_record();
  if (is == "done") {
    const RequestType* type = find_request(request);
    return type != nullptr ? &type->answer() : nullptr;
  }
  for (const ProtocolGroup& group : protocol()) {
    const auto found = std::ranges::find(group.messages, is, &MessageType::name);
    if (found != group.messages.end()) return &found->members();
  }
  return nullptr;
}

}  // namespace

const std::vector<ProtocolGroup>& protocol() {
  static const std::vector<ProtocolGroup> groups{document_messages(), view_messages(),  file_messages(),
                                                 export_messages(),   plant_messages(), shoot_messages(),
                                                 measure_messages(),  packet_messages()};
  return groups;
}

const RequestType* find_request(std::string_view name) {
  for (const ProtocolGroup& group : protocol()) {
    const auto found = std::ranges::find(group.requests, name, &RequestType::name);
    if (found != group.requests.end()) return &*found;
  }
  return nullptr;
}

std::vector<std::string> request_names() {
  std::vector<std::string> names;
  for (const ProtocolGroup& group : protocol()) {
    for (const RequestType& type : group.requests) names.push_back(type.name);
  }
  return names;
}

void check_server_message(const Value& message, std::string_view request) {
  const std::string is = text_of(message, "is");
  const Record* members = members_of(is, request);
  if (members == nullptr) throw Refusal("there is no message '" + is + "'");
  const bool is_answer = is == "done" || is == "refused";
  const std::array<std::string, 2> others{"is", is_answer ? "re" : "is"};
  check_record(*members, message, DocumentPath(), others);
  if (is_answer && message.find("re") == nullptr) throw Refusal("the answer has no 're'");
}

}  // namespace meristem::studio

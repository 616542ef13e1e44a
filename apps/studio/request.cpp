// SPDX-License-Identifier: Apache-2.0
// Reads the requests of a page by the description of the protocol. Everything that is unknown or out of range is
// refused with its path.
#include "request.h"

#include <array>
#include <limits>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"
#include "meristem/document/json.h"
#include "protocol/check.h"
#include "protocol/form.h"
#include "protocol/protocol.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

/// Returns limits that accept a document of the maximum size with all of its characters escaped. A longer message is
/// then refused for its own length only.
SizeLimits message_limits() {
  SizeLimits limits;
  limits.document_bytes = std::numeric_limits<std::uint64_t>::max();
  limits.nesting += 8;
  return limits;
}

Value read_json(std::string_view message) {
  try {
    return parse_json(message, message_limits());
  } catch (const InputError& error) {
    throw Refusal(fmt::format("the message is not JSON: {}", error.what()));
  }
}

/// Returns a member that every request has. Throws a Refusal if the member is missing or has another form.
const Value& checked_member(const Value& message, const char* name, const Form& form) {
  const Value* member = message.find(name);
  if (member == nullptr) throw Refusal(fmt::format("the message has no '{}'", name));
  check_form(form, *member, DocumentPath(DocumentPath(), name));
  return *member;
}

double id_of(const Value& message) {
  if (message.object() == nullptr) throw Refusal("the message is not an object");
  return *checked_member(message, "id", forms::whole()).number();
}

}  // namespace

std::optional<double> request_id(std::string_view message) noexcept {
  try {
    return id_of(read_json(message));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

NumberedRequest read_request(std::string_view message) {
  static const std::array<std::string, 2> kCommon{"do", "id"};
  const Value value = read_json(message);
  const double id = id_of(value);
  const std::string& name = *checked_member(value, "do", forms::text()).text();
  const RequestType* type = find_request(name);
  if (type == nullptr)
    throw Refusal(fmt::format("there is no request {}{}", in_quotes(name), similar(name, request_names())));
  check_record(type->members(), value, DocumentPath(), kCommon);
  return {id, type->read(value)};
}

}  // namespace meristem::studio

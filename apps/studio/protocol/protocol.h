// SPDX-License-Identifier: Apache-2.0
// The description of all messages between the page and the server. Everything else is made from it: the reader of
// requests (request.h), the types of the page (typescript.h), the reference page (markdown.h), and the checks of tests.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/graph/table/value.h"
#include "protocol/check.h"
#include "protocol/form.h"
#include "request.h"

namespace meristem::studio {

/// When a request is answered.
enum class AnswerTime {
  at_once,  ///< before the next request
  later,    ///< when its work is done
  newest,   ///< when its work is done; the request cancels the previous one of its kind
};

/// A kind of request. Each request also has the members `do` (its name) and `id` (its number).
struct RequestType {
  std::string name;  ///< value of `do`
  AnswerTime time = AnswerTime::at_once;
  RecordFunction members = nullptr;  ///< members besides `do` and `id`; its sentence describes the request
  RecordFunction answer = nullptr;   ///< members of the answer besides `is` and `re`
  /// Reads a valid request. Throws a Refusal for values that break rules beyond the forms.
  std::function<Request(const Value& message)> read{};
};

/// A message that the server sends on its own. It also has the member `is` (its name).
struct MessageType {
  std::string name;  ///< value of `is`
  RecordFunction members = nullptr;
};

/// Messages on one subject.
struct ProtocolGroup {
  std::string name;  ///< name of the page's file of types
  std::string doc;   ///< one sentence
  std::vector<RequestType> requests{};
  std::vector<MessageType> messages{};
  std::vector<RecordFunction> others{};  ///< other records that the page uses by themselves
};

/// Returns all messages, by subject.
const std::vector<ProtocolGroup>& protocol();

/// Returns the request of this name, or null.
const RequestType* find_request(std::string_view name);
/// Returns the names of all requests.
std::vector<std::string> request_names();

/// Throws a Refusal if a message of the server is not as described. `request` is the name of the request that an answer
/// belongs to; for other messages it is not used.
void check_server_message(const Value& message, std::string_view request);
/// Throws a Refusal if the head of a scene packet is not as described.
void check_packet_head(const Value& head);

// The messages of each subject, in a source each.

ProtocolGroup document_messages();
ProtocolGroup view_messages();
ProtocolGroup file_messages();
ProtocolGroup export_messages();
ProtocolGroup plant_messages();
ProtocolGroup shoot_messages();
ProtocolGroup measure_messages();
ProtocolGroup packet_messages();

/// Returns the request type whose members are read into an R. `members` must describe an R.
template <class R>
RequestType request_type(std::string name, AnswerTime time, RecordFunction members, RecordFunction answer) {
  return {std::move(name), time, members, answer, [members](const Value& message) {
            R request;
            store_record(members(), &request, message, DocumentPath());
            return Request(std::move(request));
          }};
}

}  // namespace meristem::studio

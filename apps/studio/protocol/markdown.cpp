// SPDX-License-Identifier: Apache-2.0
// Writes a table of all requests and one of all messages, then the members of each, by subject. Records with a name of
// their own follow the messages that use them first.
#include "protocol/markdown.h"

#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "meristem/base/markdown.h"
#include "meristem/document/json.h"
#include "protocol/common_records.h"
#include "protocol/record_order.h"

namespace meristem::studio {

namespace {

std::string link(const Record& record) {
  std::string anchor = record.name;
  for (char& letter : anchor) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return fmt::format("[{}](#{})", record.name, anchor);
}

std::string code(const std::vector<std::string>& names) { return fmt::format("`{}`", fmt::join(names, "`, `")); }

std::string span_text(const Form& form) {
  const Span& span = form.span;
  const bool is_usual = form.kind == Form::Kind::whole && span.min == 0 && span.max == kMaxWhole;
  std::string text;
  if (std::isfinite(span.min) && !is_usual) text += fmt::format(" from {}", span.min);
  if (std::isfinite(span.max) && span.max < kMaxWhole) text += fmt::format(" to {}", span.max);
  if (span.unit != Unit::none) text += fmt::format(" ({})", unit_name(span.unit));
  return text;
}

std::string value_text(const Form& form);

std::string tuple_text(const Form& form) {
  std::vector<std::string> parts;
  bool are_equal = true;
  for (const Form& part : form.parts) {
    parts.push_back(value_text(part));
    are_equal = are_equal && parts.back() == parts.front();
  }
  return fmt::format("`[{}]`: {}", fmt::join(form.names, ", "),
                     are_equal ? "each a " + parts.front() : fmt::format("{}", fmt::join(parts, ", ")));
}

std::string plain_text(const Form& form) {
  std::vector<std::string> links;
  switch (form.kind) {
    case Form::Kind::any:
      return "any JSON";
    case Form::Kind::flag:
      return "true or false";
    case Form::Kind::number:
      return "number" + span_text(form);
    case Form::Kind::whole:
      return "whole number" + span_text(form);
    case Form::Kind::text:
      return "text";
    case Form::Kind::choice:
      return code(form.names);
    case Form::Kind::list: {
      const bool is_fixed = form.min_size == form.max_size;
      const bool has_limit = form.max_size < kMaxParts;
      const std::string size = is_fixed    ? fmt::format(" with {} parts", form.max_size)
                               : has_limit ? fmt::format(" with at most {} parts", form.max_size)
                                           : "";
      return fmt::format("list{} of {}", size, value_text(form.parts[0]));
    }
    case Form::Kind::tuple:
      return tuple_text(form);
    case Form::Kind::map:
      return "object by name of " + value_text(form.parts[0]);
    case Form::Kind::record:
      return link(form.records[0]());
    case Form::Kind::kinds:
      for (const RecordFunction record : form.records) links.push_back(link(record()));
      return fmt::format("{}", fmt::join(links, " or "));
  }
  return "";
}

std::string value_text(const Form& form) { return plain_text(form) + (form.or_null ? " or null" : ""); }

std::string member_value(const Member& member) {
  const std::string text = plain_text(member.form);
  if (member.fallback) return fmt::format("{}; default {}", text, write_json_line(*member.fallback));
  if (!member.is_required) return text + "; optional";
  return value_text(member.form);
}

std::string table(const Record& record) {
  std::string text;
  if (!record.members.empty()) text += "| member | value | meaning |\n| --- | --- | --- |\n";
  for (const Member& member : record.members) {
    text += fmt::format("| `{}` | {} | {} |\n", member.name, markdown_cell(member_value(member)),
                        markdown_cell(member.doc));
  }
  if (!record.members.empty()) text += "\n";
  for (const Record::Part& part : record.parts) {
    text +=
        fmt::format("{} the members of {}.\n\n", part.is_optional ? "In some cases also" : "Also", link(part.record()));
  }
  for (const std::vector<std::string>& group : record.one_of)
    text += fmt::format("Exactly one of {} is given.\n\n", code(group));
  return text;
}

std::string time_text(AnswerTime time) {
  switch (time) {
    case AnswerTime::at_once:
      return "at once";
    case AnswerTime::later:
      return "later";
    case AnswerTime::newest:
      return "later, newest";
  }
  return "";
}

std::string request_text(const RequestType& request) {
  std::string text = fmt::format("### `{}`\n\n{}\n\n", request.name, request.members().doc);
  text += is_empty(request.members()) ? "The request has no members.\n\n" : table(request.members());
  if (is_empty(request.answer())) return text + "The answer has no members.\n\n";
  return text + fmt::format("Answer: {}\n\n", request.answer().doc) + table(request.answer());
}

/// Returns the text of a subject: its requests, its messages, and the records that they use.
std::string group_text(const GroupRecords& own) {
  std::string name = own.group->name;
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  std::string text = fmt::format("## {}\n\n{}\n\n", name, own.group->doc);
  std::set<const Record*> shown;
  for (const RequestType& request : own.group->requests) {
    text += request_text(request);
    shown.insert(&request.members());
    shown.insert(&request.answer());
  }
  for (const MessageType& message : own.group->messages) {
    text += fmt::format("### `{}`\n\n{}\n\n{}", message.name, message.members().doc, table(message.members()));
    shown.insert(&message.members());
  }
  for (const Record* record : own.records) {
    if (!shown.contains(record)) text += fmt::format("### {}\n\n{}\n\n{}", record->name, record->doc, table(*record));
  }
  return text;
}

}  // namespace

std::string protocol_reference() {
  std::string text = "\n## Requests of the page\n\n| `do` | answered | what |\n| --- | --- | --- |\n";
  for (const ProtocolGroup& group : protocol()) {
    for (const RequestType& request : group.requests) {
      text += fmt::format("| `{}` | {} | {} |\n", request.name, time_text(request.time),
                          markdown_cell(request.members().doc));
    }
  }
  text += "\n## Messages of the server\n\n| `is` | what |\n| --- | --- |\n";
  text += "| `done` | The answer to the request `re`, with the members that the request states below. |\n";
  text += fmt::format("| `refused` | The answer to the request `re`: {}. |\n", link(refused_record()));
  for (const ProtocolGroup& group : protocol()) {
    for (const MessageType& message : group.messages)
      text += fmt::format("| `{}` | {} |\n", message.name, markdown_cell(message.members().doc));
  }
  text += "\n";
  for (const GroupRecords& group : records_by_group()) text += group_text(group);
  text.pop_back();
  return text;
}

}  // namespace meristem::studio

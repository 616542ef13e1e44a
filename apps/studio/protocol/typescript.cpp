// SPDX-License-Identifier: Apache-2.0
// Writes a TypeScript interface for each record. Lists in requests are readonly, since the page may keep them.
#include "protocol/typescript.h"

#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "protocol/record_order.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kWidth = 120;  // columns of a line
constexpr const char* kHead =
    "// SPDX-License-Identifier: Apache-2.0\n"
    "// {}\n"
    "// `meristem_studio_protocol` writes this file from apps/studio/protocol.\n";

/// Returns a comment, broken into lines.
std::string comment(const std::string& text, const std::string& indent) {
  std::istringstream words(text);
  std::string lines;
  std::string line = indent + "///";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line = indent + "///";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

/// Collects the names of other types that a file uses.
class TypeWriter {
 public:
  std::string name_of(const Record& record) {
    if (is_empty(record)) return "object";
    used_.insert(&record);
    return record.name;
  }

  std::string type(const Form& form, bool is_readonly) {
    std::string text = plain(form, is_readonly);
    return form.or_null && form.kind != Form::Kind::any ? text + " | null" : text;
  }

  std::string interface_of(const Record& record, const std::string& is, bool is_readonly) {
    std::vector<std::string> bases;
    for (const Record::Part& part : record.parts) {
      const std::string base = name_of(part.record());
      bases.push_back(part.is_optional ? fmt::format("Partial<{}>", base) : base);
    }
    std::string text = comment(record.doc, "");
    text += fmt::format("export interface {}{}{} {{\n", record.name, bases.empty() ? "" : " extends ",
                        fmt::join(bases, ", "));
    if (!is.empty()) text += fmt::format("  is: '{}';\n", is);
    for (const Member& member : record.members) {
      text += comment(member.doc, "  ");
      text += fmt::format("  {}{}: {};\n", member.name, member.is_required ? "" : "?", type(member.form, is_readonly));
    }
    return text + "}\n\n";
  }

  bool uses_json() const { return uses_json_; }
  const std::set<const Record*>& used() const { return used_; }

 private:
  std::string list_of(const Form& element, bool is_readonly) {
    const std::string name = type(element, is_readonly);
    const bool is_plain = name.find_first_of(" |") == std::string::npos || name.front() == '[' || name.back() == '>';
    return fmt::format("{}{}[]", is_readonly ? "readonly " : "", is_plain ? name : "(" + name + ")");
  }

  std::string plain(const Form& form, bool is_readonly) {
    std::vector<std::string> parts;
    switch (form.kind) {
      case Form::Kind::any:
        uses_json_ = true;
        return "Json";
      case Form::Kind::flag:
        return "boolean";
      case Form::Kind::number:
      case Form::Kind::whole:
        return "number";
      case Form::Kind::text:
        return "string";
      case Form::Kind::choice:
        return fmt::format("'{}'", fmt::join(form.names, "' | '"));
      case Form::Kind::list:
        return list_of(form.parts[0], is_readonly);
      case Form::Kind::tuple:
        for (std::size_t k = 0; k < form.parts.size(); ++k)
          parts.push_back(fmt::format("{}: {}", form.names[k], type(form.parts[k], is_readonly)));
        return fmt::format("{}[{}]", is_readonly ? "readonly " : "", fmt::join(parts, ", "));
      case Form::Kind::map:
        return fmt::format("Record<string, {}>", type(form.parts[0], is_readonly));
      case Form::Kind::record:
        return name_of(form.records[0]());
      case Form::Kind::kinds:
        for (const RecordFunction record : form.records) parts.push_back(name_of(record()));
        return fmt::format("{}", fmt::join(parts, " | "));
    }
    return "";
  }

  std::set<const Record*> used_;
  bool uses_json_ = false;
};

/// Returns all records that requests contain.
std::set<const Record*> records_of_requests() {
  std::set<const Record*> found;
  const auto add = [&](const auto& self, const Record& record) -> void {
    found.insert(&record);
    for (const Member& member : record.members)
      for_each_record(member.form, [&](const Record& nested) { self(self, nested); });
  };
  for (const ProtocolGroup& group : protocol()) {
    for (const RequestType& request : group.requests) add(add, request.members());
  }
  return found;
}

/// Returns the imports of a file from the files of other subjects.
std::string imports(const TypeWriter& writer, const std::vector<GroupRecords>& groups, const ProtocolGroup* own) {
  std::map<std::string, std::string> lines;  // by the name of the file, as the page's linter sorts them
  for (const GroupRecords& group : groups) {
    std::set<std::string> names;
    for (const Record* record : group.records) {
      if (group.group != own && writer.used().contains(record)) names.insert(record->name);
    }
    if (names.empty()) continue;
    const std::string from = fmt::format("from './{}.ts';\n", group.group->name);
    const std::string line = fmt::format("import type {{ {} }} {}", fmt::join(names, ", "), from);
    lines[group.group->name] =
        line.size() <= kWidth ? line : fmt::format("import type {{\n  {},\n}} {}", fmt::join(names, ",\n  "), from);
  }
  std::string text = writer.uses_json() ? "import type { Json } from '../../values/json.ts';\n" : "";
  for (const auto& [name, line] : lines) text += line;
  return text.empty() ? "" : text + "\n";
}

PageSource subject_file(const GroupRecords& own, const std::vector<GroupRecords>& groups) {
  const std::set<const Record*> of_requests = records_of_requests();
  std::map<const Record*, std::string> messages;
  for (const MessageType& message : own.group->messages) messages[&message.members()] = message.name;
  TypeWriter writer;
  std::string body;
  for (const Record* record : own.records)
    body += writer.interface_of(*record, messages[record], of_requests.contains(record));
  body.pop_back();
  return {own.group->name + ".ts",
          fmt::format(fmt::runtime(kHead), own.group->doc) + imports(writer, groups, own.group) + body};
}

/// Returns an interface with a member for each request.
std::string table_of(const char* name, const char* doc, RecordFunction RequestType::*record, TypeWriter& writer) {
  std::string text = comment(doc, "") + fmt::format("export interface {} {{\n", name);
  for (const ProtocolGroup& group : protocol()) {
    for (const RequestType& request : group.requests)
      text += fmt::format("  {}: {};\n", request.name, writer.name_of((request.*record)()));
  }
  return text + "}\n\n";
}

PageSource tables_file(const std::vector<GroupRecords>& groups) {
  TypeWriter writer;
  std::string body = table_of("Requests", "The members of each request.", &RequestType::members, writer);
  body += table_of("Answers", "The members of each answer.", &RequestType::answer, writer);
  std::vector<std::string> messages;
  for (const ProtocolGroup& group : protocol()) {
    for (const MessageType& message : group.messages) messages.push_back(writer.name_of(message.members()));
  }
  body += "/// A message that the server sends on its own.\n";
  body += fmt::format("export type ServerMessage = {};\n", fmt::join(messages, " | "));
  return {"messages.ts", fmt::format(fmt::runtime(kHead), "All requests, answers and messages by name.") +
                             imports(writer, groups, nullptr) + body};
}

}  // namespace

std::vector<PageSource> typescript_files() {
  const std::vector<GroupRecords> groups = records_by_group();
  std::vector<PageSource> files;
  files.reserve(groups.size() + 1);
  for (const GroupRecords& group : groups) files.push_back(subject_file(group, groups));
  files.push_back(tables_file(groups));
  return files;
}

}  // namespace meristem::studio

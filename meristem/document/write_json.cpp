// SPDX-License-Identifier: Apache-2.0
// Writes a tree as JSON in its canonical form, without recursion. A list without objects stands on one line; all other
// members and elements get lines of their own.
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "meristem/document/json.h"

namespace meristem {

namespace {

/// Writes a tree without recursion.
class Writer {
 public:
  explicit Writer(bool in_lines) : in_lines_(in_lines) {}

  std::string write(const Value& root) {
    begin(root);
    while (!open_.empty()) {
      Open& top = open_.back();
      const Value::List* list = top.container->list();
      const Value::Object* object = top.container->object();
      if (top.next == (list != nullptr ? list->size() : object->size())) {
        end();
        continue;
      }
      if (top.next > 0) out_ += ',';
      separate(top, top.next == 0);
      const std::size_t k = top.next++;
      if (object != nullptr) {
        write_text((*object)[k].first);
        out_ += ": ";
      }
      begin(list != nullptr ? (*list)[k] : (*object)[k].second);
    }
    return std::move(out_);
  }

 private:
  struct Open {
    const Value* container;
    std::size_t next = 0;
    bool in_lines = false;  // each member on a line of its own
  };

  void begin(const Value& value) {
    if (const bool* boolean = value.boolean()) {
      out_ += *boolean ? "true" : "false";
    } else if (const double* number = value.number()) {
      write_number(*number);
    } else if (const std::string* text = value.text()) {
      write_text(*text);
    } else if (value.is_null()) {
      out_ += "null";
    } else {
      const bool is_list = value.list() != nullptr;
      const bool is_empty = is_list ? value.list()->empty() : value.object()->empty();
      const bool above = open_.empty() ? in_lines_ : open_.back().in_lines;
      open_.push_back({&value, 0, above && !is_empty && !(is_list && holds_no_object(value))});
      out_ += is_list ? '[' : '{';
    }
  }

  void end() {
    const Open top = open_.back();
    open_.pop_back();
    if (top.in_lines) new_line();
    out_ += top.container->list() != nullptr ? ']' : '}';
  }

  void separate(const Open& top, bool is_first) {
    if (top.in_lines) {
      new_line();
    } else if (!is_first) {
      out_ += ' ';
    }
  }

  void new_line() {
    out_ += '\n';
    out_.append(2 * open_.size(), ' ');
  }

  /// Returns true for a value without objects: numbers, points and lists of points stand on one line.
  static bool holds_no_object(const Value& value) {
    std::vector<const Value*> left{&value};
    while (!left.empty()) {
      const Value& next = *left.back();
      left.pop_back();
      if (next.object() != nullptr) return false;
      if (const Value::List* list = next.list()) {
        for (const Value& element : *list) left.push_back(&element);
      }
    }
    return true;
  }

  void write_number(double number) {
    constexpr double kExact = 9007199254740992;  // 2^53
    if (!std::isfinite(number)) {
      out_ += "null";
    } else if (number == std::floor(number) && std::abs(number) <= kExact) {
      fmt::format_to(std::back_inserter(out_), "{}", static_cast<std::int64_t>(number));
    } else {
      fmt::format_to(std::back_inserter(out_), "{}", number);
    }
  }

  void write_text(const std::string& text) {
    out_ += '"';
    for (const char c : text) {
      if (c == '"' || c == '\\') {
        out_ += '\\';
        out_ += c;
      } else if (c == '\n') {
        out_ += "\\n";
      } else if (static_cast<unsigned char>(c) < 0x20) {
        fmt::format_to(std::back_inserter(out_), "\\u{:04x}", static_cast<unsigned>(c));
      } else {
        out_ += c;
      }
    }
    out_ += '"';
  }

  bool in_lines_;
  std::string out_;
  std::vector<Open> open_;
};

}  // namespace

std::string write_json(const Value& value) { return Writer(true).write(value) + "\n"; }

std::string write_json_line(const Value& value) { return Writer(false).write(value); }

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// A variable is computed after the variables that it uses. A depth-first walk over the names in the expressions finds
// the order. It needs no recursion and takes time in proportion to the number of names. A link back to a variable on
// the walk closes a circle.
#include "meristem/document/variables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/expression/expression_scope.h"
#include "meristem/base/read_file.h"
#include "meristem/document/instance_variables.h"
#include "meristem/document/member_index.h"
#include "meristem/document/mentions.h"
#include "meristem/document/tables.h"
#include "meristem/graph/table/node_condition.h"

namespace meristem {

namespace {

/// Maximum number of variables. More are hard to use as handles, and each instance stores a number per variable that it
/// draws.
constexpr std::size_t kMaxVariables = 1000;
/// Maximum size of a grammar file, bytes. Larger files, such as meshes, are not searched for names.
constexpr std::uint64_t kLongestGrammar = 1'000'000;

/// Returns true if a variable may have this name. Expressions can be compiled only with such names.
bool is_free_name(const std::string& name) { return is_identifier(name) && !has_meaning(name); }

const Value* value_of(const Value& variable) {
  return variable.object() == nullptr ? &variable : variable.find("value");
}

std::string text_of(const Value& variable) {
  const Value* value = value_of(variable);
  return value != nullptr && value->text() != nullptr ? *value->text() : "";
}

/// Returns a circle of variables as text: "a -> b -> a".
std::string circle_text(const std::vector<ExpressionNames::Constant>& constants,
                        const std::vector<std::size_t>& circle) {
  std::string text;
  for (const std::size_t k : circle) text += constants[k].name + " -> ";
  return text + constants[circle.front()].name;
}

class Solver {
 public:
  Solver(const Value::Object& given, const SizeLimits& limits) {
    for (const auto& [name, variable] : given) {
      if (!is_free_name(name) || nodes_.size() == kMaxVariables || is_per_instance(variable)) continue;
      Node& node = nodes_.emplace_back();
      names_.add(name);
      const Value* value = value_of(variable);
      if (value != nullptr && value->number() != nullptr) node.value = *value->number();
      node.text = text_of(variable);
    }
    for (Node& node : nodes_) compile(node, limits);
    values_.assign(nodes_.size(), 1);
  }

  VariableValues run() {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      if (nodes_[k].state == State::ahead) walk_from(k);
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      solved_.constants.push_back({names_.names()[k], values_[k]});
      solved_.uses.push_back(std::move(nodes_[k].uses));
    }
    return std::move(solved_);
  }

 private:
  enum class State : std::uint8_t { ahead, on_the_way, solved };

  struct Node {
    std::string text;  // text of the expression
    double value = 1;
    std::optional<Expression> expression;
    std::vector<std::size_t> uses;
    std::size_t next = 0;  // index of the next use, for the walk
    State state = State::ahead;
    bool is_in_circle = false;
  };

  /// Compiles the expression of a variable. The reader of the value reports faults in the text later.
  void compile(Node& node, const SizeLimits& limits) const {
    if (node.text.empty()) return;
    try {
      const ExpressionScope scope{
          .variables = names_.names(), .constants = {}, .variable_table = &names_, .has_nearest = false};
      node.expression = Expression::compile_in(node.text, scope, limits.expression_bytes);
    } catch (const ExpressionError&) {
      return;
    }
    if (node.expression->is_random()) node.expression.reset();
    for (std::size_t k = 0; node.expression && k < nodes_.size(); ++k) {
      if (node.expression->uses(k)) node.uses.push_back(k);
    }
  }

  void walk_from(std::size_t begin) {
    std::vector<std::size_t> way{begin};
    nodes_[begin].state = State::on_the_way;
    while (!way.empty()) {
      Node& node = nodes_[way.back()];
      if (node.next == node.uses.size()) {
        solve(way.back());
        way.pop_back();
        continue;
      }
      const std::size_t used = node.uses[node.next++];
      if (nodes_[used].state == State::ahead) {
        nodes_[used].state = State::on_the_way;
        way.push_back(used);
      } else if (nodes_[used].state == State::on_the_way) {
        add_circle({std::find(way.begin(), way.end(), used), way.end()});
      }
    }
  }

  void solve(std::size_t k) {
    Node& node = nodes_[k];
    node.state = State::solved;
    if (node.is_in_circle) return;
    const double value = node.expression ? node.expression->evaluate(values_) : node.value;
    if (std::isfinite(value)) values_[k] = value;
  }

  /// Adds a circle of variables. If circles share a variable, only the first circle is reported. The circle begins with
  /// its first variable in the document's order.
  void add_circle(std::vector<std::size_t> members) {
    bool is_told = false;
    for (const std::size_t k : members) {
      is_told = is_told || nodes_[k].is_in_circle;
      nodes_[k].is_in_circle = true;
    }
    if (is_told) return;
    std::rotate(members.begin(), std::min_element(members.begin(), members.end()), members.end());
    solved_.circles.push_back(std::move(members));
  }

  NameTable names_;  // names of all variables; each can be used in every expression
  std::vector<Node> nodes_;
  std::vector<double> values_;
  VariableValues solved_;
};

Variable read_variable(ParameterReader& reader, const std::string& name, const Value& value, const DocumentPath& path) {
  if (!is_identifier(name)) {
    reader.add_name_error(path, fmt::format("'{}' is not a name", name),
                          "letters, digits and _, not beginning with a digit", "");
  } else if (has_meaning(name)) {
    reader.add_name_error(path, fmt::format("'{}' already has a meaning in expressions", name), "another name", "");
  }
  Variable variable;
  reader.read(variable_table(), &variable, value, path);
  variable.name = name;
  variable.expression = text_of(value);
  // Missing bounds are widened to include the value.
  if (value.find("min") == nullptr) variable.min = std::min({0.0, variable.value, variable.max});
  if (value.find("max") == nullptr) variable.max = std::max({1.0, variable.value, variable.min});
  if (variable.min > variable.max) {
    reader.add_error(DocumentPath(path, "min"),
                     fmt::format("'min' {:.12g} lies above 'max' {:.12g}", variable.min, variable.max),
                     "a 'min' of at most 'max'");
  }
  return variable;
}

bool is_beyond(const Variable& variable) { return variable.value < variable.min || variable.value > variable.max; }

/// Returns the path of a variable's value.
DocumentPath value_place(const DocumentPath& variable, const Value& said) {
  return said.object() == nullptr ? variable : DocumentPath(variable, "value");
}

/// Returns the value at a path, like find_value(). `components` is the index of the root's components.
const Value* find_value(const Value& root, const MemberIndex& components, std::string_view path) {
  constexpr std::string_view kComponents = "components.";
  if (!path.starts_with(kComponents)) return find_value(root, path);
  const std::string_view below = path.substr(kComponents.size());
  const std::size_t end = std::min(below.find_first_of(".["), below.size());
  const Value* component = components.find(below.substr(0, end));
  if (component == nullptr) return find_value(root, "components");
  const std::string_view rest = below.substr(end);
  const Value* found = find_value(*component, rest.starts_with('.') ? rest.substr(1) : rest);
  return found == nullptr ? component : found;
}

/// Returns the text of a file, or an empty text if the file is larger than a grammar may be.
std::string text_of_grammar(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  if (std::filesystem::file_size(file, error) > kLongestGrammar || error) return {};
  return read_file(file, kLongestGrammar);
}

}  // namespace

bool has_meaning(const std::string& name) {
  const auto is_in = [&name](const auto& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return is_builtin_name(name) || is_in(site_variables()) || is_in(node_variables());
}

VariableValues solve_variables(const Value* given, const SizeLimits& limits) {
  return given == nullptr || given->object() == nullptr ? VariableValues{} : Solver(*given->object(), limits).run();
}

bool are_too_many_variables(const Value* given) {
  return given != nullptr && given->object() != nullptr && given->object()->size() > kMaxVariables;
}

std::vector<Variable> read_variables(const Value* given, const VariableValues& solved, ParameterReader& reader) {
  std::vector<Variable> variables;
  if (given == nullptr) return variables;
  const DocumentPath top;
  const DocumentPath path(top, "variables");
  if (given->object() == nullptr) {
    reader.add_error(path, fmt::format("the variables are {}", given->description()), "an object of names");
    return variables;
  }
  if (are_too_many_variables(given)) {
    reader.add_error(path, fmt::format("the document has {} variables", given->object()->size()),
                     fmt::format("at most {}", kMaxVariables));
    return variables;
  }
  for (const auto& [name, value] : *given->object()) {
    if (is_per_instance(value)) continue;  // not a handle: read by read_instance_variables
    variables.push_back(read_variable(reader, name, value, DocumentPath(path, name)));
  }
  for (const std::vector<std::size_t>& circle : solved.circles) {
    const std::string& first = solved.constants[circle.front()].name;
    const DocumentPath variable(path, first);
    reader.add_error(value_place(variable, *given->find(first)),
                     circle.size() == 1 ? fmt::format("'{}' depends on itself", first)
                                        : fmt::format("the variables {} depend on each other in a circle",
                                                      circle_text(solved.constants, circle)),
                     "an expression without this circle");
  }
  return variables;
}

void warn_of_variables(const Value& root, const std::vector<Variable>& variables, ParameterReader& reader) {
  // After faults no variable is reported as unused: the faults may be the reason.
  std::set<std::string, std::less<>> unused;
  for (const Variable& variable : variables) {
    if (reader.error_count() == 0) unused.insert(variable.name);
  }
  const auto take_out = [&](std::string_view name) {
    if (const auto found = unused.find(name); found != unused.end()) unused.erase(found);
  };
  for (const char* part : {"scene", "components", "links", "output", "variables"}) {
    const Value* said = root.find(part);
    if (said != nullptr && !unused.empty()) for_each_mention(*said, take_out);
  }
  for (const NamedFile& file : reader.files().named()) {
    if (unused.empty()) break;
    const auto text = [&] { return text_of_grammar(file.path); };
    const auto kept = [&] {
      return reader.files().kept<std::string>(Fingerprint().add_text(file.path).add(*file.hash), text);
    };
    for_each_name(file.hash ? *kept() : text(), take_out);
  }
  const DocumentPath top;
  const DocumentPath path(top, "variables");
  for (const Variable& variable : variables) {
    const DocumentPath own(path, variable.name);
    if (unused.contains(variable.name)) reader.warn(own, fmt::format("nothing uses '{}'", variable.name));
    if (is_beyond(variable) && variable.min <= variable.max) {
      reader.warn(value_place(own, *root.find("variables")->find(variable.name)),
                  fmt::format("'{}' is {:.12g}, beyond its range of {:.12g} to {:.12g}", variable.name, variable.value,
                              variable.min, variable.max));
    }
  }
}

std::vector<VariableNote> note_variables(const std::vector<Variable>& variables, const VariableValues& solved,
                                         const std::vector<std::string>& overridden) {
  std::unordered_map<std::string_view, std::string> texts;
  for (const Variable& variable : variables) {
    const auto is_of = [&](const std::string& path) {
      return path == "variables." + variable.name || path == "variables." + variable.name + ".value";
    };
    const bool is_set = std::any_of(overridden.begin(), overridden.end(), is_of);
    if (!is_set && !is_beyond(variable)) continue;
    std::string& text = texts[variable.name];
    text = fmt::format("{} is {:.12g}", variable.name, variable.value);
    if (is_beyond(variable)) text += fmt::format(", beyond {:.12g} to {:.12g}", variable.min, variable.max);
  }
  for (const std::vector<std::size_t>& circle : solved.circles) {
    for (const std::size_t k : circle) texts.erase(solved.constants[k].name);  // their values have no meaning
  }
  std::vector<VariableNote> notes;
  if (texts.empty()) return notes;
  for (std::size_t k = 0; k < solved.constants.size(); ++k) {
    const std::string& name = solved.constants[k].name;
    notes.push_back({name, texts[name], solved.uses[k]});
  }
  return notes;
}

void tell_variables(const Value& root, const std::vector<VariableNote>& notes, std::vector<Diagnostic>& diagnostics) {
  if (notes.empty()) return;
  std::unordered_map<std::string_view, std::size_t> note_of;
  for (std::size_t k = 0; k < notes.size(); ++k) note_of.emplace(notes[k].variable, k);
  const MemberIndex components(root.find("components"));
  std::unordered_map<const Value*, std::string> told_of;  // text to add to messages, by value
  for (Diagnostic& diagnostic : diagnostics) {
    // Faults in the text of an expression or at a name do not depend on variables.
    if (diagnostic.severity != Severity::error || diagnostic.path.empty() || diagnostic.text_offset != -1) continue;
    const Value* said = find_value(root, components, diagnostic.path);
    if (said == nullptr) continue;
    if (const auto known = told_of.find(said); known != told_of.end()) {
      diagnostic.message += known->second;
      continue;
    }
    // Follows the mentioned variables to the variables that they use.
    std::vector<bool> is_met(notes.size());
    std::vector<std::size_t> ahead;
    const auto meet = [&](std::size_t k) {
      if (!is_met[k]) ahead.push_back(k);
      is_met[k] = true;
    };
    for_each_mention(*said, [&](std::string_view name) {
      if (const auto found = note_of.find(name); found != note_of.end()) meet(found->second);
    });
    while (!ahead.empty()) {
      const std::size_t next = ahead.back();
      ahead.pop_back();
      for (const std::size_t used : notes[next].uses) meet(used);
    }
    std::vector<std::string_view> told;
    for (std::size_t k = 0; k < notes.size(); ++k) {
      if (is_met[k] && !notes[k].text.empty()) told.push_back(notes[k].text);
    }
    const std::string addition = told.empty() ? std::string() : fmt::format(" ({})", fmt::join(told, "; "));
    diagnostic.message += addition;
    told_of.emplace(said, addition);
  }
}

}  // namespace meristem

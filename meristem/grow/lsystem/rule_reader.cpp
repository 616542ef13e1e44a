// SPDX-License-Identifier: Apache-2.0
// Splits a rule's line into its parts at the arrow, colons and context signs, and compiles the parts.
#include "meristem/grow/lsystem/rule_reader.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"

namespace meristem {

namespace {

constexpr std::string_view kAlways = "*";
constexpr std::string_view kAgeName = "age";

/// Returns the offsets of `character` outside parentheses.
std::vector<std::size_t> find_outside_parentheses(std::string_view text, char character) {
  std::vector<std::size_t> found;
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
    if (text[k] == character && depth <= 0) found.push_back(k);
  }
  return found;
}

/// Returns "->" if another sign is used as the arrow, as in "F: FF", "F = FF" or "F => FF". Otherwise returns an empty
/// text.
std::string arrow_instead(std::string_view line) {
  for (const std::string_view other : {"=>", "\u21D2", "\u27F6"}) {
    if (line.find(other) != std::string_view::npos) return "->";
  }
  for (const char other : {':', '='}) {
    const std::vector<std::size_t> found = find_outside_parentheses(line, other);
    // With a condition, the colon has its own meaning, and the arrow after it is missing.
    if (found.size() != 1 || line.find_first_of("<>!") != std::string_view::npos) continue;
    if (!trimmed(line.substr(0, found[0])).empty() && !trimmed(line.substr(found[0] + 1)).empty()) return "->";
  }
  return {};
}

/// A condition of the book's notation (= & |), converted to the notation of expressions (== && ||).
struct Condition {
  std::string text;
  std::vector<std::size_t> doubled;  ///< offsets in `text` of added characters

  std::size_t original_offset(std::size_t offset) const {
    const auto before = std::lower_bound(doubled.begin(), doubled.end(), offset);
    return offset - static_cast<std::size_t>(before - doubled.begin());
  }
};

Condition in_expression_spelling(std::string_view text) {
  Condition result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    result.text += c;
    const auto is_neighbour = [&](std::size_t at, std::string_view any) {
      return at < text.size() && any.find(text[at]) != std::string_view::npos;
    };
    const bool is_single_equal = c == '=' && !is_neighbour(k + 1, "=") && !is_neighbour(k - 1, "=<>!");
    const bool is_single_and = c == '&' && !is_neighbour(k + 1, "&") && !is_neighbour(k - 1, "&");
    const bool is_single_or = c == '|' && !is_neighbour(k + 1, "|") && !is_neighbour(k - 1, "|");
    if (!is_single_equal && !is_single_and && !is_single_or) continue;
    result.doubled.push_back(result.text.size());
    result.text += c;
  }
  return result;
}

}  // namespace

std::optional<Arrow> find_arrow(std::string_view line) {
  const std::size_t plain = line.find("->");
  const std::size_t pretty = line.substr(0, plain).find(kArrow);
  if (pretty != std::string_view::npos) return Arrow{pretty, kArrow.size()};
  if (plain == std::string_view::npos) return std::nullopt;
  // In F-->G the arrow is -->, because a predecessor precedes it. In - -> G and in A < --> G, it is ->.
  if (plain > 0 && line[plain - 1] == '-') {
    const std::string_view before = trimmed(line.substr(0, plain - 1));
    const bool is_symbol = before.empty() || before.back() == '<' || before.back() == '>' || before.back() == ':';
    if (!is_symbol) return Arrow{plain - 1, 3};
  }
  return Arrow{plain, 2};
}

GrammarConstants::GrammarConstants(std::vector<ExpressionNames::Constant> constants) {
  for (const auto& constant : constants) set(constant.name, constant.value);
}

void GrammarConstants::set(const std::string& name, double value) {
  const auto [entry, is_new] = index_.emplace(name, constants_.size());
  if (is_new) {
    constants_.push_back({name, value});
  } else {
    constants_[entry->second].value = value;
  }
}

std::vector<ExpressionNames::Constant> GrammarConstants::used_in(std::string_view text) const {
  std::vector<ExpressionNames::Constant> used;
  if (constants_.empty()) return used;
  std::unordered_set<std::size_t> seen;
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::size_t length = 0;
    while (k + length < text.size() && is_identifier(std::string("_") + text[k + length])) ++length;
    if (length == 0) continue;
    const auto found = index_.find(std::string(text.substr(k, length)));
    if (found != index_.end() && seen.insert(found->second).second) used.push_back(constants_[found->second]);
    k += length - 1;
  }
  return used;
}

/// The parts of a rule's line, trimmed. Missing parts are empty and have no position.
struct RuleReader::Parts {
  std::string_view left;
  std::string_view predecessor;
  std::string_view right;
  std::string_view life;
  std::string_view condition;
  std::string_view weight;
  std::string_view successor;
};

RuleReader::RuleReader(const GrammarText& text, GrammarErrors& errors, const SizeLimits& limits, ModuleReader& modules,
                       std::vector<ExpressionNames::Constant> constants)
    : text_(text), errors_(errors), limits_(limits), modules_(modules), constants_(std::move(constants)) {}

void RuleReader::begin_rule() {
  variables_.clear();
  expressions_.clear();
}

// Words.

bool RuleReader::read_modules(std::string_view text, std::vector<std::string_view>& open,
                              std::vector<ModuleTemplate>& modules) {
  bool is_good = true;
  std::string_view rest = text;
  while (!errors_.is_full()) {
    const std::string_view before = rest;
    const auto module = modules_.next(rest);
    // After an error in a module, nothing of the rest is read.
    if (!module) return is_good && trimmed(before).empty();
    is_good = modules_.match_bracket(*module, open) && is_good;
    ModuleTemplate form;
    form.letter = modules_.letter_of(*module);
    if (form.letter == kNoLetter) is_good = false;
    for (const std::string_view argument : module->arguments) {
      if (auto expression = read_expression(argument)) {
        form.parameters.push_back(std::move(*expression));
      } else {
        is_good = false;
      }
    }
    modules.push_back(std::move(form));
  }
  return false;
}

void RuleReader::read_axiom(std::string_view text, std::vector<std::string_view>& open,
                            std::vector<ModuleTemplate>& axiom) {
  begin_rule();
  // Skip an optional "ω :", as in the book.
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    const std::string_view name = trimmed(text.substr(0, colon));
    if (name == "\u03C9" || (name.size() > 1 && is_identifier(name))) text.remove_prefix(colon + 1);
  }
  // No word contains a colon, so this line is probably a rule without an arrow.
  if (!find_outside_parentheses(text, ':').empty()) {
    errors_.add(trimmed(text), fmt::format("{} has no arrow", in_quotes(trimmed(text))), "predecessor -> successor",
                arrow_instead(text));
    return;
  }
  const std::size_t first = axiom.size();
  if (!read_modules(text, open, axiom)) return;
  for (std::size_t k = first; k < axiom.size(); ++k) {
    for (const Expression& parameter : axiom[k].parameters) {
      if (parameter.is_random()) {
        errors_.add(text, fmt::format("{} in the axiom is drawn at random", in_quotes(parameter.text())), "a constant");
        return;
      }
    }
  }
}

// Expressions.

void RuleReader::note_names_of(std::string_view expression) {
  const auto is_of_name = [](char c) {
    return c == '_' || ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
  };
  for (std::size_t at = 0; at < expression.size();) {
    std::size_t end = at;
    while (end < expression.size() && is_of_name(expression[end])) ++end;
    const std::string_view word = expression.substr(at, end - at);
    at = std::max(end, at + 1);
    if (is_identifier(word) && std::find(variables_.begin(), variables_.end(), word) == variables_.end()) {
      noted_->push_back(word);
    }
  }
}

std::optional<Expression> RuleReader::read_expression(std::string_view text, bool is_condition) {
  if (noted_ != nullptr) note_names_of(text);
  Condition spelled;
  if (is_condition) {
    spelled = in_expression_spelling(text);
  } else {
    spelled.text = text;
  }
  if (const auto known = expressions_.find(spelled.text); known != expressions_.end()) return known->second;
  const auto compile = [&](std::vector<ExpressionNames::Constant> constants) {
    const ExpressionNames names{variables_, std::move(constants)};
    return Expression::compile(spelled.text, names, limits_.expression_bytes);
  };
  std::optional<Expression> expression;
  try {
    expression = compile(constants_.used_in(spelled.text));
  } catch (const ExpressionError&) {
    // Compile again with all names, so that the message can suggest the nearest of all names.
    try {
      compile(constants_.all());
    } catch (const ExpressionError& error) {
      const std::size_t offset = std::min(spelled.original_offset(error.details().offset), text.size());
      errors_.add(text.substr(offset), error.details().message, error.details().expected, error.details().nearest);
    }
    return std::nullopt;
  }
  if (expression->is_constant() && !std::isfinite(expression->evaluate())) {
    errors_.add(text, fmt::format("{} has no finite value", in_quotes(text)), "a number");
    return std::nullopt;
  }
  return expressions_.emplace(spelled.text, std::move(*expression)).first->second;
}

std::optional<double> RuleReader::read_constant(std::string_view text) {
  begin_rule();
  const auto expression = read_expression(text);
  if (!expression) return std::nullopt;
  if (!expression->is_constant()) {
    errors_.add(text, fmt::format("{} is drawn at random", in_quotes(text)), "a constant");
    return std::nullopt;
  }
  return expression->evaluate();
}

// Rules.

std::optional<GrammarRule> RuleReader::read_rule(std::string_view line, Kind kind) {
  begin_rule();
  Parts parts;
  if (!split_rule(line, parts)) return std::nullopt;
  GrammarRule rule;
  rule.text = line;
  rule.line = text_.line(line);

  if (parts.predecessor == "[" || parts.predecessor == "]") {
    const bool is_kept = parts.successor == parts.predecessor;
    if (!is_kept) errors_.add(parts.predecessor, "brackets cannot be rewritten", "another predecessor");
    return std::nullopt;
  }
  bool is_good = read_context(parts.left, false, rule.left);
  is_good = read_predecessor(parts, rule) && is_good;
  is_good = read_context(parts.right, true, rule.right) && is_good;
  const bool is_hidden = std::find(variables_.begin(), variables_.end(), kAgeName) != variables_.end() ||
                         constants_.has(std::string(kAgeName));
  const bool has_age = kind == Kind::interpretation && !is_hidden && variables_.size() < kMaxVariables;
  if (has_age) variables_.emplace_back(kAgeName);
  rule.variable_count = static_cast<std::uint32_t>(variables_.size());
  if (!is_good) return std::nullopt;  // later errors would only follow from unknown names
  is_good = read_conditions(parts, rule);
  is_good = read_life(parts, kind, rule) && is_good;
  std::vector<std::string_view> open;
  if (parts.successor != kEmptyWord) {
    is_good = read_modules(parts.successor, open, rule.successor) && is_good;
    modules_.report_unclosed(open);
  }
  if (!is_good || !open.empty()) return std::nullopt;
  if (has_age) note_age(rule);
  return rule;
}

/// Sets GrammarRule::sees_age if any expression of the rule uses the age, which is its last variable.
void RuleReader::note_age(GrammarRule& rule) {
  const std::size_t age = rule.variable_count - 1;
  const auto asks = [&](const std::optional<Expression>& expression) { return expression && expression->uses(age); };
  rule.sees_age = asks(rule.condition) || asks(rule.weight);
  for (const ModuleTemplate& form : rule.successor) {
    for (const Expression& parameter : form.parameters) rule.sees_age = rule.sees_age || parameter.uses(age);
  }
}

bool RuleReader::split_rule(std::string_view line, Parts& parts) {
  const auto arrow = find_arrow(line);
  if (!arrow) {
    errors_.add(line, fmt::format("{} has no arrow", in_quotes(line)), "predecessor -> successor", arrow_instead(line));
    return false;
  }
  const std::string_view left_side = trimmed(line.substr(0, arrow->begin));
  parts.successor = trimmed(line.substr(arrow->begin + arrow->size));
  if (!left_side.empty()) return split_left_side(left_side, parts);
  errors_.add(line, "no predecessor stands before the arrow", "predecessor -> successor");
  return false;
}

bool RuleReader::split_left_side(std::string_view left_side, Parts& parts) {
  std::string_view rest = left_side;
  auto colons = find_outside_parentheses(rest, ':');
  if (!colons.empty()) {
    // A name before the first colon is the rule's id, unless it is a symbol.
    const std::string_view id = trimmed(rest.substr(0, colons.front()));
    if (id.size() > 1 && is_identifier(id) && !modules_.is_declared(id)) {
      rest.remove_prefix(colons.front() + 1);
      colons = find_outside_parentheses(rest, ':');
    }
  }
  if (colons.empty()) return split_contexts(rest, parts);
  return split_contexts(rest.substr(0, colons.front()), parts) &&
         split_conditions(rest.substr(colons.front() + 1), parts);
}

bool RuleReader::split_conditions(std::string_view text, Parts& parts) {
  // Ignore colons that belong to a question mark.
  std::vector<std::size_t> colons;
  int depth = 0;
  int questions = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
    if (depth > 0) continue;
    if (text[k] == '?') ++questions;
    if (text[k] == ':' && questions-- <= 0) colons.push_back(k);
    questions = std::max(questions, 0);
  }
  if (colons.size() > 1) {
    errors_.add(text.substr(colons[1]), "one ':' too many", "predecessor : condition : weight -> successor");
    return false;
  }
  const std::string_view first = trimmed(text.substr(0, colons.empty() ? text.size() : colons.front()));
  const std::string_view second = colons.empty() ? std::string_view() : trimmed(text.substr(colons.front() + 1));
  if (first.empty() || (!colons.empty() && second.empty())) {
    errors_.add(first.empty() ? text : text.substr(colons.front()), "nothing follows ':'", "a condition, or a weight");
    return false;
  }
  const bool is_weight = colons.empty() && first != kAlways && first.find_first_of("<>=!&|") == std::string_view::npos;
  if (is_weight) {
    parts.weight = first;
  } else {
    if (first != kAlways) parts.condition = first;
    parts.weight = second;
  }
  return true;
}

bool RuleReader::split_contexts(std::string_view text, Parts& parts) {
  const auto left = find_outside_parentheses(text, '<');
  const auto right = find_outside_parentheses(text, '>');
  const auto fail = [&](std::size_t offset, std::string message) {
    errors_.add(text.substr(offset), std::move(message), "left < predecessor > right");
    return false;
  };
  if (left.size() > 1) return fail(left[1], "a second '<'");
  if (right.size() > 1) return fail(right[1], "a second '>'");
  if (!left.empty() && !right.empty() && left[0] > right[0]) return fail(left[0], "'<' stands behind '>'");

  const std::size_t end = right.empty() ? text.size() : right[0];
  const std::size_t begin = left.empty() ? 0 : left[0] + 1;
  parts.predecessor = trimmed(text.substr(begin, end - begin));
  if (parts.predecessor.empty()) return fail(0, "the rule has no predecessor");
  // An @ after other characters is no symbol, because a predecessor is one module.
  const auto lives = find_outside_parentheses(parts.predecessor, '@');
  if (!lives.empty() && lives.back() > 0) {
    const std::size_t at = lives.front() > 0 ? lives.front() : lives.back();
    parts.life = trimmed(parts.predecessor.substr(at + 1));
    const std::string_view sign = parts.predecessor.substr(at);
    parts.predecessor = trimmed(parts.predecessor.substr(0, at));
    if (parts.life.empty()) {
      errors_.add(sign, "nothing follows '@'", "the life of the module: predecessor @ life -> successor");
      return false;
    }
  }
  if (!left.empty()) {
    parts.left = trimmed(text.substr(0, left[0]));
    if (parts.left.empty()) return fail(left[0], "nothing stands before '<'");
    if (parts.left == kAlways) parts.left = {};
  }
  if (!right.empty()) {
    parts.right = trimmed(text.substr(end + 1));
    if (parts.right.empty()) return fail(end, "nothing follows '>'");
    if (parts.right == kAlways) parts.right = {};
  }
  return true;
}

bool RuleReader::read_predecessor(const Parts& parts, GrammarRule& rule) {
  std::string_view rest = parts.predecessor;
  const auto module = modules_.next(rest);
  if (!module) return false;
  if (!trimmed(rest).empty()) {
    errors_.add(parts.predecessor, fmt::format("the predecessor {} has several modules", in_quotes(parts.predecessor)),
                "one module; '#symbols' declares longer names");
    return false;
  }
  rule.first_variable = static_cast<std::uint32_t>(variables_.size());
  if (!name_parameters(*module)) return false;
  rule.predecessor = modules_.letter_of(*module);
  return rule.predecessor != kNoLetter;
}

bool RuleReader::read_context(std::string_view text, bool may_branch, std::vector<ContextModule>& context) {
  bool is_good = true;
  std::vector<std::string_view> open;
  std::string_view rest = text;
  while (!trimmed(rest).empty() && !errors_.is_full()) {
    const auto module = modules_.next(rest);
    if (!module) return false;
    if (!may_branch && (module->symbol == "[" || module->symbol == "]")) {
      errors_.add(module->all, "a bracket in the left context",
                  "modules on the way to the root; side branches are skipped");
      return false;
    }
    is_good = modules_.match_bracket(*module, open) && is_good;
    ContextModule one;
    one.first_variable = static_cast<std::uint32_t>(variables_.size());
    is_good = name_parameters(*module) && is_good;
    one.letter = modules_.letter_of(*module);
    is_good = one.letter != kNoLetter && is_good;
    context.push_back(one);
  }
  modules_.report_unclosed(open);
  return is_good && open.empty() && !errors_.is_full();
}

bool RuleReader::name_parameters(const ModuleText& module) {
  bool is_good = true;
  for (const std::string_view name : module.arguments) {
    const auto fail = [&](std::string message, std::string expected) {
      errors_.add(name.empty() ? module.all : name, std::move(message), std::move(expected));
      is_good = false;
    };
    if (name.empty()) {
      fail(fmt::format("a parameter of {} has no name", in_quotes(module.all)), "a name for each, such as x");
      return false;
    }
    if (!is_identifier(name)) {
      fail(fmt::format("{} is not a name", in_quotes(name)), "a name for each parameter, such as x");
    } else if (is_builtin_name(name)) {
      fail(fmt::format("'{}' is a function or constant of every expression", name), "another name");
    } else if (std::find(variables_.begin(), variables_.end(), name) != variables_.end()) {
      fail(fmt::format("'{}' names two parameters", name), "another name");
    } else if (variables_.size() == kMaxVariables) {
      fail(fmt::format("the rule has more than {} parameters", kMaxVariables), "fewer");
      return false;
    } else {
      variables_.emplace_back(name);
    }
  }
  return is_good;
}

bool RuleReader::read_life(const Parts& parts, Kind kind, GrammarRule& rule) {
  if (parts.life.empty()) return true;
  if (kind != Kind::production) {
    errors_.add(parts.life, "a life in a rule that takes no time", "lives in the rules behind #rules alone");
    return false;
  }
  const auto refuse = [&](std::string_view where, std::string message, std::string expected) {
    errors_.add(where, std::move(message), std::move(expected));
    return false;
  };
  if (!parts.left.empty() || !parts.right.empty()) {
    return refuse(parts.left.empty() ? parts.right : parts.left, "a rule with a life sees its neighbours",
                  "a rule without contexts: modules come to their ends at different times");
  }
  if (!parts.weight.empty()) {
    return refuse(parts.weight, "a rule with a life is drawn by chance", "a rule without a weight");
  }
  rule.life = read_expression(parts.life);
  if (!rule.life) return false;
  if (rule.life->is_constant() && !(rule.life->evaluate() > 0)) {
    return refuse(parts.life, fmt::format("the life {} is not above 0", in_quotes(parts.life)), "a number above 0");
  }
  return true;
}

bool RuleReader::read_conditions(const Parts& parts, GrammarRule& rule) {
  bool is_good = true;
  if (!parts.condition.empty()) {
    rule.condition = read_expression(parts.condition, true);
    is_good = rule.condition.has_value();
    if (is_good && rule.condition->is_constant() && rule.condition->evaluate() == 0) {
      errors_.warn(parts.condition, fmt::format("the condition {} is never true", in_quotes(parts.condition)));
    }
  }
  if (!parts.weight.empty()) {
    rule.weight = read_expression(parts.weight);
    is_good = rule.weight.has_value() && is_good;
    if (rule.weight && rule.weight->is_constant() && rule.weight->evaluate() <= 0) {
      errors_.add(parts.weight, fmt::format("the weight {} is not above 0", in_quotes(parts.weight)),
                  "a number above 0");
      return false;
    }
  }
  return is_good;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Grammars for tests, built without the reader. Modules have one character each, with parameters in parentheses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

/// Rules as "left < predecessor > right : condition : weight -> successor". Only the predecessor and the arrow are
/// required.
struct GrammarText {
  std::string axiom;
  std::vector<std::string> rules;
  std::string ignored = "";
  std::vector<std::string> decomposition = {};
  std::vector<std::string> interpretation = {};
};

/// Removes the text up to and including `mark` and returns it without `mark`. Returns the whole text if it does not
/// contain `mark`.
inline std::string take_until(std::string& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  std::string part = text.substr(0, at);
  text = at == std::string::npos ? "" : text.substr(at + mark.size());
  return part;
}

inline std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// A module's symbol and the texts of its parameters.
struct ModuleText {
  std::string symbol;
  std::vector<std::string> parameters;
};

inline std::vector<ModuleText> split_modules(std::string_view text) {
  std::vector<ModuleText> modules;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == ' ') continue;
    if (text[k] != '(') {
      modules.push_back({std::string(1, text[k]), {}});
      continue;
    }
    int depth = 0;
    std::string parameter;
    for (; k < text.size(); ++k) {
      const char c = text[k];
      if (c == ')') --depth;
      if (depth == 0 && c == ')') break;
      if (depth == 1 && c == ',') {
        modules.back().parameters.push_back(parameter);
        parameter.clear();
      } else if (depth > 0) {
        parameter += c;
      }
      if (c == '(') ++depth;
    }
    modules.back().parameters.push_back(parameter);
  }
  return modules;
}

/// Builds a grammar. Letters are added at their first occurrence.
class GrammarBuilder {
 public:
  Grammar build(const GrammarText& text) {
    grammar_.open = grammar_.alphabet.add("[", 0);
    grammar_.close = grammar_.alphabet.add("]", 0);
    grammar_.cut = grammar_.alphabet.add("%", 0);
    grammar_.axiom = forms(text.axiom, {});
    add_rules(grammar_.production, text.rules);
    add_rules(grammar_.decomposition, text.decomposition);
    add_rules(grammar_.interpretation, text.interpretation);
    for (RuleSet* set : {&grammar_.production, &grammar_.decomposition, &grammar_.interpretation}) {
      set->of_letter.resize(grammar_.alphabet.size());
      for (std::uint32_t k = 0; k < set->rules.size(); ++k) set->of_letter[set->rules[k].predecessor].push_back(k);
    }
    for (std::size_t k = 0; k < grammar_.alphabet.size(); ++k) {
      const std::string& symbol = grammar_.alphabet[static_cast<LetterIndex>(k)].symbol;
      grammar_.is_ignored.push_back(text.ignored.find(symbol) != std::string::npos ? 1 : 0);
    }
    return grammar_;
  }

 private:
  LetterIndex letter(const ModuleText& module) {
    return grammar_.alphabet.add(module.symbol, static_cast<std::uint16_t>(module.parameters.size()));
  }

  std::vector<ModuleTemplate> forms(std::string_view text, const std::vector<std::string>& variables) {
    std::vector<ModuleTemplate> result;
    for (const ModuleText& module : split_modules(text)) {
      result.push_back({letter(module), {}});
      for (const std::string& parameter : module.parameters) {
        result.back().parameters.push_back(Expression::compile(parameter, {variables, {}}));
      }
    }
    return result;
  }

  std::vector<ContextModule> context(std::string_view text, std::vector<std::string>& variables) {
    std::vector<ContextModule> result;
    for (const ModuleText& module : split_modules(text)) {
      result.push_back({letter(module), static_cast<std::uint32_t>(variables.size())});
      variables.insert(variables.end(), module.parameters.begin(), module.parameters.end());
    }
    return result;
  }

  void add_rules(RuleSet& set, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      std::string successor = without_blanks(text);
      std::string condition = take_until(successor, "->");
      std::string predecessor = take_until(condition, ":");
      std::string weight = condition;
      condition = take_until(weight, ":");
      std::string left;
      if (predecessor.find('<') != std::string::npos) left = take_until(predecessor, "<");
      std::string right = predecessor;
      predecessor = take_until(right, ">");

      GrammarRule rule;
      rule.text = text;
      rule.line = static_cast<int>(set.rules.size()) + 1;
      std::vector<std::string> variables;
      rule.left = context(left, variables);
      rule.first_variable = static_cast<std::uint32_t>(variables.size());
      rule.predecessor = context(predecessor, variables).front().letter;
      rule.right = context(right, variables);
      rule.variable_count = static_cast<std::uint32_t>(variables.size());
      if (!condition.empty()) rule.condition = Expression::compile(condition, {variables, {}});
      if (!weight.empty()) rule.weight = Expression::compile(weight, {variables, {}});
      rule.successor = forms(successor, variables);
      set.rules.push_back(std::move(rule));
    }
  }

  Grammar grammar_;
};

inline Grammar build_grammar(const GrammarText& text) { return GrammarBuilder().build(text); }

}  // namespace meristem

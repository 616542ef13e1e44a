// SPDX-License-Identifier: Apache-2.0
// Prepares rules: finds the sources of variables, and separates constants, copies and formulas of successors.
#include "meristem/grow/lsystem/rule_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/grow/lsystem/grammar_text.h"

namespace meristem {

namespace {

class RulePlanner {
 public:
  RulePlanner(const Grammar& grammar, const GrammarRule& rule, std::uint64_t& streams)
      : rule_(rule), streams_(streams) {
    const auto add_variables = [&](std::uint32_t first, std::uint32_t module, LetterIndex letter) {
      for (std::uint32_t k = 0; k < grammar.alphabet[letter].arity; ++k) {
        if (sources_.size() <= first + k) sources_.resize(first + k + 1);
        sources_[first + k] = {first + k, module, k};
      }
    };
    std::uint32_t module = 0;
    add_variables(rule.first_variable, module++, rule.predecessor);
    for (const ContextModule& left : rule.left) add_variables(left.first_variable, module++, left.letter);
    for (const ContextModule& right : rule.right) add_variables(right.first_variable, module++, right.letter);
    if (rule.sees_age) sources_.push_back({rule.variable_count - 1, VariableSource::kAge, 0});
  }

  RulePlan plan() {
    plan_.rule = &rule_;
    plan_.has_context = !rule_.left.empty() || !rule_.right.empty();
    if (rule_.condition) plan_.condition = formula(*rule_.condition);
    if (rule_.life) plan_.life = formula(*rule_.life);
    if (rule_.weight) plan_.weight = formula(*rule_.weight);
    for (const ModuleTemplate& form : rule_.successor) {
      plan_.letters.push_back(form.letter);
      for (const Expression& expression : form.parameters) add_parameter(expression);
    }
    plan_.is_identity = !rule_.life && is_identity();  // a rule with a life resets the age, so it is no identity
    return std::move(plan_);
  }

 private:
  RuleFormula formula(const Expression& expression) {
    RuleFormula result{expression, ++streams_, {}, {}};
    for (const VariableSource& source : sources_) {
      if (expression.uses(source.variable)) result.sources.push_back(source);
    }
    return result;
  }

  void add_parameter(const Expression& expression) {
    const auto place = static_cast<std::uint32_t>(plan_.parameters.size());
    plan_.parameters.push_back(0);
    if (expression.is_constant()) {
      // Values that are not finite are reported by the rewriting, which knows their place.
      if (const double value = expression.evaluate(); std::isfinite(value)) {
        plan_.parameters.back() = value;
        return;
      }
    } else if (!expression.is_random()) {
      const auto [same, is_new] = formula_of_text_.try_emplace(expression.text(), plan_.formulas.size());
      if (!is_new) {
        if (same->second == kIsCopy) {
          add_copy(expression, place);
        } else {
          plan_.formulas[same->second].places.push_back(place);
        }
        return;
      }
      if (is_identifier(trimmed(expression.text()))) {
        same->second = kIsCopy;
        add_copy(expression, place);
        return;
      }
    }
    plan_.formulas.push_back(formula(expression));
    plan_.formulas.back().places.push_back(place);
  }

  void add_copy(const Expression& variable, std::uint32_t place) {
    const auto source = std::find_if(sources_.begin(), sources_.end(),
                                     [&](const VariableSource& each) { return variable.uses(each.variable); });
    plan_.copies.push_back({*source, place});
  }

  bool is_identity() const {
    if (plan_.letters.size() != 1 || plan_.letters[0] != rule_.predecessor) return false;
    if (plan_.copies.size() != plan_.parameters.size()) return false;
    return std::all_of(plan_.copies.begin(), plan_.copies.end(), [](const RulePlan::Copy& copy) {
      return copy.source.module == 0 && copy.source.parameter == copy.place;
    });
  }

  static constexpr std::size_t kIsCopy = std::numeric_limits<std::size_t>::max();

  const GrammarRule& rule_;
  std::uint64_t& streams_;
  std::vector<VariableSource> sources_;  // one per variable
  std::unordered_map<std::string, std::size_t> formula_of_text_;
  RulePlan plan_;
};

/// Returns the choice for a letter, if the letter alone decides it.
RuleChoice choice_of_letter(const std::vector<RulePlan>& rules, const std::vector<std::uint32_t>& of_letter) {
  if (of_letter.empty()) return kCopied;
  const RulePlan& first = rules[of_letter.front()];
  if (first.has_context || first.condition || first.life || first.weight) return kUndecided;
  return first.is_identity ? kCopied : static_cast<RuleChoice>(of_letter.front() + 1);
}

}  // namespace

RewritePlan::RewritePlan(const Grammar& grammar, const RuleSet& rule_set)
    : set(&rule_set), needs(context_needs(grammar, rule_set)) {
  if (rule_set.rules.size() >= kUndecided) {
    Diagnostic diagnostic;
    diagnostic.message = fmt::format("the grammar has {} rules of one kind", rule_set.rules.size());
    diagnostic.expected = fmt::format("at most {}", kUndecided - 1);
    diagnostic.line = rule_set.rules[kUndecided - 1].line;
    throw InputError(diagnostic);
  }
  std::uint64_t streams = 0;
  added_modules.push_back(0);
  added_parameters.push_back(0);
  for (const GrammarRule& rule : rule_set.rules) {
    RulePlan plan = RulePlanner(grammar, rule, streams).plan();
    plan.index = static_cast<std::uint32_t>(rules.size());
    added_modules.push_back(static_cast<std::int64_t>(plan.letters.size()) - 1);
    added_parameters.push_back(static_cast<std::int64_t>(plan.parameters.size()) -
                               grammar.alphabet[rule.predecessor].arity);
    is_random = is_random || plan.weight || (plan.condition && plan.condition->expression.is_random());
    rules.push_back(std::move(plan));
  }
  for (LetterIndex letter = 0; letter < grammar.alphabet.size(); ++letter) {
    const bool has_rules = letter < rule_set.of_letter.size();
    by_letter.push_back(has_rules ? choice_of_letter(rules, rule_set.of_letter[letter]) : kCopied);
    is_decided = is_decided && by_letter.back() != kUndecided;
  }
}

}  // namespace meristem

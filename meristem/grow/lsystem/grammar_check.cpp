// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/grammar_check.h"

#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"

namespace meristem {

namespace {

/// Finds all letters that can occur in a word. Conditions and contexts are assumed to hold.
class ReachedLetters {
 public:
  explicit ReachedLetters(const Grammar& grammar) : is_reached_(grammar.alphabet.size()) {}

  void reach(const std::vector<ModuleTemplate>& modules) {
    for (const ModuleTemplate& module : modules) {
      if (is_reached_[module.letter]) continue;
      is_reached_[module.letter] = true;
      found_.push_back(module.letter);
    }
  }
  /// Applies the rules of the sets to all letters until no new letter occurs.
  void follow(const std::vector<const RuleSet*>& sets) {
    for (std::size_t k = 0; k < found_.size(); ++k) {
      for (const RuleSet* set : sets) {
        for (const std::uint32_t rule : set->of_letter[found_[k]]) reach(set->rules[rule].successor);
      }
    }
  }
  bool operator[](LetterIndex letter) const { return is_reached_[letter]; }
  const std::vector<LetterIndex>& all() const { return found_; }

 private:
  std::vector<bool> is_reached_;
  std::vector<LetterIndex> found_;
};

/// Returns true if the rule applies to every module of its letter.
bool always_applies(const GrammarRule& rule) {
  const bool may_fail = rule.condition && !(rule.condition->is_constant() && rule.condition->evaluate() != 0);
  return !may_fail && !rule.weight && rule.left.empty() && rule.right.empty();
}

void warn_of_hidden_rules(const RuleSet& set, const std::vector<std::string_view>& places, GrammarErrors& errors) {
  for (const auto& rules : set.of_letter) {
    const auto first = std::find_if(rules.begin(), rules.end(), [&](auto k) { return always_applies(set.rules[k]); });
    if (first == rules.end()) continue;
    for (auto hidden = first + 1; hidden != rules.end(); ++hidden) {
      errors.warn(places[*hidden], fmt::format("this rule can never match: the one of line {} is always taken first",
                                               set.rules[*first].line));
    }
  }
}

/// Warns of the first context module that can never match.
void warn_of_missing_context(const Grammar& grammar, const GrammarRule& rule, std::string_view place,
                             const ReachedLetters& reached, GrammarErrors& errors) {
  for (const std::vector<ContextModule>* context : {&rule.left, &rule.right}) {
    for (const ContextModule& module : *context) {
      if (module.letter == grammar.open || module.letter == grammar.close) continue;
      const Letter& letter = grammar.alphabet[module.letter];
      if (grammar.is_ignored[module.letter] != 0) {
        return errors.warn(place, fmt::format("this rule can never match: contexts do not see {}, which is ignored",
                                              in_quotes(letter.symbol)));
      }
      if (reached[module.letter]) continue;
      return errors.warn(place, fmt::format("this rule can never match: no word has {} with {} parameters",
                                            in_quotes(letter.symbol), letter.arity));
    }
  }
}

void warn_of_unreached_rules(const Grammar& grammar, const RuleSet& set, const std::vector<std::string_view>& places,
                             const ReachedLetters& reached, GrammarErrors& errors) {
  std::map<std::string_view, std::uint16_t> arities;  // one entry per symbol that words can contain
  for (const LetterIndex letter : reached.all()) {
    arities.emplace(grammar.alphabet[letter].symbol, grammar.alphabet[letter].arity);
  }
  for (std::size_t k = 0; k < set.rules.size(); ++k) {
    const LetterIndex predecessor = set.rules[k].predecessor;
    if (reached[predecessor]) {
      warn_of_missing_context(grammar, set.rules[k], places[k], reached, errors);
      continue;
    }
    const Letter& letter = grammar.alphabet[predecessor];
    const auto other = arities.find(letter.symbol);
    if (other == arities.end()) {
      errors.warn(places[k], fmt::format("this rule can never match: no word has {}", in_quotes(letter.symbol)));
    } else {
      errors.warn(places[k],
                  fmt::format("this rule can never match: words have {} with another number of parameters than {}",
                              in_quotes(letter.symbol), letter.arity),
                  fmt::format("as many as {}", other->second));
    }
  }
}

}  // namespace

void warn_of_idle_rules(const Grammar& grammar, const RuleTexts& places, GrammarErrors& errors) {
  ReachedLetters reached(grammar);
  reached.reach(grammar.axiom);
  reached.follow({&grammar.production, &grammar.decomposition});
  warn_of_unreached_rules(grammar, grammar.production, places.production, reached, errors);
  warn_of_unreached_rules(grammar, grammar.decomposition, places.decomposition, reached, errors);
  reached.follow({&grammar.interpretation});
  warn_of_unreached_rules(grammar, grammar.interpretation, places.interpretation, reached, errors);

  warn_of_hidden_rules(grammar.production, places.production, errors);
  warn_of_hidden_rules(grammar.decomposition, places.decomposition, errors);
  warn_of_hidden_rules(grammar.interpretation, places.interpretation, errors);
}

}  // namespace meristem

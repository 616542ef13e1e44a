// SPDX-License-Identifier: Apache-2.0
// Applies the rules to counts of letters instead of words. See word_forecast.h.
#include "meristem/grow/lsystem/word_forecast.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "meristem/grow/lsystem/rule_errors.h"

namespace meristem {

namespace {

/// Limits the work of a forecast to some milliseconds, measured in letters of successors.
constexpr std::size_t kMaxWork = 4'000'000;

using Counts = std::vector<double>;  // by letter

/// A number of modules with one letter.
struct LetterCount {
  LetterIndex letter = kNoLetter;
  double count = 0;
};

/// Counts each letter, in the order of the letters.
std::vector<LetterCount> counted(std::vector<LetterIndex> letters) {
  std::ranges::sort(letters);
  std::vector<LetterCount> counts;
  for (const LetterIndex letter : letters) {
    if (counts.empty() || counts.back().letter != letter) counts.push_back({letter, 0});
    counts.back().count += 1;
  }
  return counts;
}

std::vector<LetterCount> counted(const std::vector<ModuleTemplate>& modules) {
  std::vector<LetterIndex> letters;
  for (const ModuleTemplate& module : modules) letters.push_back(module.letter);
  return counted(std::move(letters));
}

/// Reduces `counts` to the minimum of `counts` and `others`.
void keep_common(std::vector<LetterCount>& counts, const std::vector<LetterCount>& others) {
  auto other = others.begin();
  for (LetterCount& own : counts) {
    while (other != others.end() && other->letter < own.letter) ++other;
    const bool is_shared = other != others.end() && other->letter == own.letter;
    own.count = is_shared ? std::min(own.count, other->count) : 0;
  }
  std::erase_if(counts, [](const LetterCount& own) { return own.count == 0; });
}

/// Returns the smallest successor of a letter: the successor of its rule, or the common part of all of its rules and of
/// the unchanged letter.
std::vector<LetterCount> min_successor(const RewritePlan& production, LetterIndex letter) {
  const RuleChoice choice = production.by_letter[letter];
  if (choice != kCopied && choice != kUndecided) return counted(production.rules[choice - 1].letters);
  std::vector<LetterCount> min{{letter, 1}};
  if (choice == kCopied) return min;
  for (const std::uint32_t rule : production.set->of_letter[letter]) {
    keep_common(min, counted(production.set->rules[rule].successor));
  }
  return min;
}

double sum_of(const Counts& counts) {
  double sum = 0;
  for (const double count : counts) sum += count;
  return sum;
}

/// Returns the rule whose successors add most modules to a word with these letters, or null if no rule adds any.
const GrammarRule* longest_rule(const RewritePlan& production, const Counts& counts) {
  const GrammarRule* longest = nullptr;
  double max = 0;
  for (std::size_t letter = 0; letter < counts.size(); ++letter) {
    const RuleChoice choice = production.by_letter[letter];
    if (choice == kCopied || choice == kUndecided) continue;
    const double added = counts[letter] * static_cast<double>(production.added_modules[choice]);
    if (added > max) {
      max = added;
      longest = production.rules[choice - 1].rule;
    }
  }
  return longest;
}

/// The known facts about a letter of a timed grammar: its life and its successor.
struct TimedLetter {
  std::optional<double> life;  // unset: no known replacement
  std::vector<LetterCount> successor;
  const GrammarRule* rule = nullptr;  // the rule that replaces it
  bool stays = true;  // for letters without a known life: true if every rule keeps at least one module of the letter
};

TimedLetter timed_letter(const RewritePlan& production, LetterIndex letter) {
  const bool has_rules = letter < production.set->of_letter.size() && !production.set->of_letter[letter].empty();
  if (!has_rules) return {};
  const GrammarRule& first = production.set->rules[production.set->of_letter[letter].front()];
  const bool is_known = first.life && first.life->is_constant() && !first.condition && !first.weight &&
                        first.left.empty() && first.right.empty();
  if (const double life = is_known ? first.life->evaluate() : 0; life > 0 && std::isfinite(life)) {
    return {life, counted(first.successor), &first};
  }
  const std::vector<LetterCount> min = min_successor(production, letter);
  return {{}, {}, nullptr, std::ranges::any_of(min, [&](LetterCount one) { return one.letter == letter; })};
}

/// Modules that will be replaced, by birth and letter, and the number of all other modules.
struct TimedCounts {
  std::map<std::pair<double, LetterIndex>, double> living;
  double resting = 0;

  void add(const TimedLetter& what, LetterIndex letter, double birth, double count, double until) {
    if (what.life && birth + *what.life <= until) {
      living[{birth, letter}] += count;
    } else if (what.life || what.stays) {
      resting += count;
    }
  }
};

bool has_cut(const Grammar& grammar) {
  const auto cuts = [&](const ModuleTemplate& module) { return module.letter == grammar.cut; };
  if (std::ranges::any_of(grammar.axiom, cuts)) return true;
  return std::ranges::any_of(grammar.production.rules,
                             [&](const GrammarRule& rule) { return std::ranges::any_of(rule.successor, cuts); });
}

}  // namespace

void require_bounded_words(const Grammar& grammar, const RewritePlan& production, int steps, const SizeLimits& limits) {
  if (!grammar.decomposition.rules.empty() || has_cut(grammar)) return;
  const std::size_t alphabet_size = production.by_letter.size();
  std::vector<std::vector<LetterCount>> successors;
  std::size_t work_per_step = alphabet_size;
  for (std::size_t letter = 0; letter < alphabet_size; ++letter) {
    successors.push_back(min_successor(production, static_cast<LetterIndex>(letter)));
    work_per_step += successors.back().size();
  }

  Counts counts(alphabet_size);
  for (const LetterCount& of_axiom : counted(grammar.axiom)) counts[of_axiom.letter] = of_axiom.count;
  const auto max_steps = static_cast<int>(std::min<std::size_t>(kMaxWork / work_per_step, kMaxSteps));
  for (int step = 0; step < std::min(steps, max_steps); ++step) {
    Counts next(alphabet_size);
    for (std::size_t letter = 0; letter < alphabet_size; ++letter) {
      if (counts[letter] == 0) continue;
      for (const LetterCount& made : successors[letter]) next[made.letter] += counts[letter] * made.count;
    }
    const double modules = sum_of(next);
    if (modules > static_cast<double>(limits.modules)) {
      const GrammarRule* longest = longest_rule(production, counts);
      if (longest == nullptr) return;  // the axiom is too long
      throw_word_too_long("modules of a word", modules, limits.modules, *longest);
    }
    if (next == counts) return;
    counts = std::move(next);
  }
}

void require_bounded_timed_words(const Grammar& grammar, const RewritePlan& production, double until,
                                 const SizeLimits& limits) {
  if (has_cut(grammar)) return;
  std::vector<TimedLetter> letters;
  for (std::size_t letter = 0; letter < production.by_letter.size(); ++letter) {
    letters.push_back(timed_letter(production, static_cast<LetterIndex>(letter)));
  }
  TimedCounts counts;
  for (const LetterCount& of_axiom : counted(grammar.axiom)) {
    counts.add(letters[of_axiom.letter], of_axiom.letter, 0, of_axiom.count, until);
  }

  // Replace one generation after another, as the derivation does.
  std::size_t work = 0;
  while (!counts.living.empty() && work < kMaxWork) {
    TimedCounts next{{}, counts.resting};
    double max = 0;
    const GrammarRule* longest = nullptr;
    for (const auto& [of, count] : counts.living) {
      const TimedLetter& dying = letters[of.second];
      const double birth = of.first + *dying.life;
      for (const LetterCount& made : dying.successor) {
        next.add(letters[made.letter], made.letter, birth, count * made.count, until);
      }
      work += dying.successor.size() + 1;
      const double added = count * (static_cast<double>(dying.rule->successor.size()) - 1);
      if (added > max) {
        max = added;
        longest = dying.rule;
      }
    }
    double modules = next.resting;
    for (const auto& [of, count] : next.living) modules += count;
    if (modules > static_cast<double>(limits.modules) && longest != nullptr) {
      throw_word_too_long("modules of a word", modules, limits.modules, *longest);
    }
    counts = std::move(next);
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Derives words: rewrites all modules in parallel, step by step, then applies decompositions until none applies. In
// timed grammars, modules are replaced when their lives end. See derive.h.
#include "meristem/grow/lsystem/derive.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"
#include "meristem/grow/lsystem/rewrite.h"
#include "meristem/grow/lsystem/rule_errors.h"
#include "meristem/grow/lsystem/word_forecast.h"

namespace meristem {

namespace {

/// Number of rounds after which rules that still apply are treated as endless.
constexpr std::uint64_t kMaxRounds = 1'000;
constexpr double kSoonEnough = 1e-9;  // relative to the time: tolerance for the rounding of lives
// Interpretation modules are as old as the modules that they draw.
constexpr Births kInherited{.all_are_inherited = true};

Word axiom_word(const Grammar& grammar, const SizeLimits& limits) {
  Word word;
  if (grammar.axiom.size() > limits.modules) {
    throw_limit("modules of an axiom", static_cast<double>(grammar.axiom.size()), limits.modules, "modules", "");
  }
  for (const ModuleTemplate& form : grammar.axiom) {
    word.letters.push_back(form.letter);
    for (const Expression& expression : form.parameters) {
      word.parameters.push_back(expression.evaluate());
      if (std::isfinite(word.parameters.back())) continue;
      Diagnostic diagnostic;
      diagnostic.message = fmt::format("{} in the axiom is not a finite number", in_quotes(expression.text()));
      diagnostic.expected = "an axiom without a division by zero";
      throw InputError(diagnostic);
    }
  }
  return word;
}

/// Removes each % and everything after it up to the ] of its branch. Returns true if there was any.
bool cut_branches(const Grammar& grammar, Word& word, const Progress& progress) {
  const auto first = std::find(word.letters.begin(), word.letters.end(), grammar.cut);
  if (first == word.letters.end()) return false;
  std::size_t kept = 0;
  std::size_t kept_parameters = 0;
  std::size_t in = 0;
  bool is_cutting = false;
  std::size_t depth = 0;  // of branches within the removed part
  for (std::size_t k = 0; k < word.letters.size(); ++k) {
    if (k % 65'536 == 0) progress.check();
    const LetterIndex letter = word.letters[k];
    const std::size_t arity = grammar.alphabet[letter].arity;
    if (!is_cutting && letter == grammar.cut) {
      is_cutting = true;
      depth = 0;
    } else if (is_cutting && letter == grammar.open) {
      ++depth;
    } else if (is_cutting && letter == grammar.close) {
      if (depth == 0) is_cutting = false;
      if (depth > 0) --depth;
    }
    if (!is_cutting) {
      word.letters[kept++] = letter;
      if (!word.births.empty()) word.births[kept - 1] = word.births[k];
      for (std::size_t p = 0; p < arity; ++p) word.parameters[kept_parameters++] = word.parameters[in + p];
    }
    in += arity;
  }
  word.letters.resize(kept);
  if (!word.births.empty()) word.births.resize(kept);
  word.parameters.resize(kept_parameters);
  return true;
}

/// Rewrites `word`, using `next` as a buffer, until no rule applies. Returns true if any rule applied, or may apply
/// with other random numbers.
bool rewrite_to_end(Rewriter& rewriter, const RewritePlan& plan, RandomKey key, std::string_view stage, Word& word,
                    Word& next, Births births) {
  if (plan.rules.empty()) return false;
  for (std::uint64_t round = 0;; ++round) {
    const RewriteOutcome outcome = rewriter.rewrite(plan, word, key.child(round), stage, next, births);
    if (outcome.rule == nullptr) return round > 0 || outcome.may_change;
    if (round == kMaxRounds) {
      throw_rule_error(*outcome.rule,
                       fmt::format("after {} rounds {} still applies", kMaxRounds, in_quotes(outcome.rule->text)),
                       "decompositions and interpretations that come to an end");
    }
    std::swap(word, next);
  }
}

/// Replaces all modules whose lives end by the time `end`, and their successors, until none is left. Rules depend on
/// neither neighbours nor random numbers, so the order does not matter.
Word timed_word(const Grammar& grammar, double end, RandomKey key, const SizeLimits& limits, Progress& progress) {
  const RewritePlan production(grammar, grammar.production);
  const Births births{.by_life = true, .until = end + kSoonEnough * (1 + std::abs(end))};
  require_bounded_timed_words(grammar, production, births.until, limits);
  Rewriter rewriter(grammar, limits, progress);
  Word word = axiom_word(grammar, limits);
  word.births.assign(word.module_count(), 0);
  Word next;
  for (int round = 0;; ++round) {
    const RewriteOutcome outcome = rewriter.rewrite(production, word, key, "deriving", next, births);
    if (outcome.rule == nullptr) break;
    if (round == kMaxSteps) {
      throw_rule_error(*outcome.rule, fmt::format("modules have lived one after another {} times", kMaxSteps),
                       "longer lives, or an earlier time");
    }
    std::swap(word, next);
  }
  cut_branches(grammar, word, progress);
  word.time = end;
  return word;
}

Word derived_word(const Grammar& grammar, double time, RandomKey key, const SizeLimits& limits, Progress& progress,
                  KeepBirths keep) {
  if (grammar.is_timed) return timed_word(grammar, time, key, limits, progress);
  const int steps = static_cast<int>(time);
  const RewritePlan production(grammar, grammar.production);
  const RewritePlan decomposition(grammar, grammar.decomposition);
  require_bounded_words(grammar, production, steps, limits);
  Rewriter rewriter(grammar, limits, progress);
  Word word = axiom_word(grammar, limits);
  if (keep == KeepBirths::yes || grammar.asks_ages) word.births.assign(word.module_count(), 0);
  Word next;
  for (int step = 0; step < steps; ++step) {
    const RandomKey step_key = key.child(static_cast<std::uint64_t>(step));
    const Births births{.step = step + 1.0};
    bool may_go_on = cut_branches(grammar, word, progress);
    const RewriteOutcome outcome = rewriter.rewrite(production, word, step_key, "deriving", next, births);
    if (outcome.rule != nullptr) std::swap(word, next);
    may_go_on = may_go_on || outcome.rule != nullptr || outcome.may_change;
    const RandomKey round_key = step_key.child("decomposition");
    if (rewrite_to_end(rewriter, decomposition, round_key, "decomposing", word, next, births)) may_go_on = true;
    if (!may_go_on) break;
  }
  word.time = time;
  return word;
}

Word interpreted_word(const Grammar& grammar, const Word& word, RandomKey key, const SizeLimits& limits,
                      Progress& progress) {
  const RewritePlan interpretation(grammar, grammar.interpretation);
  const RandomKey interpretation_key = key.child("interpretation");
  Rewriter rewriter(grammar, limits, progress);
  // The first round reads the original word without copying it.
  Word first;
  first.time = word.time;
  const RewriteOutcome outcome =
      rewriter.rewrite(interpretation, word, interpretation_key.child("first"), "interpreting", first, kInherited);
  if (outcome.rule == nullptr) return word;
  Word next;
  next.time = word.time;
  rewrite_to_end(rewriter, interpretation, interpretation_key, "interpreting", first, next, kInherited);
  return first;
}

/// Calls `call` and adds the grammar's file to its errors, which only have lines.
template <class Call>
Word naming_file(const Grammar& grammar, Call call) {
  try {
    return call();
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& diagnostic : diagnostics) diagnostic.file = grammar.file;
    throw InputError(std::move(diagnostics));
  }
}

}  // namespace

Word derive(const Grammar& grammar, double steps, RandomKey key, const SizeLimits& limits, Progress& progress) {
  return naming_file(grammar, [&] { return derived_word(grammar, steps, key, limits, progress, KeepBirths::no); });
}

Word interpreted(const Grammar& grammar, const Word& word, RandomKey key, const SizeLimits& limits,
                 Progress& progress) {
  if (grammar.interpretation.rules.empty()) return word;
  return naming_file(grammar, [&] { return interpreted_word(grammar, word, key, limits, progress); });
}

Word derive_drawn(const Grammar& grammar, double steps, RandomKey key, const SizeLimits& limits, Progress& progress,
                  KeepBirths births) {
  Word word = naming_file(grammar, [&] { return derived_word(grammar, steps, key, limits, progress, births); });
  if (grammar.interpretation.rules.empty()) return word;
  return interpreted(grammar, word, key, limits, progress);
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Two passes over chunks of the word: choose rules and count, then write letters and parameters in parallel. See
// rewrite.h.
#include "meristem/grow/lsystem/rewrite.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/lsystem/rule_chooser.h"
#include "meristem/grow/lsystem/rule_errors.h"

namespace meristem {

namespace {

constexpr std::size_t kModulesBetweenChecks = 65'536;

/// Resizes a column without keeping its values. Memory that is too small is freed before new memory is allocated.
template <typename Item>
void make_room(WordColumn<Item>& items, std::size_t count) {
  if (items.capacity() < count) items = {};
  items.resize(count);
}

/// Copies items. For a few items, a loop is faster than a call of memcpy.
template <typename Item>
void copy_items(const Item* from, std::size_t count, Item* to) {
  if (count > 16) {
    std::copy_n(from, count, to);
  } else {
    for (std::size_t k = 0; k < count; ++k) to[k] = from[k];
  }
}

}  // namespace

struct Rewriter::Scratch {
  RuleChooser chooser;
  RuleBatch batch;
  std::vector<std::vector<Lane>> lanes;  // by rule
  std::vector<RuleChoice> rules;         // rules that have lanes
};

/// Scratch memory for the duration of a chunk.
class Rewriter::Lease {
 public:
  explicit Lease(Rewriter& owner) : owner_(owner) {
    const std::lock_guard lock(owner.mutex_);
    if (owner.scratch_.empty()) {
      scratch_ = std::make_unique<Scratch>();
    } else {
      scratch_ = std::move(owner.scratch_.back());
      owner.scratch_.pop_back();
    }
  }
  ~Lease() {
    const std::lock_guard lock(owner_.mutex_);
    owner_.scratch_.push_back(std::move(scratch_));
  }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

  Scratch& operator*() { return *scratch_; }
  Scratch* operator->() { return scratch_.get(); }

 private:
  Rewriter& owner_;
  std::unique_ptr<Scratch> scratch_;
};

Rewriter::Rewriter(const Grammar& grammar, const SizeLimits& limits, Progress& progress)
    : grammar_(grammar), limits_(limits), progress_(progress) {
  for (std::size_t k = 0; k < grammar.alphabet.size(); ++k) {
    arities_.push_back(grammar.alphabet[static_cast<LetterIndex>(k)].arity);
  }
}

Rewriter::~Rewriter() = default;

/// Rewrites in two passes over chunks of kChunk modules, each on all threads. The first pass chooses a rule for each
/// module. The rule determines how many modules and parameters replace the module, so sums over the chunks give the
/// length of the new word and the position at which each chunk of it begins. The second pass writes all chunks at the
/// same time. Expressions of successors are evaluated last, together for all modules of a chunk that one rule replaces.
///
/// A rule is chosen by the old word and by random numbers of the module's position only. Threads and the order of
/// chunks therefore do not change the result.
RewriteOutcome Rewriter::rewrite(const RewritePlan& plan, const Word& word, RandomKey key, std::string_view stage,
                                 Word& next, Births births) {
  progress_.begin(stage, word.module_count());
  progress_.check();

  // Choose the rule of each module.
  places_.find(word, arities_, progress_);
  if (plan.needs.any()) context_.find(grammar_, word.letters, plan.needs, progress_);
  const OldWord old{word, context_, places_, key};
  make_room(choices_, word.module_count());
  make_room(ends_, births.by_life ? word.module_count() : 0);
  chunks_.assign((word.module_count() + kChunk - 1) / kChunk, {});
  parallel_for(word.module_count(), kChunk, [&](std::size_t begin, std::size_t end) {
    progress_.check();
    Lease scratch(*this);
    const std::optional<LifeSpan> lives =
        births.by_life ? std::optional(LifeSpan{.until = births.until, .ends = ends_}) : std::nullopt;
    const bool had_candidates = scratch->chooser.choose(plan, old, arities_, begin, end, choices_, lives, progress_);
    chunks_[begin / kChunk].may_change = plan.is_random && had_candidates;
    count(plan, word, begin, end);
  });

  // Compute the length of the new word and the begin of each chunk.
  RewriteOutcome outcome;
  std::size_t modules = 0;
  std::size_t parameters = 0;
  for (Chunk& chunk : chunks_) {
    if (outcome.rule == nullptr) outcome.rule = chunk.rule;
    outcome.may_change = outcome.may_change || chunk.may_change;
    modules += std::exchange(chunk.modules, modules);
    parameters += std::exchange(chunk.parameters, parameters);
  }
  if (outcome.rule == nullptr) return outcome;
  require_room(plan, modules, parameters);

  // Write the new word.
  next.letters.clear();
  next.parameters.clear();
  make_room(next.letters, modules);
  make_room(next.parameters, parameters);
  const bool keeps_births = !word.births.empty();
  next.births.clear();
  if (keeps_births) next.births.resize(modules);
  parallel_for(word.module_count(), kChunk, [&](std::size_t begin, std::size_t end) {
    Lease scratch(*this);
    write_letters(plan, old, begin, end, *scratch, next);
    if (keeps_births) write_births(plan, word, begin, end, births, next);
    for (const RuleChoice choice : scratch->rules) {
      std::vector<Lane>& lanes = scratch->lanes[choice];
      write_parameters(plan.rules[choice - 1], old, lanes, scratch->batch, next.parameters.data());
      lanes.clear();
    }
    scratch->rules.clear();
    progress_.advance(end - begin);
  });
  return outcome;
}

void Rewriter::count(const RewritePlan& plan, const Word& word, std::size_t begin, std::size_t end) {
  Chunk& chunk = chunks_[begin / kChunk];
  std::int64_t modules = 0;
  std::int64_t parameters = 0;
  RuleChoice rule = kCopied;
  for (std::size_t k = begin; k < end; ++k) {
    const RuleChoice choice = choices_[k];
    if (choice == kCopied) continue;
    if (rule == kCopied) rule = choice;
    modules += plan.added_modules[choice];
    parameters += plan.added_parameters[choice];
  }
  if (rule != kCopied) chunk.rule = plan.rules[rule - 1].rule;
  const std::size_t old_parameters = places_.of_chunk(begin / kChunk + 1) - places_.of_chunk(begin / kChunk);
  chunk.modules =
      static_cast<std::size_t>(static_cast<std::int64_t>(std::min(end, word.module_count()) - begin) + modules);
  chunk.parameters = static_cast<std::size_t>(static_cast<std::int64_t>(old_parameters) + parameters);
}

void Rewriter::require_room(const RewritePlan& plan, std::size_t modules, std::size_t parameters) const {
  const std::uint64_t limit = std::min<std::uint64_t>(limits_.modules, kNoModule - 1);
  if (modules <= limit && parameters <= limit) return;
  const bool too_many_modules = modules > limit;
  // Find the rule that adds most.
  const std::vector<std::int64_t>& added = too_many_modules ? plan.added_modules : plan.added_parameters;
  std::vector<std::int64_t> added_by(added.size());
  for (const RuleChoice choice : choices_) added_by[choice] += added[choice];
  const auto max = std::max_element(added_by.begin() + 1, added_by.end());
  const GrammarRule& rule = *plan.rules[static_cast<std::size_t>(max - added_by.begin() - 1)].rule;
  throw_word_too_long(too_many_modules ? "modules of a word" : "parameters of a word",
                      static_cast<double>(too_many_modules ? modules : parameters), limit, rule);
}

void Rewriter::write_letters(const RewritePlan& plan, const OldWord& old, std::size_t begin, std::size_t end,
                             Scratch& scratch, Word& next) const {
  const Chunk& chunk = chunks_[begin / kChunk];
  const LetterIndex* const letters = old.word.letters.data();
  const double* const parameters = old.word.parameters.data();
  const RuleChoice* const choices = choices_.data();
  const std::uint16_t* const arities = arities_.data();
  double* const parameters_out = next.parameters.data();
  LetterIndex* letters_out = next.letters.data() + chunk.modules;
  std::size_t out = chunk.parameters;
  std::size_t in = old.places.of_chunk(begin / kChunk);
  scratch.lanes.resize(plan.rules.size() + 1);
  std::size_t written = 0;
  for (std::size_t k = begin; k < end;) {
    // Copy the modules up to the next one that is replaced.
    const std::size_t first_in = in;
    for (; k < end && choices[k] == kCopied; ++k) {
      *letters_out++ = letters[k];
      in += arities[letters[k]];
    }
    copy_items(parameters + first_in, in - first_in, parameters_out + out);
    out += in - first_in;
    if (k == end) break;

    // Replace it. Its expressions are evaluated later, together with others.
    const RuleChoice choice = choices[k];
    const RulePlan& rule = plan.rules[choice - 1];
    copy_items(rule.letters.data(), rule.letters.size(), letters_out);
    copy_items(rule.parameters.data(), rule.parameters.size(), parameters_out + out);
    if (!rule.is_constant()) {
      std::vector<Lane>& lanes = scratch.lanes[choice];
      if (lanes.empty()) scratch.rules.push_back(choice);
      lanes.push_back({static_cast<std::uint32_t>(k), in, out});
    }
    letters_out += rule.letters.size();
    out += rule.parameters.size();
    in += arities[letters[k]];
    ++k;
    written += rule.letters.size();
    if (written >= kModulesBetweenChecks) {
      progress_.check();
      written = 0;
    }
  }
}

/// Writes the births of the new modules. A module of the successor continues the predecessor, and inherits its birth,
/// if it has the predecessor's letter and is outside brackets.
void Rewriter::write_births(const RewritePlan& plan, const Word& word, std::size_t begin, std::size_t end,
                            Births births, Word& next) const {
  double* out = next.births.data() + chunks_[begin / kChunk].modules;
  for (std::size_t k = begin; k < end; ++k) {
    if (choices_[k] == kCopied) {
      *out++ = word.births[k];
      continue;
    }
    if (births.by_life) {
      out = std::fill_n(out, plan.rules[choices_[k] - 1].letters.size(), ends_[k]);
      continue;
    }
    int depth = 0;
    for (const LetterIndex letter : plan.rules[choices_[k] - 1].letters) {
      if (letter == grammar_.open) ++depth;
      const bool goes_on = letter == word.letters[k] && depth == 0;
      *out++ = goes_on || births.all_are_inherited ? word.births[k] : births.step;
      if (letter == grammar_.close) --depth;
    }
  }
}

void Rewriter::write_parameters(const RulePlan& plan, const OldWord& old, std::vector<Lane>& lanes, RuleBatch& batch,
                                double* parameters) const {
  for (std::size_t begin = 0; begin < lanes.size(); begin += RuleBatch::kLanes) {
    const auto some = std::span<const Lane>(lanes).subspan(begin, std::min(RuleBatch::kLanes, lanes.size() - begin));
    const auto scatter = [&](std::span<const double> values, std::uint32_t place) {
      double* const at = parameters + place;
      for (std::size_t k = 0; k < some.size(); ++k) at[some[k].out] = values[k];
    };
    progress_.check();
    batch.begin(old, plan, some);
    for (const RulePlan::Copy& copy : plan.copies) scatter(batch.values(copy.source), copy.place);
    for (const RuleFormula& formula : plan.formulas) {
      progress_.check();
      const std::span<const double> values = batch.values(formula);
      require_finite(values, *plan.rule, formula);
      for (const std::uint32_t place : formula.places) scatter(values, place);
    }
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// One rewriting of a whole word, in two passes over fixed chunks of it: the first chooses each module's rule and counts
// what the chunk grows to, so that the second can write letters and parameters where they belong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/grow/lsystem/rule_batch.h"
#include "meristem/grow/lsystem/rule_plan.h"
#include "meristem/grow/lsystem/word.h"
#include "meristem/grow/lsystem/word_context.h"

namespace meristem {

struct RewriteOutcome {
  const Rule* rule = nullptr;  ///< the first that was applied, by position; null if nothing changed
  bool may_change = false;     ///< another draw may apply other rules
};

/// When the modules of a successor have come about, in words that keep it.
struct Births {
  double step = 0;                 ///< that of the rewriting
  bool all_are_inherited = false;  ///< from what they replace; else those alone that go on from it
  bool by_life = false;            ///< when what they replace comes to the end of its life, if that is
  double until = 0;                ///< by then: else it is not replaced
};

/// Rewrites words of one grammar; its memory serves one word after another. Beside the old word and the new one that
/// is 2 bytes per module, and 4 for each kind of neighbours that contexts ask for.
class Rewriter {
 public:
  /// All three must outlive it.
  Rewriter(const Grammar& grammar, const Limits& limits, Progress& progress);
  ~Rewriter();

  /// `next` becomes what `word` is rewritten to; it is left alone if nothing changes. Throws InputError and Cancelled.
  RewriteOutcome rewrite(const RewritePlan& plan, const Word& word, RandomKey key, std::string_view stage, Word& next,
                         Births births = {});

 private:
  struct Scratch;
  class Lease;

  /// What a chunk of the word becomes: first how much, then where it begins.
  struct Chunk {
    std::size_t modules = 0;
    std::size_t parameters = 0;
    bool may_change = false;
    const Rule* rule = nullptr;
  };

  void count(const RewritePlan& plan, const Word& word, std::size_t begin, std::size_t end);
  void require_room(const RewritePlan& plan, std::size_t modules, std::size_t parameters) const;
  void write_letters(const RewritePlan& plan, const OldWord& old, std::size_t begin, std::size_t end, Scratch& scratch,
                     Word& next) const;
  void write_births(const RewritePlan& plan, const Word& word, std::size_t begin, std::size_t end, Births births,
                    Word& next) const;
  void write_parameters(const RulePlan& plan, const OldWord& old, std::vector<Lane>& lanes, RuleBatch& batch,
                        double* parameters) const;

  const Grammar& grammar_;
  const Limits& limits_;
  Progress& progress_;
  std::vector<std::uint16_t> arities_;
  WordColumn<RuleChoice> choices_;
  WordColumn<double> ends_;  // of the lives of modules that are replaced, where births are by life
  std::vector<Chunk> chunks_;
  ParameterOffsets places_;
  WordContext context_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> scratch_;  // what no thread uses
};

}  // namespace meristem

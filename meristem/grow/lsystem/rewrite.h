// SPDX-License-Identifier: Apache-2.0
// Rewrites a whole word once, in two passes over fixed chunks. The first pass chooses each module's rule and counts the
// size of the chunk's result. The second pass writes letters and parameters to their final positions.
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
  const GrammarRule* rule = nullptr;  ///< the first applied rule, by position; null if nothing changed
  bool may_change = false;            ///< true: other random numbers may apply other rules
};

/// How the births of successor modules are computed, in words that store births.
struct Births {
  double step = 0;  ///< step of the rewriting
  /// True: all modules inherit the birth of their predecessor; false: only continuing modules do.
  bool all_are_inherited = false;
  bool by_life = false;  ///< true: the birth is the end of the predecessor's life, if it ends in time
  double until = 0;      ///< end of that time; modules with longer lives are not replaced
};

/// Rewrites words of one grammar and reuses its memory from word to word. In addition to the old and the new word, it
/// needs 2 bytes per module, and 4 bytes per module for each kind of neighbour that contexts use.
class Rewriter {
 public:
  /// All three arguments must outlive this object.
  Rewriter(const Grammar& grammar, const SizeLimits& limits, Progress& progress);
  ~Rewriter();

  /// Writes the result of rewriting `word` to `next`. Leaves `next` unchanged if nothing changes. Throws InputError and
  /// Cancelled.
  RewriteOutcome rewrite(const RewritePlan& plan, const Word& word, RandomKey key, std::string_view stage, Word& next,
                         Births births = {});

 private:
  struct Scratch;
  class Lease;

  /// The result of a chunk: first its size, later its begin.
  struct Chunk {
    std::size_t modules = 0;
    std::size_t parameters = 0;
    bool may_change = false;
    const GrammarRule* rule = nullptr;
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
  const SizeLimits& limits_;
  Progress& progress_;
  std::vector<std::uint16_t> arities_;
  WordColumn<RuleChoice> choices_;
  WordColumn<double> ends_;  // ends of the lives of replaced modules, in timed grammars
  std::vector<Chunk> chunks_;
  ParameterOffsets places_;
  WordContext context_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> scratch_;  // scratch memory that no thread uses
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/word.h"

namespace meristem {

/// The grammar's word after `steps` steps, which are whole; fewer where it can change no more. All modules of a word
/// are rewritten at once. The word of a timed grammar is the one at the time `steps`, which may have a fraction. Draws
/// depend on key, step and position alone, so the word is the same on any number of threads.
///
/// Throws InputError, with the grammar's file and the rule's line, for parameters that are not finite, decompositions
/// without an end, lives that are not above 0, and words beyond the limits: before the memory is spent, naming the rule
/// that adds most. Throws Cancelled.
Word derive(const Grammar& grammar, double steps, RandomKey key, const Limits& limits, Progress& progress);

/// Whether a word keeps the steps in which its modules have come about.
enum class KeepBirths { no, yes };

/// The word as it is drawn: with the grammar's interpretation rules applied. Throws what `derive` throws.
Word interpreted(const Grammar& grammar, const Word& word, RandomKey key, const Limits& limits, Progress& progress);

/// Both: the word after `steps` steps as it is drawn.
Word derive_drawn(const Grammar& grammar, double steps, RandomKey key, const Limits& limits, Progress& progress,
                  KeepBirths births = KeepBirths::no);

}  // namespace meristem

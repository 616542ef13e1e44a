// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/word.h"

namespace meristem {

/// Returns the grammar's word after `steps` steps, a whole number. Ends early if the word can no longer change. All
/// modules of a word are rewritten in parallel. For a timed grammar, `steps` is the time and may be fractional. Random
/// numbers depend only on key, step and position, so the word does not depend on the number of threads.
///
/// Throws InputError, with the grammar's file and the rule's line, for parameters that are not finite, endless
/// decompositions, and lives that are not above 0. If a word would exceed the limits, throws InputError before the
/// memory is used and names the rule that adds most. Throws Cancelled.
Word derive(const Grammar& grammar, double steps, RandomKey key, const SizeLimits& limits, Progress& progress);

/// Whether a word stores the step in which each module was created.
enum class KeepBirths { no, yes };

/// Returns the word for drawing: applies the grammar's interpretation rules. Throws what derive() throws.
Word interpreted(const Grammar& grammar, const Word& word, RandomKey key, const SizeLimits& limits, Progress& progress);

/// Returns interpreted(derive(...)): the word after `steps` steps for drawing.
Word derive_drawn(const Grammar& grammar, double steps, RandomKey key, const SizeLimits& limits, Progress& progress,
                  KeepBirths births = KeepBirths::no);

}  // namespace meristem

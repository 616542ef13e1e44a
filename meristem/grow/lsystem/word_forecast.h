// SPDX-License-Identifier: Apache-2.0
// Computes how long words become before they are derived. A step replaces each letter by the letters of its successor,
// so counts of letters determine the next counts. The cost depends only on the length of the rules.
#pragma once

#include "meristem/base/limits.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/rule_plan.h"

namespace meristem {

/// Throws the InputError of deriving `steps` steps from the axiom if counts of letters prove that a word exceeds
/// limits.modules. If the rules of a letter also depend on parameters, neighbours or random numbers, only the common
/// part of all its rules is counted. The forecast is therefore never too long. It does not cover grammars that
/// decompose or cut words, nor steps after the first few thousand.
void require_bounded_words(const Grammar& grammar, const RewritePlan& production, int steps, const SizeLimits& limits);

/// Like require_bounded_words(), for a timed grammar that replaces modules whose lives end until the time `until`.
/// Counts modules by letter and birth. A letter is known to be replaced only if its first rule has a constant life and
/// no condition. For other letters, only the common part of all their rules is counted.
void require_bounded_timed_words(const Grammar& grammar, const RewritePlan& production, double until,
                                 const SizeLimits& limits);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// How long words become, told from their letters before any is made. A step takes each letter to the letters of its
// successor, so counts of letters follow from counts alone, in no more time than the rules are long.
#pragma once

#include "meristem/base/limits.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/rule_plan.h"

namespace meristem {

/// Throws the InputError that deriving `steps` steps from the axiom would end with, where the letters tell that a word
/// outgrows limits.modules. A letter whose rules also depend on parameters, neighbours or chance counts with what all
/// of them have in common, so that words are never taken for longer than they are. Says nothing of grammars that
/// decompose or cut words, and of what happens after some thousands of steps.
void require_bounded_words(const Grammar& grammar, const RewritePlan& production, int steps, const Limits& limits);

/// Like `require_bounded_words`, for a timed grammar that replaces modules whose lives end until the time `until`.
/// Counts modules by letter and birth. Only a letter whose first rule has a constant life and no condition is known to
/// be replaced; any other letter counts with what all of its rules have in common.
void require_bounded_timed_words(const Grammar& grammar, const RewritePlan& production, double until,
                                 const Limits& limits);

}  // namespace meristem

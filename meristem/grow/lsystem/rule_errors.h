// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "meristem/grow/lsystem/rule_plan.h"

namespace meristem {

/// Throws an InputError at the rule's line.
[[noreturn]] void throw_rule_error(const GrammarRule& rule, std::string message, std::string expected);
/// Throws the InputError of limits.modules: `wanted` of `what` exceed `limit`, and this rule adds most.
[[noreturn]] void throw_word_too_long(std::string_view what, double wanted, std::uint64_t limit,
                                      const GrammarRule& rule);
/// Throws the rule's error if a value of the formula is infinite or NaN.
void require_finite(std::span<const double> values, const GrammarRule& rule, const RuleFormula& formula);
/// Like require_finite(), but also rejects negative values.
void require_weights(std::span<const double> values, const GrammarRule& rule, const RuleFormula& formula);

}  // namespace meristem

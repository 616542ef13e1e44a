// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "meristem/grow/lsystem/rule_plan.h"

namespace meristem {

/// An InputError at the rule's line.
[[noreturn]] void throw_rule_fault(const Rule& rule, std::string message, std::string expected);
/// The InputError of limits.modules: `wanted` of `what` where `limit` are allowed, most of them by this rule.
[[noreturn]] void throw_word_too_long(std::string_view what, double wanted, std::uint64_t limit, const Rule& rule);
/// Throws the fault of a rule for values of the formula that are infinite or no number.
void require_finite(std::span<const double> values, const Rule& rule, const RuleFormula& formula);
/// Throws it for such values and for negative ones.
void require_weights(std::span<const double> values, const Rule& rule, const RuleFormula& formula);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/rule_errors.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/limits.h"

namespace meristem {

void throw_rule_error(const GrammarRule& rule, std::string message, std::string expected) {
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  diagnostic.expected = std::move(expected);
  diagnostic.line = rule.line;
  throw InputError(diagnostic);
}

void throw_word_too_long(std::string_view what, double wanted, std::uint64_t limit, const GrammarRule& rule) {
  Diagnostic diagnostic = limit_diagnostic(what, wanted, limit, "modules", "");
  diagnostic.message += fmt::format("; {} adds most", in_quotes(rule.text));
  diagnostic.line = rule.line;
  throw InputError(diagnostic);
}

void require_finite(std::span<const double> values, const GrammarRule& rule, const RuleFormula& formula) {
  for (const double value : values) {
    if (std::isfinite(value)) continue;
    throw_rule_error(rule,
                     fmt::format("{} is not a finite number where {} is applied", in_quotes(formula.expression.text()),
                                 in_quotes(rule.text)),
                     "a condition that leaves this case out (most likely a division by zero)");
  }
}

void require_weights(std::span<const double> values, const GrammarRule& rule, const RuleFormula& formula) {
  require_finite(values, rule, formula);
  for (const double value : values) {
    if (value >= 0) continue;
    throw_rule_error(
        rule,
        fmt::format("the weight {} of {} is {}", in_quotes(formula.expression.text()), in_quotes(rule.text), value),
        "0 or more");
  }
}

}  // namespace meristem

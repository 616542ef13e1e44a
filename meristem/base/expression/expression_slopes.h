// SPDX-License-Identifier: Apache-2.0
// Slopes of an expression in some of its variables, carried forward beside the values: an instruction's slopes are
// those of its operands, each times the derivative of the operation in that operand. Private to the expression
// language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/expression/expression_bytecode.h"

namespace meristem {

/// The slopes of all registers for one block of lanes.
class ExpressionSlopes {
 public:
  /// In the variables `by`.
  ExpressionSlopes(const ExpressionBytecode& code, std::span<const std::size_t> by);

  /// Works out the slopes of what an instruction has made of its operands in `lanes` lanes.
  void follow(const ExpressionInstruction& instruction, std::span<const double* const> in, const double* out,
              std::size_t lanes, const RandomKey* keys);
  /// The slopes of a register in the variable by[k], one per lane; null where they are 0.
  const double* slope(std::uint32_t reg, std::size_t k) const;

 private:
  double* own(std::uint32_t reg, std::size_t k);
  std::uint8_t& moves(std::uint32_t reg, std::size_t k) { return moves_[(reg - variable_count_) * by_.size() + k]; }

  std::size_t variable_count_;
  std::vector<std::size_t> by_;
  std::vector<double> values_;       // by scratch register, variable, lane
  std::vector<std::uint8_t> moves_;  // by scratch register, variable: 0 where the slope is 0 in all lanes
};

}  // namespace meristem

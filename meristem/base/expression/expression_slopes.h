// SPDX-License-Identifier: Apache-2.0
// Slopes of an expression in some of its variables, computed forward together with the values. The slope of an
// instruction is the sum over its operands: the operand's slope times the derivative of the operation in this operand.
// Private to the expression language.
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
  /// Computes slopes in the variables `by`.
  ExpressionSlopes(const ExpressionBytecode& code, std::span<const std::size_t> by);

  /// Computes the slopes of an instruction's result from the slopes of its operands, in `lanes` lanes.
  void follow(const ExpressionInstruction& instruction, std::span<const double* const> in, const double* out,
              std::size_t lanes, const RandomKey* keys);
  /// Returns the slopes of a register in the variable by[k], one per lane. Returns null if they are 0.
  const double* slope(std::uint32_t reg, std::size_t k) const;

 private:
  double* own(std::uint32_t reg, std::size_t k);
  std::uint8_t& moves(std::uint32_t reg, std::size_t k) { return moves_[(reg - variable_count_) * by_.size() + k]; }

  std::size_t variable_count_;
  std::vector<std::size_t> by_;
  std::vector<double> values_;       // indexed by scratch register, variable, lane
  std::vector<std::uint8_t> moves_;  // indexed by scratch register, variable: 0 if the slope is 0 in all lanes
};

}  // namespace meristem

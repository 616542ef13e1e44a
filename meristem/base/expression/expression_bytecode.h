// SPDX-License-Identifier: Apache-2.0
// Inner form of a compiled expression: instructions on registers that hold a block of lanes each, the emitter that
// folds constants and hands out registers, and the loop over the instructions. Private to the expression language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/random.h"

namespace meristem {

/// Lanes a register holds at most.
inline constexpr std::size_t kExpressionLanes = 64;

enum class ExpressionOp : std::uint8_t {
  // No operand.
  constant,
  uniform,
  // One.
  negate,
  logical_not,
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  square_root,
  cube_root,
  exponential,
  logarithm,
  logarithm_2,
  logarithm_10,
  absolute,
  sign,
  floor,
  ceiling,
  round,
  truncate,
  fraction,
  noise_1,
  uniform_below,
  // Two.
  add,
  subtract,
  multiply,
  divide,
  modulo,
  power,
  arc_tangent_2,
  minimum,
  maximum,
  step,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  unequal,
  logical_and,
  logical_or,
  uniform_between,
  gauss,
  noise_2,
  // Three.
  select,
  clamp,
  interpolate,
  smooth_step,
  noise_3,
};

/// How many operands `op` reads.
std::size_t operand_count(ExpressionOp op);
bool is_random(ExpressionOp op);

/// Registers below the number of variables are the variables, read in place; those above are scratch.
struct ExpressionInstruction {
  ExpressionOp op = ExpressionOp::constant;
  std::uint32_t out = 0;
  std::uint32_t in[3] = {0, 0, 0};
  std::uint32_t place = 0;  ///< of a random call, counted from 0 in the text
  double value = 0;         ///< of a constant
};

struct ExpressionBytecode {
  std::size_t variable_count = 0;
  std::size_t scratch_count = 0;
  std::vector<bool> used;  ///< one per variable up to the last used one, which ends the list
  std::vector<ExpressionInstruction> instructions;
  std::uint32_t result = 0;  ///< register with the value, after the last instruction
  bool is_random = false;

  /// Values of all lanes, and `slopes` in the variables `by` where they are asked for; see Expression::evaluate.
  void run(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys, double* out,
           std::span<const std::size_t> by = {}, std::span<double* const> slopes = {}) const;
};

/// Runs one instruction for one lane; folding uses it, so folded constants have the bits they would have had.
double fold(ExpressionOp op, std::span<const double> operands);

/// A value while compiling: a constant not yet in any register, a variable, or a scratch register.
struct ExpressionOperand {
  enum class Kind : std::uint8_t { constant, variable, scratch };
  Kind kind = Kind::constant;
  std::uint32_t index = 0;  ///< of the variable or scratch register
  double value = 0;         ///< of the constant
};

/// Writes the bytecode while the text is parsed. Every operand is used exactly once.
class ExpressionEmitter {
 public:
  explicit ExpressionEmitter(std::size_t variable_count);

  static ExpressionOperand constant(double value) { return {ExpressionOperand::Kind::constant, 0, value}; }
  ExpressionOperand variable(std::size_t index);
  /// The result of `op`: a constant if all operands are and nothing is drawn. `place` is for random calls.
  ExpressionOperand apply(ExpressionOp op, std::span<const ExpressionOperand> operands, std::uint32_t place = 0);
  ExpressionBytecode finish(ExpressionOperand result);

 private:
  std::uint32_t take_scratch();
  std::uint32_t in_register(ExpressionOperand operand);
  void release(std::uint32_t reg);

  ExpressionBytecode code_;
  std::vector<std::uint32_t> free_;
};

}  // namespace meristem

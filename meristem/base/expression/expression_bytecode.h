// SPDX-License-Identifier: Apache-2.0
// Internal form of a compiled expression: instructions on registers that hold one block of lanes each, the emitter that
// folds constants and assigns registers, and the loop over the instructions. Private to the expression language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/random.h"

namespace meristem {

/// Maximum number of lanes in a register.
inline constexpr std::size_t kExpressionLanes = 64;

enum class ExpressionOp : std::uint8_t {
  // Operations without operands.
  constant,
  uniform,
  // One operand.
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
  // Two operands.
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
  // Three operands.
  select,
  clamp,
  interpolate,
  smooth_step,
  noise_3,
};

/// Returns the number of operands that `op` reads.
std::size_t operand_count(ExpressionOp op);
bool is_random(ExpressionOp op);

/// One operation. Registers below the number of variables are the variables, read in place. Higher registers are
/// scratch.
struct ExpressionInstruction {
  ExpressionOp op = ExpressionOp::constant;
  std::uint32_t out = 0;
  std::uint32_t in[3] = {0, 0, 0};
  std::uint32_t place = 0;  ///< number of a random call in the text, from 0
  double value = 0;         ///< value of a constant
};

struct ExpressionBytecode {
  std::size_t variable_count = 0;
  std::size_t scratch_count = 0;
  std::vector<bool> used;  ///< for each variable up to the last used one, whether it is used
  std::vector<ExpressionInstruction> instructions;
  std::uint32_t result = 0;  ///< register that has the value after the last instruction
  bool is_random = false;

  /// Computes the values of all lanes, and on request the `slopes` in the variables `by`. See Expression::evaluate.
  void run(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys, double* out,
           std::span<const std::size_t> by = {}, std::span<double* const> slopes = {}) const;
};

/// Runs one instruction for one lane. Constant folding uses it, so folded constants have exactly the bits of a run.
double fold(ExpressionOp op, std::span<const double> operands);

/// A value during compilation: a constant that is not yet in a register, a variable, or a scratch register.
struct ExpressionOperand {
  enum class Kind : std::uint8_t { constant, variable, scratch };
  Kind kind = Kind::constant;
  std::uint32_t index = 0;  ///< index of the variable or scratch register
  double value = 0;         ///< value of the constant
};

/// Writes the bytecode while the text is parsed. Every operand must be used exactly once.
class ExpressionEmitter {
 public:
  explicit ExpressionEmitter(std::size_t variable_count);

  static ExpressionOperand constant(double value) { return {ExpressionOperand::Kind::constant, 0, value}; }
  ExpressionOperand variable(std::size_t index);
  /// Returns the result of `op`: a constant if all operands are constants and `op` is not random. `place` is for random
  /// calls.
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

// SPDX-License-Identifier: Apache-2.0
// Emits the instructions of an expression. Operations on constants are computed at once, and scratch registers are
// reused as soon as an operand was read.
#include "meristem/base/expression/expression_bytecode.h"

#include <algorithm>
#include <array>

namespace meristem {

std::size_t operand_count(ExpressionOp op) {
  if (op >= ExpressionOp::select) return 3;
  if (op >= ExpressionOp::add) return 2;
  return op >= ExpressionOp::negate ? 1 : 0;
}

bool is_random(ExpressionOp op) {
  return op == ExpressionOp::uniform || op == ExpressionOp::uniform_below || op == ExpressionOp::uniform_between ||
         op == ExpressionOp::gauss;
}

ExpressionEmitter::ExpressionEmitter(std::size_t variable_count) { code_.variable_count = variable_count; }

ExpressionOperand ExpressionEmitter::variable(std::size_t index) {
  if (code_.used.size() <= index) code_.used.resize(index + 1);
  code_.used[index] = true;
  return {ExpressionOperand::Kind::variable, static_cast<std::uint32_t>(index), 0};
}

ExpressionOperand ExpressionEmitter::apply(ExpressionOp op, std::span<const ExpressionOperand> operands,
                                           std::uint32_t place) {
  const auto is_constant = [](const ExpressionOperand& o) { return o.kind == ExpressionOperand::Kind::constant; };
  if (!is_random(op) && std::all_of(operands.begin(), operands.end(), is_constant)) {
    std::array<double, 3> values{};
    for (std::size_t k = 0; k < operands.size(); ++k) values[k] = operands[k].value;
    return constant(fold(op, std::span(values).first(operands.size())));
  }

  ExpressionInstruction instruction;
  instruction.op = op;
  for (std::size_t k = 0; k < operands.size(); ++k) instruction.in[k] = in_register(operands[k]);
  instruction.place = place;
  code_.is_random = code_.is_random || is_random(op);
  // Take the result's register before the registers of the operands are released: the loops over lanes require that a
  // result shares no memory with an operand.
  instruction.out = take_scratch();
  for (std::size_t k = 0; k < operands.size(); ++k) release(instruction.in[k]);
  code_.instructions.push_back(instruction);
  return {ExpressionOperand::Kind::scratch, instruction.out, 0};
}

ExpressionBytecode ExpressionEmitter::finish(ExpressionOperand result) {
  code_.result = in_register(result);
  return std::move(code_);
}

std::uint32_t ExpressionEmitter::take_scratch() {
  if (free_.empty()) return static_cast<std::uint32_t>(code_.variable_count + code_.scratch_count++);
  const std::uint32_t reg = free_.back();
  free_.pop_back();
  return reg;
}

std::uint32_t ExpressionEmitter::in_register(ExpressionOperand operand) {
  if (operand.kind != ExpressionOperand::Kind::constant) return operand.index;
  ExpressionInstruction load;
  load.value = operand.value;
  load.out = take_scratch();
  code_.instructions.push_back(load);
  return load.out;
}

void ExpressionEmitter::release(std::uint32_t reg) {
  if (reg >= code_.variable_count) free_.push_back(reg);
}

}  // namespace meristem

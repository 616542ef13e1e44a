// SPDX-License-Identifier: Apache-2.0
// The loop over the instructions. An instruction is dispatched once per block and then runs over the block's lanes, in
// a loop of known length without branches if the operation allows it. Blocks have 64 lanes. The remaining lanes use the
// same code with blocks of 8 and of 1, so the value of a lane does not depend on its block.
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>

#include "meristem/base/degrees.h"
#include "meristem/base/expression/expression_bytecode.h"
#include "meristem/base/expression/expression_slopes.h"
#include "meristem/base/math.h"
#include "meristem/base/noise.h"

namespace meristem {

namespace {

using Op = ExpressionOp;

constexpr double kDegreesPerRadian = 57.295779513082321;

double cube_root(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double root = math::pow(std::abs(x), 1.0 / 3);
  // One step of Newton's iteration makes the roots of cubes exact.
  return std::copysign(root - (root - std::abs(x) / (root * root)) / 3, x);
}

double logarithm_2(double x) {
  if (!(x > 0) || std::isinf(x)) return math::log(x);
  int exponent = 0;
  double fraction = std::frexp(x, &exponent);
  if (fraction < 0.70710678118654752) {
    fraction *= 2;
    --exponent;
  }
  return exponent + math::log(fraction) * 1.4426950408889634;
}

/// Returns the logarithm to base 10, exact for powers of ten, on which documents rely.
double logarithm_10(double x) {
  constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const double result = math::log(x) * 0.43429448190325182;
  const double whole = std::floor(std::abs(result) + 0.5);
  if (!(whole <= 22)) return result;
  const double power = kPowers[static_cast<int>(whole)];
  if (x == power) return whole;
  return x == 1 / power ? -whole : result;
}

/// Returns true for whole numbers whose products and differences below are exact.
bool is_countable(double x) { return std::abs(x) < 0x1p51 && std::floor(x) == x; }

/// Returns the remainder with the divisor's sign, so that i % 4 counts 0 1 2 3 also for negative i.
double modulo(double x, double y) {
  if (is_countable(x) && is_countable(y) && y != 0) {
    // The quotient can round up to the next whole number, but never further. This is three times as fast as fmod.
    const double rest = x - y * std::floor(x / y);
    return rest != 0 && (rest < 0) != (y < 0) ? rest + y : rest;
  }
  // Adding zero removes the sign of a zero remainder.
  const double rest = std::fmod(x, y) + 0.0;
  return rest != 0 && (rest < 0) != (y < 0) ? rest + y : rest;
}

double smooth_step(double from, double to, double x) {
  if (from == to) return x < from ? 0 : 1;
  const double t = (x - from) / (to - from);
  const double inside = t < 0 ? 0 : t > 1 ? 1 : t;
  return inside * inside * (3 - 2 * inside);
}

/// Sample noise half a cell off the lattice: noise is zero on the lattice, and documents often sample at whole numbers,
/// as in noise(i).
double noise_at(double x) { return gradient_noise(RandomKey(), x + 0.5); }
double noise_at(double x, double y) { return gradient_noise(RandomKey(), x + 0.5, y + 0.5); }
double noise_at(double x, double y, double z) { return gradient_noise(RandomKey(), x + 0.5, y + 0.5, z + 0.5); }

double truth(bool value) { return value ? 1.0 : 0.0; }

/// The working memory for one block of lanes.
template <std::size_t lanes>
struct Block {
  const double* const* variables;
  std::size_t variable_count;
  std::size_t start;  ///< first lane in the variables
  double* scratch;

  const double* in(std::uint32_t reg) const {
    return reg < variable_count ? variables[reg] + start : scratch + (reg - variable_count) * lanes;
  }
  double* out(std::uint32_t reg) const { return scratch + (reg - variable_count) * lanes; }
};

// `out` must share no memory with the operands, which the emitter guarantees.
template <std::size_t lanes, typename F>
void map(double* __restrict out, const double* a, F f) {
  for (std::size_t lane = 0; lane < lanes; ++lane) out[lane] = f(a[lane]);
}
template <std::size_t lanes, typename F>
void map(double* __restrict out, const double* a, const double* b, F f) {
  for (std::size_t lane = 0; lane < lanes; ++lane) out[lane] = f(a[lane], b[lane]);
}
template <std::size_t lanes, typename F>
void map(double* __restrict out, const double* a, const double* b, const double* c, F f) {
  for (std::size_t lane = 0; lane < lanes; ++lane) out[lane] = f(a[lane], b[lane], c[lane]);
}

/// Maps angles in degrees through an `f` that accepts only small angles.
template <std::size_t lanes, typename F>
void map_angles(double* __restrict out, const double* a, F f) {
  // Collect in the top bit whether any angle is large, infinite or NaN, without a branch per lane.
  constexpr std::uint64_t kLargest = std::bit_cast<std::uint64_t>(math::kNearDegrees);
  std::uint64_t beyond = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    beyond |= kLargest - (std::bit_cast<std::uint64_t>(a[lane]) << 1 >> 1);
  if (beyond >> 63 == 0) {
    map<lanes>(out, a, f);
  } else {
    map<lanes>(out, a, [&](double x) { return f(math::near_degrees(x)); });
  }
}

template <std::size_t lanes>
void run_drawing(const ExpressionInstruction& i, const Block<lanes>& block, const RandomKey* keys) {
  double* const out = block.out(i.out);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const RandomKey key = keys[block.start + lane];
    if (i.op == Op::uniform) {
      out[lane] = key.uniform(i.place);
    } else if (i.op == Op::uniform_below) {
      out[lane] = key.uniform(i.place, 0, block.in(i.in[0])[lane]);
    } else if (i.op == Op::uniform_between) {
      out[lane] = key.uniform(i.place, block.in(i.in[0])[lane], block.in(i.in[1])[lane]);
    } else {
      out[lane] = block.in(i.in[0])[lane] + block.in(i.in[1])[lane] * key.normal(i.place);
    }
  }
}

template <std::size_t lanes>
void run_trigonometry(Op op, double* out, const double* a) {
  switch (op) {
    case Op::sine:
      return map_angles<lanes>(out, a, [](double x) { return math::near_sin_deg(x); });
    case Op::cosine:
      return map_angles<lanes>(out, a, [](double x) { return math::near_cos_deg(x); });
    case Op::tangent:
      return map_angles<lanes>(out, a, [](double x) { return math::near_sin_deg(x) / math::near_cos_deg(x); });
    case Op::arc_sine:
      return map<lanes>(out, a, [](double x) { return math::asin(x) * kDegreesPerRadian; });
    case Op::arc_cosine:
      return map<lanes>(out, a, [](double x) { return math::acos(x) * kDegreesPerRadian; });
    default:
      return map<lanes>(out, a, [](double x) { return math::atan2(x, 1) * kDegreesPerRadian; });
  }
}

template <std::size_t lanes>
void run_unary(Op op, double* out, const double* a) {
  switch (op) {
    case Op::negate:
      return map<lanes>(out, a, [](double x) { return -x; });
    case Op::logical_not:
      return map<lanes>(out, a, [](double x) { return truth(x == 0); });
    case Op::square_root:
      return map<lanes>(out, a, [](double x) { return std::sqrt(x); });
    case Op::cube_root:
      return map<lanes>(out, a, cube_root);
    case Op::exponential:
      return map<lanes>(out, a, math::exp);
    case Op::logarithm:
      return map<lanes>(out, a, math::log);
    case Op::logarithm_2:
      return map<lanes>(out, a, logarithm_2);
    case Op::logarithm_10:
      return map<lanes>(out, a, logarithm_10);
    case Op::absolute:
      return map<lanes>(out, a, [](double x) { return std::abs(x); });
    case Op::sign:
      return map<lanes>(out, a, [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : x; });
    case Op::floor:
      return map<lanes>(out, a, [](double x) { return std::floor(x); });
    case Op::ceiling:
      return map<lanes>(out, a, [](double x) { return std::ceil(x); });
    case Op::round:
      return map<lanes>(out, a, [](double x) { return std::round(x); });
    case Op::truncate:
      return map<lanes>(out, a, [](double x) { return std::trunc(x); });
    case Op::fraction:
      return map<lanes>(out, a, [](double x) { return x - std::floor(x); });
    case Op::noise_1:
      return map<lanes>(out, a, [](double x) { return noise_at(x); });
    default:
      return run_trigonometry<lanes>(op, out, a);
  }
}

template <std::size_t lanes>
void run_logic(Op op, double* out, const double* a, const double* b) {
  switch (op) {
    case Op::less:
      return map<lanes>(out, a, b, [](double x, double y) { return truth(x < y); });
    case Op::less_equal:
      return map<lanes>(out, a, b, [](double x, double y) { return truth(x <= y); });
    case Op::greater:
      return map<lanes>(out, a, b, [](double x, double y) { return truth(x > y); });
    case Op::greater_equal:
      return map<lanes>(out, a, b, [](double x, double y) { return truth(x >= y); });
    case Op::equal:
      return map<lanes>(out, a, b, [](double x, double y) { return truth(x == y); });
    case Op::unequal:
      return map<lanes>(out, a, b, [](double x, double y) { return truth(x != y); });
    case Op::logical_and:
      return map<lanes>(out, a, b, [](double x, double y) { return truth((x != 0) & (y != 0)); });
    default:
      return map<lanes>(out, a, b, [](double x, double y) { return truth((x != 0) | (y != 0)); });
  }
}

template <std::size_t lanes>
void run_binary(Op op, double* out, const double* a, const double* b) {
  switch (op) {
    case Op::add:
      return map<lanes>(out, a, b, [](double x, double y) { return x + y; });
    case Op::subtract:
      return map<lanes>(out, a, b, [](double x, double y) { return x - y; });
    case Op::multiply:
      return map<lanes>(out, a, b, [](double x, double y) { return x * y; });
    case Op::divide:
      return map<lanes>(out, a, b, [](double x, double y) { return x / y; });
    case Op::modulo:
      return map<lanes>(out, a, b, modulo);
    case Op::power:
      return map<lanes>(out, a, b, math::pow);
    case Op::arc_tangent_2:
      return map<lanes>(out, a, b, [](double y, double x) { return math::atan2(y, x) * kDegreesPerRadian; });
    case Op::minimum:
      return map<lanes>(out, a, b, [](double x, double y) { return y < x ? y : x; });
    case Op::maximum:
      return map<lanes>(out, a, b, [](double x, double y) { return y > x ? y : x; });
    case Op::step:
      return map<lanes>(out, a, b, [](double edge, double x) { return x < edge ? 0.0 : 1.0; });
    case Op::noise_2:
      return map<lanes>(out, a, b, [](double x, double y) { return noise_at(x, y); });
    default:
      return run_logic<lanes>(op, out, a, b);
  }
}

template <std::size_t lanes>
void run_ternary(Op op, double* out, const double* a, const double* b, const double* c) {
  switch (op) {
    case Op::select:
      return map<lanes>(out, a, b, c, [](double condition, double x, double y) { return condition != 0 ? x : y; });
    case Op::clamp:
      return map<lanes>(out, a, b, c, [](double x, double low, double high) {
        const double above = x < low ? low : x;
        return above > high ? high : above;
      });
    case Op::interpolate:
      return map<lanes>(out, a, b, c, [](double x, double y, double t) { return x + (y - x) * t; });
    case Op::smooth_step:
      return map<lanes>(out, a, b, c, smooth_step);
    default:
      return map<lanes>(out, a, b, c, [](double x, double y, double z) { return noise_at(x, y, z); });
  }
}

template <std::size_t lanes>
void run_instruction(const ExpressionInstruction& i, const Block<lanes>& block, const RandomKey* keys) {
  double* const out = block.out(i.out);
  if (is_random(i.op)) return run_drawing<lanes>(i, block, keys);
  switch (operand_count(i.op)) {
    case 0:
      std::fill_n(out, lanes, i.value);
      return;
    case 1:
      return run_unary<lanes>(i.op, out, block.in(i.in[0]));
    case 2:
      return run_binary<lanes>(i.op, out, block.in(i.in[0]), block.in(i.in[1]));
    default:
      return run_ternary<lanes>(i.op, out, block.in(i.in[0]), block.in(i.in[1]), block.in(i.in[2]));
  }
}

/// The arguments of one call of `run`.
struct Batch {
  std::size_t count;
  const double* const* variables;
  const RandomKey* keys;
  double* scratch;
  double* out;
  ExpressionSlopes* slopes = nullptr;        // null if no slopes are requested
  std::span<double* const> slopes_out = {};  // for each variable
};

/// Runs the block's instructions and propagates slopes.
template <std::size_t lanes>
void run_with_slopes(const ExpressionBytecode& code, const Batch& batch, const Block<lanes>& block) {
  const RandomKey* const keys = batch.keys != nullptr ? batch.keys + block.start : nullptr;
  for (const ExpressionInstruction& instruction : code.instructions) {
    run_instruction(instruction, block, batch.keys);
    const std::size_t operands = operand_count(instruction.op);
    const double* in[3] = {};
    for (std::size_t k = 0; k < operands; ++k) in[k] = block.in(instruction.in[k]);
    batch.slopes->follow(instruction, std::span(in).first(operands), block.out(instruction.out), lanes, keys);
  }
  for (std::size_t k = 0; k < batch.slopes_out.size(); ++k) {
    double* const out = batch.slopes_out[k] + block.start;
    const double* const slope = batch.slopes->slope(code.result, k);
    if (slope == nullptr) {
      std::fill_n(out, lanes, 0.0);
    } else {
      std::copy_n(slope, lanes, out);
    }
  }
}

/// Runs full blocks of this many lanes from `start` on. Returns the first lane that was not processed.
template <std::size_t lanes>
std::size_t run_blocks(const ExpressionBytecode& code, const Batch& batch, std::size_t start) {
  for (; batch.count - start >= lanes; start += lanes) {
    const Block<lanes> block{batch.variables, code.variable_count, start, batch.scratch};
    if (batch.slopes != nullptr) {
      run_with_slopes(code, batch, block);
    } else {
      for (const ExpressionInstruction& instruction : code.instructions)
        run_instruction(instruction, block, batch.keys);
    }
    std::copy_n(block.in(code.result), lanes, batch.out + start);
  }
  return start;
}

}  // namespace

void ExpressionBytecode::run(std::size_t count, std::span<const double* const> variables,
                             std::span<const RandomKey> keys, double* out, std::span<const std::size_t> by,
                             std::span<double* const> slopes) const {
  // Nearly all expressions fit into scratch memory on the stack.
  constexpr std::size_t kRegistersOnStack = 16;
  double on_stack[kRegistersOnStack * kExpressionLanes];
  std::unique_ptr<double[]> on_heap;
  double* scratch = on_stack;
  if (scratch_count > kRegistersOnStack) {
    on_heap = std::make_unique_for_overwrite<double[]>(scratch_count * kExpressionLanes);
    scratch = on_heap.get();
  }

  Batch batch{count, variables.data(), keys.data(), scratch, nullptr};
  batch.out = out;
  std::optional<ExpressionSlopes> carried;
  if (!slopes.empty()) {
    batch.slopes = &carried.emplace(*this, by);
    batch.slopes_out = slopes;
  }
  std::size_t done = run_blocks<kExpressionLanes>(*this, batch, 0);
  done = run_blocks<8>(*this, batch, done);
  run_blocks<1>(*this, batch, done);
}

double fold(ExpressionOp op, std::span<const double> operands) {
  ExpressionInstruction instruction;
  instruction.op = op;
  instruction.out = static_cast<std::uint32_t>(operands.size());
  const double* variables[3] = {};
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    instruction.in[k] = k;
    variables[k] = &operands[k];
  }
  double result = 0;
  const RandomKey unused;
  run_instruction(instruction, Block<1>{variables, operands.size(), 0, &result}, &unused);
  return result;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// No file may contain a NaN or an infinity. Writers check their input before a file appears, and check every number
// again when it is written, in all builds. There are two documented exceptions: the NaN of an unknown value in the
// columns of `.skeleton.ply`, and the infinite depth of the sky in `.pfm`.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>

#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Throws an InputError that names the component if a number of the scene is not finite, or if the place of an instance
/// would make it infinite. The cost is linear in vertices plus instances, not in their product.
void require_finite(const MeshScene& scene);
/// Throws an InputError that names the component if a number of the plant's skeletons or organs is not finite. Further
/// columns of a skeleton may be NaN, which marks an unknown value.
void require_finite(const Plant& plant);

/// Throws the InputError for a number that is not finite and belongs to no component.
[[noreturn]] void throw_not_finite();

/// Throws an InputError if a number is not finite. Whole numbers always pass.
template <class Number>
requires std::is_arithmetic_v<Number>
void require_finite_value(Number number) {
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(number)) throw_not_finite();
  }
}
template <glm::length_t kLength, class Number>
void require_finite_value(const glm::vec<kLength, Number>& vector) {
  for (glm::length_t k = 0; k < kLength; ++k) require_finite_value(vector[k]);
}
template <class Number, std::size_t kSize>
void require_finite_value(const std::array<Number, kSize>& numbers) {
  for (const Number& number : numbers) require_finite_value(number);
}

/// Throws an InputError if one of the values is not finite.
template <class Value>
void require_finite_values(std::span<const Value> values) {
  for (const Value& value : values) require_finite_value(value);
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// Returns the rotation nearest to a matrix with a determinant above 0: the rotation of its polar decomposition. For a
/// Jacobian, this removes the stretch. Exact to 1e-12. The identity and exact rotations are returned unchanged.
///
/// Based on: N. J. Higham: Computing the polar decomposition (1986).
DMat3 nearest_rotation(const DMat3& matrix);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// The rotation nearest to a matrix with a determinant above 0: what is left of a Jacobian without its stretch (its
/// polar decomposition). Right to 1e-12; the identity, and what differs from a rotation by no bit, stay as they are.
///
/// Based on: N. J. Higham: Computing the polar decomposition (1986).
DMat3 nearest_rotation(const DMat3& matrix);

}  // namespace meristem

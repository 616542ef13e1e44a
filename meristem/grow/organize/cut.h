// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/grow/organize/metamers.h"
#include "meristem/grow/organize/operation.h"

namespace meristem {

/// The first metamer that a cut takes away, after the growth of `iteration`. Throws InputError at the cut's document
/// path, with the names that there are, where there is no such shoot or nothing to take away.
MetamerIndex find_cut(const Metamers& metamers, const Cut& cut, int iteration);

}  // namespace meristem

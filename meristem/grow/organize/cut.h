// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "meristem/grow/organize/metamers.h"
#include "meristem/grow/organize/species.h"

namespace meristem {

/// The first metamer that a cut takes away, after the growth of `iteration`. It is the `index`-th of the species' cuts.
/// Throws InputError there, with the names that there are, where there is no such shoot or nothing to take away.
MetamerIndex find_cut(const Metamers& metamers, const OrganizedSpecies& species, std::size_t index, int iteration);

}  // namespace meristem

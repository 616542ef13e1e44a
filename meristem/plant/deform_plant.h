// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "meristem/base/deform/deformation.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// How far a vertex may lie from where an affine map puts it, as a share of the organ's size, where the map stands for
/// a deformation.
inline constexpr double kAffineTolerance = 5e-3;

/// Deforms a stem, each part by its own deformation (null: not): moves nodes, leaves thickness along the axes what it
/// is or stretches it as the surface is, and notes in the parts by what their surfaces are to be deformed. Throws as
/// Deformation::map does, with the part's component as what stands there.
void deform(Stem& stem, std::span<const std::shared_ptr<const Deformation>> of_part);

/// Turns and moves frames as a deformation on axes does what stands in them. Throws as Deformation::map does.
void deform(std::span<Frame> frames, const Deformation& of_axes, std::string_view who);

/// Organs of a plant in a row with one deformation.
struct DeformedOrgans {
  std::size_t first = 0;
  std::size_t count = 0;
  std::shared_ptr<const Deformation> deformation;  ///< not null
};

/// Deforms organs. Those that are turned and moved only, or deformed as an affine map would within kAffineTolerance,
/// keep their prototype and get another frame; the others get prototypes of their own, appended in the order of organs.
/// The same on any number of threads. Throws InputError as Deformation::map does, and where the new meshes take more
/// than the limit of bytes, of which `mesh_bytes` have been spent; Cancelled.
void deform_organs(Plant& plant, std::span<const DeformedOrgans> rows, std::uint64_t mesh_bytes, const Limits& limits,
                   const Progress& progress);

}  // namespace meristem

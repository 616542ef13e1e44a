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

/// Largest error of an affine map that may replace a deformation: distance of a vertex from its exact position, as a
/// share of the organ's size.
inline constexpr double kAffineTolerance = 5e-3;

/// Deforms a stem, each part by its own deformation (null: the part is not deformed). Moves nodes. Scales the radii
/// where the deformation includes geometry; a deformation of axes keeps them. Stores the remaining deformation of the
/// surface in each part. Throws as Deformation::map does and names the part's component.
void deform(Stem& stem, std::span<const std::shared_ptr<const Deformation>> of_part);

/// Moves and rotates frames as a deformation of axes moves the organs in them. Throws as Deformation::map does.
void deform(std::span<Frame> frames, const Deformation& of_axes, std::string_view who);

/// A range of a plant's organs with one deformation.
struct DeformedOrgans {
  std::size_t first = 0;                           ///< index of the first organ
  std::size_t count = 0;                           ///< number of organs
  std::shared_ptr<const Deformation> deformation;  ///< not null
};

/// Deforms organs. An organ keeps its prototype and gets a new frame if it is only moved and rotated, or if an affine
/// map is within kAffineTolerance. All other organs get prototypes of their own, appended in the order of organs. The
/// result does not depend on the number of threads. Throws InputError as Deformation::map does, and if the new meshes
/// exceed the limit of bytes; `mesh_bytes` is the number of bytes already used. Throws Cancelled.
void deform_organs(Plant& plant, std::span<const DeformedOrgans> rows, std::uint64_t mesh_bytes,
                   const SizeLimits& limits, const Progress& progress);

}  // namespace meristem

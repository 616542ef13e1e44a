// SPDX-License-Identifier: Apache-2.0
// How colonizing trees answer to light. Response A moves the whole cloud of attraction points toward brighter positions
// before each step. Response B lets light act on single points: points in the deepest shade are left out, each point
// moves as its own nearest node feels, the cloud's height is held, and points in the shade of what has grown do not
// pull.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 4.4, with the settled reading of its equations 4.19 to 4.24; response B is our own.
#pragma once

#include <optional>

#include "meristem/scene/light/shadow_grid.h"

namespace meristem {

/// Light-limited space: the darkest points are removed before growth.
struct LightLimit {
  double share = 0;     ///< share of a tree's points, 0 to 1
  double radius = 0.3;  ///< metres to the side of a ray within which other points dim it
  double k = 0.1;       ///< the light falls by exp(-k) with each of them
};

/// The shade of the plants that have grown so far, as StandSpace keeps it. A tree does not grow to points that are
/// darker than it bears.
struct ShadeResponse {
  double bears = 0.4;  ///< light below which points do not pull, from 1 in the open to 0
  ShadowParameters form{.voxel = 0.25, .amount = 0.04, .base = 1.3, .depth = 10};
};

struct LightResponse {
  double shift = 0;          ///< metres that the whole cloud moves per step
  double drift = 0;          ///< metres that a point near a node wholly in shade moves per step
  double sunlit_weight = 1;  ///< strength of light that arrives over that of light in whose shade a node stands
  bool hold_height = false;  ///< scales the heights of the points after each move, so that the cloud's top stays
  LightLimit limit;
  std::optional<ShadeResponse> shade;

  bool moves() const { return shift != 0 || drift != 0; }
};

}  // namespace meristem

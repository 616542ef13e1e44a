// SPDX-License-Identifier: Apache-2.0
// The response of colonizing trees to light. Response A moves the whole cloud of attraction points toward brighter
// positions before each step. Response B applies light to single points. It removes points in the deepest shade and
// moves each point by the light at its nearest node. It can also hold the cloud's height, and disable points in the
// shade of existing growth. Fields of worlds around the tree, such as a wind, can carry the points along.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 4.4, with the settled reading of its equations 4.19 to 4.24; response B is our own.
#pragma once

#include <optional>

#include "meristem/scene/light/shadow_grid.h"

namespace meristem {

/// Removal of the darkest points before growth.
struct LightLimit {
  double share = 0;     ///< share of a tree's points that is removed, 0 to 1
  double radius = 0.3;  ///< metres around a ray within which other points dim it
  double k = 0.1;       ///< each of these points dims the light by the factor exp(-k)
};

/// Response to the shade of plants that have grown so far (StandSpace). A tree does not grow to points that are darker
/// than `bears`.
struct ShadeResponse {
  double bears = 0.4;  ///< light below which points do not pull, from 1 (no shade) to 0
  ShadowParameters form{.voxel = 0.25, .amount = 0.04, .base = 1.3, .depth = 10};  ///< the form of the shade
};

/// How light and shade move, remove and disable attraction points.
struct LightResponse {
  double shift = 0;          ///< metres that the whole cloud moves per step
  double drift = 0;          ///< metres per step that a point moves if its node is completely in the shade
  double field = 0;          ///< metres per step that a point moves along a field of strength 1
  double sunlit_weight = 1;  ///< weight of light that arrives, relative to light that is blocked
  bool hold_height = false;  ///< true: scales the heights of the points after each move, so that the cloud's top stays
  LightLimit limit;          ///< points removed before growth
  std::optional<ShadeResponse> shade;  ///< response to the shade of existing growth; unset: no response

  bool seeks_light() const { return shift != 0 || drift != 0; }  ///< true if points move with the light
  bool moves() const { return seeks_light() || field != 0; }     ///< true if points move
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The curves of stems: bends, windings, noise, and turns toward gravity and light.
#pragma once

#include <span>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/graph/component.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Angles are in radians, lengths in metres. The end of a stem does not depend on the number of its sections.
struct StemParameters {
  double length = 1;
  double radius = 0.02;  ///< at the base
  /// Share of the radius over u; negative values count as 0.
  Curve taper{{{0.0F, 1.0F}, {1.0F, 0.15F}}, CurveKind::linear};
  int segments = 16;
  /// Points of a spline from the origin, in the stem's own frame, stretched to `length`. Empty: a straight stem. All
  /// other parameters bend it further.
  std::vector<Vec3> axis;
  double curl = 0;         ///< bend from base to tip; positive: away from its upper side
  double spiral = 0;       ///< rotation of the bend's direction about the stem from base to tip; makes a helix
  double gnarl = 0;        ///< amplitude of the random change of direction
  double gnarl_waves = 3;  ///< number of such changes from base to tip
};

const ParameterTable& stem_form_table();

/// A position where something pushes a stem aside.
struct StemBend {
  double u = 0;  ///< from 0 to 1; rising from bend to bend
  Vec3 turn{0};  ///< axis of rotation in the frame of a straight stem; its length is the angle
};

struct StemTropisms {
  const Directions* directions = nullptr;  ///< light, gravity and bodies to keep out of; null: no effects
  double gravitropism = 0;  ///< share of the angle to straight down that the tip closes; negative: to straight up
  double phototropism = 0;  ///< share of the angle to the light that the tip closes; negative: away from it
  /// The place in the scene of a stem that is made elsewhere and smaller: its positions times `stretch`, from `origin`.
  Vec3 origin{0};
  float stretch = 1;

  bool act() const { return gravitropism != 0 || phototropism != 0 || keep_out(); }
  bool keep_out() const { return directions != nullptr && directions->keep_out(); }
};

/// A stem in world space.
struct StemPath {
  Skeleton skeleton;          ///< one axis, from base to tip
  std::vector<Frame> frames;  ///< frames of its nodes: y along the stem, scaled like the site's frame
  float length = 0;           ///< metres
};

/// Returns the stem that begins at `site`. The site's key determines its noise.
StemPath grow_stem(const StemParameters& form, const Site& site, const StemTropisms& tropisms,
                   std::span<const StemBend> bends = {});

/// Reports an axis with coinciding points or too many points.
void check_stem_form(const StemParameters& form, const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem

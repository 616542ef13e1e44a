// SPDX-License-Identifier: Apache-2.0
// How the stems of components run: along a curve that bends, winds, wanders, and turns toward gravity and light.
#pragma once

#include <span>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/graph/component.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Angles in radians, lengths in metres. A stem ends the same however many sections it has.
struct StemParameters {
  double length = 1;
  double radius = 0.02;                                           ///< at the base
  Curve taper{{{0.0F, 1.0F}, {1.0F, 0.15F}}, CurveKind::linear};  ///< share of the radius over u; below 0 counts as 0
  int segments = 16;
  /// Points that a spline from the origin runs through, in the stem's own frame; its way is stretched to `length`.
  /// Empty: a straight way. All else bends it further.
  std::vector<Vec3> axis;
  double curl = 0;         ///< that it bends from base to tip; positive: away from its upper side
  double spiral = 0;       ///< turn of the bend's direction about the stem from base to tip: a helix
  double gnarl = 0;        ///< how far its direction wanders
  double gnarl_waves = 3;  ///< how often it does so from base to tip
};

const ParameterTable& stem_form_table();

/// Where something pushes a stem aside.
struct StemBend {
  double u = 0;  ///< from 0 to 1; rising from bend to bend
  Vec3 turn{0};  ///< axis in the frame that a straight stem has, with the angle for its length
};

struct StemTropisms {
  const Directions* directions = nullptr;  ///< of light and gravity, and what keeps the stem out; null: nothing does
  double gravitropism = 0;  ///< share of the angle to straight down that the tip closes; negative: to straight up
  double phototropism = 0;  ///< share of the angle to the light that the tip closes; negative: away from it
  /// Where in the scene a stem stands that is made elsewhere and smaller: its positions times `stretch`, from `origin`.
  Vec3 origin{0};
  float stretch = 1;

  bool act() const { return gravitropism != 0 || phototropism != 0 || keep_out(); }
  bool keep_out() const { return directions != nullptr && directions->keep_out(); }
};

/// A stem in world space.
struct StemPath {
  Skeleton skeleton;          ///< one axis, from base to tip
  std::vector<Frame> frames;  ///< at its nodes: y along the way, scaled as the site's frame
  float length = 0;           ///< metres
};

/// The stem that begins at `site`, whose key its wandering follows.
StemPath grow_stem(const StemParameters& form, const Site& site, const StemTropisms& tropisms,
                   std::span<const StemBend> bends = {});

/// Reports an axis whose points coincide, or are too many.
void check_stem_form(const StemParameters& form, const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem

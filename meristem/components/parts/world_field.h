// SPDX-License-Identifier: Apache-2.0
// Fields of light and gravity as documents write them.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "meristem/graph/component.h"
#include "meristem/graph/table/selection.h"
#include "meristem/scene/field/vector_field.h"

namespace meristem {

struct FieldLine {
  Vec3 point{0};
  Vec3 direction = kUp;
};

struct CylinderParameters {
  FieldLine axis;
  double radius = 0.05;
  double edge = 0.05;  ///< metres from the surface within which the pull falls to nothing
};

struct VortexParameters {
  FieldLine axis;
  double core = 0.05;  ///< metres from the axis within which the pull falls to nothing
};

struct WindParameters {
  Vec3 direction{1, 0, 0};
  double gusts = 0;  ///< by how much of its strength it changes from place to place
  double size = 2;   ///< metres, of a gust
  double drift = 0;  ///< metres that gusts have moved with the wind
};

/// Where one is not given it is 0.
struct FormulaField {
  std::optional<Formula> x, y, z;
};

/// Exactly one of the forms is given, from `formula` to `wind`.
struct WorldField {
  std::optional<FormulaField> formula;
  std::optional<Vec3> uniform;
  std::optional<Vec3> toward;
  std::optional<Vec3> away;
  std::optional<double> reach;  ///< metres from the point at which the pull is half as strong; unset: it never falls
  std::optional<CylinderParameters> cylinder;
  std::optional<VortexParameters> vortex;
  std::optional<WindParameters> wind;
  double strength = 1;
  bool add = false;  ///< to what is there, instead of taking its place
};

const ParameterTable& world_field_table();

/// What surrounds a field of one instance.
struct FieldPlace {
  const Frame& frame;
  double time = 0;
  RandomKey key = RandomKey();  ///< of its gusts
  std::string path;             ///< of the field in the document
  std::string what;             ///< "light field"
};

/// The field that a checked form means, in world space. Throws InputError for directions without a length.
FieldPointer build_field(const WorldField& form, const FieldPlace& place);

}  // namespace meristem

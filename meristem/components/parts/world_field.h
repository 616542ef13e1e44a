// SPDX-License-Identifier: Apache-2.0
// Fields of light and gravity as parameters of documents.
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
  double edge = 0.05;  ///< metres from the surface over which the pull falls to zero
};

struct VortexParameters {
  FieldLine axis;
  double core = 0.05;  ///< metres from the axis over which the pull falls to zero
};

struct WindParameters {
  Vec3 direction{1, 0, 0};
  double gusts = 0;  ///< largest change of the wind, as a share of its strength
  double size = 2;   ///< size of a gust, metres
  double drift = 0;  ///< metres that gusts have moved with the wind
};

/// A missing component is 0.
struct FormulaField {
  std::optional<ParameterFormula> x, y, z;
};

/// Exactly one of the forms from `formula` to `wind` must be set.
struct WorldField {
  std::optional<FormulaField> formula;
  std::optional<Vec3> uniform;
  std::optional<Vec3> toward;
  std::optional<Vec3> away;
  /// Distance from the point at which the pull is half as strong, metres; unset: constant strength.
  std::optional<double> reach;
  std::optional<CylinderParameters> cylinder;
  std::optional<VortexParameters> vortex;
  std::optional<WindParameters> wind;
  double strength = 1;
  bool add = false;  ///< true: adds to the existing field; false: replaces it
};

const ParameterTable& world_field_table();

/// The surroundings of a field of one instance.
struct FieldPlace {
  const Frame& frame;
  double time = 0;
  RandomKey key = RandomKey();  ///< key of its gusts
  std::string path;             ///< path of the field in the document
  std::string what;             ///< name in messages, such as "light field"
};

/// Returns the field of checked parameters in world space. Throws InputError for directions of zero length.
FieldPointer build_field(const WorldField& form, const FieldPlace& place);

}  // namespace meristem

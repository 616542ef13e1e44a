// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "meristem/components/parts/plant_grammar.h"
#include "meristem/graph/component.h"
#include "meristem/graph/table/asset.h"
#include "meristem/grow/lsystem/turtle.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// The default turns of the polar reading.
struct PolarAngles {
  double elevation = 22.5;  ///< degrees
  double azimuth = 22.5;
};

/// How a stem gets thinner from segment to segment if words set no widths.
struct WidthDecay {
  double trunk = 0.95;    ///< outside brackets
  double branch = 0.825;  ///< inside brackets
};

/// A plant that a turtle draws from the word of a grammar.
struct Lsystem : ComponentBase {
  Asset<PlantGrammar> grammar;  ///< from a text in the document
  Asset<PlantGrammar> file;     ///< from a file
  std::optional<int> steps;     ///< unset: from the grammar
  std::optional<double> time;   ///< of a timed grammar, in the unit of its lives; unset: from the grammar
  std::optional<double> angle;  ///< degrees; unset: from the grammar
  std::optional<PolarAngles> angles;
  WidthDecay width_decay;
  TurtleParameters turtle;              ///< without angles, decays and directions
  std::vector<Vec3> palette;            ///< colours of polygons, by colour number; empty: the green of leaves
  std::optional<FinishOptions> finish;  ///< post-processing of the skeleton, in steps of the turtle's length
  SurfaceOptions surface;
  TrimMode trim = TrimMode::cut;  ///< effect of a body around its stems

  const PlantGrammar& source() const { return grammar ? *grammar : *file; }
};

ComponentType lsystem_component();

/// Returns the number of derivation steps, or the time of the word.
double steps_of(const Lsystem& plant);
/// Returns the turtle parameters of an instance in surroundings with these directions.
TurtleParameters turtle_of(const Lsystem& plant, const Directions& directions);
/// Returns the key of an instance's random numbers.
inline RandomKey word_key(const Site& site) { return site.key.child("word"); }
/// Throws the errors of a derivation at the document path of the grammar of the component `id`.
[[noreturn]] void throw_placed(const InputError& error, const Lsystem& plant, const std::string& id);

}  // namespace meristem

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

/// What turns by steps of its own in the polar reading.
struct PolarAngles {
  double elevation = 22.5;  ///< degrees
  double azimuth = 22.5;
};

/// How a stem gets thinner from segment to segment where words set no widths.
struct WidthDecay {
  double trunk = 0.95;    ///< outside all brackets
  double branch = 0.825;  ///< within them
};

/// A plant by the rules of a grammar, drawn by a turtle.
struct Lsystem : ComponentBase {
  Asset<PlantGrammar> grammar;  ///< from a text in the document,
  Asset<PlantGrammar> file;     ///< or from a file
  std::optional<int> steps;     ///< unset: the grammar's
  std::optional<double> time;   ///< of a timed grammar, in the unit of its lives; unset: the grammar's
  std::optional<double> angle;  ///< degrees; unset: the grammar's
  std::optional<PolarAngles> angles;
  WidthDecay width_decay;
  TurtleParameters turtle;       ///< without angles, decays and directions
  std::vector<Vec3> palette;     ///< of polygons, by the number of their colour; empty: the green of leaves
  std::optional<Finish> finish;  ///< of the skeleton, in steps of the turtle's length
  Surface surface;
  TrimMode trim = TrimMode::cut;  ///< what a body around its stems does to them

  const PlantGrammar& source() const { return grammar ? *grammar : *file; }
};

ComponentType lsystem_component();

/// How many steps its word is derived, or at which time it stands.
double steps_of(const Lsystem& plant);
/// How the turtle draws an instance of it where the space around it has these directions.
TurtleParameters turtle_of(const Lsystem& plant, const Directions& directions);
/// The key of an instance's draws.
inline RandomKey word_key(const Site& site) { return site.key.child("word"); }
/// Faults of the grammar while it derives, at the path in the document where the grammar of the component `id` stands.
[[noreturn]] void throw_placed(const InputError& error, const Lsystem& plant, const std::string& id);

}  // namespace meristem

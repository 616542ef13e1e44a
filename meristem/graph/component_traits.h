// SPDX-License-Identifier: Apache-2.0
// The facts that a component type states about itself. The type's definition gives them, the type holds them, and the
// graph reads them through a prototype.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meristem/graph/placement.h"
#include "meristem/plant/material.h"

namespace meristem {

/// What of a component light and gravity turn.
enum class Tropism {
  heading,  ///< toward the light, or down
  face,     ///< the upper face toward the light, the heading down
  none,     ///< nothing: the component bends by itself
};

/// A look of its own for some of a component's geometry.
struct BladeLook {
  Material material;                  ///< material of the geometry
  bool has_document_colours = false;  ///< with the colours that the document gives the component, and their variety
};

/// How a component shows another one, which its text row `of` names: what it does not say itself, it takes from there,
/// and it draws its random numbers as the other one does where both stand on the same parent.
struct Showing {
  std::string type;  ///< type of the other component; empty: it shows none
  /// The rows that it takes from the other component, each with the row's path there, as in "light.limit".
  std::vector<std::pair<std::string, std::string>> rows;
  /// Rows of its own that mean nothing where it shows what growth has left to the other component.
  std::vector<std::string> before_growth;
};

/// Facts about a component type. The defaults suit a component that makes organs.
struct ComponentTraits {
  std::string name;              ///< as documents write it
  std::string doc;               ///< one sentence
  Material material;             ///< material of the geometry, unless the document gives another
  double variety = 0;            ///< variety of colours where the document gives none
  BladeLook blades;              ///< look of what the component emits as blades
  bool has_geometry = true;      ///< false: it has no geometry of its own and no parameters of looks
  bool is_whole_plant = false;   ///< what it places has looks and tropisms of its own
  bool is_camera = false;        ///< the root of every graph
  bool bears_plants = false;     ///< each instance that stands on it directly is a plant of its own (Individual)
  bool speaks_of_space = false;  ///< it makes nothing: what stands on it directly is a plant of its own where it is one
  bool begins_clock = false;     ///< what hangs on it has a clock of its own
  bool grows_in_time = false;    ///< its stems may stand as they stood at an earlier step: nodes tell their births
  bool makes_stems = false;      ///< branch links place children along stems
  bool has_twigs =
      false;              ///< by default children stand along the twigs of its stems alone; what grows has twigs anyway
  bool has_ribs = false;  ///< branch links without placement keys stand at the branch sites, others along the stems
  BranchStance stance = BranchStance::on_bark;  ///< how a branch link sets it on a stem
  Tropism tropism = Tropism::heading;           ///< which direction light and gravity turn
  /// Parameters that growth does not ask for, besides the looks that all components have: where only they change, what
  /// has grown stays.
  std::vector<std::string> after_growth;
  Showing shows;  ///< component that it shows; usually none
};

}  // namespace meristem

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

/// The direction of a component that light and gravity turn.
enum class Tropism {
  heading,  ///< toward the light, or down
  face,     ///< the upper face toward the light, the heading down
  none,     ///< nothing is turned: the component bends its own geometry
};

/// The look of some of a component's geometry, if that differs from the rest.
struct BladeLook {
  Material material;                  ///< material of the geometry
  bool has_document_colours = false;  ///< whether it has the colours and the variety that the document gives the
                                      ///< component
};

/// Describes a component that shows another one, whose id is in its text row `of`. It copies missing rows from the
/// other component. Both draw equal random numbers if they stand on the same parent.
struct ShownComponent {
  std::string type;  ///< type of the other component; empty: this component shows none
  /// Pairs of a row that is copied and the row's path in the other component, as in "light.limit".
  std::vector<std::pair<std::string, std::string>> rows;
  /// Its own rows that have no effect when it shows the remains of the other component's growth.
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
  bool is_whole_plant = false;   ///< the components that it places have their own looks and tropisms
  bool is_camera = false;        ///< the root of every graph
  bool bears_plants = false;     ///< each instance that stands on it directly is a plant of its own (Individual)
  bool speaks_of_space = false;  ///< it has no geometry; if a plant of its own begins at its site, each component that
                                 ///< stands directly on it is one instead
  bool begins_clock = false;     ///< its descendants have a clock of their own
  bool grows_in_time = false;    ///< its stems can be shown as at an earlier step: nodes store their births
  bool makes_stems = false;      ///< branch links place children along stems
  bool has_twigs = false;  ///< by default, children stand only along the twigs of its stems; grown stems always have
                           ///< twigs
  bool has_ribs = false;   ///< branch links without placement keys use the branch sites, other branch links use the
                           ///< stems
  BranchStance stance = BranchStance::on_bark;  ///< position and direction in which a branch link places it on a stem
  Tropism tropism = Tropism::heading;           ///< the direction that light and gravity turn
  /// Parameters that growth does not read, besides the looks that all components have. If only these change, the grown
  /// plants stay valid.
  std::vector<std::string> after_growth;
  ShownComponent shows;  ///< component that it shows; usually none
};

}  // namespace meristem

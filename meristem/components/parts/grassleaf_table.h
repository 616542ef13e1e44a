// SPDX-License-Identifier: Apache-2.0
// The parameters of grass leaves in documents.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "meristem/components/parts/grass_stock.h"
#include "meristem/graph/component.h"
#include "meristem/shape/grass/bend_leaf.h"
#include "meristem/shape/grass/grass_blade.h"
#include "meristem/shape/grass/load_leaf.h"

namespace meristem {

/// Individual growth rates of leaves, as formulas of the lived time and of the visible share.
struct GrassVariety {
  std::optional<ParameterFormula> age, length, width, bend;
  double step = 0.05;  ///< step of the integration, in the unit of ages; smaller: slower and more exact
  int variants = 12;   ///< number of different growth histories; 0: one per leaf

  bool acts() const { return age || length || width || bend; }
};

/// Forces on a leaf.
struct GrassForces {
  Vec3 wind{0};         ///< m/s, in the direction in which it blows
  double light = 0;     ///< pull toward the light, in weights of the leaf
  Vec3 pull{0};         ///< any other pull, in weights of the leaf
  double weight = 2.5;  ///< weight of the blade, N/m2
  LeafStrip strip;
};

/// A sheath below the blade.
struct GrassSheath {
  double length = 0;             ///< metres; 0: no sheath
  std::optional<double> radius;  ///< metres; unset: slightly larger than the stem's
  double open = radians(25);
  double ligule = 0;    ///< height of the ligule, metres
  double clasp = 0.08;  ///< share of the blade over which it unrolls from the curve of the sheath
};

/// The enabled stages. A disabled stage passes its input on unchanged.
struct GrassStages {
  bool load = true, fit = true, age = true, vary = true, bend = true, reduce = true, blade = true;
};

/// Polygons from base to tip per wave; waves with fewer polygons are omitted.
inline constexpr int kPiecesAWave = 4;

/// A grass leaf: a midrib in a plane and widths along it. They are measured or drawn, then aged, bent, reduced and
/// given a surface. The heading is the stem's; the midrib leads away from the stem.
struct Grassleaf : ComponentBase {
  GrassSource source;
  int rank = 1;
  std::optional<int> leaf;
  std::optional<double> length, width;
  double age = 1;
  double full_age = 1;
  GrassVariety vary;
  std::optional<double> inclination;
  double inclination_factor = 1;
  std::vector<LocalTurn> turns;
  std::vector<LocalWidth> widenings;
  std::optional<GrassForces> forces;
  GrassBlade blade;  ///< roll, fold, twist, waves and quads across
  std::optional<ParameterFormula> f, g, h;
  GrassSheath sheath;
  int polygons = 16;
  std::optional<double> error;
  GrassStages stages;
  bool exact = false;

  std::shared_ptr<const GrassStock> stock;  ///< made from the source when the document is read
};

/// Returns the table of all parameters of a grass leaf, in the order of the stages.
Table<Grassleaf> grassleaf_table();

}  // namespace meristem

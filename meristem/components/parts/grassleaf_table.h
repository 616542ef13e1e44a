// SPDX-License-Identifier: Apache-2.0
// The parameters of grass leaves as documents write them.
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

/// How each leaf gets a life of its own: its rates over the time that it has lived, and over the share that is seen.
struct GrassVariety {
  std::optional<Formula> age, length, width, bend;
  double step = 0.05;  ///< of its life, in the unit of ages
  int variants = 12;   ///< lives that leaves share; 0: one each

  bool acts() const { return age || length || width || bend; }
};

/// Forces on a leaf.
struct GrassForces {
  Vec3 wind{0};         ///< m/s, where it blows to
  double light = 0;     ///< pull toward the light, in weights of the leaf
  Vec3 pull{0};         ///< any other, in weights
  double weight = 2.5;  ///< N/m2
  LeafStrip strip;
};

/// A sheath below the blade.
struct GrassSheath {
  double length = 0;             ///< metres; 0: none
  std::optional<double> radius;  ///< metres; unset: a little more than the stem's
  double open = radians(25);
  double ligule = 0;    ///< height of the ligule, metres
  double clasp = 0.08;  ///< share of the blade over which it unrolls from the sheath's round
};

/// Which stages act; one that does not hands on what it got.
struct GrassStages {
  bool load = true, fit = true, age = true, vary = true, bend = true, reduce = true, blade = true;
};

/// Polygons from base to tip that it takes to show a wave; with fewer, waves are left out.
inline constexpr int kPiecesAWave = 4;

/// The leaf of a grass: a midrib in a plane and widths along it, measured or drawn, made older, bent, reduced and given
/// a surface. Its heading is the stem's; the leaf leads away from the stem by its own midrib.
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
  std::optional<GrassForces> forces;
  GrassBlade blade;  ///< its roll, fold, twist, waves and quads across
  std::optional<Formula> f, g, h;
  GrassSheath sheath;
  int polygons = 16;
  std::optional<double> error;
  GrassStages stages;
  bool exact = false;

  std::shared_ptr<const GrassStock> stock;  ///< made of the source when the document is read
};

/// All rows of a grass leaf, in the order of its stages.
Table<Grassleaf> grassleaf_table();

}  // namespace meristem

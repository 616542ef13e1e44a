// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/grassleaf_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace meristem {

namespace {

const std::vector<std::string> kLifeNames{"lived", "visible"};
const std::vector<std::string> kSurfaceNames{"s", "u"};

const ParameterTable& variety_table() {
  static const ParameterTable table =
      Table<GrassVariety>("a variety", "Rates at which each leaf lives; at 1 it develops as the plain leaf does.")
          .formula("age", &GrassVariety::age, kLifeNames,
                   "Rate at which the leaf ages, as a factor; a random call is drawn once per leaf. Raised, it matures "
                   "earlier.")
          .formula("length", &GrassVariety::length, kLifeNames,
                   "Factor on the length that emerges per unit of age; raised, a longer leaf.")
          .formula("width", &GrassVariety::width, kLifeNames,
                   "Factor on the width of what emerges; raised, a broader leaf.")
          .formula("bend", &GrassVariety::bend, kLifeNames,
                   "Factor on how far the midrib bends per unit of age; raised, the leaf hangs more.")
          .number("step", &GrassVariety::step, {.min = 1e-3, .max = 1000, .usual = {0.01, 0.2}, .fixed = true},
                  "Step of the leaf's life, in the unit of ages; lowered, it follows changing rates more closely.")
          .integer("variants", &GrassVariety::variants, {.min = 0, .max = 1'000'000, .fixed = true},
                   "Number of different lives that the leaves share; raised, more variety and more meshes; 0 gives "
                   "each leaf its own.")
          .only_where({{"age"}, {"length"}, {"width"}, {"bend"}}, {"step", "variants"});
  return table;
}

const ParameterTable& turn_table() {
  static const ParameterTable table =
      Table<LocalTurn>("a turn", "A change of the midrib's direction.")
          .number("from", &LocalTurn::from, {.min = 0, .max = 1},
                  "Position along the midrib where the turn begins, from base (0) to tip (1).")
          .number("to", &LocalTurn::to, {.min = 0, .max = 1},
                  "Position along the midrib where the turn ends; equal to 'from', it makes a kink.")
          .number("angle", &LocalTurn::angle, {.unit = Unit::degree, .min = -720, .max = 720, .usual = {-90, 90}},
                  "Bend of the leaf beyond the turn; raised, the leaf bends down, away from the stem.")
          .check([](const LocalTurn& turn, const DocumentPath& path, ParameterReader& reader) {
            if (turn.to < turn.from)
              reader.add_error(DocumentPath(path, "to"), "the turn ends before it begins", "'from' or more");
          });
  return table;
}

const ParameterTable& widening_table() {
  static const ParameterTable table =
      Table<LocalWidth>("a widening", "A change of the leaf's width at a place of the blade.")
          .number("from", &LocalWidth::from, {.min = 0, .max = 1, .fixed = true},
                  "Position along the midrib where the change begins, from base (0) to tip (1).")
          .number("to", &LocalWidth::to, {.min = 0, .max = 1, .fixed = true},
                  "Position along the midrib where the change ends.")
          .number("factor", &LocalWidth::factor, {.min = 0, .max = 100, .usual = {0, 3}},
                  "Width in the middle of the change, compared with the width before; above 1 a bulge, below 1 a "
                  "waist.")
          .required()
          .check([](const LocalWidth& width, const DocumentPath& path, ParameterReader& reader) {
            if (width.to <= width.from)
              reader.add_error(DocumentPath(path, "to"), "the widening ends where it begins, or before",
                               "above 'from'");
          });
  return table;
}

const ParameterTable& strip_table() {
  static const ParameterTable table =
      Table<LeafStrip>("a strip", "How a leaf resists bending.")
          .number("stiffness", &LeafStrip::stiffness, {.min = 1e-3, .max = 1e6, .usual = {0.05, 2}},
                  "Bending stiffness at the base over weight and cubed length: 0.1 hardly carries the leaf, 1 is "
                  "upright; raised, it bends less.")
          .number("tip_thickness", &LeafStrip::tip_thickness, {.min = 0.01, .max = 1},
                  "Thickness of the leaf at its tip, as a share of that at its base; raised, a stiffer tip.");
  return table;
}

const ParameterTable& forces_table() {
  static const ParameterTable table =
      Table<GrassForces>("forces", "Forces that bend a leaf.")
          .vector("wind", &GrassForces::wind, {.min = -60, .max = 60, .usual = {-15, 15}},
                  "Velocity of the wind in metres per second, in the direction in which it blows.")
          .in_space(InSpace::direction)
          .number("light", &GrassForces::light, {.min = -100, .max = 100, .usual = {-3, 3}},
                  "Pull toward the light, in weights of the leaf; negative pulls away from it.")
          .vector("pull", &GrassForces::pull, {.min = -100, .max = 100, .usual = {-3, 3}},
                  "Further pull on the leaf, in weights of the leaf along x, y and z.")
          .in_space(InSpace::direction)
          .number("weight", &GrassForces::weight, {.min = 0.01, .max = 1000, .usual = {0.5, 10}},
                  "Weight of the leaf in newtons per square metre; raised, wind moves it less.")
          .members(&GrassForces::strip, strip_table())
          .only_with("wind", {"weight"})
          .only_where({{"wind"}, {"light"}, {"pull"}}, {"stiffness", "tip_thickness"});
  return table;
}

const ParameterTable& waves_table() {
  static const ParameterTable table =
      Table<EdgeWaves>("waves", "Waves of the leaf's edges.")
          .number("number", &EdgeWaves::number, {.min = 0, .max = 100, .usual = {0, 12}},
                  "Number of waves along each edge from base to tip; each takes 4 of the polygons.")
          .number("depth", &EdgeWaves::depth, {.min = -2, .max = 2, .usual = {0, 1}},
                  "Height of the waves' crests, as a share of the half width there; raised, a more crinkled edge.")
          .number("left", &EdgeWaves::left, {.unit = Unit::degree, .min = -3600, .max = 3600},
                  "Phase of the left edge's waves at the base.")
          .number(
              "right", &EdgeWaves::right, {.unit = Unit::degree, .min = -3600, .max = 3600},
              "Phase of the right edge's waves at the base; where it equals the left one, both edges rise together.")
          .only_with("number", {"depth", "left", "right"})
          .only_with("depth", {"number"});
  return table;
}

const ParameterTable& sheath_table() {
  static const ParameterTable table =
      Table<GrassSheath>("a sheath", "The sheath, which holds a blade to its stem.")
          .number("length", &GrassSheath::length, {.unit = Unit::metre, .min = 0, .max = 100, .usual = {0, 0.3}},
                  "Length of the sheath from the collar down; 0 makes none.")
          .number("radius", &GrassSheath::radius,
                  {.unit = Unit::metre, .min = 1e-5, .max = 10, .usual = {0.0005, 0.02}},
                  "Radius of the sheath at its upper rim; by default, a little more than the stem's.")
          .number("open", &GrassSheath::open, {.unit = Unit::degree, .min = 0, .max = 300, .usual = {0, 90}},
                  "Gap between the sheath's edges, opposite the blade.")
          .number("ligule", &GrassSheath::ligule, {.unit = Unit::metre, .min = 0, .max = 1, .usual = {0, 0.01}},
                  "Height of the ligule, the membrane above the sheath; 0 makes none.")
          .number("clasp", &GrassSheath::clasp, {.min = 0.001, .max = 1, .usual = {0.01, 0.3}, .fixed = true},
                  "Share of the blade over which it unrolls from the round of the sheath; raised, it clasps the stem "
                  "longer.")
          .only_with("length", {"radius", "open", "ligule", "clasp"});
  return table;
}

const ParameterTable& stages_table() {
  static const ParameterTable table =
      Table<GrassStages>("stages", "Stages that act on a leaf.")
          .boolean("load", &GrassStages::load,
                   "Whether the document's curves are used; otherwise the built-in leaf is.")
          .boolean("fit", &GrassStages::fit,
                   "Whether smooth curves are fitted to the points; otherwise lines join them.")
          .boolean("age", &GrassStages::age, "Whether the leaf has the form of its age; otherwise it is full grown.")
          .boolean("vary", &GrassStages::vary,
                   "Whether each leaf has a life of its own, by the rates in 'vary'; needs the stage 'age'.")
          .boolean("bend", &GrassStages::bend, "Whether inclination, turns, widenings and forces act.")
          .boolean("reduce", &GrassStages::reduce,
                   "Whether the leaf is reduced to its polygons; otherwise it keeps all pieces of the fit.")
          .boolean("blade", &GrassStages::blade,
                   "Whether twist, fold, roll, waves, displacements and the sheath act; otherwise the blade is flat.");
  return table;
}

const ParameterTable& blade_table() {
  static const ParameterTable table =
      Table<GrassBlade>("a blade", "The surface over a grass leaf's midrib.")
          .number("twist", &GrassBlade::twist, {.unit = Unit::degree, .min = -3600, .max = 3600, .usual = {-360, 360}},
                  "Torsion of the blade about its midrib from base to tip.")
          .curve("twist_along", &GrassBlade::twist_along,
                 "Share of the twist that is reached from base (0) to tip (1).")
          .number("fold", &GrassBlade::fold, {.unit = Unit::degree, .min = -85, .max = 85},
                  "Angle that each half of the blade is raised about the midrib; raised, a steeper V.")
          .number(
              "roll", &GrassBlade::roll, {.unit = Unit::degree, .min = -320, .max = 320},
              "Bend of the blade from edge to edge; raised, the edges rise more, as in drought and in young leaves.")
          .object("waves", &GrassBlade::waves, waves_table, "Waves of the leaf's edges.")
          .integer("across", &GrassBlade::across, {.min = 2, .max = 32, .fixed = true},
                   "Number of quads from edge to edge, which must be even; raised, rolls and waves are rounder.")
          .only_with("twist", {"twist_along"});
  return table;
}

void check_grassleaf(const Grassleaf& grass, const DocumentPath& path, ParameterReader& reader) {
  if (grass.blade.across % 2 != 0) {
    reader.add_error(DocumentPath(path, "across"), "'across' is odd",
                     "an even number, so that a row of points is the midrib");
  }
  for (const Vec2 point : grass.source.profile.points()) {
    if (point.y >= 0) continue;
    reader.add_error(DocumentPath(path, "profile"), fmt::format("the profile falls to {}", point.y),
                     "shares of the width from 0");
    return;
  }
  const auto& profile = grass.source.profile.points();
  if (std::ranges::none_of(profile, [](Vec2 point) { return point.y > 0; })) {
    reader.add_error(DocumentPath(path, "profile"), "the profile is empty", "a share of the width above 0 somewhere");
    return;
  }
  const auto check_points = [&](const std::vector<Vec2>& points, const DocumentPath& at) {
    try {
      check_midrib(curve_of(points));
    } catch (const InputError& error) {
      for (const Diagnostic& found : error.diagnostics()) reader.add_error(at, found.message, found.expected);
    }
  };
  if (!grass.source.midrib_points.empty())
    check_points(grass.source.midrib_points, DocumentPath(path, "midrib_points"));
  const DocumentPath midribs(path, "midribs");
  for (std::size_t k = 0; k < grass.source.midribs.size(); ++k) {
    const DocumentPath midrib(midribs, k);
    check_points(grass.source.midribs[k].points, DocumentPath(midrib, "points"));
  }
  for (std::size_t k = 1; k < grass.source.midribs.size(); ++k) {
    if (grass.source.midribs[k].age > grass.source.midribs[k - 1].age) continue;
    reader.add_error(DocumentPath(DocumentPath(path, "midribs"), k), "the ages of the midribs do not rise",
                     "a later age than before");
    return;
  }
}

/// Warns if waves are omitted because there are too few polygons.
void warn_of_lost_waves(const Grassleaf& grass, const DocumentPath& path, ParameterReader& reader) {
  const EdgeWaves& waves = grass.blade.waves;
  const DocumentPath at_waves(path, "waves");
  const DocumentPath number(at_waves, "number"), polygons(path, "polygons");
  if (!grass.stages.reduce || !grass.stages.blade || grass.error || waves.depth == 0) return;
  if (reader.numbers().is_worked_out(number) || reader.numbers().is_worked_out(polygons)) return;
  if (!(grass.polygons < kPiecesAWave * waves.number)) return;
  reader.warn(polygons,
              fmt::format("{} polygons are too few to show {:.7g} waves, which are left out; {} or more show them",
                          grass.polygons, waves.number, std::ceil(kPiecesAWave * waves.number)));
}

/// Fits the curves of the document. Reports errors at their paths.
void prepare_grassleaf(Grassleaf& grass, const DocumentPath& path, ParameterReader& reader) {
  const char* row = grass.source.midribs.empty() ? "midrib" : "midribs";
  try {
    const StockOptions how{.is_loaded = grass.stages.load, .is_fitted = grass.stages.fit, .full_age = grass.full_age};
    grass.stock = reader.files().kept<GrassStock>(fingerprint_of(grass.source, how),
                                                  [&] { return make_stock(grass.source, how); });
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics())
      reader.add_error(DocumentPath(path, row), found.message, found.expected);
    return;
  } catch (const std::invalid_argument& error) {
    reader.add_error(DocumentPath(path, row), error.what());
    return;
  }
  warn_of_lost_waves(grass, path, reader);
  for (const StockedMidrib& midrib : grass.stock->midribs) {
    if (grass.full_age <= midrib.family.last_age()) continue;
    reader.add_error(DocumentPath(path, "full_age"),
                     fmt::format("the midribs end at the age {}", midrib.family.last_age()),
                     "at most that age, or the blade never emerges fully");
    return;
  }
}

}  // namespace

Table<Grassleaf> grassleaf_table() {
  return Table<Grassleaf>("a grassleaf", "A grass leaf, in stages.")
      .members(&Grassleaf::source, grass_source_table())
      .integer("rank", &Grassleaf::rank, {.min = -1000, .max = 1000, .usual = {1, 12}},
               "Rank of the leaf on its stem, which selects curves from files that have ranks.")
      .integer("leaf", &Grassleaf::leaf, {.min = 0, .max = 1e6},
               "Number of the leaf (lindex) in files that have several per rank; by default, a random one of the rank.")
      .number("length", &Grassleaf::length, {.unit = Unit::metre, .min = 1e-4, .max = 100, .usual = {0.02, 1}},
              "Length of the full-grown blade; by default, as measured in the files, or 0.3.")
      .number(
          "width", &Grassleaf::width, {.unit = Unit::metre, .min = 1e-5, .max = 100, .usual = {0.001, 0.06}},
          "Width of the full-grown blade at its widest; by default, as measured in the files, or 0.06 of the length.")
      .number(
          "age", &Grassleaf::age, {.min = -1e4, .max = 1e4, .usual = {0, 1}},
          "Age of the leaf, from 0 (straight, just emerging) to 1 (full grown); with midribs by age, in their unit.")
      .number("full_age", &Grassleaf::full_age,
              {.min = 0, .max = 1e4, .usual = {0.1, 1}, .above_min = true, .fixed = true},
              "Age at which the blade has fully emerged.")
      .object("vary", &Grassleaf::vary, variety_table, "Rates that give each leaf a life of its own.")
      .number("inclination", &Grassleaf::inclination, {.unit = Unit::degree, .min = 0, .max = 180},
              "Angle between stem and leaf at the collar at any age; by default, that of the midrib. Raised, the leaf "
              "stands off more.")
      .number("inclination_factor", &Grassleaf::inclination_factor, {.min = 0, .max = 10, .usual = {0, 3}},
              "Factor on the inclination; raised, the leaf stands off more.")
      .list("turns", &Grassleaf::turns, turn_table, "Local turns of the midrib, which add up.")
      .list("widenings", &Grassleaf::widenings, widening_table,
            "Changes of the leaf's width at places of the blade, whose factors multiply.")
      .object("forces", &Grassleaf::forces, forces_table,
              "Wind, light and other forces that bend the leaf as an elastic strip.")
      .members(&Grassleaf::blade, blade_table())
      .formula("f", &Grassleaf::f, kSurfaceNames,
               "Displacement of the surface away from the stem, in widths of the blade, over s (0 at the base to 1) "
               "and u (-0.5 to 0.5 across).")
      .formula("g", &Grassleaf::g, kSurfaceNames,
               "Displacement of the surface up the stem, in widths of the blade, over s (0 at the base to 1) and u "
               "(-0.5 to 0.5 across).")
      .formula("h", &Grassleaf::h, kSurfaceNames,
               "Displacement of the surface across the leaf, in widths of the blade, over s (0 at the base to 1) and u "
               "(-0.5 to 0.5 across).")
      .object("sheath", &Grassleaf::sheath, sheath_table, "Sheath that holds the blade to its stem.")
      .integer("polygons", &Grassleaf::polygons, {.min = 1, .max = 1000, .usual = {1, 64}},
               "Number of quads from base to tip on either side of the midrib; lowered, the points that matter least "
               "go first.")
      .number("error", &Grassleaf::error, {.min = 1e-6, .max = 1, .usual = {0.0005, 0.05}},
              "Tolerance of the reduction, as a share of the leaf's length, in place of a number of polygons; raised, "
              "fewer polygons.")
      .never_with("error", {"polygons"})
      .only_where({{"midrib"}, {"widths"}}, {"rank", "leaf", "unit"})
      .only_where({{"exact", {false}}}, {"vary.variants"})
      .object("stages", &Grassleaf::stages, stages_table,
              "Stages that act; a stage that is off hands its leaf on unchanged.")
      .boolean("exact", &Grassleaf::exact,
               "Whether each leaf has a mesh of its own; otherwise shapes are rounded so that leaves share meshes.")
      .check(check_grassleaf)
      .prepare(prepare_grassleaf);
}

}  // namespace meristem

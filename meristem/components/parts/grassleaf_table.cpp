// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/grassleaf_table.h"

#include <algorithm>
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
      Table<GrassVariety>("a variety", "Rates by which a leaf lives, 1 as the plain leaf does.")
          .formula("age", &GrassVariety::age, kLifeNames, "How fast it ages. A random call draws once for each leaf.")
          .formula("length", &GrassVariety::length, kLifeNames, "How much length comes out.")
          .formula("width", &GrassVariety::width, kLifeNames, "How wide it is where it comes out.")
          .formula("bend", &GrassVariety::bend, kLifeNames, "How far its pieces turn as it ages.")
          .number("step", &GrassVariety::step, {.min = 1e-3, .max = 1000, .fixed = true},
                  "Of its life, in the unit of ages; lowered, rates that change are followed more closely.")
          .integer("variants", &GrassVariety::variants, {.min = 0, .max = 1'000'000, .fixed = true},
                   "Lives that leaves share; raised, more meshes; 0: one for each leaf.")
          .only_where({{"age"}, {"length"}, {"width"}, {"bend"}}, {"step", "variants"});
  return table;
}

const ParameterTable& turn_table() {
  static const ParameterTable table =
      Table<LocalTurn>("a turn", "A change of the midrib's direction.")
          .number("from", &LocalTurn::from, {.min = 0, .max = 1}, "Place along the midrib where it begins.")
          .number("to", &LocalTurn::to, {.min = 0, .max = 1}, "Where it ends; the same: a kink.")
          .number("angle", &LocalTurn::angle, {.unit = Unit::degree, .min = -720, .max = 720},
                  "By which all beyond is turned; raised, down.")
          .check([](const LocalTurn& turn, const Place& place, ParameterReader& reader) {
            if (turn.to < turn.from)
              reader.fault(Place(place, "to"), "the turn ends before it begins", "'from' or more");
          });
  return table;
}

const ParameterTable& strip_table() {
  static const ParameterTable table =
      Table<LeafStrip>("a strip", "How a leaf yields.")
          .number("stiffness", &LeafStrip::stiffness, {.min = 1e-3, .max = 1e6},
                  "Over that by which a leaf of this length hardly carries its weight; raised, it yields less.")
          .number("tip_thickness", &LeafStrip::tip_thickness, {.min = 0.01, .max = 1},
                  "Of the tip over the base; raised, a stiffer tip.");
  return table;
}

const ParameterTable& forces_table() {
  static const ParameterTable table =
      Table<GrassForces>("forces", "What bends a leaf.")
          .vector("wind", &GrassForces::wind, {.min = -60, .max = 60}, "Metres a second, where it blows to.")
          .number("light", &GrassForces::light, {.min = -100, .max = 100},
                  "Pull toward the light, in weights of the leaf; negative: away from it.")
          .vector("pull", &GrassForces::pull, {.min = -100, .max = 100}, "Any other pull, in weights of the leaf.")
          .number("weight", &GrassForces::weight, {.min = 0.01, .max = 1000}, "Of the leaf, newtons a square metre.")
          .members(&GrassForces::strip, strip_table())
          .only_with("wind", {"weight"})
          .only_where({{"wind"}, {"light"}, {"pull"}}, {"stiffness", "tip_thickness"});
  return table;
}

const ParameterTable& waves_table() {
  static const ParameterTable table =
      Table<EdgeWaves>("waves", "Waves of the edges.")
          .number("number", &EdgeWaves::number, {.min = 0, .max = 100},
                  "From base to tip; each takes 4 of the polygons.")
          .number("depth", &EdgeWaves::depth, {.min = -2, .max = 2}, "Of the crests, a share of half the width there.")
          .number("left", &EdgeWaves::left, {.unit = Unit::degree, .min = -3600, .max = 3600},
                  "Phase of the left edge at the base.")
          .number("right", &EdgeWaves::right, {.unit = Unit::degree, .min = -3600, .max = 3600},
                  "Of the right edge; the same as the left: both rise together.")
          .only_with("number", {"depth", "left", "right"})
          .only_with("depth", {"number"});
  return table;
}

const ParameterTable& sheath_table() {
  static const ParameterTable table =
      Table<GrassSheath>("a sheath", "What holds a blade to its stem.")
          .number("length", &GrassSheath::length, {.unit = Unit::metre, .min = 0, .max = 100}, "From the collar down.")
          .number("radius", &GrassSheath::radius, {.unit = Unit::metre, .min = 1e-5, .max = 10},
                  "Of its upper rim; a little more than the stem's if not given.")
          .number("open", &GrassSheath::open, {.unit = Unit::degree, .min = 0, .max = 300},
                  "Gap between its edges, opposite the blade.")
          .number("ligule", &GrassSheath::ligule, {.unit = Unit::metre, .min = 0, .max = 1}, "Height of the ligule.")
          .number("clasp", &GrassSheath::clasp, {.min = 0.001, .max = 1, .fixed = true},
                  "Share of the blade over which it unrolls from the sheath's round.")
          .only_with("length", {"radius", "open", "ligule", "clasp"});
  return table;
}

const ParameterTable& stages_table() {
  static const ParameterTable table =
      Table<GrassStages>("stages", "Which stages act.")
          .boolean("load", &GrassStages::load, "Take curves of the document, not the built-in leaf.")
          .boolean("fit", &GrassStages::fit, "Smooth curves, not lines from point to point.")
          .boolean("age", &GrassStages::age, "The leaf at its age, not full grown.")
          .boolean("vary", &GrassStages::vary, "A life of its own; only with the stage of age.")
          .boolean("bend", &GrassStages::bend, "Inclination, turns and forces.")
          .boolean("reduce", &GrassStages::reduce, "So many polygons, not all pieces of the fit.")
          .boolean("blade", &GrassStages::blade, "Twist, folds, waves, hooks and the sheath, not a flat blade.");
  return table;
}

const ParameterTable& blade_table() {
  static const ParameterTable table =
      Table<GrassBlade>("a blade", "The surface over a grass leaf's midrib.")
          .number("twist", &GrassBlade::twist, {.unit = Unit::degree, .min = -3600, .max = 3600},
                  "Torsion about the midrib from base to tip.")
          .curve("twist_along", &GrassBlade::twist_along, "Share of the twist that is reached, from base to tip.")
          .number("fold", &GrassBlade::fold, {.unit = Unit::degree, .min = -85, .max = 85},
                  "Angle by which both halves rise about the midrib, a V.")
          .number("roll", &GrassBlade::roll, {.unit = Unit::degree, .min = -320, .max = 320},
                  "Bend from edge to edge; raised, the edges rise more, as in drought and young leaves.")
          .object("waves", &GrassBlade::waves, waves_table, "Waves of the edges.")
          .integer("across", &GrassBlade::across, {.min = 2, .max = 32, .fixed = true},
                   "Quads from edge to edge, an even number; raised, rolls and waves are rounder.")
          .only_with("twist", {"twist_along"});
  return table;
}

void check_grassleaf(const Grassleaf& grass, const Place& place, ParameterReader& reader) {
  if (grass.blade.across % 2 != 0) {
    reader.fault(Place(place, "across"), "'across' is odd", "an even number, so that a row of points is the midrib");
  }
  for (const Vec2 point : grass.source.profile.points()) {
    if (point.y >= 0) continue;
    reader.fault(Place(place, "profile"), fmt::format("the profile falls to {}", point.y),
                 "shares of the width from 0");
    return;
  }
  const auto& profile = grass.source.profile.points();
  if (std::ranges::none_of(profile, [](Vec2 point) { return point.y > 0; })) {
    reader.fault(Place(place, "profile"), "the profile is empty", "a share of the width above 0 somewhere");
    return;
  }
  const auto check_points = [&](const std::vector<Vec2>& points, const Place& at) {
    try {
      check_midrib(curve_of(points));
    } catch (const InputError& error) {
      for (const Diagnostic& found : error.diagnostics()) reader.fault(at, found.message, found.expected);
    }
  };
  if (!grass.source.midrib_points.empty()) check_points(grass.source.midrib_points, Place(place, "midrib_points"));
  const Place midribs(place, "midribs");
  for (std::size_t k = 0; k < grass.source.midribs.size(); ++k) {
    const Place midrib(midribs, k);
    check_points(grass.source.midribs[k].points, Place(midrib, "points"));
  }
  for (std::size_t k = 1; k < grass.source.midribs.size(); ++k) {
    if (grass.source.midribs[k].age > grass.source.midribs[k - 1].age) continue;
    reader.fault(Place(Place(place, "midribs"), k), "the ages of the midribs do not rise", "a later age than before");
    return;
  }
}

/// Fits what the document gives; what is wrong with it is a fault at its place.
void prepare_grassleaf(Grassleaf& grass, const Place& place, ParameterReader& reader) {
  const char* row = grass.source.midribs.empty() ? "midrib" : "midribs";
  try {
    const StockOptions how{.is_loaded = grass.stages.load, .is_fitted = grass.stages.fit, .full_age = grass.full_age};
    grass.stock =
        reader.kept<GrassStock>(fingerprint_of(grass.source, how), [&] { return make_stock(grass.source, how); });
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) reader.fault(Place(place, row), found.message, found.expected);
    return;
  } catch (const std::invalid_argument& error) {
    reader.fault(Place(place, row), error.what());
    return;
  }
  for (const StockedMidrib& midrib : grass.stock->midribs) {
    if (grass.full_age <= midrib.family.last_age()) continue;
    reader.fault(Place(place, "full_age"), fmt::format("the midribs end at the age {}", midrib.family.last_age()),
                 "at most that, or the blade never comes out whole");
    return;
  }
}

}  // namespace

Table<Grassleaf> grassleaf_table() {
  return Table<Grassleaf>("a grassleaf", "A grass's leaf, by stages.")
      .members(&Grassleaf::source, grass_source_table())
      .integer("rank", &Grassleaf::rank, {.min = -1000, .max = 1000}, "Of the leaf, where files have ranks.")
      .integer("leaf", &Grassleaf::leaf, {.min = 0, .max = 1e6},
               "Its lindex in the files; any of its rank if not given.")
      .number("length", &Grassleaf::length, {.unit = Unit::metre, .min = 1e-4, .max = 100},
              "Of the full-grown blade; if not given as measured in files, else 0.3.")
      .number("width", &Grassleaf::width, {.unit = Unit::metre, .min = 1e-5, .max = 100},
              "Where it is widest; if not given as measured in files, else 0.06 of the length.")
      .number("age", &Grassleaf::age, {.min = -1e4, .max = 1e4},
              "Of the leaf: from 0, straight and only begun, to 1, full grown; with midribs by age in their unit.")
      .number("full_age", &Grassleaf::full_age, {.min = 0, .max = 1e4, .above_min = true, .fixed = true},
              "At which the blade has come out whole.")
      .object("vary", &Grassleaf::vary, variety_table, "Rates that give each leaf a life of its own.")
      .number("inclination", &Grassleaf::inclination, {.unit = Unit::degree, .min = 0, .max = 180},
              "Between stem and leaf at the collar, whatever the age; the midrib's own if not given.")
      .number("inclination_factor", &Grassleaf::inclination_factor, {.min = 0, .max = 10},
              "By which that is multiplied; raised, the leaf stands off more.")
      .list("turns", &Grassleaf::turns, turn_table, "Changes of the midrib's direction, all of which act.")
      .object("forces", &Grassleaf::forces, forces_table,
              "Wind, light and other pulls that bend it as an elastic strip.")
      .members(&Grassleaf::blade, blade_table())
      .formula("f", &Grassleaf::f, kSurfaceNames,
               "Moves the surface away from the stem: widths of the blade at the place s (0 to 1) and u (-0.5 to 0.5 "
               "across).")
      .formula("g", &Grassleaf::g, kSurfaceNames, "The same up the stem.")
      .formula("h", &Grassleaf::h, kSurfaceNames, "The same across.")
      .object("sheath", &Grassleaf::sheath, sheath_table, "What holds the blade to its stem.")
      .integer("polygons", &Grassleaf::polygons, {.min = 1, .max = 1000},
               "From base to tip, each with a quad on either side of the midrib; lowered, those go that matter least.")
      .number("error", &Grassleaf::error, {.min = 1e-6, .max = 1},
              "In its stead by how much the leaf may change: a share of its length.")
      .never_with("error", {"polygons"})
      .only_where({{"midrib"}, {"widths"}}, {"rank", "leaf", "unit"})
      .only_where({{"exact", {false}}}, {"vary.variants"})
      .object("stages", &Grassleaf::stages, stages_table, "Which stages act; others hand on what they get.")
      .boolean("exact", &Grassleaf::exact, "Each leaf a mesh of its own, in place of rounding what leaves share.")
      .check(check_grassleaf)
      .prepare(prepare_grassleaf);
}

}  // namespace meristem

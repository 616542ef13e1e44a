// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/surface_table.h"

#include "meristem/graph/table/table.h"
#include "meristem/plant/plant.h"

namespace meristem {

namespace {

const ParameterTable& crown_body_table() {
  static const ParameterTable table =
      Table<CrownBody>("a crown body", "A closed body around the ends of branches, made of balls that grow together.")
          .number("diameter", &CrownBody::diameter,
                  {.unit = Unit::metre, .min = 0.001, .max = 1000, .usual = {0.05, 2}, .fixed = true},
                  "Diameter of the balls that the crown body is made of.")
          .number("offset", &CrownBody::offset, {.unit = Unit::metre, .min = -1000, .max = 1000, .fixed = true},
                  "Height of each ball's centre above the end of its branch.")
          .number(
              "fuse", &CrownBody::fuse, {.unit = Unit::metre, .min = 0, .max = 1000, .fixed = true},
              "Distance over which the balls grow together; raised, smoother and fuller; 0 lets them meet in creases.")
          .choice("blend", &CrownBody::blend, {"poly", "root", "pasko"},
                  "How the balls grow together: 'poly' with a fillet, 'root' swelling each other everywhere, 'pasko' "
                  "with filled creases; the last two are slow.")
          .integer(
              "resolution", &CrownBody::resolution, {.min = 10, .max = 1024, .fixed = true},
              "Number of cells along the crown body's longest side; doubled, finer, with four times as many triangles.")
          .integer("triangles", &CrownBody::triangles, {.min = 4, .max = 50e6, .usual = {100, 20000}, .fixed = true},
                   "Number of triangles to which the crown body is simplified, as far as its holes allow; by default, "
                   "it is not simplified.")
          .colour("colour", &CrownBody::colour, "Colour of the crown body.")
          .boolean("hidden", &CrownBody::hidden,
                   "Whether the crown body is invisible and only holds the children of crown links.");
  return table;
}

}  // namespace

const std::vector<std::string>& trim_modes() {
  static const std::vector<std::string> names = {"cut", "fit", "none"};
  return names;
}

const std::vector<std::string>& names_off_stems() {
  static const std::vector<std::string> names = {"texture.picture.repeat_u", "texture.picture.repeat_v",
                                                 "texture.picture.shift_u", "texture.picture.shift_v"};
  return names;
}

const ParameterTable& surface_table() {
  static const ParameterTable table =
      Table<SurfaceOptions>("a surface", "How a skeleton becomes a surface.")
          .choice("style", &SurfaceOptions::style, {"tubes", "blend"},
                  "Kind of surface: 'tubes' along the axes, or 'blend', one closed body for low-poly plants.")
          .choice("shading", &SurfaceOptions::shading, {"smooth", "flat"},
                  "Shading: 'smooth' hides the edges between triangles, 'flat' shows each triangle as a plane.")
          .object("crown", &SurfaceOptions::crown, crown_body_table, "A closed body around the ends of the branches.")
          .integer("resolution", &SurfaceOptions::resolution, {.min = 10, .max = 1024, .fixed = true},
                   "Number of cells along the longest side of a blended surface; doubled, finer, with four times as "
                   "many triangles.")
          .number("blend", &SurfaceOptions::blend, {.min = 0, .max = 4, .usual = {0, 2}, .fixed = true},
                  "Distance over which a branch of a blended surface grows together with its parent, in radii of the "
                  "branch; 0 leaves a crease.")
          .boolean("thicken", &SurfaceOptions::thicken,
                   "Whether twigs of a blended surface that are too thin for its cells are thickened; otherwise they "
                   "vanish.")
          .integer("triangles", &SurfaceOptions::triangles,
                   {.min = 4, .max = 50e6, .usual = {100, 20000}, .fixed = true},
                   "Number of triangles to which a blended surface is simplified, as far as twigs and holes allow; by "
                   "default, it is not simplified.")
          .integer(
              "sides", &SurfaceOptions::sides, {.min = 3, .max = 64, .usual = {3, 32}, .fixed = true},
              "Number of sides of the thickest tube; thinner tubes have fewer. Raised, rounder, with more triangles.")
          .number(
              "error", &SurfaceOptions::error, {.min = 0, .max = 1, .usual = {0, 0.2}, .fixed = true},
              "Tolerance of a tube along its skeleton, in radii of the tube; raised, fewer rings along straight stems.")
          .choice("cap", &SurfaceOptions::cap, {"pointed", "round", "flat"}, "How tubes end at tips.")
          .number("uv_scale", &SurfaceOptions::uv_scale,
                  {.unit = Unit::metre, .min = 0.001, .max = 100, .usual = {0.1, 5}, .fixed = true},
                  "Size of the bark that one tile of the texture covers; raised, larger features.")
          .number("shift_u", &SurfaceOptions::shift_u, {.min = -1000, .max = 1000, .usual = {0, 1}, .fixed = true},
                  "Shift of the texture around tubes, in tiles.")
          .number("shift_v", &SurfaceOptions::shift_v, {.min = -1000, .max = 1000, .usual = {0, 1}, .fixed = true},
                  "Shift of the texture along tubes, in tiles; raised, the picture moves toward the base.")
          .number(
              "turn", &SurfaceOptions::turn,
              {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 180}, .fixed = true},
              "Turn of the texture on tubes, at the nearest angle at which tiles still join around the tube; 90 lays "
              "a picture on its side.")
          .boolean("mirror", &SurfaceOptions::mirror, "Whether the texture of tubes is mirrored around them.")
          .number("smooth", &SurfaceOptions::smooth, {.min = 0, .max = 20, .usual = {0, 10}, .fixed = true},
                  "Distance along a stem over which steps of its radius at forks are smoothed, in radii to either "
                  "side; 0 keeps the steps.")
          .number("collar", &SurfaceOptions::collar, {.min = 0, .max = 3, .usual = {0, 2}, .fixed = true},
                  "Size of the collar with which a branch grows out of its parent, in radii of the branch; 0 leaves a "
                  "crease.")
          .number("flare", &SurfaceOptions::flare, {.min = 0, .max = 5, .usual = {0, 2}, .fixed = true},
                  "Widening of the stem at the ground, as a share of its radius; 1 doubles it.")
          .only_where({{"style", {"tubes"}}},
                      {"sides", "error", "cap", "uv_scale", "shift_u", "shift_v", "turn", "mirror", "smooth", "collar"})
          .only_where({{"style", {"blend"}}}, {"resolution", "blend", "thicken", "triangles"})
          .only_where({{"style", {"blend"}}, {"crown"}}, {"shading"});
  return table;
}

}  // namespace meristem

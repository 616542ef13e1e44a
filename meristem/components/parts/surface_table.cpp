// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/surface_table.h"

#include "meristem/graph/table/table.h"
#include "meristem/plant/plant.h"

namespace meristem {

namespace {

const ParameterTable& crown_body_table() {
  static const ParameterTable table =
      Table<CrownBody>("a crown body", "A closed body about the ends of branches, of balls that grow together.")
          .number("diameter", &CrownBody::diameter, {.unit = Unit::metre, .min = 0.001, .max = 1000, .fixed = true},
                  "Of the balls.")
          .number("offset", &CrownBody::offset, {.unit = Unit::metre, .min = -1000, .max = 1000, .fixed = true},
                  "How far above its branch's end each ball stands.")
          .number("fuse", &CrownBody::fuse, {.unit = Unit::metre, .min = 0, .max = 1000, .fixed = true},
                  "Over which balls grow together; raised, smoother and fuller; 0: they meet in creases.")
          .choice("blend", &CrownBody::blend, {"poly", "root", "pasko"},
                  "How they do: poly: with a fillet; root: all swell each other, slow; pasko: filled creases, slow.")
          .integer("resolution", &CrownBody::resolution, {.min = 10, .max = 1024, .fixed = true},
                   "Cells along the body's longest side; raised, finer, with the square as many triangles.")
          .integer("triangles", &CrownBody::triangles, {.min = 4, .max = 50e6, .fixed = true},
                   "Simplified to so many, if holes let it; unset, all that the cells give.")
          .colour("colour", &CrownBody::colour, "Of the body.")
          .boolean("hidden", &CrownBody::hidden, "Whether it only holds what links of kind crown set into it.");
  return table;
}

}  // namespace

const std::vector<std::string>& names_off_stems() {
  static const std::vector<std::string> names = {"texture.picture.repeat_u", "texture.picture.repeat_v",
                                                 "texture.picture.shift_u", "texture.picture.shift_v"};
  return names;
}

const ParameterTable& surface_table() {
  static const ParameterTable table =
      Table<Surface>("a surface", "How stems are clothed.")
          .choice("style", &Surface::style, {"tubes", "blend"},
                  "tubes: continuous tubes along the axes; blend: one closed body, for low-poly plants.")
          .choice("shading", &Surface::shading, {"smooth", "flat"}, "flat: each triangle shows its own plane.")
          .object("crown", &Surface::crown, crown_body_table, "A body about the ends of the branches.")
          .integer("resolution", &Surface::resolution, {.min = 10, .max = 1024, .fixed = true},
                   "blend: cells along the body's longest side; raised, finer, with the square as many triangles.")
          .number("blend", &Surface::blend, {.min = 0, .max = 4, .fixed = true},
                  "blend: over how many of its radii a branch grows together with its mother; 0: with a crease.")
          .boolean("thicken", &Surface::thicken,
                   "blend: twigs too thin for the cells are made as thick as they need; else they vanish.")
          .integer("triangles", &Surface::triangles, {.min = 4, .max = 50e6, .fixed = true},
                   "blend: simplified to so many, if twigs and holes let it; unset, all that the cells give.")
          .integer("sides", &Surface::sides, {.min = 3, .max = 64, .fixed = true},
                   "Sides of the thickest stem, thinner ones have fewer; raised, rounder and heavier.")
          .number("error", &Surface::error, {.min = 0, .max = 1, .fixed = true},
                  "How far a tube may stray from its skeleton, in its radii; raised, fewer rings along straight stems.")
          .choice("cap", &Surface::cap, {"pointed", "round", "flat"}, "How tips end.")
          .number("uv_scale", &Surface::uv_scale, {.unit = Unit::metre, .min = 0.001, .max = 100, .fixed = true},
                  "Bark that one tile of a texture covers.")
          .number("smooth", &Surface::smooth, {.min = 0, .max = 20, .fixed = true},
                  "Over how many radii along a stem the step in thickness at a fork is spread; 0 leaves it.")
          .number("collar", &Surface::collar, {.min = 0, .max = 3, .fixed = true},
                  "How far branches swell where they grow out of their mother, in their radii; 0: they start with a "
                  "crease.")
          .number("flare", &Surface::flare, {.min = 0, .max = 5, .fixed = true},
                  "How much wider a root is at the ground than above it; 1 doubles it.")
          .only_where({{"style", {"tubes"}}}, {"sides", "error", "cap", "uv_scale", "smooth", "collar"})
          .only_where({{"style", {"blend"}}}, {"resolution", "blend", "thicken", "triangles"})
          .only_where({{"style", {"blend"}}, {"crown"}}, {"shading"});
  return table;
}

}  // namespace meristem

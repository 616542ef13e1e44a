// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/tables.h"

#include "meristem/graph/table/table.h"
#include "meristem/shape/detail.h"

namespace meristem {

namespace {

constexpr double kLargestWhole = 9007199254740992;  // 2^53: up to here a JSON number is exact

const ParameterTable& ground_table() {
  static const ParameterTable table = Table<GroundSettings>("a ground", "The ground in pictures.")
                                          .colour("colour", &GroundSettings::colour, "Of the bare ground.");
  return table;
}

const ParameterTable& scene_table() {
  static const ParameterTable table =
      Table<SceneSettings>("a scene", "What surrounds the plants.")
          .members(&SceneSettings::light, light_table())
          .list("obstacles", &SceneSettings::obstacles, obstacle_table,
                "Bodies that plants do not enter and that shade them.")
          .object("ground", &SceneSettings::ground, ground_table, "The ground in pictures.")
          .check([](const SceneSettings& scene, const Place& place, ParameterReader& reader) {
            check_light(scene.light, place, reader);
            check_obstacles(scene.obstacles, Place(place, "obstacles"), reader);
          });
  return table;
}

const ParameterTable& output_table() {
  static const ParameterTable table =
      Table<OutputSettings>("an output", "Defaults for pictures and files.")
          .integers("size", &OutputSettings::size, 2, {.min = 1, .max = 16384}, "Width and height of pictures, pixels.")
          .integer("samples", &OutputSettings::samples, {.min = 1, .max = 65536},
                   "Paths a pixel; raised, less noise and slower.")
          .integer("lod", &OutputSettings::lod, {.min = 0, .max = kCoarsestDetail},
                   "Coarser levels of detail that `grow` writes beside each file with meshes.");
  return table;
}

}  // namespace

const ParameterTable& head_table() {
  static const ParameterTable table =
      Table<DocumentHead>("a document", "A plant document.")
          .integer("meristem", &DocumentHead::format, {.min = 1, .max = kDocumentFormat}, "The format's version.")
          .required()
          .text("name", &DocumentHead::name, "What the plant is called.")
          .text("description", &DocumentHead::description, "One or two sentences about it.")
          .text("author", &DocumentHead::author, "Who made it; carried into exports.")
          .text("licence", &DocumentHead::licence, "Under which it may be used; carried into exports.")
          .integer("seed", &DocumentHead::seed, {.min = 0, .max = kLargestWhole}, "All that is random comes from it.")
          .object("scene", &DocumentHead::scene, scene_table, "What surrounds the plants.")
          .object("output", &DocumentHead::output, output_table, "Defaults for pictures and files.")
          .elsewhere({"variables", "components", "links", "limits"});
  return table;
}

const ParameterTable& variable_table() {
  static const ParameterTable table =
      Table<Variable>("a variable", "A handle that expressions use by name.")
          .number("value", &Variable::value, {},
                  "Its value unless set otherwise; an expression may use the other variables.")
          .required()
          .number("min", &Variable::min, {}, "Least sensible value.")
          .number("max", &Variable::max, {}, "Greatest sensible value.")
          .text("unit", &Variable::unit, "As shown to the user.")
          .text("doc", &Variable::doc, "What it does, in one sentence.")
          .boolean("private", &Variable::is_private,
                   "No handle for users, but a name for what several expressions share.")
          .shorthand("value");
  return table;
}

const ParameterTable& limits_table() {
  static const ParameterTable table =
      Table<Limits>("limits", "Bounds on what the document may ask for; past them growth stops with an error.")
          .integer("diagnostics", &Limits::diagnostics, {.min = 1, .max = 10000}, "Faults reported at once.")
          .integer("expression_bytes", &Limits::expression_bytes, {.min = 1, .max = 1e6}, "Length of one expression.")
          .integer("points", &Limits::points, {.min = 1, .max = 4e9}, "Attraction points of a tree.")
          .integer("nodes", &Limits::nodes, {.min = 1, .max = 4e9}, "Skeleton nodes.")
          .integer("modules", &Limits::modules, {.min = 1, .max = 4e9},
                   "Modules of an L-system's word, and parameters.")
          .integer("instances", &Limits::instances, {.min = 1, .max = 4e9}, "Instances of components in all.")
          .integer("triangles", &Limits::triangles, {.min = 1, .max = kLargestWhole}, "Triangles after instancing.")
          .integer("mesh_bytes", &Limits::mesh_bytes, {.min = 1, .max = kLargestWhole}, "Bytes of distinct geometry.")
          .integer("file_bytes", &Limits::file_bytes, {.min = 1, .max = kLargestWhole},
                   "Bytes of one file that the document names.")
          .integer("picture_pixels", &Limits::picture_pixels, {.min = 1, .max = 1e9},
                   "Pixels of one picture that the document names.")
          .integer("texture_pixels", &Limits::texture_pixels, {.min = 1, .max = kLargestWhole},
                   "Pixels of all textures together; components with the same one share it.");
  return table;
}

}  // namespace meristem

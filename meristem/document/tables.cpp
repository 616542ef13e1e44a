// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/tables.h"

#include "meristem/base/seed.h"
#include "meristem/components/parts/check_line.h"
#include "meristem/graph/table/table.h"
#include "meristem/shape/detail/detail.h"

namespace meristem {

namespace {

constexpr double kLargestWhole = 9007199254740992;  // 2^53: whole numbers up to here are exact in JSON

const ParameterTable& ground_table() {
  static const ParameterTable table =
      Table<GroundParameters>("a ground", "The ground in pictures.")
          .colour("colour", &GroundParameters::colour, "Colour of the bare ground in pictures.");
  return table;
}

void check_support(const SceneSupport& support, const DocumentPath& path, ParameterReader& reader) {
  check_line(support.line, DocumentPath(path, "line"), reader);
}

const ParameterTable& support_table() {
  static const ParameterTable table =
      Table<SceneSupport>("a support", "A pole or wire that trees may be tied to.")
          .positions("line", &SceneSupport::line, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-20, 20}},
                     "Points of the line in the scene.")
          .required()
          .shorthand("line")
          .check(check_support);
  return table;
}

const ParameterTable& scene_table() {
  static const ParameterTable table =
      Table<SceneParameters>("a scene", "Surroundings of the plants.")
          .members(&SceneParameters::light, light_table())
          .list("obstacles", &SceneParameters::obstacles, obstacle_table,
                "Bodies that plants do not enter and that shade them.")
          .object("ground", &SceneParameters::ground, ground_table, "Ground in pictures.")
          .map("supports", &SceneParameters::supports, support_table,
               "Poles and wires by name, which operations of self-organizing trees tie shoots to.")
          .check([](const SceneParameters& scene, const DocumentPath& path, ParameterReader& reader) {
            check_light(scene.light, path, reader);
            check_obstacles(scene.obstacles, DocumentPath(path, "obstacles"), reader);
          });
  return table;
}

const ParameterTable& output_table() {
  static const ParameterTable table =
      Table<OutputParameters>("an output", "Defaults for pictures and files.")
          .integers("size", &OutputParameters::size, 2, {.min = 1, .max = 16384, .usual = {256, 4096}},
                    "Width and height of pictures in pixels.")
          .integer(
              "samples", &OutputParameters::samples, {.min = 1, .max = 65536, .usual = {1, 512}},
              "Largest number of light paths per pixel; even sky and ground take fewer. Raised, less noise and slower "
              "pictures.")
          .integer("lod", &OutputParameters::lod, {.min = 0, .max = kCoarsestDetail},
                   "Number of coarser levels of detail that `grow` writes beside each file with meshes.")
          .integer("cards", &OutputParameters::cards, {.min = 0, .max = kMaxCards, .usual = {0, 4}},
                   "Number of upright crossed cards, pictures of the plant, that `grow` writes as a last level; 0 "
                   "writes none.");
  return table;
}

}  // namespace

const ParameterTable& head_table() {
  static const ParameterTable table =
      Table<DocumentHead>("a document", "A plant document.")
          .integer("meristem", &DocumentHead::format, {.min = 1, .max = kDocumentFormat},
                   "Version of the document format.")
          .required()
          .text("name", &DocumentHead::name, "Name of the plant.")
          .text("description", &DocumentHead::description, "Description of the plant in one or two sentences.")
          .text("author", &DocumentHead::author, "Author of the document, who is named in exported files.")
          .text("licence", &DocumentHead::licence, "Licence of the document, which is named in exported files.")
          .integer("seed", &DocumentHead::seed, {.min = 0, .max = kLargestSeed, .usual = {0, 100}},
                   "Seed of all random numbers; another number gives another plant of this kind.")
          .object("scene", &DocumentHead::scene, scene_table,
                  "Surroundings of the plants: light, obstacles and ground.")
          .object("output", &DocumentHead::output, output_table, "Defaults for pictures and files.")
          .elsewhere({"variables", "components", "links", "animation", "limits"});
  return table;
}

const ParameterTable& variable_table() {
  static const ParameterTable table =
      Table<Variable>("a variable", "A number of the document that expressions use by name.")
          .number("value", &Variable::value, {},
                  "Value of the variable unless a command sets another one; an expression may use the other variables.")
          .required()
          .number("min", &Variable::min, {}, "Smallest sensible value of the variable.")
          .number("max", &Variable::max, {}, "Largest sensible value of the variable.")
          .text("unit", &Variable::unit, "Unit of the variable as shown to users.")
          .text("doc", &Variable::doc, "What the variable does, in one sentence.")
          .text("per", &Variable::per,
                "Id of a component: each of its instances draws a value of its own, which everything that stands on "
                "the instance uses.")
          .boolean("private", &Variable::is_private,
                   "Whether the variable is only shared by expressions and not shown to users as a handle.")
          .shorthand("value");
  return table;
}

const ParameterTable& animation_table() {
  static const ParameterTable table =
      Table<Animation>("an animation", "The document over time.")
          .number("length", &Animation::length, {.unit = Unit::second, .min = 0, .max = 1e6, .above_min = true},
                  "Length of the film of the document.")
          .required()
          .number("fps", &Animation::fps, {.min = 0, .max = 1000, .usual = {10, 60}, .above_min = true},
                  "Frames per second of films.")
          .number(
              "steps_per_second", &Animation::steps_per_second,
              {.min = 0, .max = 1e6, .usual = {1, 30}, .above_min = true},
              "Growth steps per second: plants that grow by a model unroll over time; by default, they are full-grown.")
          .number("unfold", &Animation::unfold, {.unit = Unit::second, .min = 0, .max = 1e6, .usual = {0, 5}},
                  "Time in which what stands on such a plant comes to its full size, from when its place has grown.")
          .number("hold", &Animation::hold, {.unit = Unit::second, .min = 0, .max = 1e6, .usual = {0, 10}},
                  "Time for which a branch that such a plant sheds stays on it after the branch has ceased to grow.")
          .only_with("steps_per_second", {"unfold", "hold"})
          .elsewhere({"keys"});
  return table;
}

const ParameterTable& limits_table() {
  static const ParameterTable table =
      Table<SizeLimits>("limits", "Bounds on what the document may ask for; growth beyond them stops with an error.")
          .integer("diagnostics", &SizeLimits::diagnostics, {.min = 1, .max = 10000},
                   "Largest number of faults reported at once.")
          .integer("expression_bytes", &SizeLimits::expression_bytes, {.min = 1, .max = 1e6},
                   "Largest length of one expression in bytes.")
          .integer("points", &SizeLimits::points, {.min = 1, .max = 4e9}, "Largest number of attraction points.")
          .integer("nodes", &SizeLimits::nodes, {.min = 1, .max = 4e9},
                   "Largest number of skeleton nodes; it also bounds the memory of instances, at 100 bytes for each.")
          .integer("modules", &SizeLimits::modules, {.min = 1, .max = 4e9},
                   "Largest number of modules in the word of an L-system, and of their parameters.")
          .integer(
              "instances", &SizeLimits::instances, {.min = 1, .max = 4e9},
              "Largest number of instances of all components together; it also bounds their memory, at 160 bytes for "
              "each.")
          .integer("triangles", &SizeLimits::triangles, {.min = 1, .max = kLargestWhole},
                   "Largest number of triangles; each instance counts, but a plant of another document counts once.")
          .integer("mesh_bytes", &SizeLimits::mesh_bytes, {.min = 1, .max = kLargestWhole},
                   "Largest memory for distinct geometry in bytes.")
          .integer("file_bytes", &SizeLimits::file_bytes, {.min = 1, .max = kLargestWhole},
                   "Largest size in bytes of a file that the document names.")
          .integer("picture_pixels", &SizeLimits::picture_pixels, {.min = 1, .max = 1e9},
                   "Largest number of pixels in a picture that the document names.")
          .integer("texture_pixels", &SizeLimits::texture_pixels, {.min = 1, .max = kLargestWhole},
                   "Largest number of pixels in all textures together; a texture that several components share counts "
                   "once.");
  return table;
}

}  // namespace meristem

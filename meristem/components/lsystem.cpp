// SPDX-License-Identifier: Apache-2.0
// Derives the word of a grammar, draws it with a turtle, and emits stems, polygons and sites. Polygons of equal shape
// share a mesh.
#include "meristem/components/lsystem.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "meristem/base/colour.h"
#include "meristem/base/hash.h"
#include "meristem/components/parts/finish_table.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/scene/obstacle/open_way.h"
#include "meristem/shape/flat/polygon_mesh.h"

namespace meristem {

namespace {

constexpr double kDefaultAngle = 22.5;  // degrees
constexpr float kShapeSteps = 8192;     // steps per extent of a polygon, to which its corners are rounded for sharing
constexpr Vec3 kLeafGreen{0.31F, 0.47F, 0.19F};

/// Returns the word for drawing.
Word derive_plant(const Lsystem& plant, const Site& site, const InstanceContext& instance, StemSink& stems) {
  const Grammar& grammar = plant.source().grammar;
  const double last = steps_of(plant);
  double steps = stems.grown_to(last);
  if (instance.grows_in_time()) {
    // A timed grammar has another word at each time. Other grammars draw the final word, which is then cut by time.
    if (grammar.is_timed) stems.stands_as_grown();
    if (!grammar.is_timed) steps = last;
  }
  return derive_drawn(grammar, steps, word_key(site), instance.limits(), instance.progress(),
                      instance.grows_in_time() ? KeepBirths::yes : KeepBirths::no);
}

/// A polygon's corners in its own frame, as rounded shares of its extent, so that equal polygons share a mesh.
struct PolygonShape {
  /// Origin of the corners: the turtle's start of the polygon, or the first corner if the start is far away.
  Vec3 base{0};
  std::vector<Vec3> corners;
  float extent = 0;
  std::uint64_t key = 0;
};

PolygonShape shape_of(const WordDrawing& drawing, const TurtlePolygon& polygon) {
  PolygonShape shape;
  const std::span corners = std::span(drawing.corners).subspan(polygon.first, polygon.count);
  float size = 0;
  for (const Vec3 corner : corners) size = std::max(size, glm::distance(corner, corners[0]));
  shape.base = glm::distance(corners[0], polygon.frame.origin) <= size ? polygon.frame.origin : corners[0];
  const Mat3 to_local = glm::transpose(polygon.frame.axes);
  for (const Vec3 corner : corners) {
    const Vec3 local = to_local * (corner - shape.base);
    shape.corners.push_back(local);
    const Vec3 reach = glm::abs(local);
    shape.extent = std::max({shape.extent, reach.x, reach.y, reach.z});
  }
  if (shape.extent == 0) return shape;
  for (Vec3& corner : shape.corners) {
    // Adding zero turns negative zeros into positive ones.
    corner = glm::floor(corner * (kShapeSteps / shape.extent) + 0.5F) / kShapeSteps + 0.0F;
  }
  shape.key = hash64(
      std::string_view(reinterpret_cast<const char*>(shape.corners.data()), shape.corners.size() * sizeof(Vec3)));
  return shape;
}

/// Returns linear factors on the green of the blades.
Vec3 tint_of(const Lsystem& plant, std::uint32_t colour) {
  if (plant.palette.empty()) return Vec3(1);
  const std::size_t last = plant.palette.size() - 1;
  return linear_from_srgb(plant.palette[std::min<std::size_t>(colour, last)]) / linear_from_srgb(kLeafGreen);
}

void emit_polygons(const Lsystem& plant, const Site& site, const WordDrawing& drawing, const InstanceContext& instance,
                   OrganSink& organs, StemSink& stems) {
  const Mat3 to_instance = glm::inverse(site.frame.axes);
  for (const TurtlePolygon& polygon : drawing.polygons) {
    instance.progress().check();
    const PolygonShape shape = shape_of(drawing, polygon);
    const bool is_flat = shape.extent == 0;
    const Frame frame{polygon.frame.axes, shape.base};
    const std::optional<Frame> stands = is_flat ? std::nullopt : stems.on_rest(polygon.node, frame);
    if (!stands) {
      organs.skip();
      continue;
    }
    Frame local;
    local.axes = to_instance * (shape.extent * stands->axes);
    local.origin = to_instance * (stands->origin - site.frame.origin);
    organs.add_blade(
        local, shape.key, [&] { return make_polygon(shape.corners); }, tint_of(plant, polygon.colour));
  }
}

/// Returns the length of a step of `finish` in metres.
double step_of(const Lsystem& plant, const Site& site) {
  return std::abs(plant.turtle.length) * static_cast<double>(glm::length(site.frame.heading()));
}

/// Finishes the skeleton. Polygons and sites move with the nodes that bear them.
void finish_drawing(const Lsystem& plant, const Site& site, WordDrawing& drawing, const InstanceContext& instance) {
  FinishOptions wanted = *plant.finish;
  const double step = step_of(plant, site);
  if (step == 0) wanted.decimate = wanted.subdivide = 0;
  if (drawing.skeleton.node_count() == 0) return;

  // Keep the nodes that bear polygons or sites.
  TrackedNodes tracked;
  tracked.stays.resize(drawing.skeleton.node_count(), 0);
  const auto mark = [&](NodeIndex node) {
    if (node != kNoNode) tracked.stays[node] = 1;
  };
  for (const TurtlePolygon& polygon : drawing.polygons) mark(polygon.node);
  for (const TurtleSite& place : drawing.places) mark(place.node);
  const std::vector<Vec3> before = drawing.skeleton.position;
  const Vec3 root = before[0];
  const auto is_open = [&](Vec3 from, Vec3 to) {
    return is_way_open(instance.scene().obstacles, root, from - root, to - root);
  };
  const auto require_nodes = [&](std::uint64_t nodes) {
    if (nodes <= instance.limits().nodes) return;
    throw_limit("nodes", static_cast<double>(nodes), instance.limits().nodes, "nodes",
                fmt::format("components.{}.finish.subdivide", instance.component()));
  };
  drawing.skeleton =
      finish(std::move(drawing.skeleton), wanted, {step, is_open, require_nodes, instance.progress()}, &tracked);

  const auto moved_by = [&](NodeIndex node) {
    return node == kNoNode ? Vec3(0) : drawing.skeleton.position[tracked.now[node]] - before[node];
  };
  for (TurtlePolygon& polygon : drawing.polygons) {
    const Vec3 by = moved_by(polygon.node);
    polygon.frame.origin += by;
    for (Vec3& corner : std::span(drawing.corners).subspan(polygon.first, polygon.count)) corner += by;
  }
  for (TurtleSite& place : drawing.places) {
    place.frame.origin += moved_by(place.node);
    if (place.node != kNoNode) place.node = tracked.now[place.node];
  }
}

void expand(const Lsystem& plant, const Site& site, const InstanceContext& instance, OrganSink& organs, StemSink& stems,
            SiteSink& sites) {
  WordDrawing drawing;
  Word word;
  try {
    const PlantGrammar& source = plant.source();
    word = derive_plant(plant, site, instance, stems);
    drawing = draw(word, source.grammar.alphabet, turtle_of(plant, instance.directions()), site.frame,
                   instance.limits(), "components." + instance.component(), instance.progress());
  } catch (const InputError& error) {
    throw_placed(error, plant, instance.component());
  }
  if (plant.finish) finish_drawing(plant, site, drawing, instance);
  const float length = glm::length(site.frame.heading()) * static_cast<float>(plant.turtle.length);
  const std::vector<TurtleSite> places = std::move(drawing.places);
  stems.add(std::move(drawing.skeleton), plant.surface, {.trim = plant.trim});
  emit_polygons(plant, site, drawing, instance, organs, stems);
  for (const TurtleSite& mark : places) {
    instance.progress().check();
    sites.add_named(plant.source().placed_of_letter[mark.letter], mark.frame, length, mark.radius, mark.node);
    if (!word.births.empty()) sites.born(word.births[mark.module]);
  }
}

std::vector<PlacedComponent> placed(const Lsystem& plant) {
  return plant.grammar || plant.file ? plant.source().placed : std::vector<PlacedComponent>();
}

/// Returns true if a word of the grammar may move the turtle by the default length.
bool draws_default_length(const Grammar& grammar) {
  const auto is_default = [&](const ModuleTemplate& module) {
    const Letter& letter = grammar.alphabet[module.letter];
    return letter.arity == 0 && letter.symbol.size() == 1 &&
           std::string_view("FGfg").find(letter.symbol[0]) != std::string_view::npos;
  };
  const auto moves = [&](const std::vector<ModuleTemplate>& word) { return std::ranges::any_of(word, is_default); };
  if (moves(grammar.axiom)) return true;
  for (const RuleSet* set : {&grammar.production, &grammar.decomposition, &grammar.interpretation}) {
    if (std::ranges::any_of(set->rules, [&](const GrammarRule& rule) { return moves(rule.successor); })) return true;
  }
  return false;
}

void check_lsystem(const Lsystem& plant, const DocumentPath& path, ParameterReader& reader) {
  if (!plant.grammar && !plant.file) return;  // the table has already reported this
  const Grammar& grammar = plant.source().grammar;
  if (grammar.is_timed && plant.steps) {
    reader.add_error(DocumentPath(path, "steps"), "the rules of the grammar have lives, so it counts no steps",
                     "'time'");
  } else if (!grammar.is_timed && plant.time) {
    reader.add_error(DocumentPath(path, "time"), "no rule of the grammar has a life, so it knows no time",
                     "'steps', or rules such as A @ 1 -> A B");
  } else if (grammar.is_timed && !plant.time && !grammar.time) {
    reader.add_error(path, "the time at which the grammar stands is not given", "'time', or #time in the grammar");
  } else if (!grammar.is_timed && !plant.steps && !grammar.steps) {
    reader.add_error(path, "the number of steps of the grammar is not given", "'steps', or #steps in the grammar");
  }
  const bool counts_steps = plant.finish && (plant.finish->decimate > 0 || plant.finish->subdivide > 0);
  if (counts_steps && plant.turtle.length == 0) {
    reader.add_error(DocumentPath(path, "finish"), "'finish' counts in steps of 'length', which is 0",
                     "a 'length' other than 0");
  }
  if (plant.turtle.length == 0 && draws_default_length(grammar)) {
    reader.warn(DocumentPath(path, "length"),
                "'length' is 0, and the grammar has F, G, f or g without a parameter, which then draw nothing");
  }
}

const ParameterTable& angles_table() {
  static const ParameterTable table =
      Table<PolarAngles>("angles", "The angles of a polar turtle, in degrees.")
          .number("elevation", &PolarAngles::elevation, {.min = -360, .max = 360, .usual = {0, 120}},
                  "Angle in degrees of a polar turtle's turns at ^ and & without a parameter.")
          .number("azimuth", &PolarAngles::azimuth, {.min = -360, .max = 360, .usual = {0, 120}},
                  "Angle in degrees of a polar turtle's turns at + and - without a parameter.");
  return table;
}

const ParameterTable& decay_table() {
  static const ParameterTable table =
      Table<WidthDecay>("a decay", "Factors on the radius of stems along each segment.")
          .number("trunk", &WidthDecay::trunk, {.min = 0, .max = 2, .usual = {0.5, 1.2}},
                  "Factor on the radius along each segment outside all brackets; lowered, the trunk tapers more.")
          .number("branch", &WidthDecay::branch, {.min = 0, .max = 2, .usual = {0.5, 1.2}},
                  "Factor on the radius along each segment within brackets; lowered, branches taper more.");
  return table;
}

const ParameterTable& turtle_table() {
  static const ParameterTable table =
      Table<TurtleParameters>("a turtle", "How the turtle draws the word.")
          .choice("turtle", &TurtleParameters::reading, {"frame", "polar"},
                  "How turns are read: 'frame' turns about the turtle's own axes, 'polar' changes its elevation and "
                  "azimuth.")
          .boolean("stack_angles", &TurtleParameters::stack_angles,
                   "Whether ] restores a polar turtle's angles along with its position.")
          .number("length", &TurtleParameters::length,
                  {.unit = Unit::metre, .min = -1000, .max = 1000, .usual = {0, 0.5}},
                  "Distance that F, G, f and g go when they have no parameter.")
          .number("width", &TurtleParameters::width, {.unit = Unit::metre, .min = 0, .max = 100},
                  "Radius of the stem at the root; the symbols ! and # change it.")
          .number("thinner", &TurtleParameters::thinner, {.min = 0, .max = 1, .usual = {0.4, 1}, .above_min = true},
                  "Factor on the radius at each ! without a parameter; each # without one divides the radius by it.")
          .vector("tropism", &TurtleParameters::tropism, {.min = -100, .max = 100, .usual = {-1, 1}},
                  "Direction toward which segments bend; by default, straight down. The bend is proportional to the "
                  "vector's length.")
          .in_space(InSpace::direction)
          .number(
              "elasticity", &TurtleParameters::elasticity, {.min = -10, .max = 10, .usual = {-0.5, 0.5}},
              "Bend of each segment toward the tropism, in radians where it is at right angles; negative bends away.");
  return table;
}

}  // namespace

[[noreturn]] void throw_placed(const InputError& error, const Lsystem& plant, const std::string& id) {
  std::vector<Diagnostic> placed = error.diagnostics();
  for (Diagnostic& found : placed) {
    if (!found.path.empty()) continue;
    found.path = fmt::format("components.{}.{}", id, plant.grammar ? "grammar" : "file");
    if (found.line > 0) {
      const std::string& file = plant.file.path;
      found.message = plant.grammar ? fmt::format("line {} of the grammar: {}", found.line, found.message)
                                    : fmt::format("'{}:{}': {}", file, found.line, found.message);
    }
    found.line = 0;
    found.column = 0;
  }
  throw InputError(std::move(placed));
}

double steps_of(const Lsystem& plant) {
  const Grammar& grammar = plant.source().grammar;
  if (grammar.is_timed) return plant.time.value_or(grammar.time.value_or(0));
  return plant.steps.value_or(grammar.steps.value_or(0));
}

TurtleParameters turtle_of(const Lsystem& plant, const Directions& directions) {
  TurtleParameters turtle = plant.turtle;
  turtle.directions = directions;
  turtle.angle = plant.angle.value_or(plant.source().grammar.angle.value_or(kDefaultAngle));
  turtle.azimuth = turtle.angle;
  if (plant.angles) {
    turtle.angle = plant.angles->elevation;
    turtle.azimuth = plant.angles->azimuth;
  }
  turtle.trunk_decay = plant.width_decay.trunk;
  turtle.branch_decay = plant.width_decay.branch;
  return turtle;
}

ComponentType lsystem_component() {
  return define_component<Lsystem>({
      .traits =
          {.name = "lsystem",
           .doc = "A plant by the rules of a grammar (L-system), drawn by a turtle; ~ in its words places components.",
           .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
           .blades = {.material = {.colour = kLeafGreen, .roughness = 0.6F, .translucency = 0.3F, .two_sided = true}},
           .grows_in_time = true,
           .makes_stems = true,
           .has_twigs = true,
           .stance = BranchStance::on_axis},
      .parameters =
          Table<Lsystem>("an lsystem", "A plant by the rules of a grammar, drawn by a turtle.")
              .lines("grammar", &Lsystem::grammar, read_plant_grammar, "Text of the grammar, or a list of its lines.")
              .text_file("file", &Lsystem::file, read_plant_grammar, "File with the grammar's text.")
              .one_of({"grammar", "file"})
              .integer("steps", &Lsystem::steps, {.min = 0, .max = kMaxSteps},
                       "Number of times that the rules are applied; by default, as the grammar says.")
              .number("time", &Lsystem::time, {.min = 0, .max = 1e6, .usual = {0, 20}},
                      "Time up to which a grammar with lives develops, in the unit of its lives; by default, as the "
                      "grammar says.")
              .number("angle", &Lsystem::angle, {.min = -360, .max = 360, .usual = {0, 120}},
                      "Angle in degrees of turns without a parameter; by default, as the grammar says, or 22.5.")
              .object("angles", &Lsystem::angles, angles_table,
                      "Angles of turns without a parameter for a polar turtle: one for the elevation and one for the "
                      "azimuth.")
              .members(&Lsystem::turtle, turtle_table())
              .object("width_decay", &Lsystem::width_decay, decay_table,
                      "Decrease of the radius of stems along each segment, for grammars without ! and #.")
              .colours("palette", &Lsystem::palette,
                       "Colours of polygons, in the order in which the symbol ' counts; the last holds for all higher "
                       "numbers.")
              .object("finish", &Lsystem::finish, finish_table,
                      "What is done to the drawn skeleton, in steps of 'length': nodes removed, forks softened, curves "
                      "smoothed; by default, nothing.")
              .object("surface", &Lsystem::surface, surface_table, "How the skeleton becomes a surface.")
              .choice("trim", &Lsystem::trim, trim_modes(), kTrimDoc)
              .only_where({{"surface.style", {"tubes"}}}, {"texture"})
              .without(names_off_stems(), kWhyOffStems)
              .never_with("angle", {"angles"})
              .only_where({{"turtle", {"polar"}}}, {"angles", "stack_angles"})
              .only_where({{"turtle", {"frame"}}}, {"elasticity"})
              .only_with("elasticity", {"tropism"})
              .check(check_lsystem),
      .expand = expand,
      .placed = placed,
  });
}

}  // namespace meristem

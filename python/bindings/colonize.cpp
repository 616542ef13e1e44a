// SPDX-License-Identifier: Apache-2.0
// Space colonization into a caller's own points. Grows a document with one component that has these points, so that
// parameters have their usual meanings and checks.
#include "meristem/components/colonize.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/document/document.h"
#include "meristem/document/json.h"
#include "meristem/graph/expand.h"
#include "scene.h"
#include "values.h"

namespace meristem::python {

namespace {

const std::string kComponent = "components.tree";

Value places_value(const std::vector<Vec3>& places) {
  Value::List list;
  for (const Vec3 position : places)
    list.emplace_back(Value::List{double{position.x}, double{position.y}, double{position.z}});
  return list;
}

/// Converts a document path to the name of the caller's argument.
std::string argument_of(const std::string& path) {
  if (!path.starts_with(kComponent)) return path;
  const std::string name = path.substr(std::min(kComponent.size() + 1, path.size()));
  return name == "crown" || name == "points.file" ? "points" : name;
}

/// Calls `call()`. Its faults then name the caller's arguments.
template <class Call>
auto naming_arguments(Call call) {
  try {
    return read_written_here(call);
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& diagnostic : diagnostics) diagnostic.path = argument_of(diagnostic.path);
    throw InputError(std::move(diagnostics));
  }
}

/// Makes a document with one colonize component.
Document read_parameters(const py::dict& parameters, const std::vector<Vec3>& roots, const py::object& seed) {
  Value tree = naming_arguments([&] { return to_value(parameters); });
  Value::Object& members = *tree.object();
  members.emplace_back("type", "colonize");
  members.emplace_back("roots", places_value(roots));
  // An arbitrary crown, which the points replace.
  members.emplace_back("crown", Value(Value::Object{{"box", places_value({Vec3(0), Vec3(1)})}}));
  Value::Object document{{"meristem", kDocumentFormat}, {"components", Value(Value::Object{{"tree", tree}})}};
  if (!seed.is_none()) document.emplace_back("seed", to_value(seed));
  return naming_arguments([&] { return read_document(write_json(Value(document)), "", component_types()); });
}

void set_points(Document& document, const std::vector<Vec3>& points) {
  for (Prototype& prototype : document.graph.components) {
    if (prototype.id != "tree") continue;
    auto& tree = *static_cast<Colonize*>(prototype.parameters.get());
    tree.crown.reset();
    tree.points.file = {.path = "points", .content = std::make_shared<PointCloud>(points.begin(), points.end())};
  }
}

std::shared_ptr<Skeleton> colonize(const py::object& points, const py::object& roots, const py::object& step,
                                   const py::object& influence, const py::object& kill, const py::object& iterations,
                                   const py::object& bias, const py::object& tip_radius,
                                   const py::object& pipe_exponent, const py::object& finish, const py::object& light,
                                   const py::object& shed, const std::shared_ptr<Scene>& scene, const py::object& seed,
                                   int threads, const py::object& progress) {
  const std::vector<Vec3> places = points_of(points, "points");
  if (places.empty()) throw py::value_error("points has no rows");
  const std::vector<Vec3> trees = one_or_more_points(roots, "roots");
  if (trees.empty()) throw py::value_error("roots has no rows");
  py::dict parameters;
  const auto set = [&](const char* name, const py::object& value) {
    if (!value.is_none()) parameters[name] = value;
  };
  set("step", step);
  set("influence", influence);
  set("kill", kill);
  set("iterations", iterations);
  set("bias", bias);
  set("tip_radius", tip_radius);
  set("pipe_exponent", pipe_exponent);
  set("finish", finish);
  set("light", light);
  set("shed", shed);
  Document document = read_parameters(parameters, trees, seed);
  set_points(document, places);
  const Scene surroundings = scene ? *scene : Scene();
  return naming_arguments([&] {
    return run_call(progress, threads, [&](Progress& inner) {
      auto all = std::make_shared<Skeleton>();
      Plant plant = expand(document.graph, surroundings, 0, inner);
      for (Stem& stem : plant.stems) all->append(std::move(stem.skeleton));
      return all;
    });
  });
}

}  // namespace

void bind_colonize(py::module_& module) {
  const ColonizeParameters plain;
  module.def("colonize", &colonize, py::arg("points"), py::arg("roots") = py::make_tuple(0, 0, 0), py::kw_only(),
             py::arg("step") = plain.step, py::arg("influence") = plain.influence, py::arg("kill") = plain.kill,
             py::arg("iterations") = plain.iterations, py::arg("bias") = py::make_tuple(0, 0, 0),
             py::arg("tip_radius") = plain.radii.tip_radius, py::arg("pipe_exponent") = plain.radii.exponent,
             py::arg("finish") = py::none(), py::arg("light") = py::none(), py::arg("shed") = py::none(),
             py::arg("scene") = py::none(), py::arg("seed") = 1, py::arg("threads") = 0,
             py::arg("progress") = py::none(),
             R"(Grows a tree into your own attraction points by space colonization. Returns a Skeleton.

`points` (n, 3) and `roots` (3,) or (k, 3) are positions in the world, metres. Trees of several roots compete for the
points and are one skeleton. A root without a point in reach first grows straight toward the nearest point. `step` (m)
is the length of a segment. Points pull within `influence` (m) and are used up within `kill` (m). Growth ends after at
most `iterations` steps. `bias` is added to each direction. `tip_radius` (m) and `pipe_exponent` give radii. `finish`,
`light` and `shed` have the values of a document's colonize component: {"relax": False}, {"shift": 0.1}, "height < 2".

In a `scene` no segment enters an obstacle, and points inside are left out. `seed` (0 to 2^53) breaks ties. Results are
equal on any number of `threads`. Raises TypeError and ValueError for wrong arrays, InputError for parameters out of
range, Cancelled.)");
}

}  // namespace meristem::python

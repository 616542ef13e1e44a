// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/base/mesh.h"
#include "meristem/base/parallel.h"
#include "meristem/document/document.h"
#include "meristem/document/json.h"
#include "meristem/grow/colonize/light_response.h"
#include "meristem/measure/convex_hull.h"
#include "meristem/measure/crown_light.h"
#include "meristem/scene/light_of_points.h"
#include "values.h"

namespace meristem::python {

namespace {

using ScenePointer = std::shared_ptr<Scene>;
using Within = std::optional<double>;  // metres; no bound if unset

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kAskedPerBlock = 256;

ScenePointer make_scene(const py::object& values, const py::object& path) {
  if (values.is_none()) return std::make_shared<Scene>();
  const std::string file = path_of(path);
  // Wrapped, so that faults have the paths of a document.
  py::dict content;
  content["meristem"] = kDocumentFormat;
  content["scene"] = values;
  Value tree = to_value(content);
  const Value camera(Value::Object{{"type", "camera"}});
  tree.object()->emplace_back("components", Value(Value::Object{{"camera", camera}}));
  const Document document = read_written_here([&] { return read_document(write_json(tree), file, component_types()); });
  for (const Diagnostic& warning : document.warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.message.c_str(), 1) != 0) throw py::error_already_set();
  }
  return std::make_shared<Scene>(document.scene);
}

// Light.

py::tuple directional_lights(const ScenePointer& scene, const std::vector<DirectionalLight>& lights) {
  static const DirectionalLight kNone;
  const DirectionalLight* const first = lights.empty() ? &kNone : lights.data();
  const auto count = static_cast<py::ssize_t>(lights.size());
  return py::make_tuple(view(scene, &first->toward.x, {count, 3}, {sizeof(DirectionalLight), sizeof(float)}),
                        view(scene, &first->strength, {count}, {sizeof(DirectionalLight)}));
}

py::tuple lamps_of(const ScenePointer& scene) {
  static const Lamp kNone;
  const std::vector<Lamp>& lamps = scene->light.lamps;
  const Lamp* const first = lamps.empty() ? &kNone : lamps.data();
  const auto count = static_cast<py::ssize_t>(lamps.size());
  return py::make_tuple(view(scene, &first->position.x, {count, 3}, {sizeof(Lamp), sizeof(float)}),
                        view(scene, &first->strength, {count}, {sizeof(Lamp)}));
}

py::object mean_direction(const ScenePointer& scene) {
  const Vec3 mean = scene->light.mean_direction();
  return array_of(std::vector<float>{mean.x, mean.y, mean.z});
}

py::list obstacle_meshes(const ScenePointer& scene) {
  py::list meshes;
  for (const Obstacle& body : scene->obstacles.bodies()) {
    auto mesh = std::make_shared<Mesh>();
    for (const DVec3 position : body.mesh.positions) mesh->positions.emplace_back(position);
    mesh->triangles.assign(body.mesh.triangles.begin(), body.mesh.triangles.end());
    meshes.append(mesh);
  }
  return meshes;
}

// Queries for many positions.

/// Pairs of rows of two arguments. A single row of one argument is paired with all rows of the other.
class Pairs {
 public:
  Pairs(const py::object& first, const char* first_name, const py::object& second, const char* second_name)
      : first_(one_or_more_points(first, first_name)), second_(one_or_more_points(second, second_name)) {
    if (first_.size() == second_.size() || first_.size() == 1 || second_.size() == 1) return;
    throw py::value_error(fmt::format("{} has {} rows and {} has {}; expected as many, or one for all", first_name,
                                      first_.size(), second_name, second_.size()));
  }

  std::size_t count() const { return first_.size() == 1 ? second_.size() : first_.size(); }
  Vec3 first(std::size_t k) const { return first_[first_.size() == 1 ? 0 : k]; }
  Vec3 second(std::size_t k) const { return second_[second_.size() == 1 ? 0 : k]; }

  /// Normalizes the second vector of each pair.
  void make_directions(const char* name) {
    for (std::size_t k = 0; k < second_.size(); ++k) {
      const DVec3 direction(second_[k]);
      const double length = std::sqrt(glm::dot(direction, direction));
      if (!(length > 0)) throw py::value_error(fmt::format("{}[{}] is a zero vector", name, k));
      second_[k] = Vec3(direction / length);
    }
  }

 private:
  std::vector<Vec3> first_;
  std::vector<Vec3> second_;
};

Pairs rays_of(const py::object& origins, const py::object& directions, Within within) {
  Pairs rays(origins, "origins", directions, "directions");
  rays.make_directions("directions");
  if (!(within.value_or(0) >= 0)) throw py::value_error("within must be at least 0 metres");
  return rays;
}

/// Calls `ask(k)` for each k below `count`, on all threads of the call.
template <class Ask>
void ask_each(std::size_t count, Progress& progress, Ask ask) {
  progress.begin("asking", count);
  parallel_for(count, kAskedPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) ask(k);
    progress.advance(end - begin);
  });
}

/// Returns the results of `ask(k)`, (count,) bool.
template <class Ask>
py::object answers(std::size_t count, int threads, const py::object& progress, Ask ask) {
  std::vector<std::uint8_t> found = run_call(progress, threads, [&](Progress& inner) {
    std::vector<std::uint8_t> all(count);
    ask_each(count, inner, [&](std::size_t k) { all[k] = ask(k) ? 1 : 0; });
    return all;
  });
  return array_of(std::move(found)).attr("view")("bool");
}

py::object inside(const ScenePointer& scene, const py::object& points, int threads, const py::object& progress) {
  const std::vector<Vec3> places = points_of(points, "points");
  return answers(places.size(), threads, progress, [&](std::size_t k) { return scene->obstacles.contain(places[k]); });
}

py::object crosses(const ScenePointer& scene, const py::object& starts, const py::object& ends, int threads,
                   const py::object& progress) {
  const Pairs ways(starts, "starts", ends, "ends");
  return answers(ways.count(), threads, progress,
                 [&](std::size_t k) { return scene->obstacles.cross(ways.first(k), ways.second(k)); });
}

py::object blocked(const ScenePointer& scene, const py::object& origins, const py::object& directions, Within within,
                   int threads, const py::object& progress) {
  const Pairs rays = rays_of(origins, directions, within);
  const double farthest = within.value_or(kInfinity);
  return answers(rays.count(), threads, progress,
                 [&](std::size_t k) { return scene->obstacles.block(rays.first(k), rays.second(k), farthest); });
}

py::tuple first_hit(const ScenePointer& scene, const py::object& origins, const py::object& directions, Within within,
                    int threads, const py::object& progress) {
  const Pairs rays = rays_of(origins, directions, within);
  const double farthest = within.value_or(kInfinity);
  std::vector<double> distances(rays.count(), kInfinity);
  std::vector<std::int64_t> obstacles(rays.count(), -1);
  watch_of(progress)->run(threads, [&](Progress& inner) {
    ask_each(rays.count(), inner, [&](std::size_t k) {
      const std::optional<Obstacles::Hit> hit = scene->obstacles.first_hit(rays.first(k), rays.second(k), farthest);
      if (!hit) return;
      distances[k] = hit->distance;
      obstacles[k] = static_cast<std::int64_t>(hit->obstacle);
    });
  });
  return py::make_tuple(array_of(std::move(distances)), array_of(std::move(obstacles)));
}

double arriving_light(const Scene& scene, Vec3 point) {
  double sum = 0;
  scene.light.for_each_ray(point, [&](const LightRay& ray) {
    if (!scene.obstacles.block(point, ray.toward, ray.distance)) sum += ray.strength;
  });
  return sum;
}

py::object light_at(const ScenePointer& scene, const py::object& points, int threads, const py::object& progress) {
  const std::vector<Vec3> places = points_of(points, "points");
  return array_of(run_call(progress, threads, [&](Progress& inner) {
    std::vector<double> light(places.size());
    ask_each(places.size(), inner, [&](std::size_t k) { light[k] = arriving_light(*scene, places[k]); });
    return light;
  }));
}

py::object light_of_cloud(const ScenePointer& scene, const py::object& points, double radius, double k, int threads,
                          const py::object& progress) {
  const std::vector<Vec3> cloud = points_of(points, "points");
  if (!(radius > 0 && radius < kInfinity)) throw py::value_error("radius must be above 0 metres");
  if (!(k >= 0 && k < kInfinity)) throw py::value_error("k must be at least 0");
  return array_of(
      run_call(progress, threads, [&](Progress& inner) { return light_of_points(cloud, *scene, radius, k, inner); }));
}

py::tuple crown_light(const ScenePointer& scene, const py::object& crown, std::uint64_t rays, int threads,
                      const py::object& progress) {
  if (rays < 1) throw py::value_error("rays must be at least 1");
  const std::vector<Vec3> points =
      py::isinstance<Mesh>(crown) ? crown.cast<const Mesh&>().positions : points_of(crown, "crown");
  CrownLight light = run_call(progress, threads, [&](Progress& inner) {
    const Mesh hull = convex_hull(points, &inner);
    if (hull.triangle_count() == 0) throw std::invalid_argument("crown lies in one plane, so it has no hull");
    return measure_crown_light(hull, *scene, rays, &inner);
  });
  return py::make_tuple(light.lit_share, array_of(std::move(light.lit_shares)));
}

std::string scene_repr(const ScenePointer& scene) {
  const auto counted = [](std::size_t count, const char* one, const char* more) {
    return fmt::format("{} {}", count, count == 1 ? one : more);
  };
  return fmt::format(
      "<meristem.Scene: {} of the sun, {} of sky, {}, {}>", counted(scene->light.sun.size(), "position", "positions"),
      counted(scene->light.sky.size(), "patch", "patches"), counted(scene->light.lamps.size(), "lamp", "lamps"),
      counted(scene->obstacles.bodies().size(), "obstacle", "obstacles"));
}

using SceneClass = py::class_<Scene, ScenePointer>;

void bind_light(SceneClass& scene) {
  scene
      .def_property_readonly(
          "sun", [](const ScenePointer& s) { return directional_lights(s, s->light.sun); },
          "The sun's positions as (directions, strengths): (k, 3) float32 unit vectors toward it, (k,) float64.\n\nThe "
          "strengths of sun and sky sum to 1 if the sun rises. Empty at night.")
      .def_property_readonly(
          "sky", [](const ScenePointer& s) { return directional_lights(s, s->light.sky); },
          "The patches of the sky as (directions, strengths), as in `sun`.")
      .def_property_readonly("lamps", &lamps_of,
                             "The lamps as (positions, strengths): (k, 3) float32 metres, (k,) float64 one metre away.")
      .def_property_readonly(
          "mean_direction", &mean_direction,
          "(3,) float32: the unit vector toward the middle of sun and sky. Without both, it points up.")
      .def("light_at", &light_at, py::arg("points"), py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Returns (n,) float64: the light that reaches each of `points` (n, 3) past the obstacles.

It is the sum of the strengths of the lights that arrive: for sun and sky 1 in the open and 0 in full shade, and more
with lamps.)")
      .def("light_of_points", &light_of_cloud, py::arg("points"), py::kw_only(),
           py::arg("radius") = LightLimit{}.radius, py::arg("k") = LightLimit{}.k, py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Returns (n,) float64: the light of each of `points` (n, 3) in a cloud whose points dim each other.

As in light_at(), but each point within `radius` metres of the ray to sun or sky multiplies the light by exp(-k).)")
      .def("crown_light", &crown_light, py::arg("crown"), py::kw_only(), py::arg("rays") = kCrownRays,
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Returns the lit shares of a crown's hull under the sun: (lit_share, lit_shares).

`crown` is points (n, 3) or a Mesh, whose convex hull is taken. `lit_shares` (k,) are the shares of its area, 0 to 1,
that each position of the sun lights past the obstacles. `lit_share` is their plain mean. `rays` are shared among the
positions. Raises ValueError for a crown in one plane.)");
}

void bind_obstacles(SceneClass& scene) {
  scene.def_property_readonly("obstacles", &obstacle_meshes, "Returns the obstacles in the world: a list of new Mesh.")
      .def("inside", &inside, py::arg("points"), py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(), "Returns (n,) bool: true for each of `points` (n, 3) inside an obstacle.")
      .def("crosses", &crosses, py::arg("starts"), py::arg("ends"), py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Returns (n,) bool: true if the straight line from a row of `starts` to the same row of `ends` meets an
obstacle's surface.

Both are (n, 3), metres; a single row is used for all. Touching counts. A line without length meets no surface.)")
      .def("first_hit", &first_hit, py::arg("origins"), py::arg("directions"), py::arg("within") = py::none(),
           py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Returns the first hits of rays as (distances, obstacles): (n,) float64 metres and (n,) int64 indices in
`obstacles`.

`origins` and `directions` are (n, 3); a single row is used for all, and directions may have any length above 0. If a
ray hits no obstacle, or none within `within` metres, the distance is infinite and the index -1. Of equally near
obstacles the first counts.)")
      .def("blocked", &blocked, py::arg("origins"), py::arg("directions"), py::arg("within") = py::none(),
           py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
           "Returns (n,) bool: true for rays, as in first_hit(), that meet any obstacle. Faster than first_hit().");
}

}  // namespace

std::vector<Vec3> one_or_more_points(const py::object& object, const char* name) {
  const py::array given = py::array::ensure(object);
  if (!given) PyErr_Clear();
  if (given && given.ndim() == 1 && given.size() == 3) return points_of(given.attr("reshape")(1, 3), name);
  return points_of(object, name);
}

void bind_scene(py::module_& module) {
  SceneClass scene(module, "Scene", R"(The surroundings of plants: light and obstacles.

`values` is the dict of a document's "scene": {"latitude": 50, "sun": {"day": 126, "every_hours": 1}, "sky": 0.3,
"obstacles": [{"box": [[1, 0, -1], [2, 3, 1]]}]}; None gives light from the zenith alone. Meshes that it names are
searched in the folder of `file`, or in the current folder. A scene never changes, and many threads may query it. Raises
InputError with all faults.

Each query takes all its positions at once, as arrays in metres. `threads` bounds the threads (0: all cores). `progress`
is a Progress or a function of stage and fraction. Queries raise TypeError for wrong types, ValueError for wrong shapes
and values, and Cancelled.

    scene = meristem.Scene({"latitude": 50, "sun": {"day": 172, "every_hours": 1},
                            "sky": 0.3, "obstacles": [{"box": [[1, 0, -1], [2, 3, 1]]}]})
    light = scene.light_at([[0.8, 0.5, 0], [-5, 0.5, 0]])
    assert light[0] < light[1]
    assert scene.inside([[1.5, 1, 0]]).all())");
  scene.def(py::init(&make_scene), py::arg("values") = py::none(), py::kw_only(), py::arg("file") = "");
  bind_light(scene);
  bind_obstacles(scene);
  scene.def("__repr__", &scene_repr);
  scene.def(py::pickle(&state_of, &scene_from));
  bind_sun(module);
}

}  // namespace meristem::python

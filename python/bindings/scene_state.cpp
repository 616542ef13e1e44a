// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "scene.h"

namespace meristem::python {

namespace {

template <class Item>
py::bytes bytes_of(const std::vector<Item>& items) {
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)};
}

template <class Item>
std::vector<Item> items_of(const py::handle& bytes) {
  const auto text = bytes.cast<std::string>();
  std::vector<Item> items(text.size() / sizeof(Item));
  if (!items.empty()) std::memcpy(items.data(), text.data(), items.size() * sizeof(Item));
  return items;
}

std::array<float, 3> numbers_of(Vec3 vector) { return {vector.x, vector.y, vector.z}; }

Vec3 vector_of(const py::handle& numbers) {
  const auto [x, y, z] = numbers.cast<std::array<float, 3>>();
  return {x, y, z};
}

py::list state_of(const std::vector<DirectionalLight>& lights) {
  py::list states;
  for (const DirectionalLight& light : lights) states.append(py::make_tuple(numbers_of(light.toward), light.strength));
  return states;
}

std::vector<DirectionalLight> directional_lights_from(const py::handle& states) {
  std::vector<DirectionalLight> lights;
  for (const py::handle state : states) {
    const auto pair = state.cast<py::tuple>();
    lights.push_back({vector_of(pair[0]), pair[1].cast<double>()});
  }
  return lights;
}

py::tuple state_of(const Obstacle& body) {
  return py::make_tuple(bytes_of(body.mesh.positions), bytes_of(body.mesh.triangles), numbers_of(body.colour),
                        body.is_broken, body.is_hidden, body.name);
}

Obstacle obstacle_from(const py::tuple& state) {
  return {
      .mesh = {.positions = items_of<DVec3>(state[0]), .triangles = items_of<std::array<std::uint32_t, 3>>(state[1])},
      .colour = vector_of(state[2]),
      .is_broken = state[3].cast<bool>(),
      .is_hidden = state[4].cast<bool>(),
      .name = state[5].cast<std::string>()};
}

py::tuple state_of(const Lamp& lamp) {
  const auto numbers = [](const std::optional<Vec3>& vector) {
    return vector ? std::optional(numbers_of(*vector)) : std::nullopt;
  };
  return py::make_tuple(numbers_of(lamp.position), lamp.strength, numbers(lamp.colour), numbers(lamp.target),
                        lamp.angle, lamp.radius);
}

Lamp lamp_from(const py::tuple& state) {
  const auto vector = [](const py::object& numbers) {
    return numbers.is_none() ? std::nullopt : std::optional<Vec3>(vector_of(numbers));
  };
  return {.position = vector_of(state[0]),
          .strength = state[1].cast<double>(),
          .colour = vector(state[2]),
          .target = vector(state[3]),
          .angle = state[4].cast<double>(),
          .radius = state[5].cast<std::optional<double>>()};
}

}  // namespace

py::tuple state_of(const Scene& scene) {
  py::list lamps;
  for (const Lamp& lamp : scene.light.lamps) lamps.append(state_of(lamp));
  py::list bodies;
  for (const Obstacle& body : scene.obstacles.bodies()) bodies.append(state_of(body));
  return py::make_tuple(
      state_of(scene.light.sun), state_of(scene.light.sky), lamps, bodies, scene.sun.azimuth, scene.sun.altitude,
      numbers_of(scene.ground_colour), scene.latitude,
      scene.clock ? std::optional(std::pair(scene.clock->longitude, scene.clock->utc_offset)) : std::nullopt);
}

Scene scene_from(const py::tuple& state) {
  if (state.size() != 9) throw py::value_error("the state of a Scene has nine parts");
  Scene scene;
  scene.light = {.sun = directional_lights_from(state[0]), .sky = directional_lights_from(state[1])};
  for (const py::handle each : state[2]) {
    scene.light.lamps.push_back(lamp_from(each.cast<py::tuple>()));
  }
  std::vector<Obstacle> bodies;
  for (const py::handle body : state[3]) bodies.push_back(obstacle_from(body.cast<py::tuple>()));
  if (!bodies.empty()) scene.obstacles = Obstacles(std::move(bodies));
  scene.sun = {state[4].cast<double>(), state[5].cast<double>()};
  scene.ground_colour = vector_of(state[6]);
  scene.latitude = state[7].cast<std::optional<double>>();
  if (const auto clock = state[8].cast<std::optional<std::pair<double, double>>>()) {
    scene.clock = ClockZone{clock->first, clock->second};
  }
  return scene;
}

}  // namespace meristem::python

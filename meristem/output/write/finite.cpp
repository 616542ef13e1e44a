// SPDX-License-Identifier: Apache-2.0
// Checks that numbers are finite. A bound on the effect of all frames replaces a check of every vertex of every
// instance.
#include "meristem/output/write/finite.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"

namespace meristem {

namespace {

// Maximum coordinate of moved instances: the largest float, with room for the additions of writers.
constexpr double kLargest = 1e38;
constexpr const char* kExpected = "finite numbers; smaller lengths, radii and scales in the document";

[[noreturn]] void fail(std::string_view component, std::string_view what) {
  throw InputError(
      Diagnostic{.message = fmt::format("{} of {} is not finite", what, in_quotes(component)), .expected = kExpected});
}

template <glm::length_t kLength>
bool is_finite(const glm::vec<kLength, float>& vector) {
  bool finite = true;
  for (glm::length_t k = 0; k < kLength; ++k) finite = finite && std::isfinite(vector[k]);
  return finite;
}

template <class Vector>
bool are_finite(const std::vector<Vector>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const Vector& vector) { return is_finite(vector); });
}

/// The maximum effect of frames on the coordinates of a point. Infinite if a frame is not finite.
struct Stretch {
  double factor = 0;
  double shift = 0;

  explicit Stretch(const std::vector<Frame>& frames) {
    for (const Frame& frame : frames) {
      double sum = 0;
      for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(frame.axes[axis])) sum = INFINITY;
        for (int k = 0; k < 3; ++k) sum += std::abs(double{frame.axes[axis][k]});
      }
      factor = std::max(factor, sum);
      if (!is_finite(frame.origin)) shift = INFINITY;
      for (int k = 0; k < 3; ++k) shift = std::max(shift, std::abs(double{frame.origin[k]}));
    }
  }

  /// Returns the largest coordinate that points with coordinates up to `max` can reach.
  double of(double max) const { return factor * max + shift; }
};

double largest(const std::vector<Vec3>& positions) {
  float max = 0;
  for (const Vec3 position : positions) {
    for (int k = 0; k < 3; ++k) max = std::max(max, std::abs(position[k]));
  }
  return max;
}

/// Checks a mesh and returns its largest coordinate.
double checked(const Mesh& mesh, std::string_view component) {
  if (!are_finite(mesh.positions)) fail(component, "a position of the mesh");
  if (!are_finite(mesh.normals)) fail(component, "a normal of the mesh");
  if (!are_finite(mesh.uvs)) fail(component, "a texture coordinate of the mesh");
  if (!are_finite(mesh.tangents)) fail(component, "a tangent of the mesh");
  return largest(mesh.positions);
}

void check_skeleton(const Skeleton& skeleton, std::string_view component) {
  const auto check = [&](const std::vector<float>& numbers, const char* what) {
    const auto finite = [](float number) { return std::isfinite(number); };
    if (!std::all_of(numbers.begin(), numbers.end(), finite)) fail(component, what);
  };
  if (!are_finite(skeleton.position)) fail(component, "the position of a node");
  check(skeleton.radius, "the radius of a node");
  check(skeleton.birth, "the birth of a node");
  for (const auto& [name, values] : skeleton.extra) {
    if (std::any_of(values.begin(), values.end(), [](float value) { return std::isinf(value); })) {
      fail(component, fmt::format("a value of the column {}", in_quotes(name)));
    }
  }
}

}  // namespace

void require_finite(const MeshScene& scene) {
  for (const Material& material : scene.materials) {
    if (!is_finite(material.colour) || !std::isfinite(material.roughness + material.translucency + material.opacity)) {
      fail(material.name, "a number of the material");
    }
  }
  std::unordered_map<const Mesh*, double> sizes;  // largest coordinate of each mesh
  std::unordered_map<const void*, Stretch> places;
  for (const MeshInstances& part : scene.meshes) {
    const auto [size, is_new] = sizes.try_emplace(part.mesh.get(), 0);
    if (is_new) size->second = checked(*part.mesh, part.component);
    double reach = Stretch(part.frames).of(size->second);
    if (part.places != nullptr) reach = places.try_emplace(part.places.get(), *part.places).first->second.of(reach);
    if (!(reach < kLargest)) fail(part.component, "the place or size of an instance");
    if (!are_finite(part.tints)) fail(part.component, "the tint of an instance");
  }
}

void require_finite(const Plant& plant) {
  for (const Stem& stem : plant.stems) check_skeleton(stem.skeleton, stem.parts.front().component);
  for (const Organ& organ : plant.organs) {
    const Frame& frame = organ.frame;
    if (is_finite(frame.origin) && is_finite(frame.axes[0]) && is_finite(frame.axes[1]) && is_finite(frame.axes[2])) {
      continue;
    }
    fail(plant.prototypes[organ.prototype].component, "the place or size of an organ");
  }
}

void throw_not_finite() {
  throw InputError(Diagnostic{.message = "a number of the file would not be finite", .expected = kExpected});
}

}  // namespace meristem

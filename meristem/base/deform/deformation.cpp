// SPDX-License-Identifier: Apache-2.0
// Maps points, normals and tangents through nested deformations. A level adds to a point the shift that it has in its
// own frame, so a coordinate without a shift keeps every bit.
#include "meristem/base/deform/deformation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "meristem/base/deform/polar.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kTogether = 512;   // number of vertices that are mapped together
constexpr std::size_t kPerBlock = 8192;  // vertices in one block of a parallel loop
constexpr double kFarthest = 1e7;        // maximum distance of a mapped point from the origin, metres

/// Turns and moves all of space.
class RigidMap : public SpaceMap {
 public:
  RigidMap(DVec3 from, DVec3 to, DMat3 rotation) : from_(from), to_(to), rotation_(rotation) {}

  void map(std::span<DVec3> points, std::span<DMat3> jacobians) const override {
    for (DVec3& point : points) point = to_ + rotation_ * (point - from_);
    std::fill(jacobians.begin(), jacobians.end(), rotation_);
  }
  void add_to(Fingerprint& fingerprint) const override {
    for (const DVec3& v : {from_, to_, rotation_[0], rotation_[1], rotation_[2]})
      fingerprint.add(v.x).add(v.y).add(v.z);
  }

 private:
  DVec3 from_, to_;
  DMat3 rotation_;
};

bool is_finite(const DVec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool is_finite(const DMat3& m) { return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]); }

std::string text_of(const DVec3& v) { return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x, v.y, v.z); }

/// Throws the error of a level that maps `from` to `to`. Both are in the level's frame.
[[noreturn]] void throw_error(const Deformation::Level& level, std::string_view who, const DVec3& world,
                              const DVec3& from, const DVec3& to, const DMat3& jacobian) {
  const std::string place =
      fmt::format("where '{}' stands at {} ({} in its own frame)", who, text_of(world), text_of(from));
  if (!is_finite(to) || !is_finite(jacobian)) {
    throw InputError(
        Diagnostic{.message = fmt::format("the deformation has no finite value {}", place),
                   .expected = "functions that are finite and have finite slopes wherever something stands",
                   .path = level.path});
  }
  const double determinant = glm::determinant(jacobian);
  if (!(determinant > 0)) {
    throw InputError(Diagnostic{
        .message = fmt::format("the deformation folds space over {}: the determinant of its Jacobian is {:.3g} there",
                               place, determinant),
        .expected = "a gentler bend, or one that nothing reaches the fold of",
        .path = level.path});
  }
  throw InputError(Diagnostic{.message = fmt::format("the deformation takes a point to {}, {}", text_of(to), place),
                              .expected = fmt::format("points within {:g} m of the origin", kFarthest),
                              .path = level.path});
}

/// Returns the cofactors of a Jacobian, which turn normals.
DMat3 cofactors(const DMat3& m) { return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])}; }

bool is_identity(const DMat3& m) { return m == DMat3(1); }

void turn(Mesh& mesh, std::size_t vertex, const DMat3& jacobian) {
  if (is_identity(jacobian)) return;
  Vec3 normal(0);
  if (!mesh.normals.empty()) {
    normal = normalized_or(Vec3(cofactors(jacobian) * DVec3(mesh.normals[vertex])), mesh.normals[vertex]);
    mesh.normals[vertex] = normal;
  }
  if (!mesh.tangents.empty()) {
    const Vec4 old = mesh.tangents[vertex];
    const Vec3 along(jacobian * DVec3(old));
    mesh.tangents[vertex] = Vec4(normalized_or(along - glm::dot(along, normal) * normal, Vec3(old)), old.w);
  }
}

}  // namespace

namespace {

using Levels = std::vector<Deformation::Level>;

Levels::const_iterator first_on_geometry(const Levels& levels) {
  return std::find_if(levels.begin(), levels.end(),
                      [](const Deformation::Level& level) { return level.part == DeformedPart::geometry; });
}

std::shared_ptr<const Deformation> made_of(Levels::const_iterator begin, Levels::const_iterator end) {
  return begin == end ? nullptr : std::make_shared<const Deformation>(Levels(begin, end));
}

}  // namespace

std::shared_ptr<const Deformation> Deformation::nested(const std::shared_ptr<const Deformation>& inner,
                                                       const std::shared_ptr<const Deformation>& outer) {
  if (inner == nullptr || outer == nullptr) return inner == nullptr ? outer : inner;
  Levels levels = inner->levels_;
  levels.insert(levels.end(), outer->levels_.begin(), outer->levels_.end());
  return std::make_shared<const Deformation>(std::move(levels));
}

std::shared_ptr<const Deformation> Deformation::of_axes() const {
  return made_of(levels_.begin(), first_on_geometry(levels_));
}

std::shared_ptr<const Deformation> Deformation::of_surface() const {
  return made_of(first_on_geometry(levels_), levels_.end());
}

std::shared_ptr<const Deformation> Deformation::rigid_at(Vec3 position, std::string_view who) const {
  DVec3 point(position);
  DMat3 jacobian(1);
  map(std::span(&point, 1), std::span(&jacobian, 1), who);
  auto rigid = std::make_shared<const RigidMap>(DVec3(position), point, nearest_rotation(jacobian));
  return std::make_shared<const Deformation>(Levels{{std::move(rigid), Frame{}, DeformedPart::axes, {}}});
}

std::shared_ptr<const Deformation> Deformation::moved_to(const Frame& frame) const {
  Levels levels = levels_;
  for (Level& level : levels) level.frame = frame * level.frame;
  return std::make_shared<const Deformation>(std::move(levels));
}

void Deformation::map(const Level& level, std::span<DVec3> points, std::span<DMat3> jacobians, std::string_view who) {
  const DMat3 axes(level.frame.axes);
  const DMat3 inverse = glm::inverse(axes);
  const DVec3 origin(level.frame.origin);
  std::array<DVec3, kTogether> local;
  for (std::size_t begin = 0; begin < points.size(); begin += kTogether) {
    const std::size_t count = std::min(kTogether, points.size() - begin);
    const std::span<DVec3> moved = std::span(local).first(count);
    const std::span<DMat3> slopes = jacobians.subspan(begin, count);
    for (std::size_t k = 0; k < count; ++k) moved[k] = inverse * (points[begin + k] - origin);
    level.map->map(moved, slopes);
    for (std::size_t k = 0; k < count; ++k) {
      DVec3& point = points[begin + k];
      const DVec3 from = inverse * (point - origin);
      const DVec3 to = point + axes * (moved[k] - from);
      const double determinant = glm::determinant(slopes[k]);
      const bool is_near = is_finite(to) && std::max({std::abs(to.x), std::abs(to.y), std::abs(to.z)}) <= kFarthest;
      if (!(determinant > 0) || !std::isfinite(determinant) || !is_near) {
        throw_error(level, who, point, from, moved[k], slopes[k]);
      }
      point = to;
      if (!is_identity(slopes[k])) slopes[k] = DMat3(1) + axes * (slopes[k] - DMat3(1)) * inverse;
    }
  }
}

void Deformation::map(std::span<DVec3> points, std::span<DMat3> jacobians, std::string_view who) const {
  map(levels_[0], points, jacobians, who);
  std::vector<DMat3> own(levels_.size() > 1 ? points.size() : 0);
  for (std::size_t k = 1; k < levels_.size(); ++k) {
    map(levels_[k], points, own, who);
    for (std::size_t i = 0; i < points.size(); ++i) jacobians[i] = own[i] * jacobians[i];
  }
}

void Deformation::map(std::span<Vec3> positions, std::string_view who) const {
  parallel_for(positions.size(), kPerBlock, [&](std::size_t begin, std::size_t end) {
    std::array<DVec3, kTogether> points;
    std::array<DMat3, kTogether> jacobians;
    for (std::size_t first = begin; first < end; first += kTogether) {
      const std::size_t count = std::min(kTogether, end - first);
      for (std::size_t k = 0; k < count; ++k) points[k] = DVec3(positions[first + k]);
      map(std::span(points).first(count), std::span(jacobians).first(count), who);
      for (std::size_t k = 0; k < count; ++k) positions[first + k] = Vec3(points[k]);
    }
  });
}

void Deformation::map(Mesh& mesh, Vec3 origin, Vec3 new_origin, std::string_view who) const {
  const DVec3 from(origin), to(new_origin);
  parallel_for(mesh.vertex_count(), kPerBlock, [&](std::size_t begin, std::size_t end) {
    std::array<DVec3, kTogether> points;
    std::array<DMat3, kTogether> jacobians;
    for (std::size_t first = begin; first < end; first += kTogether) {
      const std::size_t count = std::min(kTogether, end - first);
      for (std::size_t k = 0; k < count; ++k) points[k] = from + DVec3(mesh.positions[first + k]);
      map(std::span(points).first(count), std::span(jacobians).first(count), who);
      for (std::size_t k = 0; k < count; ++k) {
        mesh.positions[first + k] = Vec3(points[k] - to);
        turn(mesh, first + k, jacobians[k]);
      }
    }
  });
}

std::uint64_t Deformation::hash() const {
  Fingerprint hash;
  for (const Level& level : levels_) {
    hash.add(level.part);
    for (const Vec3& v : {level.frame.axes[0], level.frame.axes[1], level.frame.axes[2], level.frame.origin}) {
      hash.add(v.x).add(v.y).add(v.z);
    }
    level.map->add_to(hash);
  }
  return hash.hash();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Places cameras so that a plant exactly fits the picture. Once the camera's directions are known, a plant fits if it
// lies on the inner side of four planes through the camera with known normals. The extent of the plant along each
// normal gives the camera's position directly.
#include "meristem/output/picture/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"

namespace meristem {

namespace {

// Share of half the picture that stays free on each side.
constexpr double kMargin = 0.07;

/// The extent of a set of points along four directions.
struct Reach {
  std::array<float, 4> along;

  Reach() { along.fill(-std::numeric_limits<float>::infinity()); }
  void add(Vec3 point, const std::array<Vec3, 4>& directions) {
    for (int i = 0; i < 4; ++i) along[i] = std::max(along[i], glm::dot(point, directions[i]));
  }
  void add(const Reach& other) {
    for (int i = 0; i < 4; ++i) along[i] = std::max(along[i], other.along[i]);
  }
};

std::vector<Vec3> corners(const Mesh& mesh) {
  Box box;
  for (const Vec3 position : mesh.positions) box.add(position);
  std::vector<Vec3> points;
  points.reserve(8);
  for (int corner = 0; corner < 8; ++corner) {
    points.emplace_back(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                        corner & 4 ? box.high.z : box.low.z);
  }
  return points;
}

/// Returns the extent of one part of the scene. Small meshes with many instances are replaced by their boxes.
Reach reach_of(const MeshInstances& part, const std::array<Vec3, 4>& directions) {
  const bool is_single = part.count() == 1;
  const std::vector<Vec3> points = is_single ? part.mesh->positions : corners(*part.mesh);
  const std::size_t count = part.count() * points.size();
  constexpr std::size_t kGrain = 1 << 16;
  std::vector<Reach> reaches((count + kGrain - 1) / kGrain);
  parallel_for(count, kGrain, [&](std::size_t begin, std::size_t end) {
    Reach& reach = reaches[begin / kGrain];
    for (std::size_t i = begin; i < end; ++i) {
      reach.add(part.frame(i / points.size()).point(points[i % points.size()]), directions);
    }
  });
  Reach all;
  for (const Reach& reach : reaches) all.add(reach);
  return all;
}

Reach reach_of(const MeshScene& scene, const std::array<Vec3, 4>& directions) {
  Reach all;
  for (const MeshInstances& part : scene.meshes) {
    if (part.triangle_count() > 0) all.add(reach_of(part, directions));
  }
  if (!std::isfinite(all.along[0])) {  // if nothing is visible, frames a ball of one metre at the origin
    for (int i = 0; i < 4; ++i) all.along[i] = 0.5F * glm::length(directions[i]);
  }
  return all;
}

/// The directions along which x and y of the film rise.
struct FilmAxes {
  Vec3 right, up;
};

/// Returns the axes of a camera that looks along the heading of `frame`, turned by `roll` radians.
FilmAxes film_axes(const Frame& frame, double roll) {
  const Vec3 up = frame.upper();
  const Vec3 right = glm::cross(frame.heading(), up);
  if (roll == 0) return {right, up};
  const auto cosine = static_cast<float>(math::cos(roll));
  const auto sine = static_cast<float>(math::sin(roll));
  return {cosine * right + sine * up, cosine * up - sine * right};
}

}  // namespace

Camera::Camera(Vec3 position, Vec3 target, double field_of_view, double aspect, double roll) : position_(position) {
  const Frame frame = frame_along(position, normalized_or(target - position, Vec3(0, 0, -1)), kUp);
  forward_ = frame.heading();
  const FilmAxes axes = film_axes(frame, roll);
  right_ = axes.right;
  up_ = axes.up;
  half_height_ = static_cast<float>(math::tan(field_of_view / 2));
  half_width_ = static_cast<float>(half_height_ * aspect);
}

Vec3 Camera::direction(Vec2 film) const {
  return glm::normalize(forward_ + film.x * half_width_ * right_ + film.y * half_height_ * up_);
}

std::optional<Vec2> Camera::project(Vec3 point) const {
  const Vec3 offset = point - position_;
  const float depth = glm::dot(offset, forward_);
  if (depth <= 0) return std::nullopt;
  return Vec2(glm::dot(offset, right_) / (depth * half_width_), glm::dot(offset, up_) / (depth * half_height_));
}

Camera place_camera(const MeshScene& scene, const CameraView& view, double aspect) {
  if (view.position && view.target) return {*view.position, *view.target, view.field_of_view, aspect, view.roll};
  if (view.position) {
    const Box box = scene.bounds();
    return {*view.position, box.is_empty() ? Vec3(0) : box.centre(), view.field_of_view, aspect, view.roll};
  }

  // The camera's directions, and the outward normals of the four planes that bound the plant.
  const Vec3 backward = unit_vector({view.azimuth, view.altitude});
  const Frame frame = frame_along(Vec3(0), -backward, kUp);
  const auto [right, up] = film_axes(frame, view.roll);
  const double half_height = math::tan(view.field_of_view / 2) * (1 - kMargin);
  const auto x_slope = static_cast<float>(half_height * aspect);
  const auto y_slope = static_cast<float>(half_height);
  const std::array<Vec3, 4> normals{x_slope * backward + right, x_slope * backward - right, y_slope * backward + up,
                                    y_slope * backward - up};
  const Reach reach = reach_of(scene, normals);

  // Step back from the target until the plant lies inside all four planes.
  if (view.target) {
    float distance = 0;
    for (int i = 0; i < 4; ++i) {
      const float slope = i < 2 ? x_slope : y_slope;
      distance = std::max(distance, (reach.along[i] - glm::dot(normals[i], *view.target)) / slope);
    }
    return {*view.target + distance * backward, *view.target, view.field_of_view, aspect, view.roll};
  }

  // Without a target, stand where opposite planes both touch the plant, as far back as the wider direction needs.
  const auto [to_right, to_left, to_top, to_bottom] = reach.along;
  const float back = std::max((to_right + to_left) / (2 * x_slope), (to_top + to_bottom) / (2 * y_slope));
  const Vec3 position = 0.5F * (to_right - to_left) * right + 0.5F * (to_top - to_bottom) * up + back * backward;
  return {position, position - backward, view.field_of_view, aspect, view.roll};
}

CameraView placed_view(const MeshScene& scene, CameraView view, double aspect) {
  const Camera camera = place_camera(scene, view, aspect);
  view.position = camera.position();
  if (!view.target) view.target = camera.position() + camera.direction({0, 0});
  return view;
}

}  // namespace meristem

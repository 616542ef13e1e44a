// SPDX-License-Identifier: Apache-2.0
// Builds meshes of simple solids from grids of vertices. Vertices at creases and at the ends of u are split.
#include "meristem/shape/solid/primitives.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "meristem/base/math.h"
#include "meristem/base/require.h"

namespace meristem {
namespace {

bool is_length(double value) { return std::isfinite(value) && value > 0; }

std::uint32_t add_vertex(Mesh& mesh, Vec3 position, Vec3 normal, Vec2 uv) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
  mesh.uvs.push_back(uv);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Returns the unit vector at a share of a full turn about y, from +z over +x. Whole turns give the same bytes as none.
Vec3 around_y(int segment, int segments) {
  const double angle = 2 * kPi * (segment % segments) / segments;
  return {static_cast<float>(math::sin(angle)), 0, static_cast<float>(math::cos(angle))};
}

float share(int part, int whole) { return static_cast<float>(part) / static_cast<float>(whole); }

/// Adds two triangles per cell of a grid of (columns + 1) x (rows + 1) vertices that begins at `first`, rows upward.
void add_grid(Mesh& mesh, std::uint32_t first, int columns, int rows) {
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto a = first + static_cast<std::uint32_t>(row) * stride + static_cast<std::uint32_t>(column);
      mesh.triangles.push_back({a, a + 1, a + stride + 1});
      mesh.triangles.push_back({a, a + stride + 1, a + stride});
    }
  }
}

/// Adds a flat disc at height y that faces up or down.
void add_disc(Mesh& mesh, double radius, double y, int segments, bool up) {
  const Vec3 normal{0, up ? 1.0F : -1.0F, 0};
  const Vec3 centre{0, static_cast<float>(y), 0};
  const auto first = add_vertex(mesh, centre, normal, {0.5F, 0.5F});
  for (int k = 0; k < segments; ++k) {
    const Vec3 out = around_y(k, segments);
    const Vec2 uv{0.5F + 0.5F * out.x, 0.5F + (up ? -0.5F : 0.5F) * out.z};
    add_vertex(mesh, centre + static_cast<float>(radius) * out, normal, uv);
  }
  for (int k = 0; k < segments; ++k) {
    const auto a = first + 1 + static_cast<std::uint32_t>(k);
    const auto b = first + 1 + static_cast<std::uint32_t>((k + 1) % segments);
    mesh.triangles.push_back(up ? std::array{first, a, b} : std::array{first, b, a});
  }
}

/// Adds a square face. `right` and `up` span it from its centre, and `out` is its normal.
void add_face(Mesh& mesh, Vec3 centre, Vec3 right, Vec3 up, Vec3 out) {
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  for (const Vec2 at : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
    add_vertex(mesh, centre + at.x * right + at.y * up, out, 0.5F * (at + 1.0F));
  }
  add_grid(mesh, first, 1, 1);
}

}  // namespace

Mesh make_box(Vec3 size) {
  require(is_length(size.x) && is_length(size.y) && is_length(size.z), "a box needs a positive size");
  const Vec3 centre{0, 0.5F * size.y, 0};
  const Vec3 x{0.5F * size.x, 0, 0};
  const Vec3 y{0, 0.5F * size.y, 0};
  const Vec3 z{0, 0, 0.5F * size.z};
  Mesh mesh;
  add_face(mesh, centre + z, x, y, {0, 0, 1});
  add_face(mesh, centre + x, -z, y, {1, 0, 0});
  add_face(mesh, centre - z, -x, y, {0, 0, -1});
  add_face(mesh, centre - x, z, y, {-1, 0, 0});
  add_face(mesh, centre + y, x, -z, {0, 1, 0});
  add_face(mesh, centre - y, x, z, {0, -1, 0});
  return mesh;
}

Mesh make_sphere(double radius, int segments) {
  require(is_length(radius), "a sphere needs a positive radius");
  require(segments >= 3, "a sphere needs at least 3 segments");
  const int rows = std::max(2, segments / 2);
  Mesh mesh;
  for (int row = 0; row <= rows; ++row) {
    const bool is_pole = row == 0 || row == rows;
    const double latitude = kPi * row / rows - kPi / 2;
    const auto ring = is_pole ? 0.0F : static_cast<float>(math::cos(latitude));
    const auto height = is_pole ? (row == 0 ? -1.0F : 1.0F) : static_cast<float>(math::sin(latitude));
    for (int k = 0; k <= segments; ++k) {
      const Vec3 out = ring * around_y(k, segments) + Vec3(0, height, 0);
      // A pole has one vertex per triangle, in the middle of the triangle's u.
      const float u = is_pole ? share(2 * k + 1, 2 * segments) : share(k, segments);
      add_vertex(mesh, static_cast<float>(radius) * out, out, {u, share(row, rows)});
    }
  }
  add_grid(mesh, 0, segments, rows);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return mesh.positions[t[0]] == mesh.positions[t[1]] || mesh.positions[t[1]] == mesh.positions[t[2]];
  });
  return mesh;
}

Mesh make_cylinder(double radius, double height, int segments) {
  require(is_length(radius) && is_length(height), "a cylinder needs a positive radius and height");
  require(segments >= 3, "a cylinder needs at least 3 segments");
  Mesh mesh;
  for (int row = 0; row <= 1; ++row) {
    for (int k = 0; k <= segments; ++k) {
      const Vec3 out = around_y(k, segments);
      const Vec3 position = static_cast<float>(radius) * out + Vec3(0, row == 0 ? 0.0F : static_cast<float>(height), 0);
      add_vertex(mesh, position, out, {share(k, segments), static_cast<float>(row)});
    }
  }
  add_grid(mesh, 0, segments, 1);
  add_disc(mesh, radius, 0, segments, false);
  add_disc(mesh, radius, height, segments, true);
  return mesh;
}

Mesh make_cone(double radius, double height, int segments) {
  require(is_length(radius) && is_length(height), "a cone needs a positive radius and height");
  require(segments >= 3, "a cone needs at least 3 segments");
  const double slant = std::sqrt(radius * radius + height * height);
  const auto outward = static_cast<float>(height / slant);
  const auto upward = static_cast<float>(radius / slant);
  Mesh mesh;
  for (int k = 0; k <= segments; ++k) {
    const Vec3 out = around_y(k, segments);
    add_vertex(mesh, static_cast<float>(radius) * out, outward * out + Vec3(0, upward, 0), {share(k, segments), 0});
  }
  // The apex has one vertex per triangle, with the normal at the middle of the triangle's side.
  for (int k = 0; k < segments; ++k) {
    const Vec3 normal = outward * around_y(2 * k + 1, 2 * segments) + Vec3(0, upward, 0);
    const Vec3 apex{0, static_cast<float>(height), 0};
    const auto tip = add_vertex(mesh, apex, normal, {share(2 * k + 1, 2 * segments), 1});
    const auto a = static_cast<std::uint32_t>(k);
    mesh.triangles.push_back({a, a + 1, tip});
  }
  add_disc(mesh, radius, 0, segments, false);
  return mesh;
}

Mesh make_torus(double radius, double tube, int segments) {
  require(is_length(radius) && is_length(tube), "a torus needs positive radii");
  require(tube < radius, "a torus needs a tube thinner than its radius");
  require(segments >= 3, "a torus needs at least 3 segments");
  const int rows = std::max(3, segments / 2);
  Mesh mesh;
  // Rows run around the tube from its inner side over the lower side, so that they rise on the outside.
  for (int row = 0; row <= rows; ++row) {
    const double angle = 2 * kPi * (row % rows) / rows;
    const auto inward = static_cast<float>(math::cos(angle));
    const auto downward = static_cast<float>(math::sin(angle));
    for (int k = 0; k <= segments; ++k) {
      const Vec3 around = around_y(k, segments);
      const Vec3 normal = -inward * around - Vec3(0, downward, 0);
      add_vertex(mesh, static_cast<float>(radius) * around + static_cast<float>(tube) * normal, normal,
                 {share(k, segments), share(row, rows)});
    }
  }
  add_grid(mesh, 0, segments, rows);
  return mesh;
}

}  // namespace meristem

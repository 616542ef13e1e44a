// SPDX-License-Identifier: Apache-2.0
// Each triangle lowers the distances of the grid positions near it. The sign is the winding number of the mesh. It is
// asked only near the surface, because neighbours far from the surface are on the same side.
//
// Based on: C. Ericson: Real-Time Collision Detection (2005), 5.1.5, for the nearest point of a triangle.
#include "meristem/shape/implicit/mesh_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "meristem/base/parallel.h"
#include "meristem/base/require.h"

namespace meristem {

namespace {

constexpr double kDistanceBand = 3;  // cells around the surface in which distances are exact
constexpr int kCombineMargin = 2;    // cells around the result
constexpr int kMinCombineCells = 10;
constexpr int kMaxCombineCells = 512;
constexpr std::size_t kSlabs = 8;  // slabs of the grid that one thread fills at a time

// Shift of the grid, in cells. Faces of blocks often lie on whole cells of a grid that begins at their corner. Rounding
// would put its positions on either side of such faces and leave crumbs.
const DVec3 kPhase(0.37, 0.43, 0.31);

struct FieldTriangle {
  DVec3 a, b, c;
};

/// Returns the square of the distance from a point to a triangle.
double triangle_distance2(const FieldTriangle& t, DVec3 p) {
  const DVec3 ab = t.b - t.a;
  const DVec3 ac = t.c - t.a;
  const auto to = [&](DVec3 nearest) { return glm::dot(p - nearest, p - nearest); };
  const double d1 = glm::dot(ab, p - t.a), d2 = glm::dot(ac, p - t.a);
  if (d1 <= 0 && d2 <= 0) return to(t.a);
  const double d3 = glm::dot(ab, p - t.b), d4 = glm::dot(ac, p - t.b);
  if (d3 >= 0 && d4 <= d3) return to(t.b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 > d3 ? to(t.a + d1 / (d1 - d3) * ab) : to(t.a);
  const double d5 = glm::dot(ab, p - t.c), d6 = glm::dot(ac, p - t.c);
  if (d6 >= 0 && d5 <= d6) return to(t.c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 > d6 ? to(t.a + d2 / (d2 - d6) * ac) : to(t.a);
  const double va = d3 * d6 - d5 * d4;
  const double along = (d4 - d3) + (d5 - d6);
  if (va <= 0 && d4 >= d3 && d5 >= d6) return along > 0 ? to(t.b + (d4 - d3) / along * (t.c - t.b)) : to(t.b);
  const double whole = va + vb + vc;
  if (!(whole > 0)) return std::min({to(t.a), to(t.b), to(t.c)});  // no area
  return to(t.a + vb / whole * ab + vc / whole * ac);
}

/// Lowers the values of the slabs from `begin` to `end` to the distances from the triangle.
void lower_distances(const FieldTriangle& t, int begin, int end, SampledField& field) {
  const double band = kDistanceBand * field.spacing;
  const DVec3 low = (glm::min(t.a, glm::min(t.b, t.c)) - band - field.origin) / field.spacing;
  const DVec3 high = (glm::max(t.a, glm::max(t.b, t.c)) + band - field.origin) / field.spacing;
  const auto first = [&](int k) { return static_cast<int>(std::clamp(std::ceil(low[k]), 0.0, 1e6)); };
  const auto last = [&](int k) {
    return static_cast<int>(std::clamp(std::floor(high[k]), -1.0, static_cast<double>(field.size[k] - 1)));
  };
  for (int z = std::max(first(2), begin); z <= std::min(last(2), end - 1); ++z) {
    for (int y = first(1); y <= last(1); ++y) {
      const std::size_t row = (static_cast<std::size_t>(z) * field.size.y + y) * field.size.x;
      for (int x = first(0); x <= last(0); ++x) {
        const double squared = triangle_distance2(t, field.origin + field.spacing * DVec3(x, y, z));
        float& value = field.values[row + x];
        if (squared < static_cast<double>(value) * value) value = static_cast<float>(std::sqrt(squared));
      }
    }
  }
}

/// Makes the values negative inside the mesh, row by row.
void add_signs(const ClosedMesh& mesh, int begin, int end, SampledField& field) {
  const auto far = static_cast<float>(kDistanceBand * field.spacing);
  for (int z = begin; z < end; ++z) {
    for (int y = 0; y < field.size.y; ++y) {
      float* const row = field.values.data() + (static_cast<std::size_t>(z) * field.size.y + y) * field.size.x;
      bool is_inside = false;
      bool was_far = false;
      for (int x = 0; x < field.size.x; ++x) {
        const bool is_far = row[x] == far;
        if (!(is_far && was_far)) is_inside = mesh.contains(field.origin + field.spacing * DVec3(x, y, z));
        was_far = is_far;
        if (is_inside) row[x] = -row[x];
      }
    }
  }
}

struct DBox {
  DVec3 low{std::numeric_limits<double>::infinity()};
  DVec3 high{-std::numeric_limits<double>::infinity()};
};

DBox bounds_of(const TriangleMesh& mesh) {
  DBox box;
  for (const DVec3 position : mesh.positions) {
    box.low = glm::min(box.low, position);
    box.high = glm::max(box.high, position);
  }
  return box;
}

/// Returns a box that contains the result.
DBox result_box(MeshOperation operation, const TriangleMesh& a, const TriangleMesh& b) {
  const DBox first = bounds_of(a);
  const DBox second = bounds_of(b);
  switch (operation) {
    case MeshOperation::intersect:
      return {glm::max(first.low, second.low), glm::min(first.high, second.high)};
    case MeshOperation::subtract:
      return first;
    default:
      return {glm::min(first.low, second.low), glm::max(first.high, second.high)};
  }
}

float combined(MeshOperation operation, float a, float b) {
  switch (operation) {
    case MeshOperation::intersect:
      return std::max(a, b);
    case MeshOperation::subtract:
      return std::max(a, -b);
    default:
      return std::min(a, b);
  }
}

}  // namespace

SampledField mesh_distances(const TriangleMesh& mesh, glm::ivec3 size, DVec3 origin, double spacing,
                            Progress& progress) {
  SampledField field{.size = size, .origin = origin, .spacing = spacing, .values = {}};
  field.values.assign(static_cast<std::size_t>(size.x) * size.y * size.z, static_cast<float>(kDistanceBand * spacing));
  const ClosedMesh body(mesh);
  progress.begin("measuring distances", static_cast<std::uint64_t>(size.z));
  parallel_for(static_cast<std::size_t>(size.z), kSlabs, [&](std::size_t begin, std::size_t end) {
    const auto first = static_cast<int>(begin);
    const auto last = static_cast<int>(end);
    for (const auto& triangle : mesh.triangles) {
      progress.check();
      lower_distances({mesh.positions[triangle[0]], mesh.positions[triangle[1]], mesh.positions[triangle[2]]}, first,
                      last, field);
    }
    for (int z = first; z < last; ++z) {
      progress.check();
      add_signs(body, z, z + 1, field);
    }
    progress.advance(end - begin);
  });
  return field;
}

Mesh combine_meshes(MeshOperation operation, const TriangleMesh& a, const TriangleMesh& b,
                    const CombineOptions& options, const SizeLimits& limits, Progress& progress) {
  require(options.resolution >= kMinCombineCells && options.resolution <= kMaxCombineCells,
          "a resolution must be 10 to 512 cells");
  const DBox box = result_box(operation, a, b);
  const DVec3 sides = box.high - box.low;
  const double longest = std::max({sides.x, sides.y, sides.z});
  if (!(std::min({sides.x, sides.y, sides.z}) > 0)) return {};
  const double cell = longest / options.resolution;
  const glm::ivec3 size = glm::ivec3(glm::ceil(sides / cell)) + 2 * kCombineMargin + 2;
  const double bytes = 2.0 * sizeof(float) * size.x * size.y * size.z;
  if (bytes > static_cast<double>(limits.mesh_bytes)) {
    throw_limit("bytes of distances", bytes, limits.mesh_bytes, "mesh_bytes", options.path);
  }
  const DVec3 origin = box.low - (static_cast<double>(kCombineMargin) + kPhase) * cell;
  SampledField field = mesh_distances(a, size, origin, cell, progress);
  const SampledField other = mesh_distances(b, size, origin, cell, progress);
  for (std::size_t k = 0; k < field.values.size(); ++k) {
    field.values[k] = combined(operation, field.values[k], other.values[k]);
  }
  return extract_isosurface(field, 0, limits, options.path, progress);
}

}  // namespace meristem

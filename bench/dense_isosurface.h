// SPDX-License-Identifier: Apache-2.0
// Plain marching cubes: evaluates a tree's function at all corners of a grid, and visits all cells in order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "meristem/base/mesh.h"
#include "meristem/shape/implicit/cell_surface.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// Values on the corners of cells, x fastest.
struct DenseGrid {
  DVec3 origin{0};
  double cell = 1;
  glm::ivec3 size{0};
  std::vector<float> values;

  std::size_t index(int x, int y, int z) const { return (static_cast<std::size_t>(z) * size.y + y) * size.x + x; }
  float coordinate(int axis, int k) const { return static_cast<float>(origin[axis] + cell * k); }
};

/// Returns cells of side `cell` about a body, with the corners that extract_isosurface samples.
inline DenseGrid dense_grid(const ImplicitBody& body, double cell) {
  const double margin = body.reach() + 2 * cell;
  DenseGrid grid{.origin = body.low() - margin, .cell = cell};
  grid.size = glm::ivec3((body.high() + margin - grid.origin) / cell) + 2;
  grid.values.resize(grid.index(0, 0, grid.size.z));
  return grid;
}

/// The body that make_stem_body makes from a skeleton with one root. The axes blend one after another, and each axis is
/// a union of cones. A box below the ground is cut away from the first axis.
class DenseTree {
 public:
  explicit DenseTree(const ImplicitBody& body) : base_(moved(std::get<distance::FlatCone<double>>(body.solids()[0]))) {
    axes_.resize(1);
    for (std::size_t k = 0; k < body.clauses().size(); ++k) {
      if (body.clauses()[k].kind != BodyClause::Kind::poly) continue;
      axes_.push_back({(body.clauses()[k - 1].size + 1) / 2, static_cast<float>(body.clauses()[k].width)});
    }
    for (std::size_t k = 1; k < body.solids().size(); ++k) {
      if (const auto* ground = std::get_if<distance::Box<double>>(&body.solids()[k])) {
        ground_ = moved(*ground);
        ground_solid_ = k;
        axes_[0].cones = k - 1;
      } else {
        cones_.push_back(moved(std::get<distance::RoundCone<double>>(body.solids()[k])));
      }
    }
  }

  float value(float x, float y, float z) const {
    const auto* cone = cones_.data();
    float tree = base_.distance(x, y, z);
    for (const auto* end = cone + axes_[0].cones; cone < end; ++cone) tree = std::min(tree, cone->distance(x, y, z));
    tree = std::max(tree, -ground_.distance(x, y, z));
    for (std::size_t k = 1; k < axes_.size(); ++k) {
      float axis = kFar;
      for (const auto* end = cone + axes_[k].cones; cone < end; ++cone) axis = std::min(axis, cone->distance(x, y, z));
      tree = distance::blend_poly(tree, axis, axes_[k].blend, 0.25F / axes_[k].blend);
    }
    return tree;
  }

  /// Evaluates all segments everywhere.
  void fill(DenseGrid& grid) const {
    float* out = grid.values.data();
    for (int z = 0; z < grid.size.z; ++z) {
      for (int y = 0; y < grid.size.y; ++y) {
        for (int x = 0; x < grid.size.x; ++x) {
          *out++ = value(grid.coordinate(0, x), grid.coordinate(1, y), grid.coordinate(2, z));
        }
      }
    }
  }

  /// Evaluates each segment only in its own box, padded by the blend width of its axis and two cells.
  void fill_boxes(DenseGrid& grid, const ImplicitBody& body) const {
    std::fill(grid.values.begin(), grid.values.end(), kFar);
    std::vector<float> axis(grid.values.size(), kFar);
    std::size_t first = 0;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const std::size_t end = first + axes_[k].cones + (k == 0 ? 1 : 0);
      const double pad = axes_[std::max<std::size_t>(k, 1)].blend + 2 * grid.cell;
      for (std::size_t solid = first; solid < end; ++solid) {
        const Span span = span_of(body.solids()[solid], pad, grid);
        // The box stands between the first axis's cones and the others.
        const std::size_t cone = solid - (solid < ground_solid_ ? 1 : 2);
        solid == 0 ? lower(base_, span, grid, axis) : lower(cones_[cone], span, grid, axis);
      }
      if (k == 0) cut(body.solids()[ground_solid_], pad, grid, axis);
      for (std::size_t solid = first; solid < end; ++solid) {
        take(axis, span_of(body.solids()[solid], pad, grid), axes_[k].blend, grid);
      }
      first = k == 0 ? ground_solid_ + 1 : end;
    }
  }

 private:
  static constexpr float kFar = 1e6F;

  struct Axis {
    std::size_t cones = 0;
    float blend = 0;
  };
  struct Span {
    glm::ivec3 low, high;
  };

  static distance::FlatCone<float> moved(const distance::FlatCone<double>& cone) {
    return {glm::vec3(cone.origin), glm::vec3(cone.axis), static_cast<float>(cone.half),
            static_cast<float>(cone.low_radius), static_cast<float>(cone.high_radius)};
  }
  static distance::RoundCone<float> moved(const distance::RoundCone<double>& cone) {
    return {glm::vec3(cone.origin),          glm::vec3(cone.axis),
            static_cast<float>(cone.low),    static_cast<float>(cone.high),
            static_cast<float>(cone.radius), static_cast<float>(cone.slope),
            static_cast<float>(cone.tangent)};
  }

  static distance::Box<float> moved(const distance::Box<double>& box) {
    return {glm::vec3(box.origin), glm::mat3(box.axes), glm::vec3(box.half)};
  }

  static Span span_of(const ImplicitSolid& solid, double pad, const DenseGrid& grid) {
    DVec3 low, high;
    if (const auto* flat = std::get_if<distance::FlatCone<double>>(&solid)) {
      const DVec3 reach = glm::abs(flat->half * flat->axis) + std::max(flat->low_radius, flat->high_radius);
      low = flat->origin - reach, high = flat->origin + reach;
    } else if (const auto* box = std::get_if<distance::Box<double>>(&solid)) {
      DVec3 reach{0};
      for (int k = 0; k < 3; ++k) reach += glm::abs(box->axes[k]) * box->half[k];
      low = box->origin - reach, high = box->origin + reach;
    } else {
      const auto& cone = std::get<distance::RoundCone<double>>(solid);
      const DVec3 to = cone.origin + cone.high * cone.axis;
      const double to_radius = cone.radius - cone.slope * cone.high;
      low = glm::min(cone.origin - cone.radius, to - to_radius);
      high = glm::max(cone.origin + cone.radius, to + to_radius);
    }
    return {glm::max(glm::ivec3((low - pad - grid.origin) / grid.cell), 0),
            glm::min(glm::ivec3((high + pad - grid.origin) / grid.cell) + 2, grid.size)};
  }

  template <class Cone>
  static void lower(const Cone& cone, const Span& span, const DenseGrid& grid, std::vector<float>& values) {
    for (int z = span.low.z; z < span.high.z; ++z) {
      for (int y = span.low.y; y < span.high.y; ++y) {
        float* const row = values.data() + grid.index(0, y, z);
        for (int x = span.low.x; x < span.high.x; ++x) {
          row[x] = std::min(row[x], cone.distance(grid.coordinate(0, x), grid.coordinate(1, y), grid.coordinate(2, z)));
        }
      }
    }
  }

  /// Cuts the ground away.
  void cut(const ImplicitSolid& ground, double pad, const DenseGrid& grid, std::vector<float>& values) const {
    const Span span = span_of(ground, pad, grid);
    for (int z = span.low.z; z < span.high.z; ++z) {
      for (int y = span.low.y; y < span.high.y; ++y) {
        float* const row = values.data() + grid.index(0, y, z);
        for (int x = span.low.x; x < span.high.x; ++x) {
          if (row[x] == kFar) continue;
          const float depth = ground_.distance(grid.coordinate(0, x), grid.coordinate(1, y), grid.coordinate(2, z));
          row[x] = std::max(row[x], -depth);
        }
      }
    }
  }

  /// Blends an axis's values into the tree's values. Each value is taken once.
  static void take(std::vector<float>& axis, const Span& span, float blend, DenseGrid& grid) {
    for (int z = span.low.z; z < span.high.z; ++z) {
      for (int y = span.low.y; y < span.high.y; ++y) {
        const std::size_t row = grid.index(0, y, z);
        for (std::size_t k = row + span.low.x; k < row + span.high.x; ++k) {
          if (axis[k] == kFar) continue;
          grid.values[k] = blend > 0 ? distance::blend_poly(grid.values[k], axis[k], blend, 0.25F / blend) : axis[k];
          axis[k] = kFar;
        }
      }
    }
  }

  distance::FlatCone<float> base_;
  distance::Box<float> ground_;
  std::size_t ground_solid_ = 0;
  std::vector<distance::RoundCone<float>> cones_;
  std::vector<Axis> axes_;
};

/// Extracts the surface between negative and other values. Its cells must not touch the grid's border.
class DenseMesher {
 public:
  explicit DenseMesher(const DenseGrid& grid) : grid_(grid) {
    for (auto& layers : made_) layers.resize(std::size_t{2} * grid.size.x * grid.size.y);
  }

  Mesh run() {
    for (int z = 0; z + 1 < grid_.size.z; ++z) {
      for (int y = 0; y + 1 < grid_.size.y; ++y) {
        std::uint32_t pattern = column(0, y, z) << 1;
        for (int x = 0; x + 1 < grid_.size.x; ++x) {
          pattern = (pattern >> 1 & 0x55U) | column(x + 1, y, z) << 1;
          if (pattern != 0 && pattern != 0xffU) add_cell({x, y, z}, static_cast<std::uint8_t>(pattern));
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  std::uint32_t column(int x, int y, int z) const {
    const float* const value = grid_.values.data() + grid_.index(x, y, z);
    const std::size_t row = grid_.size.x;
    const std::size_t layer = row * grid_.size.y;
    return static_cast<std::uint32_t>(value[0] < 0) | static_cast<std::uint32_t>(value[row] < 0) << 2 |
           static_cast<std::uint32_t>(value[layer] < 0) << 4 | static_cast<std::uint32_t>(value[layer + row] < 0) << 6;
  }

  static glm::ivec3 edge_start(int edge) {
    const int a = edge & 1;
    const int b = edge >> 1 & 1;
    return edge < 4 ? glm::ivec3(0, a, b) : edge < 8 ? glm::ivec3(a, 0, b) : glm::ivec3(a, b, 0);
  }

  std::uint32_t& made_on(glm::ivec3 cell, int edge) {
    const glm::ivec3 at = cell + edge_start(edge);
    return made_[edge / 4][(static_cast<std::size_t>(at.z & 1) * grid_.size.y + at.y) * grid_.size.x + at.x];
  }

  DVec3 crossing(glm::ivec3 cell, int edge) const {
    const glm::ivec3 from = cell + edge_start(edge);
    glm::ivec3 to = from;
    ++to[edge / 4];
    const double a = grid_.values[grid_.index(from.x, from.y, from.z)];
    const double b = grid_.values[grid_.index(to.x, to.y, to.z)];
    DVec3 at(from);
    at[edge / 4] += std::clamp(a / (a - b), 1e-3, 1 - 1e-3);
    return grid_.origin + grid_.cell * at;
  }

  void add_cell(glm::ivec3 cell, std::uint8_t pattern) {
    std::array<float, 8> values{};
    for (int c = 0; c < 8; ++c) {
      values[c] = grid_.values[grid_.index(cell.x + (c & 1), cell.y + (c >> 1 & 1), cell.z + (c >> 2))];
    }
    const CellSurface& surface = cell_surface(pattern, values);
    std::array<std::uint32_t, 20> vertices{};
    for (unsigned left = crossed_edges(pattern); left != 0; left &= left - 1) {
      const int edge = std::countr_zero(left);
      // Other cells have visited an edge before unless it lies above in both directions.
      if ((edge & 3) == 3) {
        made_on(cell, edge) = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.emplace_back(crossing(cell, edge));
      }
      vertices[edge] = made_on(cell, edge);
    }
    for (std::size_t k = 0; k < surface.inner.size(); ++k) {
      vertices[12 + k] = static_cast<std::uint32_t>(mesh_.positions.size());
      DVec3 sum{0};
      for (unsigned left = surface.inner[k]; left != 0; left &= left - 1) {
        sum += crossing(cell, std::countr_zero(left));
      }
      mesh_.positions.emplace_back(sum / static_cast<double>(std::popcount(surface.inner[k])));
    }
    for (const auto& [a, b, c] : surface.triangles) {
      mesh_.triangles.push_back({vertices[a], vertices[b], vertices[c]});
    }
  }

  const DenseGrid& grid_;
  std::array<std::vector<std::uint32_t>, 3> made_;  // vertices on the edges along each axis, of two layers
  Mesh mesh_;
};

}  // namespace meristem

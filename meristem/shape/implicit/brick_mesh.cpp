// SPDX-License-Identifier: Apache-2.0
// Meshes bodies that are sampled in bricks of 8 x 8 x 8 corners near their surface. Each corner's value is computed
// once, by the brick that owns the corner, so cells that share corners agree and meshes close. Two cells agree on their
// common face, because the products of its corners' values are exact in doubles. A tie separates the inside. Vertices
// stay a thousandth of an edge away from its ends, so no triangle degenerates where a value is exactly 0.
#include "meristem/shape/implicit/brick_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "meristem/base/parallel.h"
#include "meristem/shape/implicit/brick_index.h"
#include "meristem/shape/implicit/cell_geometry.h"
#include "meristem/shape/implicit/cell_surface.h"

namespace meristem {

namespace {

constexpr int kSide = kBrickSide;
constexpr int kRows = kSide * kSide;
constexpr double kFromEnds = 1e-3;     // share of an edge: minimum distance of vertices from its ends
constexpr double kMaxFromEnds = 0.25;  // maximum of this distance, far from the origin
constexpr double kRounding = 1e-6;     // share of a coordinate, several float steps
constexpr double kInnerHeight = 0.02;  // in cells: distance that inner points keep, if possible, from lines between
                                       // other points
constexpr int kInnerTries = 6;
constexpr std::uint32_t kInner = 0x80000000U;  // marks points inside cells until all are counted
constexpr std::uint64_t kMaxVertices = 0x7fffffffU;

/// Returns the lower end of a cell's edge.
glm::ivec3 edge_start(int edge) {
  const int corner = edge_corners(edge)[0];
  return {corner & 1, corner >> 1 & 1, corner >> 2};
}

/// Returns the number of set bits. Some processors have no instruction for it.
std::uint32_t bit_count(std::uint32_t bits) {
  bits -= bits >> 1 & 0x55555555U;
  bits = (bits & 0x33333333U) + (bits >> 2 & 0x33333333U);
  return ((bits + (bits >> 4)) & 0x0f0f0f0fU) * 0x01010101U >> 24;
}

int row_index(int y, int z) { return y + kSide * z; }
int corner_index(glm::ivec3 corner) { return corner.x + kSide * row_index(corner.y, corner.z); }

/// The corners of a brick that are inside, one bit per corner, and the vertices on the edges that leave its corners
/// upward.
struct BrickTopology {
  std::array<std::uint8_t, kRows> inside{};
  std::array<std::uint32_t, kRows> edges{};       // 8 bits each for edges along x, y and z
  std::array<std::uint16_t, kRows> first_edge{};  // number of vertices in earlier rows
  std::uint32_t vertices = 0;

  std::uint32_t rank(glm::ivec3 corner, int axis) const {
    const int row = row_index(corner.y, corner.z);
    const std::uint32_t before = edges[row] & ((1U << (kSide * axis + corner.x)) - 1);
    return first_edge[row] + bit_count(before);
  }
};

/// The vertices on the edges that leave a brick's corners upward, along each axis. Entries without a vertex are unset.
using BrickVertices = std::array<std::array<std::uint32_t, kBrickSize>, 3>;

/// A brick with its seven neighbours above it along the axes, as its cells see them.
class Neighbourhood {
 public:
  Neighbourhood(const BrickGrid& grid, const BrickIndex& index, const std::vector<std::vector<BrickTopology>>& topology,
                BrickNumber brick)
      : grid_(grid), topology_(topology) {
    bricks_[0] = brick;
    const glm::ivec3 at = grid.chunks[brick.chunk].at[brick.brick];
    for (int k = 1; k < 8; ++k) bricks_[k] = index.find(at + glm::ivec3(k & 1, k >> 1 & 1, k >> 2));
    for (int z = 0; z <= kSide; ++z) {
      for (int y = 0; y <= kSide; ++y) inside_[z][y] = inside_row(y, z);
    }
  }

  /// Returns which of the nine corners of a row of cells are inside.
  std::uint32_t inside(int y, int z) const { return inside_[z][y]; }

  BrickNumber brick_of(glm::ivec3 corner) const {
    return bricks_[(corner.x >> 3) | (corner.y >> 3) << 1 | (corner.z >> 3) << 2];
  }
  const BrickTopology& topology_of(BrickNumber brick) const { return topology_[brick.chunk][brick.brick]; }
  float value(glm::ivec3 corner) const {
    const BrickNumber brick = brick_of(corner);
    return grid_.chunks[brick.chunk].values_of(brick.brick)[corner_index(corner & (kSide - 1))];
  }

 private:
  // If a brick is missing, all corners of the cells that touch it have the sign of our own corner next to it.
  std::uint32_t inside_row(int y, int z) const {
    const int which = (y >> 3) << 1 | (z >> 3) << 2;
    std::uint32_t row = 0;
    if (bricks_[which].exists()) {
      row = topology_of(bricks_[which]).inside[row_index(y & (kSide - 1), z & (kSide - 1))];
    } else {
      row = topology_of(bricks_[0]).inside[row_index(std::min(y, kSide - 1), std::min(z, kSide - 1))];
    }
    const BrickNumber next = bricks_[which | 1];
    const std::uint32_t last =
        next.exists() ? topology_of(next).inside[row_index(y & (kSide - 1), z & (kSide - 1))] & 1U : row >> (kSide - 1);
    return row | last << kSide;
  }

  const BrickGrid& grid_;
  const std::vector<std::vector<BrickTopology>>& topology_;
  std::array<BrickNumber, 8> bricks_;
  std::array<std::array<std::uint32_t, kSide + 1>, kSide + 1> inside_{};
};

class BrickMesher {
 public:
  BrickMesher(const BrickGrid& grid, Progress& progress) : grid_(grid), progress_(progress), index_(grid) {
    DVec3 farthest = glm::abs(grid.origin);
    for (const BrickChunk& chunk : grid.chunks) {
      topology_.emplace_back(chunk.at.size());
      for (const glm::ivec3 at : chunk.at) farthest = glm::max(farthest, glm::abs(grid.position(kSide * (at + 1))));
    }
    // If coordinates are large relative to the cells, rounding must not join vertices.
    const double rounding = kRounding * std::max({farthest.x, farthest.y, farthest.z}) / grid.cell;
    from_ends_ = std::clamp(rounding, kFromEnds, kMaxFromEnds);
  }

  BrickMesh run(const SizeLimits& limits, const std::string& path) {
    each_chunk([this](std::uint32_t chunk, std::uint32_t brick) { find_signs(chunk, brick); });
    each_chunk([this](std::uint32_t chunk, std::uint32_t brick) { find_edges(chunk, brick); });
    const std::uint64_t vertices = number_vertices();
    // A closed mesh has about two triangles per vertex.
    if (2 * vertices > limits.triangles || vertices > kMaxVertices) {
      throw_limit("triangles at this resolution", 2.0 * static_cast<double>(vertices), limits.triangles, "triangles",
                  path);
    }
    made_.mesh.positions.resize(vertices);
    parts_.resize(grid_.chunks.size());
    each_chunk([this](std::uint32_t chunk, std::uint32_t brick) { make_surface(chunk, brick); });
    gather();
    return std::move(made_);
  }

 private:
  struct Part {  // the result of a chunk
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Vec3> inner;
    std::vector<std::uint32_t> brick_of_inner;
  };

  template <class Visit>
  void each_chunk(Visit visit) {
    parallel_for(grid_.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t chunk = begin; chunk < end; ++chunk) {
        for (std::size_t brick = 0; brick < grid_.chunks[chunk].at.size(); ++brick) {
          if (brick % 64 == 0) progress_.check();
          visit(static_cast<std::uint32_t>(chunk), static_cast<std::uint32_t>(brick));
        }
      }
    });
  }

  void find_signs(std::uint32_t chunk, std::uint32_t brick) {
    const float* value = grid_.chunks[chunk].values_of(brick).data();
    for (std::uint8_t& row : topology_[chunk][brick].inside) {
      std::uint32_t bits = 0;
      for (int x = 0; x < kSide; ++x) bits |= static_cast<std::uint32_t>(value[x] < 0) << x;
      row = static_cast<std::uint8_t>(bits);
      value += kSide;
    }
  }

  void find_edges(std::uint32_t chunk, std::uint32_t brick) {
    const Neighbourhood around(grid_, index_, topology_, {chunk, brick});
    BrickTopology& topology = topology_[chunk][brick];
    for (int z = 0; z < kSide; ++z) {
      for (int y = 0; y < kSide; ++y) {
        const std::uint32_t row = around.inside(y, z);
        const std::uint32_t along_x = (row ^ row >> 1) & 0xffU;
        const std::uint32_t along_y = (row ^ around.inside(y + 1, z)) & 0xffU;
        const std::uint32_t along_z = (row ^ around.inside(y, z + 1)) & 0xffU;
        const int k = row_index(y, z);
        topology.edges[k] = along_x | along_y << kSide | along_z << 2 * kSide;
        topology.first_edge[k] = static_cast<std::uint16_t>(topology.vertices);
        topology.vertices += bit_count(topology.edges[k]);
      }
    }
  }

  std::uint64_t number_vertices() {
    std::uint64_t count = 0;
    for (const std::vector<BrickTopology>& chunk : topology_) {
      std::vector<std::uint32_t>& first = made_.first_vertex.emplace_back();
      for (const BrickTopology& brick : chunk) {
        first.push_back(static_cast<std::uint32_t>(count));
        count += brick.vertices;
      }
      first.push_back(static_cast<std::uint32_t>(count));
    }
    return count;
  }

  void make_surface(std::uint32_t chunk, std::uint32_t brick) {
    const Neighbourhood around(grid_, index_, topology_, {chunk, brick});
    BrickVertices own;
    make_vertices(around, chunk, brick, own);
    for (int z = 0; z < kSide; ++z) {
      for (int y = 0; y < kSide; ++y) {
        const std::array<std::uint32_t, 4> rows{around.inside(y, z), around.inside(y + 1, z), around.inside(y, z + 1),
                                                around.inside(y + 1, z + 1)};
        const std::uint32_t any = rows[0] | rows[1] | rows[2] | rows[3];
        const std::uint32_t all = rows[0] & rows[1] & rows[2] & rows[3];
        std::uint32_t cells = (any | any >> 1) & ~(all & all >> 1) & 0xffU;
        for (; cells != 0; cells &= cells - 1) {
          make_cell(around, own, {std::countr_zero(cells), y, z}, rows, chunk, brick);
        }
      }
    }
  }

  void make_vertices(const Neighbourhood& around, std::uint32_t chunk, std::uint32_t brick, BrickVertices& own) {
    const BrickTopology& topology = topology_[chunk][brick];
    const glm::ivec3 base = kSide * grid_.chunks[chunk].at[brick];
    std::uint32_t vertex = made_.first_vertex[chunk][brick];
    for (int row = 0; row < kRows; ++row) {
      for (std::uint32_t edges = topology.edges[row]; edges != 0; edges &= edges - 1) {
        const int edge = std::countr_zero(edges);
        const int axis = edge / kSide;
        const glm::ivec3 from(edge % kSide, row % kSide, row / kSide);
        glm::ivec3 to = from;
        ++to[axis];
        DVec3 corner(base + from);
        corner[axis] += crossing(around.value(from), around.value(to));
        own[axis][corner_index(from)] = vertex;
        made_.mesh.positions[vertex++] = Vec3(grid_.origin + grid_.cell * corner);
      }
    }
  }

  /// Returns the position along an edge at which the value is 0.
  double crossing(float from, float to) const {
    const double share = from / (static_cast<double>(from) - to);
    // Two infinities meet in the middle.
    return std::isfinite(share) ? std::clamp(share, from_ends_, 1 - from_ends_) : 0.5;
  }

  void make_cell(const Neighbourhood& around, const BrickVertices& own, glm::ivec3 cell,
                 const std::array<std::uint32_t, 4>& rows, std::uint32_t chunk, std::uint32_t brick) {
    std::uint32_t pattern = 0;
    for (int k = 0; k < 4; ++k) pattern |= (rows[k] >> cell.x & 3U) << 2 * k;
    const CellSurface& surface = surface_of(around, cell, static_cast<std::uint8_t>(pattern));
    std::array<std::uint32_t, 20> vertices{};
    const auto vertex_on = [&](int edge) {
      const glm::ivec3 corner = cell + edge_start(edge);
      if (((corner.x | corner.y | corner.z) & kSide) == 0) return own[edge / 4][corner_index(corner)];
      const BrickNumber owner = around.brick_of(corner);
      return made_.first_vertex[owner.chunk][owner.brick] +
             around.topology_of(owner).rank(corner & (kSide - 1), edge / 4);
    };
    std::uint32_t used = crossed_edges(static_cast<std::uint8_t>(pattern));
    for (; used != 0; used &= used - 1) {
      const int edge = std::countr_zero(used);
      vertices[edge] = vertex_on(edge);
    }
    Part& part = parts_[chunk];
    for (std::size_t k = 0; k < surface.inner.size(); ++k) {
      vertices[12 + k] = kInner | static_cast<std::uint32_t>(part.inner.size());
      part.inner.push_back(inner_point(around, kSide * grid_.chunks[chunk].at[brick] + cell, cell, surface, k));
      part.brick_of_inner.push_back(brick);
    }
    for (const auto& [a, b, c] : surface.triangles) part.triangles.push_back({vertices[a], vertices[b], vertices[c]});
  }

  static const CellSurface& surface_of(const Neighbourhood& around, glm::ivec3 cell, std::uint8_t pattern) {
    if (!is_ambiguous(pattern)) return simple_surface(pattern);
    std::array<float, 8> values{};
    for (int c = 0; c < 8; ++c) values[c] = around.value(cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2));
    return cell_surface(pattern, values);
  }

  /// Returns the position of a cell's inner point: the mean of the points on its edges. If the mean lies in line with
  /// two of them, as among equal values, the inner point lies beside it.
  Vec3 inner_point(const Neighbourhood& around, glm::ivec3 place, glm::ivec3 cell, const CellSurface& surface,
                   std::size_t which) const {
    std::array<DVec3, 12> points;
    for (std::uint32_t left = surface.inner[which]; left != 0; left &= left - 1) {
      const int edge = std::countr_zero(left);
      const glm::ivec3 from = edge_start(edge);
      glm::ivec3 to = from;
      ++to[edge / 4];
      points[edge] = DVec3(from);
      points[edge][edge / 4] += crossing(around.value(cell + from), around.value(cell + to));
    }
    DVec3 best{0};
    double best_height = -1;
    for (int shift = 0; shift < kInnerTries && best_height < kInnerHeight; ++shift) {
      const DVec3 tried = weighted_mean(points, surface.inner[which], shift);
      double height = 1;
      for (const auto& triangle : surface.triangles) {
        for (int k = 0; k < 3; ++k) {
          if (triangle[k] != 12 + which) continue;
          const std::uint8_t a = triangle[(k + 1) % 3];
          const std::uint8_t b = triangle[(k + 2) % 3];
          if (a >= 12 || b >= 12) continue;
          const DVec3 side = points[b] - points[a];
          height = std::min(height, glm::length(glm::cross(side, tried - points[a])) / glm::length(side));
        }
      }
      if (height <= best_height) continue;
      best_height = height;
      best = tried;
    }
    return Vec3(grid_.origin + grid_.cell * (DVec3(place) + best));
  }

  /// Returns the mean of the points for shift 0. Other shifts give some points more weight.
  static DVec3 weighted_mean(const std::array<DVec3, 12>& points, std::uint32_t edges, int shift) {
    DVec3 sum{0};
    double weights = 0;
    for (std::uint32_t left = edges; left != 0; left &= left - 1) {
      const int edge = std::countr_zero(left);
      const double weight = shift == 0 ? 1 : 1 + 0.2 * (edge * (shift + 2) % 7);
      sum += weight * points[edge];
      weights += weight;
    }
    return sum / weights;
  }

  /// Combines the triangles and inner points of the chunks.
  void gather() {
    std::vector<std::size_t> first_triangle(1, 0);
    std::vector<std::uint32_t> first_inner(1, static_cast<std::uint32_t>(made_.mesh.positions.size()));
    for (std::uint32_t chunk = 0; chunk < parts_.size(); ++chunk) {
      first_triangle.push_back(first_triangle.back() + parts_[chunk].triangles.size());
      first_inner.push_back(first_inner.back() + static_cast<std::uint32_t>(parts_[chunk].inner.size()));
      made_.mesh.positions.insert(made_.mesh.positions.end(), parts_[chunk].inner.begin(), parts_[chunk].inner.end());
      for (const std::uint32_t brick : parts_[chunk].brick_of_inner) made_.inner.emplace_back(chunk, brick);
    }
    made_.mesh.triangles.resize(first_triangle.back());
    parallel_for(parts_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t chunk = begin; chunk < end; ++chunk) {
        auto* out = made_.mesh.triangles.data() + first_triangle[chunk];
        for (std::array<std::uint32_t, 3> triangle : parts_[chunk].triangles) {
          for (std::uint32_t& vertex : triangle) {
            if ((vertex & kInner) != 0) vertex = first_inner[chunk] + (vertex & ~kInner);
          }
          *out++ = triangle;
        }
        parts_[chunk].triangles = {};
      }
    });
  }

  const BrickGrid& grid_;
  Progress& progress_;
  BrickIndex index_;
  double from_ends_ = kFromEnds;
  std::vector<std::vector<BrickTopology>> topology_;
  std::vector<Part> parts_;
  BrickMesh made_;
};

}  // namespace

BrickMesh mesh_bricks(const BrickGrid& grid, const SizeLimits& limits, const std::string& path, Progress& progress) {
  return BrickMesher(grid, progress).run(limits, path);
}

}  // namespace meristem

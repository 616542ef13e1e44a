// SPDX-License-Identifier: Apache-2.0
// Puts the cells of a grid together and checks the meshes that a plain extraction makes of random and of known fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/shape/implicit/cell_geometry.h"
#include "meristem/shape/implicit/cell_surface.h"
#include "tests/support/check_mesh.h"
#include "tests/support/test_data.h"

namespace meristem::cell_grid_test {

/// Values at n x n x n positions, x fastest.
struct Grid {
  std::size_t n;
  std::vector<float> values;
  double origin = 0, spacing = 1;
};

/// Extracts every cell of a grid, one after the other.
class Extraction {
 public:
  /// Points keep `margin` of an edge from its ends.
  Extraction(const Grid& grid, double margin) : grid_(grid), margin_(margin) {
    for (std::size_t z = 0; z + 1 < grid.n; ++z) {
      for (std::size_t y = 0; y + 1 < grid.n; ++y) {
        for (std::size_t x = 0; x + 1 < grid.n; ++x) add_cell(index(x, y, z));
      }
    }
  }
  Mesh mesh;

 private:
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const { return (z * grid_.n + y) * grid_.n + x; }
  std::size_t corner(std::size_t cell, int c) const { return cell + index(c & 1, c >> 1 & 1, c >> 2 & 1); }
  DVec3 position(std::size_t i) const {
    return grid_.origin + grid_.spacing * DVec3(i % grid_.n, i / grid_.n % grid_.n, i / grid_.n / grid_.n);
  }

  std::uint32_t add_point(DVec3 at) {
    mesh.positions.emplace_back(at);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  }

  std::uint32_t edge_point(std::size_t cell, int edge) {
    const auto [c, d] = edge_corners(edge);
    const std::size_t low = corner(cell, c), high = corner(cell, d);
    const auto [found, is_new] = points_.try_emplace({low, edge / 4}, 0);
    if (!is_new) return found->second;
    constexpr double kMax = std::numeric_limits<float>::max();
    const double a = std::clamp<double>(grid_.values[low], -kMax, kMax);
    const double b = std::clamp<double>(grid_.values[high], -kMax, kMax);
    const double t = std::clamp(a / (a - b), margin_, 1 - margin_);
    return found->second = add_point(glm::mix(position(low), position(high), t));
  }

  void add_cell(std::size_t cell) {
    std::array<float, 8> values{};
    for (int c = 0; c < 8; ++c) values[c] = grid_.values[corner(cell, c)];
    const CellSurface& surface = cell_surface(values);
    std::vector<std::uint32_t> points(kCellEdges + surface.inner.size());
    for (int edge = 0; edge < kCellEdges; ++edge) {
      if ((crossed_edges(cell_pattern(values)) >> edge & 1) != 0) points[edge] = edge_point(cell, edge);
    }
    for (std::size_t i = 0; i < surface.inner.size(); ++i) {
      DVec3 sum{0};
      int count = 0;
      for (int edge = 0; edge < kCellEdges; ++edge) {
        if ((surface.inner[i] >> edge & 1) != 0) sum += DVec3(mesh.positions[points[edge]]), ++count;
      }
      points[kCellEdges + i] = add_point(sum / static_cast<double>(count));
    }
    for (const auto& [a, b, c] : surface.triangles) mesh.triangles.push_back({points[a], points[b], points[c]});
  }

  const Grid& grid_;
  double margin_;
  std::map<std::pair<std::size_t, int>, std::uint32_t> points_;  ///< by lower end and axis
};

bool is_border(std::size_t i, std::size_t n) {
  for (const std::size_t at : {i % n, i / n % n, i / n / n}) {
    if (at == 0 || at == n - 1) return true;
  }
  return false;
}

/// Returns a random grid that is outside at its border.
Grid random_grid(std::size_t n, RandomKey key, const std::function<float(double)>& value) {
  Grid grid{n, std::vector<float>(n * n * n)};
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    grid.values[i] = value(key.uniform(i));
    if (is_border(i, n)) grid.values[i] = std::abs(grid.values[i]);
  }
  return grid;
}

Mesh extract(const Grid& grid) { return Extraction(grid, 1e-3).mesh; }

TEST(CellGrid, EveryPatternIsClosedAmongItsNeighbours) {
  for (std::uint64_t pattern = 1; pattern < 256; ++pattern) {
    for (std::uint64_t i = 0; i < 8; ++i) {
      Grid grid = random_grid(4, RandomKey(1).child(pattern).child(i), [](double u) { return static_cast<float>(u); });
      for (std::size_t c = 0; c < 8; ++c) {
        if ((pattern >> c & 1) == 0) continue;
        float& value = grid.values[(1 + (c & 1)) + 4 * (1 + (c >> 1 & 1)) + 16 * (1 + (c >> 2 & 1))];
        value = -value - 1e-6F;
      }
      ASSERT_TRUE(check_mesh(extract(grid))) << "pattern " << pattern << ", values " << i;
    }
  }
}

TEST(CellGrid, RandomValuesGiveClosedMeshes) {
  for (std::uint64_t i = 0; i < 600; ++i) {
    const Grid grid = random_grid(6, RandomKey(2).child(i), [](double u) { return static_cast<float>(2 * u - 1); });
    ASSERT_TRUE(check_mesh(extract(grid))) << "grid " << i;
  }
}

TEST(CellGrid, EqualAndExtremeValuesGiveClosedMeshes) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::array<float, 8> extreme{0, -0.0F, kInfinity, -kInfinity, -1, 1, -1e-45F, 3e38F};
  const std::array<float, 3> equal{-1, 0, 1};
  for (std::uint64_t i = 0; i < 400; ++i) {
    const RandomKey key = RandomKey(3).child(i);
    ASSERT_TRUE(check_mesh(extract(random_grid(6, key, [&](double u) { return extreme[static_cast<int>(8 * u)]; }))))
        << "extreme " << i;
    ASSERT_TRUE(check_mesh(extract(random_grid(6, key, [&](double u) { return equal[static_cast<int>(3 * u)]; }))))
        << "equal " << i;
  }
}

TEST(CellGrid, TurnedInsideOutAnExtractionHasTheSameTriangles) {
  // If signs alone decide, the complement has equal triangles with opposite orientation.
  for (int pattern = 0; pattern < 256; ++pattern) {
    if (is_ambiguous(static_cast<std::uint8_t>(pattern))) continue;
    const auto sorted = [](const CellSurface& surface) {
      std::vector<std::array<std::uint8_t, 3>> triangles(surface.triangles.begin(), surface.triangles.end());
      for (auto& triangle : triangles) std::sort(triangle.begin(), triangle.end());
      std::sort(triangles.begin(), triangles.end());
      return triangles;
    };
    EXPECT_EQ(sorted(simple_surface(static_cast<std::uint8_t>(pattern))),
              sorted(simple_surface(static_cast<std::uint8_t>(255 - pattern))));
  }
}

double box_distance(DVec3 at, double half) {
  const DVec3 beyond = glm::abs(at) - half;
  return glm::length(glm::max(beyond, 0.0)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
}

double capsule_distance(DVec3 at, double half, double radius) {
  at.z -= std::clamp(at.z, -half, half);
  return glm::length(at) - radius;
}

const std::map<std::string, double (*)(DVec3)> kFields{
    {"sphere_r1_sdf", [](DVec3 at) { return glm::length(at) - 1; }},
    {"torus_R1_r0.4_sdf",
     [](DVec3 at) { return glm::length(glm::dvec2(glm::length(glm::dvec2(at.x, at.y)) - 1, at.z)) - 0.4; }},
    {"capsule_z-0.8..0.8_r0.3", [](DVec3 at) { return capsule_distance(at, 0.8, 0.3); }},
    {"two_spheres_union", [](DVec3 at) { return glm::length(DVec3(std::abs(at.x) - 0.5, at.y, at.z)) - 0.6; }},
    {"box_half0.7_sdf", [](DVec3 at) { return box_distance(at, 0.7); }},
};

Grid sample(double (*field)(DVec3), std::size_t n) {
  Grid grid{n, std::vector<float>(n * n * n), -1.61, 3.18 / static_cast<double>(n - 1)};
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    const DVec3 at = grid.origin + grid.spacing * DVec3(i % n, i / n % n, i / n / n);
    grid.values[i] = static_cast<float>(field(at));
  }
  return grid;
}

/// Where the values of two neighbours differ in sign, the surface has a vertex.
std::size_t sign_changes(const Grid& grid) {
  std::size_t changes = 0;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    for (const auto& [at, step] : {std::pair(i % grid.n, std::size_t{1}),
                                   {i / grid.n % grid.n, grid.n},
                                   {i / grid.n / grid.n, grid.n * grid.n}}) {
      if (at > 0 && (grid.values[i] < 0) != (grid.values[i - step] < 0)) ++changes;
    }
  }
  return changes;
}

struct KnownSurface {
  const char* field;
  int euler;
  double area, volume;
};

/// Closed forms. The union's parts are spheres of radius 0.6 that lose caps of the height 0.1.
const std::array<KnownSurface, 5> kSurfaces{{
    {"sphere_r1_sdf", 2, 4 * kPi, 4 * kPi / 3},
    {"torus_R1_r0.4_sdf", 0, 4 * kPi* kPi * 0.4, 2 * kPi* kPi * 0.16},
    {"capsule_z-0.8..0.8_r0.3", 2, 2 * kPi * 0.3 * (1.6 + 0.6), kPi * 0.09 * (1.6 + 0.4)},
    {"two_spheres_union", 2, 2 * 2 * kPi * 0.6 * (1.2 - 0.1), 2 * kPi*(4 * 0.216 - 0.01 * (1.8 - 0.1)) / 3},
    {"box_half0.7_sdf", 2, 6 * 1.96, 2.744},
}};

TEST(CellGrid, KnownFieldsHaveAVertexForEachChangeOfSignAndTheirEulerNumber) {
  for (const KnownSurface& known : kSurfaces) {
    for (const std::size_t n : {16, 32}) {
      SCOPED_TRACE(fmt::format("{} at {}", known.field, n));
      const Grid grid = sample(kFields.at(known.field), n);
      const Mesh mesh = Extraction(grid, 1e-6).mesh;
      EXPECT_TRUE(check_mesh(mesh));
      EXPECT_EQ(mesh.vertex_count(), sign_changes(grid));
      EXPECT_EQ(euler_number(mesh), known.euler);
      EXPECT_EQ(mesh.triangle_count() + 2U * static_cast<unsigned>(known.euler), 2 * mesh.vertex_count());
    }
  }
}

/// On a grid that is twice as fine, the errors are less than half.
TEST(CellGrid, AreasAndVolumesOfKnownFieldsConvergeToClosedForms) {
  for (const KnownSurface& known : kSurfaces) {
    SCOPED_TRACE(known.field);
    const auto errors = [&](std::size_t n) {
      const Grid grid = sample(kFields.at(known.field), n);
      const Mesh mesh = Extraction(grid, 1e-6).mesh;
      return std::pair(1 - surface_area(mesh) / known.area, 1 - signed_volume(mesh) / known.volume);
    };
    const auto [area, volume] = errors(32);
    const auto [coarse_area, coarse_volume] = errors(16);
    EXPECT_LT(std::abs(area), 0.05);
    EXPECT_LT(std::abs(volume), 0.04);
    EXPECT_LT(area, 0.5 * coarse_area);
    EXPECT_LT(volume, 0.5 * coarse_volume);
  }
}

/// Compares known fields with the counts, areas and volumes that another program gives. Returns the number of rows.
int compare_known_fields(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    const std::size_t quote = line.find('"');  // the domain has a comma
    if (quote != std::string::npos) line.erase(quote, line.rfind('"') - quote + 1);
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::string name, method;
    std::size_t n = 0, crossings = 0, vertices = 0, triangles = 0;
    long euler = 0, components = 0, boundary = 0, nonmanifold = 0;
    double area = 0, volume = 0;
    fields >> name >> n >> crossings >> method >> vertices >> triangles >> euler >> components >> boundary >>
        nonmanifold >> area >> volume;
    EXPECT_TRUE(fields) << line;
    const Grid grid = sample(kFields.at(name), n);
    const Mesh mesh = Extraction(grid, 1e-6).mesh;
    EXPECT_TRUE(check_mesh(mesh)) << name;
    EXPECT_EQ(mesh.vertex_count(), vertices) << name;
    EXPECT_EQ(mesh.triangle_count(), triangles) << name;
    EXPECT_EQ(euler_number(mesh), euler) << name;
    EXPECT_NEAR(surface_area(mesh), area, 1e-5 * area) << name << " at " << n;
    EXPECT_NEAR(signed_volume(mesh), volume, 1e-5 * volume) << name << " at " << n;
  }
  return rows;
}

TEST(CellGrid, KnownFieldsHaveTheCountsAreasAndVolumesOfAnotherProgram) {
  // The project's own file has single facts: the sphere and the torus, one grid each.
  for (const auto& [file, rows] :
       data_sets<int>({{"tests/data/reference/isosurface_fields.csv", 2}}, {{"reference/isosurface_fields.csv", 20}})) {
    SCOPED_TRACE(file);
    EXPECT_EQ(compare_known_fields(file), rows);
  }
}

}  // namespace meristem::cell_grid_test

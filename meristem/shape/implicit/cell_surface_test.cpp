// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/implicit/cell_surface.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/shape/implicit/cell_geometry.h"
#include "tests/support/test_data.h"

namespace meristem::cell_surface_test {

using Corners = std::array<float, 8>;

/// Finds which of `count` items are connected.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }
  std::size_t of(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parents_;
};

struct Topology {
  int components, euler, boundaries;
  bool operator==(const Topology&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Topology& topology) {
  return out << topology.components << " components, Euler number " << topology.euler << ", " << topology.boundaries
             << " boundaries";
}

/// Counts how often each edge, lower point first, is a triangle's side.
std::map<std::pair<int, int>, int> count_sides(const CellSurface& surface) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& triangle : surface.triangles) {
    for (int k = 0; k < 3; ++k) ++sides[std::minmax<int>(triangle[k], triangle[(k + 1) % 3])];
  }
  return sides;
}

Topology topology_of(const CellSurface& surface) {
  const auto sides = count_sides(surface);
  Groups pieces(64), borders(64);
  std::set<int> points, border_points;
  for (const auto& [side, count] : sides) {
    EXPECT_LE(count, 2);
    points.insert({side.first, side.second});
    pieces.join(side.first, side.second);
    if (count == 2) continue;
    border_points.insert({side.first, side.second});
    borders.join(side.first, side.second);
  }
  std::set<std::size_t> components, boundaries;
  for (const int point : points) components.insert(pieces.of(point));
  for (const int point : border_points) boundaries.insert(borders.of(point));
  return {static_cast<int>(components.size()),
          static_cast<int>(points.size() + surface.triangles.size()) - static_cast<int>(sides.size()),
          static_cast<int>(boundaries.size())};
}

double trilinear(const Corners& values, DVec3 at) {
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const DVec3 weights = glm::mix(1.0 - at, at, corner_place(c));
    sum += values[c] * weights.x * weights.y * weights.z;
  }
  return sum;
}

/// Returns for each corner its connected region of equal signs, from `n` samples per edge.
std::array<std::size_t, 8> sampled_regions(const Corners& values, std::size_t n) {
  const std::size_t row = n + 1, layer = row * row;
  Groups regions(layer * row);
  std::vector<bool> inside(layer * row);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const std::array<std::size_t, 3> at{i % row, i / row % row, i / layer};
    inside[i] = trilinear(values, DVec3(at[0], at[1], at[2]) / static_cast<double>(n)) < 0;
    for (const auto& [coordinate, step] : {std::pair(at[0], std::size_t{1}), {at[1], row}, {at[2], layer}}) {
      if (coordinate > 0 && inside[i] == inside[i - step]) regions.join(i, i - step);
    }
  }
  std::array<std::size_t, 8> result{};
  for (std::size_t c = 0; c < 8; ++c) {
    result[c] = regions.of(n * (c & 1) + n * row * (c >> 1 & 1) + n * layer * (c >> 2 & 1));
  }
  return result;
}

/// Returns true if two crossed edges lie on one piece of the surface exactly if they separate the same two regions.
bool agrees_with_samples(const Corners& values, std::size_t n) {
  const CellSurface& surface = cell_surface(values);
  Groups pieces(64);
  for (const auto& [a, b, c] : surface.triangles) pieces.join(a, b), pieces.join(b, c);
  const std::array<std::size_t, 8> regions = sampled_regions(values, n);

  std::map<std::size_t, std::set<std::pair<std::size_t, std::size_t>>> parted_by;
  std::set<std::pair<std::size_t, std::size_t>> parted;
  for (int edge = 0; edge < kCellEdges; ++edge) {
    auto [in, out] = edge_corners(edge);
    if ((values[in] < 0) == (values[out] < 0)) continue;
    if (values[out] < 0) std::swap(in, out);
    parted_by[pieces.of(edge)].emplace(regions[in], regions[out]);
    parted.emplace(regions[in], regions[out]);
  }
  const bool one_each =
      std::all_of(parted_by.begin(), parted_by.end(), [](const auto& entry) { return entry.second.size() == 1; });
  return one_each && parted.size() == parted_by.size();
}

Corners random_corners(RandomKey key) {
  Corners values{};
  for (std::uint64_t c = 0; c < 8; ++c) values[c] = static_cast<float>(key.uniform(c, -1, 1));
  return values;
}

/// Compares each cell of a table with its known topology. Returns the number of cells.
int compare_known_cells(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  int cells = 0;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::string name;
    std::array<double, 8> values{};
    double level = 0;
    Topology expected{};
    fields >> name;
    for (double& value : values) fields >> value;
    fields >> level >> expected.components >> expected.euler >> expected.boundaries;
    EXPECT_TRUE(fields) << line;
    Corners corners{};
    for (int c = 0; c < 8; ++c) {
      corners[c] = static_cast<float>(values[4 * (c & 1) + 2 * (c >> 1 & 1) + (c >> 2)] - level);
    }
    EXPECT_EQ(topology_of(cell_surface(corners)), expected) << name;
    ++cells;
  }
  return cells;
}

TEST(CellSurface, HasTheTopologyOfTheTrilinearFunctionInKnownAmbiguousCells) {
  for (const auto& [file, cells] :
       data_sets<int>({{"tests/data/reference/ambiguous_cells.csv", 12}}, {{"reference/ambiguous_cases.csv", 15}})) {
    SCOPED_TRACE(file);
    EXPECT_EQ(compare_known_cells(file), cells);
  }
}

TEST(CellSurface, AgreesWithDenseSamplesInAmbiguousCells) {
  int cells = 0, tunnels = 0;
  for (std::uint64_t i = 0; cells < 60; ++i) {
    const Corners values = random_corners(RandomKey(3).child(i));
    if (!is_ambiguous(cell_pattern(values))) continue;
    const Topology topology = topology_of(cell_surface(values));
    const bool has_tunnel = topology.euler != topology.components;
    if (!has_tunnel && i % 16 != 0) continue;  // tunnels are rare
    ++cells;
    if (has_tunnel) ++tunnels;
    // Necks thinner than the first samples need the second, finer samples.
    EXPECT_TRUE(agrees_with_samples(values, 24) || agrees_with_samples(values, 96)) << "cell " << i;
  }
  EXPECT_GT(tunnels, 5);
}

TEST(CellSurface, ForgetsNoTunnelBetweenTwoCorners) {
  // Two opposite corners extend toward each other through the cell.
  const auto between = [](float others) { return Corners{-1, others, others, others, others, others, others, -1}; };
  EXPECT_EQ(topology_of(cell_surface(between(0.3F))), (Topology{1, 0, 2}));
  EXPECT_EQ(topology_of(cell_surface(between(0.4F))), (Topology{2, 2, 2}));
  EXPECT_TRUE(agrees_with_samples(between(0.3F), 48));
  EXPECT_TRUE(agrees_with_samples(between(0.4F), 48));
}

TEST(CellSurface, HasNoDiagonalsOnFaces) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const Corners values = random_corners(RandomKey(4).child(i));
    for (const auto& [side, count] : count_sides(cell_surface(values))) {
      const auto [a, b] = side;
      ASSERT_TRUE(count == 1 || b >= kCellEdges || !share_a_face(1U << a | 1U << b)) << "cell " << i;
    }
  }
}

TEST(CellSurface, HasInnerPointsOnlyWhereSignsDoNotDecide) {
  int ambiguous = 0;
  for (int pattern = 0; pattern < 256; ++pattern) {
    if (is_ambiguous(static_cast<std::uint8_t>(pattern))) {
      ++ambiguous;
    } else {
      EXPECT_TRUE(simple_surface(static_cast<std::uint8_t>(pattern)).inner.empty()) << pattern;
    }
  }
  EXPECT_EQ(ambiguous, 128);
}

TEST(CellSurface, UsesThePointsOnCrossedEdgesAndNoOthers) {
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    const Corners values = random_corners(RandomKey(5).child(i));
    const CellSurface& surface = cell_surface(values);
    unsigned used = 0;
    for (const auto& triangle : surface.triangles) {
      for (const std::uint8_t point : triangle) {
        ASSERT_LT(point, kCellEdges + surface.inner.size());
        if (point < kCellEdges) used |= 1U << point;
      }
    }
    const std::uint16_t crossed = crossed_edges(cell_pattern(values));
    EXPECT_EQ(used, crossed);
    for (const std::uint16_t edges : surface.inner) EXPECT_EQ(edges & ~crossed, 0);
  }
}

TEST(CellSurface, IsMadeOnceHoweverManyThreadsMeetItFirst) {
  constexpr std::size_t kCells = 500;
  const RandomKey key(11);
  std::array<std::array<const CellSurface*, kCells>, 4> found{};
  std::vector<std::thread> threads;
  for (auto& surfaces : found) {
    threads.emplace_back([&] {
      for (std::size_t cell = 0; cell < kCells; ++cell) {
        Corners values;
        for (std::size_t c = 0; c < values.size(); ++c) {
          values[c] = static_cast<float>(key.uniform(values.size() * cell + c, -1, 1));
        }
        surfaces[cell] = &cell_surface(values);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& surfaces : found) EXPECT_EQ(surfaces, found[0]);
}

TEST(CellSurface, TakesInfiniteValuesForTheLargest) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity(), kMax = std::numeric_limits<float>::max();
  const Corners infinite{-kInfinity, kInfinity, 0, -1, kInfinity, -kInfinity, -kInfinity, 2};
  const Corners largest{-kMax, kMax, 0, -1, kMax, -kMax, -kMax, 2};
  EXPECT_EQ(&cell_surface(infinite), &cell_surface(largest));
}

}  // namespace meristem::cell_surface_test

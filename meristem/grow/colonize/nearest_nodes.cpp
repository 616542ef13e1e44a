// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/nearest_nodes.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr std::size_t kPointsPerCheck = 1 << 16;  // between two looks at the cancel flag
constexpr std::size_t kNodesToShare = 64;         // fewer new nodes are not worth a second thread
constexpr std::size_t kBlocks = 16;               // of layers, for more

// The square of the influence distance itself still counts as within.
float just_above(float square) { return std::nextafter(square, std::numeric_limits<float>::infinity()); }

}  // namespace

NearestNodes::NearestNodes(const std::vector<Vec3>& points, float influence, Progress& progress)
    : grid_(points), influence_(influence), living_(points.size()) {
  sort_into_cells(points, progress);
  const float none2 = just_above(influence * influence);
  distance2_.assign(points.size(), none2);
  node_.assign(points.size(), kNoNode);
  farthest2_.assign(grid_.cell_count(), none2);
  is_reached_.assign(grid_.cell_count(), 0);
  reached_.resize(static_cast<std::size_t>(grid_.size()[2]));
}

void NearestNodes::sort_into_cells(const std::vector<Vec3>& points, Progress& progress) {
  std::vector<Cell> cell(points.size());
  end_.assign(grid_.cell_count(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k % kPointsPerCheck == 0) progress.check();
    cell[k] = grid_.cell_of(points[k]);
    ++end_[cell[k]];
  }
  begin_.resize(grid_.cell_count());
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < begin_.size(); ++k) {
    begin_[k] = sum;
    sum += end_[k];
    end_[k] = begin_[k];
  }
  x_.resize(points.size());
  y_.resize(points.size());
  z_.resize(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k % kPointsPerCheck == 0) progress.check();
    const std::uint32_t place = end_[cell[k]]++;
    x_[place] = points[k].x;
    y_[place] = points[k].y;
    z_[place] = points[k].z;
  }
}

std::size_t NearestNodes::add_nodes(NodeIndex first, std::span<const Vec3> positions, Progress& progress) {
  if (living_ == 0) return 0;
  // Blocks of layers are disjoint, so each may be written by a thread of its own.
  const std::size_t layers = reached_.size();
  const std::size_t blocks = positions.size() < kNodesToShare ? 1 : kBlocks;
  std::atomic<std::size_t> taken{0};
  parallel_for(layers, (layers + blocks - 1) / blocks, [&](std::size_t begin, std::size_t end) {
    progress.check();
    taken += visit_layers(static_cast<int>(begin), static_cast<int>(end) - 1, first, positions);
  });
  return taken;
}

std::size_t NearestNodes::visit_layers(int low, int high, NodeIndex first, std::span<const Vec3> positions) {
  std::size_t taken = 0;
  std::vector<float> gaps_x2(static_cast<std::size_t>(grid_.size()[0]));
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const PointGrid::Range range = grid_.cells_near(positions[k], influence_);
    for (int x = range.low[0]; x <= range.high[0]; ++x) {
      const float gap = grid_.gap(0, x, positions[k].x);
      gaps_x2[static_cast<std::size_t>(x)] = gap * gap;
    }
    for (int z = std::max(low, range.low[2]); z <= std::min(high, range.high[2]); ++z) {
      taken += visit_cells(z, range, first + static_cast<NodeIndex>(k), positions[k], gaps_x2);
    }
  }
  return taken;
}

std::size_t NearestNodes::visit_cells(int z, const PointGrid::Range& range, NodeIndex node, Vec3 position,
                                      std::span<float> gaps_x2) {
  std::size_t taken = 0;
  const float gap_z = grid_.gap(2, z, position.z);
  for (int y = range.low[1]; y <= range.high[1]; ++y) {
    const float gap_y = grid_.gap(1, y, position.y);
    const float gap_yz2 = gap_y * gap_y + gap_z * gap_z;
    const Cell row = grid_.cell_at(0, y, z);
    for (int x = range.low[0]; x <= range.high[0]; ++x) {
      // Pass by cells all of whose points have a node at least as near.
      const Cell cell = row + static_cast<Cell>(x);
      if (gaps_x2[static_cast<std::size_t>(x)] + gap_yz2 >= farthest2_[cell]) continue;
      const std::size_t here = compare(cell, node, position);
      taken += here;
      if (here == 0 || is_reached_[cell]) continue;
      is_reached_[cell] = 1;
      reached_[static_cast<std::size_t>(z)].push_back(cell);
    }
  }
  return taken;
}

std::size_t NearestNodes::compare(Cell cell, NodeIndex node, Vec3 position) {
  const float* x = x_.data() + begin_[cell];
  const float* y = y_.data() + begin_[cell];
  const float* z = z_.data() + begin_[cell];
  float* distance2 = distance2_.data() + begin_[cell];
  NodeIndex* nearest = node_.data() + begin_[cell];
  const auto count = static_cast<std::int32_t>(end_[cell] - begin_[cell]);
  // Selections instead of branches, and the maximum over the bits of floats (which order like the floats, as none is
  // negative): so compilers take four points at a time, which saves a quarter of all growth.
  std::int32_t taken = 0;
  std::int32_t farthest2 = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    const float dx = x[k] - position.x;
    const float dy = y[k] - position.y;
    const float dz = z[k] - position.z;
    const float square = dx * dx + dy * dy + dz * dz;
    const float before = distance2[k];
    const float kept = square < before ? square : before;
    nearest[k] = square < before ? node : nearest[k];
    taken += square < before ? 1 : 0;
    distance2[k] = kept;
    const auto bits = std::bit_cast<std::int32_t>(kept);
    farthest2 = bits > farthest2 ? bits : farthest2;
  }
  farthest2_[cell] = std::bit_cast<float>(farthest2);
  return static_cast<std::size_t>(taken);
}

std::size_t NearestNodes::remove_within(float distance) {
  const float limit = distance * distance;
  const std::size_t before = living_;
  for (std::vector<Cell>& layer : reached_) {
    for (const Cell cell : layer) {
      for (std::uint32_t k = begin_[cell]; k < end_[cell];) {
        if (node_[k] != kNoNode && distance2_[k] <= limit) {
          remove(cell, k);
        } else {
          ++k;
        }
      }
    }
    std::erase_if(layer, [this](Cell cell) { return begin_[cell] == end_[cell]; });
  }
  return before - living_;
}

void NearestNodes::remove(Cell cell, std::uint32_t point) {
  const std::uint32_t last = --end_[cell];
  x_[point] = x_[last];
  y_[point] = y_[last];
  z_[point] = z_[last];
  distance2_[point] = distance2_[last];
  node_[point] = node_[last];
  if (begin_[cell] == last) farthest2_[cell] = 0;
  --living_;
}

}  // namespace meristem

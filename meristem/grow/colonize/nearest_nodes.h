// SPDX-License-Identifier: Apache-2.0
// The living attraction points and, for each, the nearest node within the influence distance.
//
// Nodes never move and never go, so a new node can only take points over, and only from nodes that are farther away: a
// point's nearest node is kept, and compared with new nodes alone. Points lie sorted by grid cell, and a cell knows how
// far its points are from their nodes at most, so cells that are already well served are passed by. Removed points
// leave the array's cells at once. Costs per new node: the points it comes nearer to, and a few cells around.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/colonize/point_grid.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

class NearestNodes {
 public:
  /// `influence` in metres, above 0, may be infinite. Throws std::invalid_argument for points that are not finite.
  NearestNodes(const std::vector<Vec3>& points, float influence, Progress& progress);

  /// Compares all living points with the nodes `first`, `first` + 1, ... at `positions`. Of nodes at the same distance
  /// the one with the lower index stays. Returns how many times a point got a nearer node.
  std::size_t add_nodes(NodeIndex first, std::span<const Vec3> positions, Progress& progress);

  /// Removes the points whose nearest node is within `distance` metres, and returns how many.
  std::size_t remove_within(float distance);

  std::size_t living() const { return living_; }

  /// Calls `visit(position, node)` for every living point that has a node within the influence distance. The order is
  /// that of the cells and means nothing.
  template <class Visit>
  void for_each_influenced(Visit visit) const {
    for (const std::vector<Cell>& layer : reached_) {
      for (const Cell cell : layer) {
        for (std::uint32_t k = begin_[cell]; k < end_[cell]; ++k) {
          if (node_[k] != kNoNode) visit(Vec3(x_[k], y_[k], z_[k]), node_[k]);
        }
      }
    }
  }

 private:
  using Cell = PointGrid::Cell;

  void sort_into_cells(const std::vector<Vec3>& points, Progress& progress);
  std::size_t visit_layers(int low, int high, NodeIndex first, std::span<const Vec3> positions);
  std::size_t visit_cells(int z, const PointGrid::Range& range, NodeIndex node, Vec3 position,
                          std::span<float> gaps_x2);
  std::size_t compare(Cell cell, NodeIndex node, Vec3 position);
  void remove(Cell cell, std::uint32_t point);

  PointGrid grid_;
  float influence_;
  std::size_t living_;

  // By point, sorted by cell.
  std::vector<float> x_, y_, z_;
  std::vector<float> distance2_;  // squared, to the nearest node; just above the influence distance where there is none
  std::vector<NodeIndex> node_;

  // By cell: its living points are [begin, end).
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> end_;
  std::vector<float> farthest2_;            // no living point in the cell has a larger distance2
  std::vector<std::uint8_t> is_reached_;    // whether a node has influenced a point in it
  std::vector<std::vector<Cell>> reached_;  // those cells, for each layer along z
};

}  // namespace meristem

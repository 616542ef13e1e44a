// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meristem/grow/organize/species.h"
#include "meristem/grow/prune/layers.h"
#include "meristem/grow/prune/leads.h"

namespace meristem {

/// The lines that the shoots of a tree are tied to, numbered from 1, and the buds that will be tied.
class TreeTies {
 public:
  /// Makes the lines of a tree with this root. Throws InputError for a support that the scene does not have.
  TreeTies(const OrganizedSpecies& species, Vec3 root);

  void forget_buds() { arms_.clear(); }
  /// Adds buds that grow along wires; `first` is the number of the first wire.
  void add_arms(const std::vector<ArmBud>& arms, std::uint32_t first);

  /// Returns the first line of an operation, given by its index in the list; 0 if it has no line.
  std::uint32_t line_of(std::size_t operation) const { return first_of_[operation]; }
  /// Returns the line of the shoot that a bud grows; 0 if it is not tied. A shoot that succeeds a tied shoot is also
  /// tied.
  std::uint32_t of_bud(const Metamers& metamers, const TreeLeads& leads, MetamerIndex from, bool is_lateral) const;

  double weight(std::uint32_t tie) const { return lines_[tie - 1].weight; }
  /// Returns the unit growth direction along a line, and back to the line, for a shoot that ends at `tip`.
  Vec3 way(std::uint32_t tie, Vec3 tip) const;

 private:
  struct Line {
    std::vector<Vec3> points;
    double weight = 0;
  };
  float ahead_;
  std::vector<Line> lines_;
  std::vector<std::uint32_t> first_of_;
  std::vector<std::pair<MetamerIndex, std::uint32_t>> arms_;  // sorted by metamer
};

}  // namespace meristem

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

/// The lines that the shoots of a tree are tied to, numbered from 1, and the buds that will be.
class TreeTies {
 public:
  /// The lines of a tree with this root. Throws InputError for a support that the scene does not have.
  TreeTies(const OrganizedSpecies& species, Vec3 root);

  void forget_buds() { arms_.clear(); }
  /// Buds that grow along wires; `first` is the number of the first wire.
  void add_arms(const std::vector<ArmBud>& arms, std::uint32_t first);

  /// The first line of an operation by its place in the list; 0 where it has none.
  std::uint32_t line_of(std::size_t operation) const { return first_of_[operation]; }
  /// What the shoot that a bud grows is tied to; 0: nothing. What leads a shoot on is tied as that shoot is.
  std::uint32_t of_bud(const Metamers& metamers, const Leads& leads, MetamerIndex from, bool is_lateral) const;

  double weight(std::uint32_t tie) const { return lines_[tie - 1].weight; }
  /// The unit vector along a line, and back to it, for a shoot that ends at `tip`.
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

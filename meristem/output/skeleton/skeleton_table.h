// SPDX-License-Identifier: Apache-2.0
// The skeletons of a plant as one table with a row per node. All exports of skeletons show these columns under these
// names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// One node of one stem.
struct SkeletonRow {
  std::size_t row = 0;   ///< number of the row in the table, from 0
  std::size_t stem = 0;  ///< index into Plant::stems
  NodeIndex node = 0;    ///< index into the stem's skeleton
};

/// A column of the table.
struct SkeletonColumn {
  /// The meaning of a column's numbers.
  enum class Kind {
    component,  ///< a whole number that indexes SkeletonTable::components()
    label,      ///< a whole number that indexes SkeletonTable::labels()
    index,      ///< a whole number; kNoRow for a missing row
    number,     ///< a float; NaN if unknown
  };
  std::string name;          ///< name in the head of a table
  Kind kind = Kind::number;  ///< meaning of the numbers
};

/// A view of all stems in the plant's order. The columns, in this order:
///
/// | column | meaning |
/// | --- | --- |
/// | `component`, `instance` | component of the stem, and number of the instance |
/// | `node`, `parent` | number of the row, and number of the parent's row |
/// | `x`, `y`, `z`, `radius` | metres |
/// | `axis` | number of the axis, unique over all stems |
/// | `order`, `birth` | branching order, growth step |
/// | others | columns of `extra` in any skeleton, by name |
/// | `label` | label of the axis (axis_labels), if some skeleton numbers its metamers |
class SkeletonTable {
 public:
  static constexpr double kNoRow = -1;  ///< marks a missing row

  /// `plant` must outlive the table.
  explicit SkeletonTable(const Plant& plant);

  std::size_t row_count() const { return first_row_.back(); }              ///< number of nodes of all stems
  const std::vector<SkeletonColumn>& columns() const { return columns_; }  ///< columns in the order above
  /// Returns the ids of components with stems, in the plant's order.
  const std::vector<std::string>& components() const { return components_; }

  /// Returns the label of each axis. Empty if there is no column of labels.
  const std::vector<std::string>& labels() const { return labels_; }

  /// Returns the node of a row.
  SkeletonRow row(std::size_t number) const;
  /// Calls `body(row)` for each row from number `begin` to `end`.
  template <class Body>
  void for_each_row(std::size_t begin, std::size_t end, Body body) const {
    if (begin >= end) return;
    SkeletonRow row = this->row(begin);
    for (; row.stem + 1 < first_row_.size() && row.row < end; ++row.stem, row.node = 0) {
      for (; row.row < std::min(end, first_row_[row.stem + 1]); ++row.row, ++row.node) body(row);
    }
  }
  /// Returns the number of the parent's row, or kNoRow.
  double parent(const SkeletonRow& row) const;
  /// Returns the value of a column, an index into columns(). Exact, since a double represents every float and every
  /// index.
  double value(const SkeletonRow& row, std::size_t column) const;

 private:
  const Plant& plant_;
  std::vector<SkeletonColumn> columns_;
  std::vector<std::string> components_;
  std::vector<std::string> labels_;
  std::vector<std::vector<std::size_t>> component_;  // for each stem's parts, indices into components_
  std::vector<std::size_t> first_row_;               // first row of each stem, and last the number of rows
  std::vector<std::size_t> first_axis_;              // first axis of each stem
  std::vector<std::vector<const std::vector<float>*>>
      extra_;  // values of each stem for each further column; may be null
};

}  // namespace meristem

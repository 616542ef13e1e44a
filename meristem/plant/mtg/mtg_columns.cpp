// SPDX-License-Identifier: Apache-2.0
// Reads columns other than positions from an MTG's features, and restores the order of nodes that the writer stored.
#include "meristem/plant/mtg/mtg_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "meristem/plant/axis_labels.h"
#include "meristem/plant/mtg/mtg_text.h"

namespace meristem {
namespace {

constexpr std::array<std::string_view, 15> kTakenNames{"XX",     "YY",       "ZZ",     "TopDia",    "node",
                                                       "parent", "position", "radius", "axis",      "order",
                                                       "birth",  "Alias",    "label",  "component", "instance"};
constexpr std::array<std::string_view, 7> kNoNames{
    "NAME", "CODE", "CODE:", "CLASSES:", "DESCRIPTION:", "FEATURES:", "MTG:"};
constexpr std::uint64_t kMaxColumns = 16;
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr double kMaxWhole = 9'007'199'254'740'992;  // the largest n up to which doubles represent every whole number
constexpr std::int32_t kMaxMetamers = 16'777'216;    // the largest n up to which floats do

bool is_whole(double number, double max) { return number >= 0 && number <= max && std::floor(number) == number; }

class ColumnReader {
 public:
  ColumnReader(const MtgTree& tree, std::span<const NodeIndex> node_of, std::span<const std::string> geometry,
               MtgSkeleton& made)
      : tree_(tree), node_of_(node_of), geometry_(geometry), made_(made), skeleton_(made.skeleton) {}

  void read(const std::string& file, const SizeLimits& limits) {
    find_columns();
    check_count(file, limits);
    read_columns();
    const auto order = numbered_order();
    if (!order && !skeleton_.extra.contains(kMetamerColumn)) read_metamers();
    if (!order) return;
    if (!std::is_sorted(order->begin(), order->end())) reorder(*order);
    read_axes();
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  /// Finds the numeric features that at least one node has.
  void find_columns() {
    std::vector<bool> is_present(tree_.features.size(), false);
    for (const MtgValues::Row& row : tree_.values.rows) {
      bool has_node = false;
      for (MtgVertex vertex = row.first; vertex <= row.last; ++vertex) has_node |= node_of_[vertex] != kNoNode;
      for (std::size_t k = row.begin; has_node && k < row.end; ++k) is_present[tree_.values.cells[k].feature] = true;
    }
    column_of_.assign(tree_.features.size(), kNone);
    for (std::size_t k = 0; k < tree_.features.size(); ++k) {
      const MtgFeature& feature = tree_.features[k];
      const bool is_place = std::find(geometry_.begin(), geometry_.end(), feature.name) != geometry_.end();
      if (!is_present[k] || !feature.is_number || is_place) continue;
      if (feature.name != "birth" && !is_mtg_column_name(feature.name)) continue;
      column_of_[k] = names_.size();
      names_.push_back(feature.name);
    }
  }

  void check_count(const std::string& file, const SizeLimits& limits) const {
    const double wanted = static_cast<double>(names_.size()) * static_cast<double>(skeleton_.node_count());
    const std::uint64_t max = kMaxColumns * limits.nodes;
    if (wanted <= static_cast<double>(max)) return;
    Diagnostic error = limit_diagnostic("numbers of nodes", wanted, max, "nodes * 16", "");
    error.file = file;
    throw InputError(std::move(error));
  }

  void read_columns() {
    std::vector<std::vector<float>> columns(names_.size(), std::vector<float>(skeleton_.node_count(), kNoNumber));
    for (const MtgValues::Row& row : tree_.values.rows) {
      for (std::size_t k = row.begin; k < row.end; ++k) {
        const MtgValues::Cell& cell = tree_.values.cells[k];
        const std::size_t column = column_of_[cell.feature];
        if (column == kNone) continue;
        const std::string_view text = std::string_view(tree_.values.text).substr(cell.begin, cell.size);
        const float value = to_float(text).value_or(kNoNumber);
        for (MtgVertex vertex = row.first; vertex <= row.last; ++vertex) {
          if (node_of_[vertex] != kNoNode) columns[column][node_of_[vertex]] = value;
        }
      }
    }
    for (std::size_t k = 0; k < names_.size(); ++k) {
      if (names_[k] == "birth") {
        set_birth(columns[k]);
      } else {
        skeleton_.extra.emplace(names_[k], std::move(columns[k]));
      }
    }
  }

  /// Sets the births. A node without a birth has its parent's.
  void set_birth(const std::vector<float>& birth) {
    for (NodeIndex node = 0; node < skeleton_.node_count(); ++node) {
      if (!std::isnan(birth[node])) {
        skeleton_.birth[node] = birth[node];
      } else if (!skeleton_.is_root(node)) {
        skeleton_.birth[node] = skeleton_.birth[skeleton_.parent[node]];
      }
    }
  }

  /// Sets the metamer numbers to the entities' own numbers if these count every axis from 1. A root that is not an
  /// entity has 0.
  void read_metamers() {
    int finest = 0;
    for (const MtgVertex vertex : made_.vertex) finest = std::max(finest, tree_.scale(vertex));
    std::vector<float> metamer(skeleton_.node_count(), 0);
    for (NodeIndex node = 0; node < skeleton_.node_count(); ++node) {
      const MtgVertex vertex = made_.vertex[node];
      if (tree_.scale(vertex) != finest) continue;
      const NodeIndex parent = skeleton_.parent[node];
      const bool goes_on = parent != kNoNode && skeleton_.axis[parent] == skeleton_.axis[node];
      const std::int32_t index = tree_.index[vertex];
      if (index > kMaxMetamers || static_cast<float>(index) != (goes_on ? metamer[parent] : 0) + 1) return;
      metamer[node] = static_cast<float>(index);
    }
    if (!metamer.empty()) skeleton_.extra.emplace(kMetamerColumn, std::move(metamer));
  }

  /// Returns a feature's number for each node. Empty if there is no such feature.
  std::vector<double> node_numbers(std::string_view name) const {
    const auto feature = tree_.find_feature(name);
    if (!feature) return {};
    const std::vector<double> of_vertex = tree_.numbers(*feature);
    std::vector<double> numbers;
    numbers.reserve(made_.vertex.size());
    for (const MtgVertex vertex : made_.vertex) numbers.push_back(of_vertex[vertex]);
    return numbers;
  }

  /// Returns the order of nodes by the feature `node`, if it numbers all nodes uniquely and parents before children.
  std::optional<std::vector<NodeIndex>> numbered_order() const {
    const std::vector<double> number = node_numbers("node");
    if (number.empty()) return {};
    for (NodeIndex node = 0; node < skeleton_.node_count(); ++node) {
      if (!is_whole(number[node], kMaxWhole)) return {};
      if (!skeleton_.is_root(node) && number[skeleton_.parent[node]] >= number[node]) return {};
    }
    std::vector<NodeIndex> order(skeleton_.node_count());
    std::iota(order.begin(), order.end(), 0U);
    const auto comes_before = [&](NodeIndex a, NodeIndex b) { return number[a] < number[b]; };
    if (!std::is_sorted(order.begin(), order.end(), comes_before)) std::sort(order.begin(), order.end(), comes_before);
    const auto are_equal = [&](NodeIndex a, NodeIndex b) { return number[a] == number[b]; };
    if (std::adjacent_find(order.begin(), order.end(), are_equal) != order.end()) return {};
    return order;
  }

  void reorder(const std::vector<NodeIndex>& order) {
    const auto reordered = [&order](const auto& column) {
      auto result = column;
      for (std::size_t k = 0; k < order.size(); ++k) result[k] = column[order[k]];
      return result;
    };
    std::vector<NodeIndex> place(order.size());
    for (NodeIndex k = 0; k < order.size(); ++k) place[order[k]] = k;
    skeleton_.parent = reordered(skeleton_.parent);
    for (NodeIndex& parent : skeleton_.parent) parent = parent == kNoNode ? kNoNode : place[parent];
    skeleton_.position = reordered(skeleton_.position);
    skeleton_.radius = reordered(skeleton_.radius);
    skeleton_.axis = reordered(skeleton_.axis);
    skeleton_.order = reordered(skeleton_.order);
    skeleton_.birth = reordered(skeleton_.birth);
    for (auto& [name, values] : skeleton_.extra) values = reordered(values);
    made_.vertex = reordered(made_.vertex);
    // Axes must be numbered in the order of their first nodes.
    std::vector<AxisIndex> renumbered(order.size(), kNoAxis);
    AxisIndex axes = 0;
    for (AxisIndex& axis : skeleton_.axis) {
      if (renumbered[axis] == kNoAxis) renumbered[axis] = axes++;
      axis = renumbered[axis];
    }
  }

  /// Reads axes and orders from their own features. They are written if they do not follow from the joints of entities.
  void read_axes() {
    const std::vector<double> axis = node_numbers("axis");
    const std::vector<double> order = node_numbers("order");
    if (axis.empty() || order.empty()) return;
    AxisIndex axes = 0;
    for (std::size_t node = 0; node < axis.size(); ++node) {
      if (!is_whole(axis[node], axes) || !is_whole(order[node], std::numeric_limits<std::uint16_t>::max())) return;
      if (axis[node] == axes) ++axes;
    }
    for (std::size_t node = 0; node < axis.size(); ++node) {
      skeleton_.axis[node] = static_cast<AxisIndex>(axis[node]);
      skeleton_.order[node] = static_cast<std::uint16_t>(order[node]);
    }
  }

  const MtgTree& tree_;
  std::span<const NodeIndex> node_of_;
  std::span<const std::string> geometry_;
  MtgSkeleton& made_;
  Skeleton& skeleton_;
  std::vector<std::string> names_;      // of the columns that are read
  std::vector<std::size_t> column_of_;  // index into names_ for each feature, or kNone
};

}  // namespace

bool is_mtg_column_name(std::string_view name) {
  const auto is_in = [name](const auto& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  const auto ends_word = [](char c) { return (c >= 0 && c <= ' ') || c == '\x7f' || is_mtg_sign(c); };
  return !name.empty() && std::none_of(name.begin(), name.end(), ends_word) && !is_in(kTakenNames) && !is_in(kNoNames);
}

void read_mtg_columns(const MtgTree& tree, const std::string& file, std::span<const NodeIndex> node_of,
                      std::span<const std::string> geometry, const SizeLimits& limits, MtgSkeleton& made) {
  ColumnReader(tree, node_of, geometry, made).read(file, limits);
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Numbers rows and axes over all stems of a plant and finds the columns, without copying values.
#include "meristem/output/skeleton/skeleton_table.h"

#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "meristem/plant/axis_labels.h"

namespace meristem {

namespace {

using Kind = SkeletonColumn::Kind;

enum Column : std::size_t { component, instance, node, parent, x, y, z, radius, axis, order, birth, first_extra };

constexpr std::array<std::pair<const char*, Kind>, first_extra> kColumns{{{"component", Kind::component},
                                                                          {"instance", Kind::index},
                                                                          {"node", Kind::index},
                                                                          {"parent", Kind::index},
                                                                          {"x", Kind::number},
                                                                          {"y", Kind::number},
                                                                          {"z", Kind::number},
                                                                          {"radius", Kind::number},
                                                                          {"axis", Kind::index},
                                                                          {"order", Kind::index},
                                                                          {"birth", Kind::number}}};

}  // namespace

SkeletonTable::SkeletonTable(const Plant& plant) : plant_(plant) {
  for (const auto& [name, kind] : kColumns) columns_.push_back({name, kind});
  std::set<std::string> names;
  for (const Stem& stem : plant.stems) {
    for (const auto& [name, values] : stem.skeleton.extra) names.insert(name);
  }
  for (const std::string& name : names) columns_.push_back({name, Kind::number});
  const bool has_labels = names.contains(std::string(kMetamerColumn));
  if (has_labels) columns_.push_back({"label", Kind::label});

  std::map<std::string_view, std::size_t> component_indices;
  first_row_.push_back(0);
  std::size_t axes = 0;
  for (const Stem& stem : plant.stems) {
    std::vector<std::size_t>& component = component_.emplace_back();
    for (const StemPart& part : stem.parts) {
      const auto [found, is_new] = component_indices.try_emplace(part.component, components_.size());
      if (is_new) components_.push_back(part.component);
      component.push_back(found->second);
    }
    first_row_.push_back(first_row_.back() + stem.skeleton.node_count());
    first_axis_.push_back(axes);
    axes += stem.skeleton.axis_count();
    if (has_labels) {
      std::vector<std::string> labels = axis_labels(stem.skeleton);
      std::move(labels.begin(), labels.end(), std::back_inserter(labels_));
    }
    std::vector<const std::vector<float>*>& extra = extra_.emplace_back();
    for (const std::string& name : names) {
      const auto column = stem.skeleton.extra.find(name);
      extra.push_back(column == stem.skeleton.extra.end() ? nullptr : &column->second);
    }
  }
}

SkeletonRow SkeletonTable::row(std::size_t number) const {
  const auto after = std::upper_bound(first_row_.begin(), first_row_.end(), number);
  const auto stem = static_cast<std::size_t>(after - first_row_.begin()) - 1;
  return {number, stem, static_cast<NodeIndex>(number - first_row_[stem])};
}

double SkeletonTable::parent(const SkeletonRow& row) const {
  const Skeleton& skeleton = plant_.stems[row.stem].skeleton;
  if (skeleton.is_root(row.node)) return kNoRow;
  return static_cast<double>(first_row_[row.stem] + skeleton.parent[row.node]);
}

double SkeletonTable::value(const SkeletonRow& row, std::size_t column) const {
  const Stem& stem = plant_.stems[row.stem];
  const Skeleton& skeleton = stem.skeleton;
  switch (column) {
    case Column::component:
      return static_cast<double>(component_[row.stem][stem.part_index(skeleton.axis[row.node])]);
    case Column::instance:
      return stem.part(skeleton.axis[row.node]).instance;
    case Column::node:
      return static_cast<double>(row.row);
    case Column::parent:
      return this->parent(row);
    case Column::x:
      return skeleton.position[row.node].x;
    case Column::y:
      return skeleton.position[row.node].y;
    case Column::z:
      return skeleton.position[row.node].z;
    case Column::radius:
      return skeleton.radius[row.node];
    case Column::axis:
      return static_cast<double>(first_axis_[row.stem] + skeleton.axis[row.node]);
    case Column::order:
      return skeleton.order[row.node];
    case Column::birth:
      return skeleton.birth[row.node];
    default:
      break;
  }
  if (columns_[column].kind == Kind::label) return value(row, Column::axis);
  const std::vector<float>* const values = extra_[row.stem][column - Column::first_extra];
  return values == nullptr ? std::numeric_limits<double>::quiet_NaN() : (*values)[row.node];
}

}  // namespace meristem

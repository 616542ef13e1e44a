// SPDX-License-Identifier: Apache-2.0
// Finds the positions on a trimmed stem that correspond to positions on the whole stem. On a cut stem a position keeps
// its node if that is left. On a stem that fits, a position keeps its share of the axis.
#include "meristem/graph/trimmed_stem.h"

#include <algorithm>
#include <utility>

#include "meristem/graph/thickness_left.h"

namespace meristem {

namespace {

Vec3 position_at(const Skeleton& skeleton, StemPosition at) {
  if (skeleton.is_root(at.node)) return skeleton.position[at.node];
  return glm::mix(skeleton.position[skeleton.parent[at.node]], skeleton.position[at.node], at.along);
}

Vec3 heading_at(const Skeleton& skeleton, StemPosition at) {
  if (skeleton.is_root(at.node)) return kUp;
  return normalized_or(skeleton.position[at.node] - skeleton.position[skeleton.parent[at.node]], kUp);
}

/// Returns the radius at a position. A lateral begins with the radius of its first node.
float radius_at_position(const Skeleton& skeleton, StemPosition at) {
  const NodeIndex parent = skeleton.parent[at.node];
  if (parent == kNoNode || skeleton.axis[parent] != skeleton.axis[at.node]) return skeleton.radius[at.node];
  return glm::mix(skeleton.radius[parent], skeleton.radius[at.node], at.along);
}

}  // namespace

float GrowingStem::share_unfolded(NodeIndex node, double birth) const {
  const double now = step_of_node.empty() ? step : std::min<double>(step, step_of_node[node]);
  const double u = unfold > 0 ? std::clamp((now - birth) / unfold, 0.0, 1.0) : 1;
  return static_cast<float>(u * u * (3 - 2 * u));
}

TrimmedStem::TrimmedStem(Skeleton whole, TrimmedSkeleton trimmed, TrimMode mode)
    : whole_(std::move(whole)), trimmed_(std::move(trimmed)), mode_(mode) {
  if (mode_ != TrimMode::fit) return;
  whole_arc_ = arcs_along_axes(whole_);
  left_arc_ = arcs_along_axes(left());
  left_axes_.emplace(left());
  for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
    const AxisIndex axis = whole_.axis[node];
    if (axis >= whole_length_.size()) {
      whole_length_.resize(axis + 1, 0);
      left_axis_.resize(axis + 1, kNoAxis);
    }
    whole_length_[axis] = std::max(whole_length_[axis], whole_arc_[node]);
    if (trimmed_.kept[node] > 0) left_axis_[axis] = left().axis[trimmed_.node[node]];
  }
}

std::optional<StemPosition> TrimmedStem::left_of(StemPosition position) const {
  const float kept = trimmed_.kept[position.node];
  const bool stays = whole_.is_root(position.node) ? kept > 0 : position.along <= kept && kept > 0;
  if (mode_ == TrimMode::fit && !whole_.is_root(position.node)) return share_left_of(position);
  if (!stays) return std::nullopt;
  return StemPosition{trimmed_.node[position.node], position.along / kept};
}

std::vector<AxisIndex> TrimmedStem::whole_axes() const {
  std::vector<AxisIndex> axes;
  std::vector<bool> is_known;
  for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
    if (!(trimmed_.kept[node] > 0)) continue;
    const AxisIndex axis = left().axis[trimmed_.node[node]];
    if (axis >= axes.size()) {
      axes.resize(axis + 1, 0);
      is_known.resize(axis + 1, false);
    }
    if (!is_known[axis]) axes[axis] = whole_.axis[node];
    is_known[axis] = true;
  }
  return axes;
}

/// Returns the position at the same share of the remaining axis.
std::optional<StemPosition> TrimmedStem::share_left_of(StemPosition position) const {
  const AxisIndex whole_axis = whole_.axis[position.node];
  const AxisIndex axis = left_axis_[whole_axis];
  if (axis == kNoAxis) return std::nullopt;
  const std::span<const NodeIndex> nodes = left_axes_->of(axis);
  const NodeIndex parent = whole_.parent[position.node];
  const float begin = whole_.axis[parent] == whole_axis ? whole_arc_[parent] : 0;
  const float at = glm::mix(begin, whole_arc_[position.node], position.along);
  const float share = whole_length_[whole_axis] > 0 ? at / whole_length_[whole_axis] : 0;
  const float target = share * left_arc_[nodes.back()];
  const auto found = std::ranges::lower_bound(nodes, target, {}, [&](NodeIndex node) { return left_arc_[node]; });
  std::size_t k = std::min(static_cast<std::size_t>(found - nodes.begin()), nodes.size() - 1);
  if (left().is_root(nodes[k]) && k + 1 < nodes.size()) ++k;  // positions lie on segments, and a root ends none
  const float low = k > 0 ? left_arc_[nodes[k - 1]] : 0;
  const float high = left_arc_[nodes[k]];
  return StemPosition{nodes[k], high > low ? std::clamp((target - low) / (high - low), 0.0F, 1.0F) : 1};
}

Frame TrimmedStem::moved(const Frame& frame, StemPosition from, StemPosition to) const {
  if (mode_ == TrimMode::cut) return frame;
  const Mat3 turn = rotation_between(heading_at(whole_, from), heading_at(left(), to));
  const Vec3 off = thickness_left(*this, from, to) * (frame.origin - position_at(whole_, from));
  return {turn * frame.axes, position_at(left(), to) + turn * off};
}

float thickness_left(const TrimmedStem& stem, StemPosition from, StemPosition to) {
  if (stem.mode() == TrimMode::cut) return 1;
  const float before = radius_at_position(stem.whole(), from);
  return before > 0 ? radius_at_position(stem.left(), to) / before : 1;
}

void TrimmedStem::settle(const GrowingStem& growing, StemPosition from, StemPosition to, Site& site) const {
  const float last = radius_at_position(whole_, from);
  const float thinner = last > 0 ? radius_at_position(left(), to) / last : 1;
  const Vec3 foot = position_at(whole_, from);
  site.frame.origin = foot + thinner * (site.frame.origin - foot);
  site.radius *= thinner;
  site.birth = growing.spans.at(from.node, from.along);
  site.appeared = site.birth / growing.steps_per_second;
  site.frame.axes *= growing.share_unfolded(from.node, site.birth);
}

std::uint64_t TrimmedStem::bytes() const {
  const std::uint64_t of_nodes = 64 * (whole_.node_count() + left().node_count());
  return of_nodes + sizeof(*this);
}

}  // namespace meristem

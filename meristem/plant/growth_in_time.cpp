// SPDX-License-Identifier: Apache-2.0
// Computes when each segment grows, and cuts the skeleton at a time. Nodes of one step on one branch share the step:
// their segments grow one after another within it. See growth_in_time.h.
#include "meristem/plant/growth_in_time.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr float kShortestGrowth = 1e-3F;  // steps; used if births do not rise along a branch

/// The place of a node among the consecutive nodes of one branch that were born in the same step.
struct InStep {
  std::uint32_t before = 1;  // number of these nodes up to and including this one
  std::uint32_t after = 0;
  float begin = 0;  // when the first of these nodes began to grow
};

class SpanFinder {
 public:
  explicit SpanFinder(const Skeleton& skeleton) : skeleton_(skeleton), in_step_(skeleton.node_count()) {}

  void find(GrowthSpans& spans) {
    const auto count = static_cast<NodeIndex>(skeleton_.node_count());
    for (NodeIndex node = 0; node < count; ++node) {
      if (follows(node)) in_step_[node].before = in_step_[skeleton_.parent[node]].before + 1;
    }
    for (NodeIndex node = count; node-- > 0;) {
      if (!follows(node)) continue;
      std::uint32_t& after = in_step_[skeleton_.parent[node]].after;
      after = std::max(after, in_step_[node].after + 1);
    }
    find_next_births();
    for (NodeIndex node = 0; node < count; ++node) find_span(node, spans);
  }

 private:
  /// Returns true if the parent was born in the same step. Roots do not count as parents.
  bool follows(NodeIndex node) const {
    const NodeIndex parent = skeleton_.parent[node];
    return parent != kNoNode && skeleton_.parent[parent] != kNoNode && birth(parent) == birth(node);
  }
  float birth(NodeIndex node) const { return skeleton_.birth[node]; }

  /// Finds, for each node, the birth of the next node on its axis.
  void find_next_births() {
    next_.assign(skeleton_.node_count(), 0);
    for (NodeIndex node = 0; node < skeleton_.node_count(); ++node) {
      const NodeIndex parent = skeleton_.parent[node];
      if (parent != kNoNode && skeleton_.axis[parent] == skeleton_.axis[node]) next_[parent] = birth(node);
    }
  }

  void find_span(NodeIndex node, GrowthSpans& spans) {
    const NodeIndex parent = skeleton_.parent[node];
    if (parent == kNoNode) {
      spans.begin[node] = spans.end[node] = birth(node);
      return;
    }
    InStep& own = in_step_[node];
    own.begin = follows(node) ? in_step_[parent].begin : begin_of(node, spans.end[parent]);
    spans.begin[node] = follows(node) ? spans.end[parent] : own.begin;
    const float share = static_cast<float>(own.before) / static_cast<float>(own.before + own.after);
    const float end = own.after == 0 ? birth(node) : own.begin + (birth(node) - own.begin) * share;
    spans.end[node] = std::max(end, spans.begin[node] + kShortestGrowth);
  }

  /// Returns when the segment of `node` begins to grow, not before `earliest`. On an axis, growth continues from the
  /// previous node. The first segment of a lateral takes as long as the next segment, because nodes may have been
  /// removed.
  float begin_of(NodeIndex node, float earliest) const {
    const NodeIndex parent = skeleton_.parent[node];
    if (skeleton_.axis[parent] == skeleton_.axis[node]) return earliest;
    const float pace = next_[node] > birth(node) ? next_[node] - birth(node) : 1;
    return std::max(earliest, birth(node) - pace);
  }

  const Skeleton& skeleton_;
  std::vector<InStep> in_step_;
  std::vector<float> next_;
};

/// Returns the number of tips at or beyond each node, at least 1. A tip that is still growing counts by its grown
/// share. Branches that have fallen still count.
std::vector<double> tips_at(const Skeleton& whole, const std::vector<float>& grown) {
  std::vector<double> tips(whole.node_count(), 0);
  for (auto node = static_cast<NodeIndex>(whole.node_count()); node-- > 0;) {
    tips[node] = std::max(1.0, tips[node]);
    const NodeIndex parent = whole.parent[node];
    if (parent != kNoNode) tips[parent] += tips[node] * static_cast<double>(grown[node]);
  }
  return tips;
}

}  // namespace

GrowthSpans::GrowthSpans(const Skeleton& skeleton) : begin(skeleton.node_count()), end(skeleton.node_count()) {
  SpanFinder(skeleton).find(*this);
}

std::vector<float> steps_of_nodes(const Skeleton& whole, const GrowthSpans& spans, double step) {
  const auto falls = whole.extra.find(kFallsColumn);
  if (falls == whole.extra.end()) return {};
  std::vector<float> last = spans.end;
  for (auto node = static_cast<NodeIndex>(whole.node_count()); node-- > 0;) {
    const NodeIndex parent = whole.parent[node];
    if (parent != kNoNode) last[parent] = std::max(last[parent], last[node]);
  }
  std::vector<float> steps(whole.node_count(), static_cast<float>(step));
  for (NodeIndex node = 0; node < whole.node_count(); ++node) {
    const NodeIndex parent = whole.parent[node];
    if (parent != kNoNode) steps[node] = steps[parent];
    const float fall = falls->second[node];
    if (!(fall > 0) || parent == kNoNode) continue;
    const float grown = std::min(last[node], fall);
    const float begin = 0.5F * (grown + fall);  // when withering begins
    const float share = fall > begin ? std::clamp((static_cast<float>(step) - begin) / (fall - begin), 0.0F, 1.0F)
                                     : (step >= fall ? 1.0F : 0.0F);
    if (share > 0) steps[node] = std::min(steps[node], glm::mix(grown, spans.begin[node], share));
  }
  return steps;
}

void let_fall(Skeleton& skeleton, std::span<const std::uint8_t> marked, double hold) {
  std::vector<float> last = skeleton.birth;
  for (auto node = static_cast<NodeIndex>(skeleton.node_count()); node-- > 0;) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent != kNoNode) last[parent] = std::max(last[parent], last[node]);
  }
  std::vector<float>& falls = skeleton.extra[std::string(kFallsColumn)];
  falls.resize(skeleton.node_count(), 0);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    const bool begins_branch = parent != kNoNode && skeleton.axis[parent] != skeleton.axis[node];
    if (begins_branch && marked[node] != 0) falls[node] = last[node] + static_cast<float>(hold);
  }
}

TrimmedSkeleton standing_at(const Skeleton& whole, const GrowthSpans& spans, double step, double pipe_exponent) {
  // Compute how much of each segment has grown, and how much is left after withering.
  const std::vector<float> steps = steps_of_nodes(whole, spans, step);
  std::vector<float> grown(whole.node_count(), 0);
  std::vector<float> kept(whole.node_count(), 0);
  for (NodeIndex node = 0; node < whole.node_count(); ++node) {
    const NodeIndex parent = whole.parent[node];
    if (parent == kNoNode) {
      kept[node] = grown[node] = 1;
      continue;
    }
    const double begin = spans.begin[node];
    const auto share_at = [&](double at) {
      return static_cast<float>(std::clamp((at - begin) / (spans.end[node] - begin), 0.0, 1.0));
    };
    grown[node] = grown[parent] < 1 ? 0 : share_at(step);
    const float left = steps.empty() || steps[node] >= static_cast<float>(step) ? grown[node] : share_at(steps[node]);
    kept[node] = kept[parent] < 1 ? 0 : std::min(left, grown[node]);
  }

  // Scale the final radii by the share of tips that have grown.
  TrimmedSkeleton standing = keep_shares(whole, std::move(kept));
  const std::vector<double> now = tips_at(whole, grown);
  const std::vector<double> last = tips_at(whole, std::vector<float>(whole.node_count(), 1));
  for (NodeIndex node = 0; node < whole.node_count(); ++node) {
    const NodeIndex made = standing.node[node];
    if (made == kNoNode) continue;
    // A growing tip has the final radius of its node.
    standing.skeleton.radius[made] = whole.radius[node];
    if (now[node] == last[node]) continue;
    standing.skeleton.radius[made] *= static_cast<float>(math::pow(now[node] / last[node], 1 / pipe_exponent));
  }
  return standing;
}

}  // namespace meristem

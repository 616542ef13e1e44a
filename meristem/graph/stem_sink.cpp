// SPDX-License-Identifier: Apache-2.0
// Stores the stems of instances. A stem may be shown before the end of its growth, and a body may trim it. The rest is
// then stored with the whole skeleton, so that children keep their positions and random numbers.
#include "meristem/graph/stem_sink.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "meristem/base/math.h"
#include "meristem/graph/present_instance.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

namespace {

/// Moves a skeleton in world space along with its frame. Returns the factor of its size.
float move_geometry(Skeleton& skeleton, const Frame& from, const Frame& to) {
  const Mat3 axes = to.axes * glm::inverse(from.axes);
  for (Vec3& position : skeleton.position) position = to.origin + axes * (position - from.origin);
  const auto scale = static_cast<float>(math::pow(std::abs(glm::determinant(axes)), 1.0 / 3));
  for (float& radius : skeleton.radius) radius *= scale;
  const Frame moved{.axes = axes, .origin = to.origin - axes * from.origin};
  for (OperationRecord& record : skeleton.operations) move_record(record, moved, scale);
  return scale;
}

}  // namespace

void StemSink::add(Skeleton skeleton, const SurfaceOptions& surface, const StemOptions& options) {
  count_nodes(skeleton.node_count());

  // Take the stem back to its step of growth, and trim it by the body of the surroundings.
  std::shared_ptr<const GrowingStem> growing = growing_stem(skeleton, options.pipe_exponent);
  std::shared_ptr<const TrimmedStem> trimmed = trimmed_stem(skeleton, options, growing.get());
  if (trimmed != nullptr) skeleton = trimmed->left();

  // The stem's key follows from its number in the instance.
  EmittedStem stem{std::move(skeleton), shared_surface(surface), shared_branching(options.branching),
                   present_->site,      present_->is_visible,    present_->tint};
  stem.site.key = next_key();
  stem.trimmed = std::move(trimmed);
  stem.growing = std::move(growing);
  if (present_->is_individual() && present_->stem_count == 0) found_roots(stem);

  // `place` moves the visible skeleton; children stay on the skeleton that is not moved.
  if (present_->is_placed && stem.visible) {
    auto moved = std::make_unique<Skeleton>(stem.skeleton);
    stem.moved_scale = move_geometry(*moved, present_->site.frame, present_->geometry_frame);
    stem.moved = std::move(moved);
  }
  ++present_->stem_count;
  present_->emitted.stems.push_back(std::move(stem));
}

void StemSink::add_unseen(Skeleton skeleton, TrimMode trim) {
  const bool was_visible = std::exchange(present_->is_visible, false);
  add(std::move(skeleton), {}, {.trim = trim});
  present_->is_visible = was_visible;
}

RandomKey StemSink::next_key() const { return present_->site.key.child("stem").child(present_->stem_count); }

void StemSink::count_nodes(std::uint64_t more) {
  const EmitterContext& context = *present_->context;
  const std::uint64_t limit = context.limits.nodes;
  if (present_->context->nodes.fetch_add(more, std::memory_order_relaxed) + more <= limit) return;
  throw_past_limit(fmt::format("with '{}' there are more than {} nodes", present_->prototype().id, limit), limit,
                   "nodes", present_->path());
}

/// Returns the growth of the stem up to the time of the clock, or null if the stem is shown with its whole growth.
std::shared_ptr<const GrowingStem> StemSink::growing_stem(const Skeleton& whole, double pipe_exponent) const {
  if (!present_->grows_in_time() || present_->stands_as_grown) return nullptr;
  const Animation& animation = *present_->context->animation;
  const double steps = *animation.steps_per_second;
  GrowingStem growing{GrowthSpans(whole), present_->time() * steps, steps, animation.unfold * steps, pipe_exponent};
  growing.step_of_node = steps_of_nodes(whole, growing.spans, growing.step);
  return std::make_shared<const GrowingStem>(std::move(growing));
}

/// Returns the stem trimmed by the surroundings and the time, or null if it stays whole. A growing stem is cut at its
/// present size, even if it would otherwise be fitted.
std::shared_ptr<const TrimmedStem> StemSink::trimmed_stem(Skeleton skeleton, const StemOptions& options,
                                                          const GrowingStem* growing) const {
  const Crown* const body = present_->surroundings != nullptr ? present_->surroundings->trim.get() : nullptr;
  const bool is_cut = body != nullptr && options.trim != TrimMode::none;
  const auto reach = [&](Vec3 from, Vec3 to) { return body->reach(from, to); };
  if (growing == nullptr) {
    if (!is_cut) return nullptr;
    TrimmedSkeleton left = trim_skeleton(skeleton, reach, options.trim);
    if (left.is_whole) return nullptr;
    return std::make_shared<const TrimmedStem>(std::move(skeleton), std::move(left), options.trim);
  }
  TrimmedSkeleton standing = standing_at(skeleton, growing->spans, growing->step, options.pipe_exponent);
  if (is_cut) {
    TrimmedSkeleton left = trim_skeleton(standing.skeleton, reach, TrimMode::cut);
    if (!left.is_whole) standing = one_after_other(std::move(standing), std::move(left));
  }
  return std::make_shared<const TrimmedStem>(std::move(skeleton), std::move(standing), TrimMode::cut);
}

/// Returns the placement of branches, or null. Stems with equal placements share it.
std::shared_ptr<const BranchPlacement> StemSink::shared_branching(const BranchPlacement* branching) {
  if (branching == nullptr) {
    branching_ = nullptr;
  } else if (branching_ == nullptr || !(*branching_ == *branching)) {
    branching_ = std::make_shared<const BranchPlacement>(*branching);
  }
  return branching_;
}

/// Returns a surface with its crown in world space. Stems with equal surfaces share it.
std::shared_ptr<const SurfaceOptions> StemSink::shared_surface(SurfaceOptions surface) {
  if (surface.crown) surface.crown->scale(present_->scale());
  if (surface_ == nullptr || !(*surface_ == surface)) surface_ = std::make_shared<const SurfaceOptions>(surface);
  return surface_;
}

/// Makes each root of a plant's first stem a plant of its own. Parts that stand on no root belong to the first one.
void StemSink::found_roots(EmittedStem& stem) {
  std::vector<Emitted::Founded>& founded = present_->emitted.founded;
  const Skeleton& skeleton = stem.skeleton;
  if (std::count(skeleton.parent.begin(), skeleton.parent.end(), kNoNode) < 2) return;
  std::uint32_t roots = 0;
  stem.root_of_node.resize(skeleton.node_count());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.is_root(node)) {
      stem.root_of_node[node] = stem.root_of_node[skeleton.parent[node]];
      continue;
    }
    const Vec3 foot = skeleton.position[node];
    if (roots == 0) {
      founded.back().foot = foot;
    } else {
      founded.push_back({stem.individual_of_root(roots), foot, stem.deformation(), present_->site.row});
    }
    stem.root_of_node[node] = roots++;
  }
}

Skeleton StemSink::take_grown() {
  assert(present_->index < grown_.size());
  return std::move(grown_[present_->index]);
}

double StemSink::grown_to(double last) {
  const EmitterContext& context = *present_->context;
  int& growth_steps = present_->emitted.growth_steps;
  growth_steps = std::max(growth_steps, static_cast<int>(std::ceil(last)));
  if (context.growth_step) return std::clamp<double>(*context.growth_step, 0, last);
  if (!present_->grows_in_time()) return last;
  return std::clamp(present_->time() * *context.animation->steps_per_second, 0.0, last);
}

void StemSink::stands_as_grown() { present_->stands_as_grown = true; }

std::optional<Frame> StemSink::on_rest(NodeIndex node, const Frame& frame) const {
  const EmittedStem& stem = present_->emitted.stems.back();
  if (node == kNoNode || stem.trimmed == nullptr) return frame;
  const std::optional<StemPosition> left = stem.left_of({node, 1});
  if (!left) return std::nullopt;
  Site moved{.frame = stem.trimmed->moved(frame, {node, 1}, *left)};
  if (stem.growing != nullptr) stem.trimmed->settle(*stem.growing, {node, 1}, *left, moved);
  return moved.frame;
}

float StemSink::length_left() const { return present_->emitted.stems.back().length_left(); }

}  // namespace meristem

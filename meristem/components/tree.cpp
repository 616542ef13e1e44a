// SPDX-License-Identifier: Apache-2.0
// The stem grows section by section: each turns by its share of the curl, by what the noise has changed since the last
// one, and toward gravity and light. The shares are set so that a stem ends the same however many sections it has.
#include "meristem/components/tree.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/math.h"
#include "meristem/base/noise.h"
#include "meristem/components/surface_table.h"

namespace meristem {

namespace {

constexpr double kStrongest = 0.995;  // share of an angle: at 1 the first section would close all of it

/// What one of `sections` equal turns must close so that together they close `strength` of the angle.
double share_of_turn(double strength, int sections) {
  const double open = 1 - std::min(std::abs(strength), kStrongest);
  return 1 - math::pow(open, 1.0 / sections);
}

/// Grows the axis of one stem in world space.
class StemPath {
 public:
  StemPath(const Tree& tree, const Site& site, Vec3 light) : tree_(tree), key_(site.key.child("gnarl")), light_(light) {
    const Frame& frame = site.frame;
    scale_ = glm::length(frame.heading());
    heading_ = normalized_or(frame.heading(), kUp);
    right_ = normalized_or(frame.right() - glm::dot(frame.right(), heading_) * heading_, any_perpendicular(heading_));
    origin_ = frame.origin;
  }

  Skeleton run() {
    Skeleton skeleton;
    skeleton.reserve(static_cast<std::size_t>(tree_.segments) + 1);
    const float section = scale_ * static_cast<float>(tree_.length / tree_.segments);
    Vec3 place = origin_;
    NodeIndex last = add_node(skeleton, kNoNode, place, 0);
    for (int k = 0; k < tree_.segments; ++k) {
      turn(k);
      place += section * heading_;
      last = add_node(skeleton, last, place, k + 1);
    }
    return skeleton;
  }

  /// The frame at the tip.
  Frame end(Vec3 tip) const {
    Frame frame{Mat3(right_, heading_, glm::cross(right_, heading_)), tip};
    frame.axes *= scale_;
    return frame;
  }

 private:
  NodeIndex add_node(Skeleton& skeleton, NodeIndex parent, Vec3 place, int section) const {
    const NodeIndex node = skeleton.add_node(parent, place, 0);
    const double u = static_cast<double>(section) / tree_.segments;
    skeleton.radius[node] = scale_ * static_cast<float>(std::max(0.0, tree_.taper(u)) * tree_.radius);
    return node;
  }

  void turn(int section) {
    const Vec3 upper = glm::cross(right_, heading_);
    const double curl = tree_.curl / tree_.segments;
    rotate(rotation(right_, wandered(section, 0) - curl) * rotation(upper, wandered(section, 1)));
    if (tree_.gravitropism != 0) turn_toward(tree_.gravitropism > 0 ? -kUp : kUp, tree_.gravitropism);
    if (tree_.phototropism != 0) turn_toward(tree_.phototropism > 0 ? light_ : -light_, tree_.phototropism);
  }

  /// How much the noise turns this section against the one before.
  double wandered(int section, std::uint64_t direction) const {
    if (tree_.gnarl == 0) return 0;
    const auto noise = [&](int k) {
      return gradient_noise(key_.child(direction), k * tree_.gnarl_waves / tree_.segments);
    };
    return 2 * tree_.gnarl * (noise(section + 1) - noise(section));
  }

  void turn_toward(Vec3 target, double strength) {
    const double angle = math::acos(glm::dot(heading_, target));
    const Vec3 axis = normalized_or(glm::cross(heading_, target), right_);
    rotate(rotation(axis, angle * share_of_turn(strength, tree_.segments)));
  }

  void rotate(const Mat3& turn) {
    heading_ = glm::normalize(turn * heading_);
    right_ = turn * right_;
    right_ = glm::normalize(right_ - glm::dot(right_, heading_) * heading_);
  }

  const Tree& tree_;
  RandomKey key_;
  Vec3 light_;
  float scale_ = 1;
  Vec3 heading_{0}, right_{0}, origin_{0};
};

void expand(const Tree& tree, const Site& site, Emitter& out) {
  StemPath path(tree, site, unit_vector(out.scene().sun));
  Skeleton skeleton = path.run();
  const Frame end = path.end(skeleton.position.back());
  const float tip_radius = skeleton.radius.back();
  out.stem(std::move(skeleton), tree.surface);
  out.child_site_in_world(end, glm::length(end.heading()) * static_cast<float>(tree.length), tip_radius);
}

}  // namespace

ComponentType tree_component() {
  return define_component<Tree>({
      .name = "tree",
      .doc = "A stem along a curve; branch links place children along it, and stems among them become its branches.",
      .parameters =
          Table<Tree>("a tree", "A stem along a curve.")
              .number("length", &Tree::length, {.unit = Unit::metre, .min = 1e-4, .max = 1000}, "Base to tip.")
              .number("radius", &Tree::radius, {.unit = Unit::metre, .min = 1e-6, .max = 100}, "At the base.")
              .curve("taper", &Tree::taper, "Share of the radius from base (0) to tip (1).")
              .integer("segments", &Tree::segments, {.min = 1, .max = 1000, .fixed = true},
                       "Straight pieces; raised, smoother bends.")
              .number("curl", &Tree::curl, {.unit = Unit::degree, .min = -3600, .max = 3600},
                      "Bend from base to tip; raised, it leans away from its upper side, which faces its mother's tip.")
              .number("gnarl", &Tree::gnarl, {.unit = Unit::degree, .min = 0, .max = 180},
                      "By how much its direction wanders; raised, more crooked.")
              .number("gnarl_waves", &Tree::gnarl_waves, {.min = 0, .max = 1000},
                      "How often it does so from base to tip.")
              .number("gravitropism", &Tree::gravitropism, {.min = -1, .max = 1},
                      "Share of the angle to straight down that the tip has closed; negative, to straight up.")
              .number("phototropism", &Tree::phototropism, {.min = -1, .max = 1},
                      "The same for the direction of the light; negative, away from it.")
              .object("surface", &Tree::surface, surface_table, "How the stem is clothed."),
      .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
      .makes_stems = true,
      .expand = expand,
  });
}

}  // namespace meristem

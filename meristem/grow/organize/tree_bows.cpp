// SPDX-License-Identifier: Apache-2.0
// Bends sections of shoots gradually: in each iteration, every metamer of a bow turns by an equal share of the
// remaining angle.
#include "meristem/grow/organize/tree_bows.h"

#include <algorithm>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/grow/prune/draw.h"

namespace meristem {

namespace {

/// The rotation of each metamer of a bow, about one axis.
struct Turn {
  Vec3 axis{0};
  double angle = 0;
};

/// Returns the rotation per metamer and iteration that brings `heading` to an inclination, for `count` metamers and
/// `iterations` iterations.
Turn turn_to(Vec3 heading, double inclination, int count, int iterations) {
  const Vec3 level = normalized_or(Vec3(heading.x, 0, heading.z), Vec3(1, 0, 0));
  const Vec3 wanted =
      static_cast<float>(math::cos(inclination)) * level + static_cast<float>(math::sin(inclination)) * kUp;
  const Vec3 across = glm::cross(heading, wanted);
  const double sine = glm::length(across);
  if (sine < 1e-6) return {};
  return {normalized_or(across, kUp), math::atan2(sine, glm::dot(heading, wanted)) / (count * iterations)};
}

}  // namespace

void TreeBows::add(const Bow& bow) {
  std::erase_if(bows_, [&](const Bow& other) { return other.first == bow.first; });
  bows_.push_back(bow);
}

TreePose TreeBows::bend(const Metamers& metamers) {
  const std::size_t count = metamers.count();
  std::vector<std::uint32_t> bow_of(count, 0);  // from 1; 0: not in a bow
  std::vector<int> lengths;
  for (const Bow& bow : bows_) {
    lengths.push_back(0);
    for (MetamerIndex metamer = bow.last;; metamer = metamers.parent[metamer]) {
      bow_of[metamer] = static_cast<std::uint32_t>(lengths.size());
      ++lengths.back();
      if (metamer == bow.first) break;
    }
  }
  const auto drawn = [&](const Bow& bow, const Mat3& turned, int length) {
    std::vector<Vec3> points(static_cast<std::size_t>(length) + 1);
    MetamerIndex metamer = bow.last;
    for (std::size_t k = points.size(); k-- > 0; metamer = metamers.parent[metamer]) points[k] = metamers.tip[metamer];
    const Vec3 base = points[0];
    for (Vec3& point : points) point = base + turned * (point - base);
    const Draw draw = draw_toward(points, *bow.toward, bow.gap);
    return Turn{draw.axis, draw.angle / (length * bow.iterations)};
  };
  std::vector<Turn> turns(bows_.size());
  std::vector<Mat3> turned(count, Mat3(1));
  TreePose pose{std::vector<Vec3>(count, Vec3(0)), metamers.side, {}};
  pose.tip[0] = metamers.tip[0];
  for (MetamerIndex metamer = 1; metamer < count; ++metamer) {
    const MetamerIndex parent = metamers.parent[metamer];
    turned[metamer] = turned[parent];
    if (const std::uint32_t number = bow_of[metamer]; number != 0) {
      const Bow& bow = bows_[number - 1];
      Turn& turn = turns[number - 1];
      if (metamer == bow.first) {
        const int length = lengths[number - 1];
        const Vec3 heading = turned[parent] * metamers.heading(bow.last);
        turn =
            bow.toward ? drawn(bow, turned[parent], length) : turn_to(heading, bow.inclination, length, bow.iterations);
      }
      if (turn.angle != 0) turned[metamer] = rotation(turn.axis, turn.angle) * turned[parent];
    }
    const Vec3 internode = metamers.tip[metamer] - metamers.tip[parent];
    // Copy unmoved metamers, so that their positions stay bitwise equal.
    if (pose.tip[parent] == metamers.tip[parent] && turned[metamer] == Mat3(1)) {
      pose.tip[metamer] = metamers.tip[metamer];
      continue;
    }
    pose.tip[metamer] = pose.tip[parent] + turned[metamer] * internode;
    pose.tip[metamer].y = std::max(pose.tip[metamer].y, std::min(0.0F, metamers.tip[metamer].y));
    pose.side[metamer] = turned[metamer] * metamers.side[metamer];
  }
  for (Bow& bow : bows_) --bow.iterations;
  std::erase_if(bows_, [](const Bow& bow) { return bow.iterations <= 0; });
  return pose;
}

void TreeBows::remove(const std::vector<std::uint8_t>& gone) {
  if (bows_.empty()) return;
  std::vector<MetamerIndex> place(gone.size());
  MetamerIndex kept = 0;
  for (std::size_t metamer = 0; metamer < gone.size(); ++metamer) {
    place[metamer] = kept;
    if (gone[metamer] == 0) ++kept;
  }
  std::erase_if(bows_, [&](const Bow& bow) { return gone[bow.last] != 0; });
  for (Bow& bow : bows_) {
    bow.first = place[bow.first];
    bow.last = place[bow.last];
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Bends branches in two passes: from the tips, sum mass and moments; from the root, turn each internode by the increase
// of its moment over its stiffness. See sag.h.
#include "meristem/grow/organize/sag.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr double kGravity = 9.81;
// Largest turn of an internode in one iteration, radians. Beyond it wood would break, and beam theory is invalid.
constexpr double kMaxTurn = 0.35;

bool is_tied(const Metamers& metamers, MetamerIndex metamer) { return metamers.axes[metamers.axis[metamer]].tie != 0; }

}  // namespace

TreePose BranchLoad::bend(const Metamers& metamers, int iteration) const {
  const std::size_t count = metamers.count();
  const std::vector<float> radius = pipe_radii(metamers.parent, metamers.lost_tips, radii_);

  // Compute mass and first moment of the load of each metamer, including itself.
  std::vector<double> mass(count, 0);
  std::vector<DVec3> first(count, DVec3(0));
  for (std::size_t metamer = count; metamer-- > 1;) {
    const MetamerIndex parent = metamers.parent[metamer];
    const double wood = sag_.density * kPi * radius[metamer] * radius[metamer] * metamers.length(metamer);
    const double leaves = metamers.birth[metamer] == iteration ? sag_.leaf_mass : 0;
    mass[metamer] += wood + leaves;
    first[metamer] += wood * 0.5 * DVec3(metamers.tip[metamer] + metamers.tip[parent]);
    first[metamer] += leaves * DVec3(metamers.tip[metamer]);
    if (is_tied(metamers, metamer)) continue;
    mass[parent] += mass[metamer];
    first[parent] += first[metamer];
  }

  // From the root to the tips: turn each internode by the increase of its moment, together with everything that it
  // bears.
  std::vector<Mat3> turned(count, Mat3(1));
  TreePose pose{std::vector<Vec3>(count, Vec3(0)), metamers.side, moment_};
  pose.moment.resize(count, Vec3(0));
  for (MetamerIndex metamer = 1; metamer < count; ++metamer) {
    const MetamerIndex parent = metamers.parent[metamer];
    if (is_tied(metamers, metamer)) {
      pose.tip[metamer] = pose.tip[parent] + (metamers.tip[metamer] - metamers.tip[parent]);
      continue;
    }
    const DVec3 lever = first[metamer] - mass[metamer] * DVec3(metamers.tip[parent]);
    // The moment of weights m at a lever r is r x g m.
    const DVec3 down(directions_.gravity(root_ + metamers.tip[parent]).vector());
    const DVec3 moment = kGravity * glm::cross(lever, down);
    const DVec3 grown = moment - DVec3(pose.moment[metamer]);
    pose.moment[metamer] = Vec3(moment);
    const double r = radius[metamer];
    const double rigidity = sag_.stiffness * 1e9 * kPi / 4 * r * r * r * r;
    const double size = std::sqrt(squared_length(grown));
    const double turn = std::min(size * metamers.length(metamer) / rigidity, kMaxTurn);
    Mat3 own(1);
    if (turn > 1e-9) own = rotation(Vec3(grown / size), turn);
    const Vec3 internode = metamers.tip[metamer] - metamers.tip[parent];
    turned[metamer] = own * turned[parent];
    pose.tip[metamer] = pose.tip[parent] + turned[metamer] * internode;
    const float ground = std::min(0.0F, metamers.tip[metamer].y);
    pose.tip[metamer].y = std::max(pose.tip[metamer].y, ground);
    pose.side[metamer] = turned[metamer] * metamers.side[metamer];
  }
  return pose;
}

void BranchLoad::remove(const std::vector<std::uint8_t>& gone) { erase_marked(moment_, gone); }

}  // namespace meristem

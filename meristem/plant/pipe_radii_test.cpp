// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/pipe_radii.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "tests/support/check_skeleton.h"

namespace meristem::pipe_radii_test {

// A tree in which each node grows from a random node among the last few.
Skeleton random_tree(NodeIndex nodes, RandomKey key) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, Vec3(0), 0);
  for (NodeIndex node = 1; node < nodes; ++node) {
    const auto back = static_cast<NodeIndex>(key.uniform(node) * std::min(node, NodeIndex{40}));
    const NodeIndex parent = node - 1 - back;
    skeleton.add_node(parent, skeleton.position[parent] + key.child("way").direction(node), skeleton.birth[parent] + 1);
  }
  return skeleton;
}

TEST(PipeRadii, HoldThePipeLawAtEveryFork) {
  for (const double exponent : {2.0, 2.4, 3.5}) {
    Skeleton skeleton = random_tree(5000, RandomKey(11));
    assign_pipe_radii(skeleton, {.tip_radius = 0.004, .exponent = exponent});
    assign_axes(skeleton);
    ASSERT_TRUE(check_skeleton(skeleton));
    const NodeChildren children(skeleton);
    std::size_t forks = 0;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      if (children.of(node).empty()) {
        EXPECT_FLOAT_EQ(skeleton.radius[node], 0.004F);
        continue;
      }
      double sum = 0;
      for (const NodeIndex child : children.of(node)) sum += std::pow(skeleton.radius[child], exponent);
      EXPECT_NEAR(std::pow(sum, 1 / exponent) / skeleton.radius[node], 1, 1e-6) << "node " << node;
      forks += children.of(node).size() > 1 ? 1 : 0;
    }
    EXPECT_GT(forks, 500U);
  }
}

TEST(PipeRadii, FourTipsDoubleTheRadiusAtExponentTwo) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  for (int k = 0; k < 4; ++k) skeleton.add_node(0, {k, 1, 0}, 1);
  assign_pipe_radii(skeleton, {.tip_radius = 0.5, .exponent = 2});
  EXPECT_FLOAT_EQ(skeleton.radius[0], 1);
}

TEST(PipeRadii, ALoneRootIsATip) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, Vec3(0), 0);
  assign_pipe_radii(skeleton, {});
  assign_axes(skeleton);
  EXPECT_FLOAT_EQ(skeleton.radius[0], 0.004F);
  EXPECT_TRUE(check_skeleton(skeleton));
}

TEST(PipeRadii, RejectNumbersOfZeroOrBelow) {
  Skeleton skeleton = random_tree(3, RandomKey(1));
  EXPECT_THROW(assign_pipe_radii(skeleton, {.tip_radius = 0}), std::invalid_argument);
  EXPECT_THROW(assign_pipe_radii(skeleton, {.exponent = -1}), std::invalid_argument);
}

TEST(Axes, TheThickestChildContinuesItsParent) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {1, 0, 0}, 1);
  skeleton.add_node(0, {0, 1, 0}, 1);
  skeleton.add_node(2, {0, 2, 0}, 2);
  skeleton.add_node(2, {1, 2, 0}, 2);
  assign_pipe_radii(skeleton, {});
  assign_axes(skeleton);
  // Node 2 bears two tips and continues the axis. At its fork both children are equal, and the lower index continues.
  EXPECT_EQ(skeleton.axis, (std::vector<AxisIndex>{0, 1, 0, 0, 2}));
  EXPECT_EQ(skeleton.order, (std::vector<std::uint16_t>{0, 1, 0, 0, 1}));
}

TEST(Axes, EveryRootBeginsAStem) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(kNoNode, {1, 0, 0}, 0);
  skeleton.add_node(1, {1, 1, 0}, 1);
  assign_pipe_radii(skeleton, {});
  assign_axes(skeleton);
  EXPECT_EQ(skeleton.axis, (std::vector<AxisIndex>{0, 1, 1}));
  EXPECT_EQ(skeleton.order, (std::vector<std::uint16_t>{0, 0, 0}));
}

TEST(PipeRadii, AStumpStaysAsThickAsWhenItBoreWhatItLost) {
  // A stem with three tips, and the stump that is left when the upper two are cut.
  const std::vector<NodeIndex> whole{kNoNode, 0, 1, 1, 0};
  const std::vector<NodeIndex> cut{kNoNode, 0, 0};
  const std::vector<float> lost{0, 2, 0};
  EXPECT_EQ(count_tips(whole, {}), (std::vector<double>{3, 2, 1, 1, 1}));
  EXPECT_EQ(count_tips(cut, lost), (std::vector<double>{3, 2, 1}));
  EXPECT_EQ(count_tips(cut, lost, 0), (std::vector<double>{2, 1, 1}));
  const PipeModel model;
  EXPECT_EQ(pipe_radii(whole, {}, model)[0], pipe_radii(cut, lost, model)[0]);
}

}  // namespace meristem::pipe_radii_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/segment_tree.h"

#include <limits>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::segment_tree_test {

/// Finds the nearest surface by testing every segment.
std::uint32_t nearest_of_all(const std::vector<RoundSegment>& segments, Vec3 position) {
  float best = std::numeric_limits<float>::infinity();
  std::uint32_t number = kNoSegment;
  for (const RoundSegment& segment : segments) {
    const float distance = segment.distance(position);
    if (distance > best || (distance == best && segment.number >= number)) continue;
    best = distance;
    number = segment.number;
  }
  return number;
}

Vec3 somewhere(RandomKey key, std::uint64_t index) {
  return Vec3(key.child(index).uniform(0), key.child(index).uniform(1), key.child(index).uniform(2));
}

TEST(SegmentTree, FindsWhatAskingEverySegmentFinds) {
  const RandomKey key(7);
  std::vector<RoundSegment> segments;
  for (std::uint32_t k = 0; k < 300; ++k) {
    const Vec3 begin = somewhere(key.child("begin"), k);
    const float thick = k % 10 == 0 ? 0.2F : 0.01F;
    segments.push_back({begin, begin + 0.1F * key.direction(k), thick, 0.5F * thick, k / 3});
  }
  const SegmentTree tree(segments, Progress());
  for (std::uint64_t k = 0; k < 500; ++k) {
    const Vec3 position = 1.4F * somewhere(key.child("asked"), k) - Vec3(0.2F);
    EXPECT_EQ(tree.nearest(position), nearest_of_all(segments, position)) << k;
  }
}

TEST(SegmentTree, CountsTheDistanceToTheSurfaceFromBothSides) {
  const RoundSegment segment{Vec3(0), Vec3(0, 2, 0), 0.2F, 0.1F, 0};
  EXPECT_NEAR(segment.distance({0.5F, 1, 0}), 0.35F, 1e-6F);
  EXPECT_NEAR(segment.distance({0.05F, 1, 0}), 0.1F, 1e-6F);
  EXPECT_NEAR(segment.distance({0, 3, 0}), 0.9F, 1e-6F);
}

TEST(SegmentTree, LateralsAreAsThickAsTheirOwnFirstNode) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, Vec3(0), 0);
  skeleton.add_node(0, Vec3(0, 1, 0), 0);
  skeleton.add_node(1, Vec3(1, 1, 0), 0);
  skeleton.radius = {0.3F, 0.2F, 0.05F};
  skeleton.axis = {0, 0, 1};
  std::vector<RoundSegment> segments;
  append_segments(skeleton, 4, segments);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].begin_radius, 0.3F);
  EXPECT_EQ(segments[1].begin_radius, 0.05F);
  EXPECT_EQ(segments[1].number, 5U);
}

TEST(SegmentTree, WithoutSegmentsNothingIsNearest) {
  EXPECT_EQ(SegmentTree({}, Progress()).nearest(Vec3(0)), kNoSegment);
}

}  // namespace meristem::segment_tree_test

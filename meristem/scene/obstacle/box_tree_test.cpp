// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/obstacle/box_tree.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::box_tree_test {

std::set<std::uint32_t> all_around(const BoxTree& tree, Vec3 position) {
  std::set<std::uint32_t> found;
  tree.any_around(position, [&](std::uint32_t box) {
    EXPECT_TRUE(found.insert(box).second) << box;
    return false;
  });
  return found;
}

std::vector<Box> random_boxes(std::size_t count) {
  std::vector<Box> boxes;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 middle = 10.0F * RandomKey(1).direction(k);
    Box& box = boxes.emplace_back();
    box.add(middle);
    box.add(middle + 5.0F * RandomKey(2).direction(k));
  }
  return boxes;
}

TEST(BoxTree, FindsTheBoxesThatASearchThroughAllFinds) {
  for (const std::size_t count : {1, 2, 4, 5, 9, 64, 1000}) {
    const std::vector<Box> boxes = random_boxes(count);
    const BoxTree tree(boxes);
    for (std::uint64_t k = 0; k < 300; ++k) {
      // Also test corners of boxes, because faces belong to their boxes.
      const Vec3 position = k % 3 == 0 ? boxes[k % count].low : 9.0F * RandomKey(3).direction(k);
      std::set<std::uint32_t> expected;
      for (std::uint32_t box = 0; box < count; ++box) {
        if (glm::clamp(position, boxes[box].low, boxes[box].high) == position) expected.insert(box);
      }
      EXPECT_EQ(all_around(tree, position), expected);
    }
  }
}

TEST(BoxTree, StopsAtTheFirstYes) {
  Box box;
  box.add(Vec3(0));
  box.add(Vec3(1));
  const BoxTree tree(std::vector<Box>(100, box));
  int asked = 0;
  EXPECT_TRUE(tree.any_around(Vec3(0.5F), [&](std::uint32_t) { return ++asked == 3; }));
  EXPECT_EQ(asked, 3);
}

TEST(BoxTree, AsksOnlyWhatIsNear) {
  std::vector<Box> row;
  for (int k = 0; k < 1000; ++k) {
    Box& box = row.emplace_back();
    box.add(Vec3(3 * k, 0, 0));
    box.add(Vec3(3 * k + 2, 1, 1));
  }
  int asked = 0;
  BoxTree(row).any_around(Vec3(1500.5F, 0.5F, 0.5F), [&](std::uint32_t) { return ++asked < 0; });
  EXPECT_LE(asked, 4);
}

TEST(BoxTree, MayBeEmpty) {
  EXPECT_FALSE(BoxTree().any_around(Vec3(0), [](std::uint32_t) { return true; }));
  EXPECT_FALSE(BoxTree(std::vector<Box>()).any_around(Vec3(0), [](std::uint32_t) { return true; }));
}

}  // namespace meristem::box_tree_test

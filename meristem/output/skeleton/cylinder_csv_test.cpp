// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/skeleton/cylinder_csv.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "meristem/output/skeleton/cylinders.h"
#include "meristem/output/skeleton/tree_file.h"
#include "meristem/plant/file/node_table.h"
#include "tests/support/sample_plants.h"
#include "tests/support/temporary_folder.h"

namespace meristem::cylinder_csv_test {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// The table of a plant, and the result of reading it.
class CylinderTables : public testing::Test {
 protected:
  std::string csv(const Plant& plant) {
    write_cylinder_csv(plant, {}, at("x.qsm.csv"), progress_);
    return text_of(at("x.qsm.csv"));
  }
  std::string trees(const Plant& plant) {
    write_tree_file(plant, {}, at("x.trees.txt"), {.name = "Fork", .version = "1"}, progress_);
    return text_of(at("x.trees.txt"));
  }
  static Skeleton read(const std::string& text) {
    return skeleton_of(read_node_table(text, "x", {}), {.begins_at_origin = false}, "x");
  }

 private:
  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  Progress progress_;
};

/// Returns the volume of a skeleton as cones between its nodes. Laterals begin with the thickness of their first node.
double volume_of(const Skeleton& skeleton) {
  double volume = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    const double b = skeleton.radius[node];
    const double a = skeleton.axis[parent] == skeleton.axis[node] ? double{skeleton.radius[parent]} : b;
    const double length = glm::distance(DVec3(skeleton.position[parent]), DVec3(skeleton.position[node]));
    volume += kPi / 3 * length * (a * a + a * b + b * b);
  }
  return volume;
}

/// Returns the volume of the cylinders that end in the nodes.
double volume_of_cylinders(const Skeleton& skeleton) {
  double volume = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    const double radius = skeleton.radius[node];
    volume += kPi * radius * radius * glm::distance(skeleton.position[parent], skeleton.position[node]);
  }
  return volume;
}

TEST_F(CylinderTables, HaveTreeQsmsColumnsAndZUp) {
  const std::string text = csv(two_stems());
  EXPECT_TRUE(text.starts_with(
      "radius,length,start.x,start.y,start.z,axis.x,axis.y,axis.z,parent,extension,added,UnmodRadius,branch,SurfCov,"
      "mad,BranchOrder,PositionInBranch\n"
      "0.09504385,1,0,0,0,0,0,1,0,2,0,0.09504385,1,1,0,0,1\n"
      "0.07094599,1,0,0,1,0,0,1,1,0,0,0.07094599,1,1,0,0,2\n"
      "0.04,0.70710677,0,0,1,0.70710677,0,0.70710677,1,0,0,0.04,2,1,0,1,1\n"))
      << text;
}

TEST_F(CylinderTables, HoldTheVolumeOfTheSkeletons) {
  const Plant plant = two_stems();
  double volume = 0;
  for (const Stem& stem : plant.stems) volume += volume_of(stem.skeleton);
  EXPECT_NEAR(volume_of_cylinders(read(csv(plant))) / volume, 1, 1e-6);
  EXPECT_NEAR(volume_of_cylinders(read(trees(plant))) / volume, 1, 1e-6);
}

TEST_F(CylinderTables, ReadAsTheSkeletonsThatTheyWereWrittenFrom) {
  const Plant plant = two_stems();
  for (const Skeleton& again : {read(csv(plant)), read(trees(plant))}) {
    ASSERT_EQ(again.node_count(), 7U);
    EXPECT_EQ(again.parent, (std::vector<NodeIndex>{kNoNode, 0, 1, 1, kNoNode, 4, 5}));
    EXPECT_EQ(again.axis, (std::vector<AxisIndex>{0, 0, 0, 1, 2, 2, 2}));
    EXPECT_EQ(again.order, (std::vector<std::uint16_t>{0, 0, 0, 1, 0, 0, 0}));
    for (NodeIndex node = 0; node < 4; ++node) {
      EXPECT_LT(glm::distance(again.position[node], plant.stems[0].skeleton.position[node]), 1e-6F);
    }
    EXPECT_LT(glm::distance(again.position[6], plant.stems[1].skeleton.position[2]), 1e-6F);
  }
}

TEST_F(CylinderTables, TreeFilesHaveALinePerTree) {
  EXPECT_EQ(trees(two_stems()),
            "# tree file\n# Meristem 1\n# name: Fork\n# seed: 0\n# to grow it again: meristem grow DOCUMENT -o FILE "
            "--seed 0\n# units: metres, z up\nx,y,z,radius,parent_id,branch_id,order\n"
            "0,0,0,0.1,-1,0,0, 0,0,1,0.09504385,0,0,0, 0,0,2,0.07094599,1,0,0, 0.5,0,1.5,0.04,1,1,1\n"
            "3,0,0,0.01,-1,2,0, 3,0,0.1,0.01,0,2,0, 3,0,0.33333334,0.0057735313,1,2,0\n");
}

/// Nodes of two trees alternate in one skeleton.
TEST_F(CylinderTables, TreesOfOneSkeletonDoNotMix) {
  Plant plant;
  Stem stem{.parts = {{.component = "pair"}}};
  Skeleton& pair = stem.skeleton;
  pair.add_node(kNoNode, {0, 0, 0}, 0);
  pair.add_node(kNoNode, {5, 0, 0}, 0);
  pair.add_node(0, {0, 1, 0}, 1);
  pair.add_node(1, {5, 1, 0}, 1);
  pair.radius = {0.1F, 0.1F, 0.1F, 0.1F};
  pair.axis = {0, 1, 0, 1};
  plant.stems.push_back(stem);
  const Skeleton again = read(trees(plant));
  EXPECT_EQ(again.parent, (std::vector<NodeIndex>{kNoNode, 0, kNoNode, 2}));
  EXPECT_EQ(again.position[3].x, 5);
  EXPECT_EQ(read(csv(plant)).parent, (std::vector<NodeIndex>{kNoNode, 0, kNoNode, 2}));
}

TEST_F(CylinderTables, OfNothingHaveTheirHeadAlone) {
  EXPECT_EQ(csv({}).find('\n'), csv({}).size() - 1);
  EXPECT_TRUE(trees({}).ends_with("order\n"));
}

}  // namespace meristem::cylinder_csv_test

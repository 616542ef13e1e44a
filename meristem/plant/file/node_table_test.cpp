// SPDX-License-Identifier: Apache-2.0
// Skeletons from tables of nodes, cylinders and trees that other programs wrote.
#include "meristem/plant/file/node_table.h"

#include <cmath>
#include <ctime>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/check_skeleton.h"

namespace meristem::node_table_test {

Skeleton skeleton(const std::string& text, const NodeTablePlacement& placement = {}) {
  return skeleton_of(read_node_table(text, "t.csv", {}), placement, "t.csv");
}

std::string error_of(const std::string& text, const SizeLimits& limits = {}) {
  try {
    skeleton_of(read_node_table(text, "t.csv", limits), {}, "t.csv");
  } catch (const InputError& error) {
    return error.diagnostics()[0].text();
  }
  return "no fault";
}

using Nodes = std::vector<NodeIndex>;
using Axes16 = std::vector<AxisIndex>;
using Orders = std::vector<std::uint16_t>;

// A trunk of two segments with a thinner branch from its middle. z is up.
const std::string kTree =
    "x,y,z,radius,parent\n"
    "0,0,0,0.1,-1\n"
    "0,0,1,0.08,0\n"
    "0,0,2,0.06,1\n"
    "1,0,1,0.03,1\n";

TEST(NodeTable, NodesBecomeASkeletonWithYUpAndNorthBackward) {
  const Skeleton tree = skeleton(kTree + "0,2,1,0.02,1\n");
  EXPECT_EQ(tree.parent, (Nodes{kNoNode, 0, 1, 1, 1}));
  EXPECT_EQ(tree.position[2], Vec3(0, 2, 0));
  EXPECT_EQ(tree.position[3], Vec3(1, 1, 0));
  EXPECT_EQ(tree.position[4], Vec3(0, 1, -2)) << "north is -z";
  EXPECT_EQ(tree.radius[3], 0.03F);
  EXPECT_EQ(tree.axis, (Axes16{0, 0, 0, 1, 2})) << "the thickest child goes on";
  EXPECT_EQ(tree.order, (Orders{0, 0, 0, 1, 1}));
  EXPECT_TRUE(check_skeleton(tree));
}

TEST(NodeTable, UnitsAndUpAxisAreAsTold) {
  const Skeleton tree = skeleton(kTree, {.unit = 0.01, .is_y_up = true});
  EXPECT_EQ(tree.position[2], Vec3(0, 0, 0.02F));
  EXPECT_EQ(tree.radius[0], 0.001F);
}

TEST(NodeTable, LargeCoordinatesAreTakenFromTheRootBeforeFloatsMakeThemCoarse) {
  const std::string map = "x;y;z;radius;parent\n691234,125;5336789,5;512;0,1;\n691234,126;5336789,5;513;0,05;0\n";
  const Skeleton tree = skeleton(map);
  EXPECT_EQ(tree.position[0], Vec3(0));
  EXPECT_NEAR(tree.position[1].x, 0.001, 1e-6);
  EXPECT_EQ(tree.position[1].y, 1);
  const Skeleton as_is = skeleton("x,y,z,parent\n5,6,7,-1\n5,6,8,0\n", {.begins_at_origin = false});
  EXPECT_EQ(as_is.position[1], Vec3(5, 8, -6));
}

TEST(NodeTable, DiametersAreHalvedAndMissingRadiiAreNone) {
  const Skeleton tree = skeleton("x,y,z,Diameter (m),parent\n0,0,0,0.2,\n0,0,1,,0\n");
  EXPECT_EQ(tree.radius, (std::vector<float>{0.1F, 0}));
}

TEST(NodeTable, WithoutRadiiTheLongestWayToATipGoesOn) {
  const Skeleton tree = skeleton("x,y,z,parent\n0,0,0,-1\n0,0,1,0\n1,0,1,1\n0,0,2,1\n0,0,3,3\n");
  EXPECT_EQ(tree.axis, (Axes16{0, 0, 1, 0, 0}));
}

TEST(NodeTable, RowsMayStandInAnyOrderAndBeNamedByNumbersOfTheirOwn) {
  const Skeleton tree = skeleton("id,parent,x,y,z,radius\n30,20,0,0,2,0.1\n20,10,0,0,1,0.2\n10,-1,0,0,0,0.3\n");
  EXPECT_EQ(tree.parent, (Nodes{kNoNode, 0, 1}));
  EXPECT_EQ(tree.position[2], Vec3(0, 2, 0));
}

TEST(NodeTable, MeristemsOwnTablesHaveYUpAndKeepAxesAndBirths) {
  const std::string own =
      "component,instance,node,parent,x,y,z,radius,axis,order,birth\n"
      "tree,0,0,,0,0,0,0.1,0,0,0\ntree,0,1,0,0,1,0,0.05,1,1,3\ntree,0,2,0,0,1,1,0.08,0,0,4\n";
  const NodeTable table = read_node_table(own, "t.csv", {});
  EXPECT_TRUE(table.is_y_up);
  const Skeleton tree = skeleton_of(table, {.is_y_up = true}, "t.csv");
  EXPECT_EQ(tree.position[1], Vec3(0, 1, 0));
  EXPECT_EQ(tree.birth, (std::vector<float>{0, 3, 4}));
  EXPECT_EQ(tree.axis, (Axes16{0, 1, 0})) << "the file's axes, though the other child comes first";
}

// TreeQSM's columns: a cylinder of the stem, the next one, and a branch from the first.
const std::string kQsm =
    "radius (m)\tlength (m)\tstart_x\tstart_y\tstart_z\taxis_x\taxis_y\taxis_z\tparent\textension\tbranch\n"
    "0.1\t1\t5\t5\t0\t0\t0\t1\t0\t2\t1\n"
    "0.08\t0.5\t5\t5\t1\t0\t0\t1\t1\t0\t1\n"
    "0.09\t2\t5\t5\t1\t0.6\t0\t0.8\t1\t0\t2\n";

TEST(NodeTable, CylindersEndInNodesAndCountFromOne) {
  const Skeleton tree = skeleton(kQsm);
  EXPECT_EQ(tree.parent, (Nodes{kNoNode, 0, 1, 1}));
  EXPECT_LT(glm::distance(tree.position[1], Vec3(0, 1, 0)), 1e-6F);
  EXPECT_LT(glm::distance(tree.position[2], Vec3(0, 1.5F, 0)), 1e-6F);
  EXPECT_LT(glm::distance(tree.position[3], Vec3(1.2F, 2.6F, 0)), 1e-6F);
  EXPECT_EQ(tree.axis, (Axes16{0, 0, 0, 1})) << "by branches, although the other one is thicker";
  EXPECT_EQ(tree.order, (Orders{0, 0, 0, 1}));
}

TEST(NodeTable, TreeQsmsTextFilesNameAPointOverThreeColumns) {
  const Skeleton tree = skeleton(
      "radius (m)\tlength (m)\tstart_point\taxis_direction\tparent\textension\tbranch\tbranch_order\n"
      "0.1\t1\t5\t5\t0\t0\t0\t1\t0\t2\t1\t0\n"
      "0.08\t0.5\t5\t5\t1\t1\t0\t0\t1\t0\t1\t0\n");
  ASSERT_EQ(tree.node_count(), 3U);
  EXPECT_EQ(tree.position[2], Vec3(0.5F, 1, 0));
  EXPECT_EQ(tree.radius[1], 0.1F);
  EXPECT_EQ(error_of("length (m)\tstart_point\taxis_direction\tparent\n1\t0\t0\tup\t0\t0\t1\t0\n"),
            "t.csv:1:1: there is no column 'radius'; expected a head line that names it");
}

TEST(NodeTable, CylindersThatBeginWhereARootBeginsShareIt) {
  const Skeleton bush = skeleton(
      "radius,length,start.x,start.y,start.z,axis.x,axis.y,axis.z,parent,branch\n"
      "0.1,1,0,0,0,0,0,1,0,1\n0.05,1,0,0,0,1,0,0,0,2\n0.05,1,3,0,0,0,0,1,0,3\n");
  EXPECT_EQ(bush.parent, (Nodes{kNoNode, 0, 0, kNoNode, 3}));
  EXPECT_EQ(bush.axis, (Axes16{0, 0, 1, 2, 2}));
}

TEST(NodeTable, BranchesOfTreeFilesAreAxes) {
  const Skeleton tree =
      skeleton("x,y,z,radius,parent_id,branch_id\n0,0,0,0.1,-1,0, 0,0,1,0.1,0,0, 1,0,1,0.09,1,4, 0,0,2,0.05,1,0\n");
  EXPECT_EQ(tree.axis, (Axes16{0, 0, 1, 0})) << "although the other one is thicker";
}

TEST(NodeTable, CylindersMayHaveEndsAndNumbers) {
  const Skeleton tree = skeleton(
      "ID,parentID,startX,startY,startZ,endX,endY,endZ,radius\n"
      "0,-1,0,0,0,0,0,1,0.1\n1,0,0,0,1,0,0,3,0.05\n");
  EXPECT_EQ(tree.parent, (Nodes{kNoNode, 0, 1}));
  EXPECT_EQ(tree.position[2], Vec3(0, 3, 0));
}

TEST(NodeTable, TreeFilesHaveALinePerTree) {
  const std::string trees =
      "# Tree file\nheight, x,y,z,radius,parent_id,section_id\n"
      "9, 0,0,0,0.1,-1,0, 0,0,1,0.1,0,1, 0,0,2,0.05,1,1\n"
      "4, 7,0,0,0.2,-1,0, 7,0,1,0.2,0,1\n";
  const NodeTable table = read_node_table(trees, "t.txt", {});
  EXPECT_EQ(table.form, NodeTableForm::trees);
  const Skeleton both = skeleton_of(table, {}, "t.txt");
  EXPECT_EQ(both.parent, (Nodes{kNoNode, 0, 1, kNoNode, 3}));
  EXPECT_EQ(both.position[4], Vec3(7, 1, 0));
  EXPECT_EQ(both.axis, (Axes16{0, 0, 0, 1, 1}));
}

TEST(NodeTable, FaultsHaveTheirLine) {
  EXPECT_EQ(error_of("x,y,z,radius,parrent\n0,0,0,1,-1\n"),
            "t.csv:1:1: there is no column 'parent'; expected a head line that names it; did you mean 'parrent'?");
  EXPECT_EQ(error_of("# scan\nx,y,z,radius,parent\n0,0,0,1,-1\n0,high,0,1,0\n"),
            "t.csv:4:3: 'high' in the column 'y' is not a number; expected a finite number");
  EXPECT_EQ(error_of("x,y,z,radius,parent\n0,0,0,1,-1\n0,0,1,1,7\n"),
            "t.csv:3: there is no parent 7; expected the number of another row; of roots -1, or nothing");
  EXPECT_EQ(error_of("id,x,y,z,radius,parent\n1,0,0,0,1,-1\n1,0,0,1,1,1\n"),
            "t.csv:3: the number 1 is that of line 2 already; expected a number of its own for each row");
  EXPECT_EQ(error_of("x,y,z,radius,parent\n0,0,0,1,-1\n0,0,1,1,2\n0,0,2,1,1\n"),
            "t.csv:3: the row's parents lead in a circle; expected parents that lead to a root");
  EXPECT_EQ(error_of("x,y,z,radius,parent\n0,0,0,1,0\n"),
            "t.csv:2: the row's parents lead in a circle; expected parents that lead to a root");
  EXPECT_EQ(error_of("x,y,z,radius,parent\n0,0,0,-1,-1\n"),
            "t.csv:2:7: '-1' in the column 'radius' is out of range; expected a radius or diameter from 0 to 1e+09");
  EXPECT_EQ(error_of("x,y,z,radius,parent\n0,0,0,1,-1\n3e9,0,0,1,0\n"),
            "t.csv:3: the node is too far away; expected coordinates within 1000000 m");
  EXPECT_EQ(error_of("x,y,z,radius,parent\n"), "t.csv:1:1: the file has no rows below its head line");
  EXPECT_EQ(error_of(""), "t.csv: the file has no lines; expected a head line and rows");
}

TEST(NodeTable, FaultsOfTreeFilesHaveTheirLine) {
  const std::string head = "x,y,z,radius,parent_id\n";
  EXPECT_EQ(error_of(head + "0,0,0,0.1,-1, 0,0,1,0.1\n"),
            "t.csv:2: the segment 1 of the tree has 4 numbers; expected 5, as the head line");
  EXPECT_EQ(error_of(head + "0,0,0,0.1,-1, 0,0,up,0.1,0\n"),
            "t.csv:2:19: 'up' in the segment 1 of the tree is not a number; expected z, a finite number");
  EXPECT_EQ(error_of("x,y,z,radius,parent_ld\n0,0,0,0.1,-1, 0,0,1,0.1,0\n"),
            "t.csv:1: there is no column 'parent_id'; expected a head line that names it; did you mean 'parent_ld'?");
  EXPECT_EQ(error_of(head + "0,0,0,0.1,-1, 0,0,1,0.1,5\n"),
            "t.csv:2: there is no parent 5; expected the number of another row; of roots -1, or nothing");
}

TEST(NodeTable, NumbersThatAreOutOfRangeAreRefusedWithLineAndColumn) {
  const std::string nodes = "x,y,z,radius,parent\n0,0,0,1,-1\n";
  const std::string expected_radius = " is out of range; expected a radius or diameter from 0 to 1e+09";
  EXPECT_EQ(error_of(nodes + "0,0,1,1e308,0\n"), "t.csv:3:7: '1e308' in the column 'radius'" + expected_radius);
  EXPECT_EQ(error_of(nodes + "0,-1e13,1,1,0\n"),
            "t.csv:3:3: '-1e13' in the column 'y' is out of range; expected a coordinate from -1e+12 to 1e+12");
  EXPECT_EQ(error_of(nodes + "0,0,inf,1,0\n"),
            "t.csv:3:5: 'inf' in the column 'z' is not a number; expected a finite number");
  EXPECT_EQ(error_of(nodes + "0,0,1,nan,0\n"),
            "t.csv:3:7: 'nan' in the column 'radius' is not a number; expected a finite number");
  EXPECT_EQ(error_of("x,y,z,radius,parent,birth\n0,0,0,1,-1,1e39\n"),
            "t.csv:2:12: '1e39' in the column 'birth' is out of range; expected a number from -3.4e+38 to 3.4e+38");
  EXPECT_EQ(error_of("radius,length,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent\n1e9,1e300,0,0,0,0,0,1,0\n"),
            "t.csv:2:5: '1e300' in the column 'length' is out of range; expected a coordinate from -1e+12 to 1e+12");
  const std::string trees = "x,y,z,radius,parent_id\n0,0,0,0.1,-1, 0,0,1,";
  EXPECT_EQ(error_of(trees + "1e308,0\n"), "t.csv:2:21: '1e308' in the segment 1 of the tree" + expected_radius);
}

TEST(NodeTable, RadiiAreLimitedInMetres) {
  EXPECT_EQ(error_of("x,y,z,radius,parent\n0,0,0,1e3,-1\n0,0,1,1.5e3,0\n"),
            "t.csv:3: the radius of 1500 m is too large; expected radii up to 1000 m");
  EXPECT_EQ(skeleton("x,y,z,radius,parent\n0,0,0,1e3,-1\n").radius[0], 1000);
}

/// Returns the processor time of reading a table of one stem, in ticks of std::clock().
std::clock_t ticks_of_reading(int rows) {
  std::string text = "id,parent,x,y,z\n0,-1,0,0,0\n";
  for (int k = 1; k < rows; ++k) text += fmt::format("{},{},0,0,{}\n", k, k - 1, 0.001 * k);
  const std::clock_t begin = std::clock();
  EXPECT_EQ(read_node_table(text, "t.csv", {}).node_count(), rows);
  return std::clock() - begin;
}

TEST(NodeTable, RowsWithoutBranchesAreReadInLinearTime) {
  // Ten times as many rows take ten times as long. They would take a hundred times as long in quadratic time.
  EXPECT_LT(ticks_of_reading(100'000), 40 * ticks_of_reading(10'000));
}

TEST(NodeTable, MoreNodesThanMayBeAreRefusedWhileTheyAreRead) {
  std::string many = "x,y,z,parent\n0,0,0,-1\n";
  for (int k = 0; k < 20; ++k) many += fmt::format("0,0,{},{}\n", k + 1, k);
  SizeLimits limits;
  limits.nodes = 10;
  EXPECT_EQ(
      error_of(many, limits).find("t.csv:12: 11 rows of a table are too many; expected at most 10 (limits.nodes)"), 0U)
      << error_of(many, limits);
  limits.nodes = 2;
  EXPECT_NE(error_of("x,y,z,radius,parent_id\n0,0,0,1,-1, 0,0,1,1,0, 0,0,2,1,1\n", limits).find("nodes of a file"),
            std::string::npos);
}

}  // namespace meristem::node_table_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/skeleton/skeleton_mtg.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/base/read_file.h"
#include "meristem/base/visible_text.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "tests/support/sample_plants.h"
#include "tests/support/test_data.h"

namespace meristem::skeleton_mtg_test {

std::string written(const Plant& plant, const MtgOptions& options = {}) {
  const std::string path =
      testing::TempDir() + "skeleton_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".mtg";
  Progress progress;
  write_skeleton_mtg(plant, {}, path, options, progress);
  std::string text = read_file(path, SizeLimits{}.file_bytes);
  std::filesystem::remove(path);
  return text;
}

Plant plant_of(Skeleton skeleton) {
  Plant plant;
  plant.stems.emplace_back().skeleton = std::move(skeleton);
  return plant;
}

Skeleton read(const std::string& text, const MtgGeometry& geometry = {}) {
  return skeleton_of(read_mtg(text, "plant.mtg", {}), "plant.mtg", geometry, {}).skeleton;
}

/// Returns the text from the line that names the columns.
std::string codes_of(const std::string& text) { return text.substr(text.find("ENTITY-CODE")); }

/// Checks that a written and read skeleton is equal, and that writing it again gives equal bytes.
void check_round_trip(const Skeleton& skeleton) {
  const std::string text = written(plant_of(skeleton));
  const Skeleton again = read(text);
  EXPECT_EQ(skeleton_hash(again), skeleton_hash(skeleton));
  EXPECT_EQ(axis_labels(again), axis_labels(skeleton));
  EXPECT_TRUE(written(plant_of(again)) == text);
}

/// Returns a skeleton of random shape: axes that continue late, several roots, positions and columns of all magnitudes.
Skeleton random_skeleton(const RandomKey& key, NodeIndex nodes) {
  Skeleton skeleton;
  std::vector<bool> goes_on(nodes, false);
  AxisIndex axes = 0;
  for (NodeIndex k = 0; k < nodes; ++k) {
    const bool is_root = k == 0 || key.uniform(k, 0, 1) < 0.02;
    const NodeIndex parent = is_root ? kNoNode : static_cast<NodeIndex>(key.child(1).uniform(k, 0, k));
    const double size = std::ldexp(1.0, static_cast<int>(key.child(2).uniform(k, -40, 18)));
    skeleton.add_node(parent, static_cast<float>(size) * key.child(3).direction(k), static_cast<float>(k) / 3);
    skeleton.radius[k] = static_cast<float>(key.child(4).uniform(k, 0, std::min(size, 900.0)));  // readers allow 1 km
    const bool continues = !is_root && !goes_on[parent] && key.child(5).uniform(k, 0, 1) < 0.7;
    if (continues) goes_on[parent] = true;
    skeleton.axis[k] = continues ? skeleton.axis[parent] : axes++;
    if (!is_root) skeleton.order[k] = static_cast<std::uint16_t>(skeleton.order[parent] + (continues ? 0 : 1));
  }
  std::vector<float>& light = skeleton.extra["light"];
  for (NodeIndex k = 0; k < nodes; ++k) {
    light.push_back(static_cast<float>(std::ldexp(key.child(6).uniform(k, -1, 1), static_cast<int>(k % 250) - 125)));
  }
  return skeleton;
}

TEST(SkeletonMtg, LinesAreEntitiesInTheColumnsOfTheirOrders) {
  EXPECT_EQ(codes_of(written(two_stems())),
            "ENTITY-CODE\t\tXX\tYY\tZZ\tTopDia\tnode\tbirth\tlight\tcomponent\tinstance\n"
            "/P1\n"
            "^/A0\t\t\t\t\t\t\t\t\ttree\t0\n"
            "^/B0\t\t0\t-0\t0\t0.2\t0\t0\t0\n"
            "^<S1\t\t0\t-0\t1\t0.18\t1\t1\t0.1\n"
            "\t+A1\t\t\t\t\t\t\t\ttree\t0\n"
            "\t^/S1\t0.5\t-0\t1.5\t0.08\t3\t2\t0.3\n"
            "^<S2\t\t0\t-0\t2\t0.1\t2\t2\t0.2\n"
            "/P2\n"
            "^/A2\t\t\t\t\t\t\t\t\tvine\t3\n"
            "^/B0\t\t3\t-0\t0\t0.02\t4\t0\n"
            "^<S1\t\t3\t-0\t0.1\t0.02\t5\t1\n"
            "^<S2\t\t3\t-0\t0.33333334\t2e-07\t6\t2.5\n");
}

TEST(SkeletonMtg, HeadsAreThoseOfFormA) {
  const std::string text = written(two_stems(), {Provenance{.name = "two", .seed = 5, .version = "1"}});
  EXPECT_EQ(text.substr(0, text.find("MTG:")),
            "# Meristem 1\n"
            "# name: two\n"
            "# seed: 5\n"
            "# to grow it again: meristem grow DOCUMENT -o FILE --seed 5\n"
            "# units: metres; XX east, YY north, ZZ up\n"
            "CODE:\tFORM-A\n\n"
            "CLASSES:\n"
            "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
            "$\t0\tFREE\tFREE\tIMPLICIT\n"
            "P\t1\tCONNECTED\tFREE\tIMPLICIT\n"
            "A\t2\t<-LINEAR\tFREE\tEXPLICIT\n"
            "B\t3\tNONE\tFREE\tEXPLICIT\n"
            "S\t3\tNONE\tFREE\tEXPLICIT\n\n"
            "DESCRIPTION:\n"
            "LEFT\tRIGHT\tRELTYPE\tMAX\n"
            "A\tA\t+\t?\n"
            "B\tS\t<\t1\n"
            "B\tS\t+\t?\n"
            "S\tS\t<\t1\n"
            "S\tS\t+\t?\n\n"
            "FEATURES:\n"
            "NAME\tTYPE\n"
            "XX\tREAL\nYY\tREAL\nZZ\tREAL\nTopDia\tREAL\nnode\tINT\nbirth\tREAL\nlight\tREAL\n"
            "component\tALPHA\ninstance\tINT\n\n");
}

TEST(SkeletonMtg, SegmentsHaveTheNumbersOfTheirMetamersAndAxesTheirLabels) {
  Plant plant = two_stems();
  plant.stems.resize(1);
  plant.stems[0].parts[0].component.clear();
  plant.stems[0].skeleton.extra = {{"metamer", {0, 3, 4, 1}}};
  EXPECT_EQ(codes_of(written(plant)),
            "ENTITY-CODE\t\tXX\tYY\tZZ\tTopDia\tnode\tbirth\tmetamer\tlabel\n"
            "/P1\n"
            "^/A0\t\t\t\t\t\t\t\t\tmain\n"
            "^/B0\t\t0\t-0\t0\t0.2\t0\t0\t0\n"
            "^<S3\t\t0\t-0\t1\t0.18\t1\t1\t3\n"
            "\t+A1\t\t\t\t\t\t\t\tmain.3\n"
            "\t^/S1\t0.5\t-0\t1.5\t0.08\t3\t2\t1\n"
            "^<S4\t\t0\t-0\t2\t0.1\t2\t2\t4\n");
  check_round_trip(plant.stems[0].skeleton);
}

TEST(SkeletonMtg, WhatASkeletonHasComesBackExactly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) check_round_trip(random_skeleton(RandomKey(seed), 400));
  check_round_trip(Skeleton());
}

TEST(SkeletonMtg, AxesThatNoReaderWouldFindComeBackToo) {
  Skeleton skeleton = random_skeleton(RandomKey(3), 50);
  // An axis that forks, and orders that jump.
  for (NodeIndex node = 0; node < 50; ++node) skeleton.axis[node] = std::min<AxisIndex>(skeleton.axis[node], 3);
  for (std::uint16_t& order : skeleton.order) order = static_cast<std::uint16_t>(3 * order);
  check_round_trip(skeleton);
  EXPECT_NE(written(plant_of(skeleton)).find("\tnode\taxis\torder\tbirth"), std::string::npos);
}

TEST(SkeletonMtg, StemsAreTreesOfOneForest) {
  const Plant plant = two_stems();
  Skeleton all = plant.stems[0].skeleton;
  all.append(plant.stems[1].skeleton);
  Skeleton forest = read(written(plant));
  std::vector<float>& light = forest.extra["light"];
  for (std::size_t k = 0; k < 4; ++k) EXPECT_FALSE(std::isnan(light[k]));
  for (std::size_t k = 4; k < 7; ++k) {
    EXPECT_TRUE(std::isnan(light[k])) << "the vine has no such column";
    light[k] = 0;
  }
  EXPECT_EQ(skeleton_hash(forest), skeleton_hash(all));
}

TEST(SkeletonMtg, NumbersThatAreNotKnownStayOut) {
  Skeleton skeleton = two_stems().stems[0].skeleton;
  skeleton.extra["light"] = {1e30F, std::numeric_limits<float>::quiet_NaN(), 1e-30F, 1};
  const std::string text = written(plant_of(skeleton));
  EXPECT_EQ(codes_of(text).find('+'), codes_of(text).find("+A")) << "1e30 has no plus";
  check_round_trip(skeleton);
  skeleton.extra["light"][0] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(written(plant_of(skeleton)), InputError);
}

TEST(SkeletonMtg, NamesOfComponentsAreWordsThatNoReaderTakesApart) {
  Plant plant = two_stems();
  plant.stems[0].parts[0].component = "a +b/c(d)[e]<f,g=h;1";
  plant.stems[1].parts[0].component = "a +b/c(d)[e]<f,g=h:1";
  const std::string text = written(plant);
  EXPECT_NE(text.find("\ta__b_c_d__e__f_g_h_1\t0\n"), std::string::npos);
  EXPECT_NE(text.find("\ta__b_c_d__e__f_g_h_1_2\t3\n"), std::string::npos);
}

TEST(SkeletonMtg, ColumnsWhoseNamesAFileCannotHaveAreRefused) {
  for (const char* name : {"XX", "node", "label", "a b", "", "a#", "NAME", "MTG:", "tab\t"}) {
    Skeleton skeleton = two_stems().stems[0].skeleton;
    skeleton.extra[name] = {1, 2, 3, 4};
    try {
      written(plant_of(skeleton));
      ADD_FAILURE() << "'" << name << "' is written";
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics()[0].message, "a file cannot have the column '" + visible_text(name) + "'");
    }
  }
}

/// Returns a stem whose every node bears a branch, which again bears branches: orders are as high as the number of
/// nodes.
Skeleton stairs(NodeIndex steps) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, Vec3(0), 0);
  for (NodeIndex k = 1; k <= steps; ++k) {
    for (const bool continues : {true, false}) {
      const NodeIndex bearer = k == 1 ? 0 : 2 * k - 2;
      const NodeIndex node = skeleton.add_node(bearer, Vec3(k, continues, 0), 0);
      skeleton.axis[node] = continues ? skeleton.axis[bearer] : k;
      skeleton.order[node] = static_cast<std::uint16_t>(skeleton.order[bearer] + (continues ? 0 : 1));
    }
  }
  return skeleton;
}

TEST(SkeletonMtg, LinesStayShortHoweverHighTheOrders) {
  for (const NodeIndex steps : {63U, 64U, 5000U}) {
    const Skeleton skeleton = stairs(steps);
    const std::string text = written(plant_of(skeleton));
    if (steps < 5000) check_round_trip(skeleton);
    EXPECT_EQ(skeleton_hash(read(text)), skeleton_hash(skeleton));
    EXPECT_LT(text.size(), skeleton.node_count() * 140) << steps;
  }
}

TEST(SkeletonMtg, ALongStemStaysInOneColumn) {
  const std::string text = written(long_stem(3000));
  EXPECT_EQ(text.find("\n\t"), std::string::npos);
  EXPECT_NE(text.find("\n^<S2999\t"), std::string::npos);
}

/// Two trees of each list have no coordinates. Other features replace them, since these tests check how entities are
/// joined.
std::vector<DataSet<MtgGeometry>> digitised_trees() {
  const MtgGeometry units{.length_unit = 0.01, .diameter_unit = 0.001};
  return data_sets<MtgGeometry>(
      {{"tests/data/trees/sapling.mtg", units},
       {"tests/data/trees/sapling.mtg", {}},
       {"tests/data/trees/coded_shoot.mtg", {.position = {"width", "width", "width"}, .diameter = "width"}},
       {"tests/data/trees/dated_shoot.mtg", {.position = {"Angle", "Angle", "Angle"}}}},
      {{"trees/noylum2.mtg", units},
       {"trees/noylum2.mtg", {}},
       {"trees/monopodial_plant.mtg", {.position = {"diam", "diam", "diam"}, .diameter = "diam"}},
       {"trees/simple_plant.mtg", {.position = {"XEuler", "XEuler", "XEuler"}}}});
}

TEST(SkeletonMtg, DigitisedTreesComeBack) {
  for (const auto& [file, geometry] : digitised_trees()) {
    SCOPED_TRACE(file);
    check_round_trip(read(read_file(file, SizeLimits{}.file_bytes), geometry));
  }
}

TEST(SkeletonMtg, TreesWithoutCoordinatesHaveNoSkeleton) {
  for (const std::string& file : data_files({"tests/data/trees/coded_shoot.mtg", "tests/data/trees/dated_shoot.mtg"},
                                            {"trees/monopodial_plant.mtg", "trees/simple_plant.mtg"})) {
    try {
      read(read_file(file, SizeLimits{}.file_bytes));
      ADD_FAILURE() << file;
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics()[0].message, "there is no feature 'XX'");
    }
  }
}

TEST(SkeletonMtg, HasTheSameBytesOnAnyNumberOfThreads) {
  const Plant plant = plant_of(random_skeleton(RandomKey(1), 30'000));
  const std::string expected = [&] {
    const ThreadLimit limit(1);
    return written(plant);
  }();
  for (const int threads : {2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(written(plant) == expected) << threads << " threads";
  }
}

TEST(SkeletonMtg, ReportsAFullDiskAndARefusedPath) {
  Progress progress;
  EXPECT_THROW(write_skeleton_mtg(two_stems(), {}, "/dev/full", {}, progress), MachineError);
  EXPECT_THROW(write_skeleton_mtg(two_stems(), {}, "/nonexistent/plant.mtg", {}, progress), MachineError);
}

TEST(SkeletonMtg, LeavesNothingWhenCancelled) {
  const std::string folder = testing::TempDir() + "skeleton_mtg_cancelled/";
  std::filesystem::create_directory(folder);
  Progress* self = nullptr;
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.5) self->cancel();
  });
  self = &progress;
  EXPECT_THROW(write_skeleton_mtg(long_stem(300'000), {}, folder + "plant.mtg", {}, progress), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove(folder);
}

}  // namespace meristem::skeleton_mtg_test

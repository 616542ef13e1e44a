// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/skeleton/skeleton_csv.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "tests/support/sample_plants.h"

namespace meristem::skeleton_csv_test {

std::string written(const Plant& plant) {
  const std::string path =
      testing::TempDir() + "skeleton_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
  Progress progress;
  write_skeleton_csv(plant, {}, path, progress);
  std::ifstream in(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  std::filesystem::remove(path);
  return text;
}

TEST(SkeletonCsv, IsOneRowANodeWithEmptyFieldsForWhatIsNotThere) {
  EXPECT_EQ(written(two_stems()),
            "component,instance,node,parent,x,y,z,radius,axis,order,birth,light\n"
            "tree,0,0,,0,0,0,0.1,0,0,0,0\n"
            "tree,0,1,0,0,1,0,0.09,0,0,1,0.1\n"
            "tree,0,2,1,0,2,0,0.05,0,0,2,0.2\n"
            "tree,0,3,1,0.5,1.5,0,0.04,1,1,2,0.3\n"
            "vine,3,4,,3,0,0,0.01,2,0,0,\n"
            "vine,3,5,4,3,0.1,0,0.01,2,0,1,\n"
            "vine,3,6,5,3,0.33333334,0,1e-07,2,0,2.5,\n");
}

TEST(SkeletonCsv, LabelsOfAxesComeLast) {
  Plant plant = two_stems();
  plant.stems.resize(1);
  plant.stems[0].skeleton.extra = {{"metamer", {0, 1, 2, 1}}};
  EXPECT_EQ(written(plant),
            "component,instance,node,parent,x,y,z,radius,axis,order,birth,metamer,label\n"
            "tree,0,0,,0,0,0,0.1,0,0,0,0,main\n"
            "tree,0,1,0,0,1,0,0.09,0,0,1,1,main\n"
            "tree,0,2,1,0,2,0,0.05,0,0,2,2,main\n"
            "tree,0,3,1,0.5,1.5,0,0.04,1,1,2,1,main.1\n");
}

TEST(SkeletonCsv, QuotesNamesThatHoldSeparators) {
  Plant plant = two_stems();
  plant.stems.resize(1);
  plant.stems[0].parts[0].component = "a,\"b\"\nc";
  plant.stems[0].skeleton.extra = {{"x, y", {1, 2, 3, 4}}};
  const std::string text = written(plant);
  EXPECT_EQ(text.substr(0, text.find('\n')), "component,instance,node,parent,x,y,z,radius,axis,order,birth,\"x, y\"");
  EXPECT_NE(text.find("\n\"a,\"\"b\"\"\nc\",0,0,,"), std::string::npos);
}

TEST(SkeletonCsv, NumbersReadBackAsTheSameFloats) {
  const Plant plant = long_stem(500);
  std::istringstream lines(written(plant));
  std::string line;
  std::getline(lines, line);
  for (const Vec3 position : plant.stems[0].skeleton.position) {
    ASSERT_TRUE(std::getline(lines, line));
    std::istringstream fields(line);
    std::vector<std::string> row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    ASSERT_EQ(row.size(), 11U);
    EXPECT_EQ(Vec3(std::stof(row[4]), std::stof(row[5]), std::stof(row[6])), position);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(SkeletonCsv, APlantWithoutStemsIsAHeaderAlone) {
  EXPECT_EQ(written({}), "component,instance,node,parent,x,y,z,radius,axis,order,birth\n");
}

TEST(SkeletonCsv, HasTheSameBytesOnAnyNumberOfThreads) {
  const Plant plant = long_stem(50'000);
  const std::string expected = [&] {
    const ThreadLimit limit(1);
    return written(plant);
  }();
  for (const int threads : {2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(written(plant) == expected) << threads << " threads";
  }
}

TEST(SkeletonCsv, ReportsAFullDiskAndARefusedPath) {
  Progress progress;
  EXPECT_THROW(write_skeleton_csv(two_stems(), {}, "/dev/full", progress), MachineError);
  EXPECT_THROW(write_skeleton_csv(two_stems(), {}, "/nonexistent/plant.csv", progress), MachineError);
}

TEST(SkeletonCsv, LeavesNothingWhenCancelled) {
  const std::string folder = testing::TempDir() + "skeleton_csv_cancelled/";
  std::filesystem::create_directory(folder);
  Progress* self = nullptr;
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.5) self->cancel();
  });
  self = &progress;
  EXPECT_THROW(write_skeleton_csv(long_stem(300'000), {}, folder + "plant.csv", progress), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove(folder);
}

}  // namespace meristem::skeleton_csv_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/skeleton/organ_csv.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"

namespace meristem::organ_csv_test {

/// Returns organs of two prototypes of one component and of one prototype of another, in alternation.
Plant organs(std::size_t count) {
  Plant plant;
  plant.prototypes = {{"leaf", 0, nullptr}, {"a \"b\", c", 0, nullptr}, {"leaf", 0, nullptr}};
  for (std::size_t k = 0; k < count; ++k) {
    plant.organs.push_back({.frame = {Mat3(1), {k, 0.1F, -1.0F / 3}}, .prototype = static_cast<std::uint32_t>(k % 3)});
  }
  return plant;
}

std::vector<LitOrgan> light(std::size_t count) {
  std::vector<LitOrgan> lit;
  for (std::size_t k = 0; k < count; ++k) lit.push_back({0.25, 0.5, static_cast<double>(k) / 8});
  return lit;
}

std::string written(std::size_t count) {
  const std::string path =
      testing::TempDir() + "organs_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
  Progress progress;
  write_organ_csv(organs(count), {}, light(count), path, progress);
  std::ifstream in(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  std::filesystem::remove(path);
  return text;
}

TEST(OrganCsv, IsOneRowAnOrganNumberedWithinItsComponent) {
  EXPECT_EQ(written(4),
            "component,instance,tree,x,y,z,area,exposure,irradiance\n"
            "leaf,0,,0,0.1,-0.33333334,0.25,0.5,0\n"
            "\"a \"\"b\"\", c\",0,,1,0.1,-0.33333334,0.25,0.5,0.125\n"
            "leaf,1,,2,0.1,-0.33333334,0.25,0.5,0.25\n"
            "leaf,2,,3,0.1,-0.33333334,0.25,0.5,0.375\n");
}

TEST(OrganCsv, APlantWithoutOrgansIsItsHeader) {
  EXPECT_EQ(written(0), "component,instance,tree,x,y,z,area,exposure,irradiance\n");
}

TEST(OrganCsv, TheSameBytesOnAnyNumberOfThreads) {
  const auto text = [](int threads) {
    const ThreadLimit limit(threads);
    return written(50'000);
  };
  const std::string one = text(1);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 50'001);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(text(threads), one);
}

TEST(OrganCsv, WantsLightForEachOrgan) {
  Progress progress;
  EXPECT_THROW(write_organ_csv(organs(3), {}, light(2), testing::TempDir() + "organs.csv", progress),
               std::invalid_argument);
}

TEST(OrganCsv, ARefusedPathIsAnError) {
  Progress progress;
  EXPECT_THROW(write_organ_csv(organs(3), {}, light(3), "/no/such/folder/organs.csv", progress), MachineError);
}

}  // namespace meristem::organ_csv_test

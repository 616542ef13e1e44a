// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_maker.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/dataset/dataset_in_a_test.h"
#include "tests/support/temporary_folder.h"

namespace meristem::plant_maker_test {

MadePlant make_one(const DatasetPlan& plan, std::uint64_t number, const TemporaryFolder& folder) {
  unpack_documents(plan, folder / "documents");
  std::filesystem::create_directory(folder / "out");
  PlantMaker maker(plan, builtin_components(), {.documents = folder / "documents"});
  Progress progress;
  return maker.make(number, folder / "out", progress);
}

TEST(PlantMaker, WritesTheFilesAndMeasuresThatThePlanAsksFor) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(R"({"meristem_dataset": 1, "files": [".obj", ".glb"],
    "measures": ["height"], "grid": {"tall": [0.5, 1.5]},
    "pictures": {"size": [16, 12], "samples": 1, "views": 2, "depth": "pfm", "normals": "png", "organs": true, "coco": true}})");
  const MadePlant made = make_one(plan, 1, folder);
  EXPECT_EQ(made.error, "");
  std::vector<std::string> names;
  for (const PlantFile& file : made.files) {
    names.push_back(file.path);
    EXPECT_EQ(file.hash.size(), 32U);
    EXPECT_EQ(file_content(folder.path() / "out" / std::filesystem::path(file.path).filename()).size(), file.bytes);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"plants/0000/000001.glb", "plants/0000/000001.mtl", "plants/0000/000001.obj",
                                      "plants/0000/000001_0.coco.json", "plants/0000/000001_0.depth.pfm",
                                      "plants/0000/000001_0.normals.png", "plants/0000/000001_0.organs.png",
                                      "plants/0000/000001_0.png", "plants/0000/000001_1.coco.json",
                                      "plants/0000/000001_1.depth.pfm", "plants/0000/000001_1.normals.png",
                                      "plants/0000/000001_1.organs.png", "plants/0000/000001_1.png"}));
  ASSERT_EQ(made.measures.size(), 1U);
}

TEST(PlantMaker, ScansPlantsAsThePlanSays) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(R"({"meristem_dataset": 1, "files": [{"ending": ".scan.csv",
    "instrument": {"kind": "terrestrial", "step": 1}, "around": 1}]})");
  const MadePlant made = make_one(plan, 0, folder);
  EXPECT_EQ(made.error, "");
  ASSERT_EQ(made.files.size(), 1U);
  EXPECT_EQ(made.files[0].path, "plants/0000/000000.scan.csv");
  EXPECT_GT(made.files[0].bytes, 100U);
}

TEST(PlantMaker, RecordsGrowthForFilesThatTellOfIt) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(R"({"meristem_dataset": 1, "files": [".points.csv"]})",
                                    R"({"meristem": 1, "components": {"tree": {"type": "colonize", "points": 30,
    "crown": {"ellipsoid": {"centre": [0, 1, 0], "radii": [0.5, 0.5, 0.5]}}, "iterations": 3}}})");
  const MadePlant made = make_one(plan, 0, folder);
  EXPECT_EQ(made.error, "");
  const std::string table = file_content(folder / "out/000000.points.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 31);
}

TEST(PlantMaker, MakesPlantsOfManyDocumentsInAnyOrder) {
  const std::string other = R"({"meristem": 1, "components": {"rod": {"type": "simple", "shape": "sphere"}}})";
  const DatasetPlan plan =
      read_dataset_plan(R"({"meristem_dataset": 1, "seeds": 2, "files": [".obj"]})", "plan.json", builtin_components(),
                        {.documents = {{.name = "rod", .text = kRod, .file = "rod.json", .set = {}},
                                       {.name = "ball", .text = other, .file = "b.json", .set = {}}}});
  const TemporaryFolder folder;
  unpack_documents(plan, folder / "documents");
  std::filesystem::create_directory(folder / "out");
  PlantMaker maker(plan, builtin_components(), {.documents = folder / "documents"});
  Progress progress;
  for (const std::uint64_t number : {0, 2, 1, 3, 0}) {
    const MadePlant alone = make_one(plan, number, folder);
    const MadePlant made = maker.make(number, folder / "out", progress);
    ASSERT_EQ(made.files.size(), alone.files.size());
    for (std::size_t k = 0; k < made.files.size(); ++k) EXPECT_EQ(made.files[k].hash, alone.files[k].hash) << number;
  }
}

TEST(PlantMaker, TellsAPlantThatItsValuesDoNotAllow) {
  const TemporaryFolder folder;
  const DatasetPlan plan =
      rod_plan(R"({"meristem_dataset": 1, "files": [".glb"], "grid": {"limits.triangles": [100, 2]}})");
  const MadePlant made = make_one(plan, 1, folder);
  EXPECT_NE(made.error.find("triangles"), std::string::npos) << made.error;
  EXPECT_EQ(made.error.find(folder.path().string()), std::string::npos) << "it does not say where it was made";
  EXPECT_TRUE(made.files.empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

TEST(PlantMaker, MakesTheSameWhateverWasMadeBefore) {
  const TemporaryFolder one, other;
  const DatasetPlan plan =
      rod_plan(R"({"meristem_dataset": 1, "seeds": 3, "files": [".glb"], "vary": {"tall": {"uniform": [0.5, 2]}}})");
  const MadePlant alone = make_one(plan, 2, one);
  unpack_documents(plan, other / "documents");
  PlantMaker maker(plan, builtin_components(), {.documents = other / "documents"});
  Progress progress;
  for (const std::uint64_t number : {0U, 1U, 2U}) {
    std::filesystem::create_directory(other / std::to_string(number));
    const MadePlant made = maker.make(number, other / std::to_string(number), progress);
    EXPECT_EQ(made.files == alone.files, number == 2);
  }
}

}  // namespace meristem::plant_maker_test

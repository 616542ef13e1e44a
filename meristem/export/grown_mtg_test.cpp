// SPDX-License-Identifier: Apache-2.0
// Multiscale tree graphs of plants that were grown from documents.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/read_file.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/document/models.h"
#include "meristem/output/skeleton/skeleton_mtg.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/mtg/mtg_skeleton.h"

namespace meristem::grown_mtg_test {

std::string written(const Plant& plant) {
  const std::string path =
      testing::TempDir() + "grown_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".mtg";
  Progress progress;
  write_skeleton_mtg(plant, {}, path, {}, progress);
  std::string text = read_file(path, SizeLimits{}.file_bytes);
  std::filesystem::remove(path);
  return text;
}

Skeleton read(const std::string& text) {
  return skeleton_of(read_mtg(text, "plant.mtg", {}), "plant.mtg", {}, {}).skeleton;
}

TEST(GrownMtg, TellsWhatWasCutAndWhatIsPlanned) {
  const auto skeleton_that = [](bool plans) {
    const std::string text =
        R"({"meristem": 1, "seed": 1, "components": {"tree": {"type": "organize", "iterations": 9, "length": 0.1,
            "operations": [{"do": "cut", "from": 6, "every": 3, "shoots": "rank == 1 && length > 0.2", "above": 1}],
            "plan": )" +
        std::string(plans ? "true" : "false") + "}}}";
    Progress progress;
    const Document document = read_document(text, "pruned.json", builtin_components());
    const Plant plant = grow_document(document, progress, {.up_to = GrownPart::plant}).plant;
    const Skeleton again = read(written(plant));
    const Skeleton& grown = plant.stems.at(0).skeleton;
    for (const char* const column : {"cut_at", "cut_metamers", "cut_length", "cut_wood", "cut_light", "rank"}) {
      EXPECT_EQ(again.extra.at(column), grown.extra.at(column)) << column;
    }
    EXPECT_GT(*std::ranges::max_element(again.extra.at("cut_metamers")), 0);
    return again;
  };
  EXPECT_EQ(skeleton_that(false).extra.count("plan_cut"), 0U);
  const std::vector<float> plan = skeleton_that(true).extra.at("plan_cut");
  EXPECT_GT(std::ranges::count(plan, 1.0F), 0);
  EXPECT_GT(std::ranges::count(plan, 0.0F), 0);
}

/// Checks that a plant's file restores its stems as one skeleton.
void check_grown(const Document& document) {
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  Skeleton all;
  for (const Stem& stem : grown.plant.stems) all.append(stem.skeleton);
  Skeleton forest = read(written(grown.plant));
  // An attribute that a stem lacks is unknown here, but 0 in a skeleton to which the stem was appended.
  for (auto& [name, values] : forest.extra) {
    const auto is_unknown = [](float value) { return std::isnan(value); };
    std::replace_if(values.begin(), values.end(), is_unknown, 0.0F);
  }
  EXPECT_GT(forest.node_count(), 10U);
  EXPECT_EQ(skeleton_hash(forest), skeleton_hash(all));
  EXPECT_EQ(axis_labels(forest), axis_labels(all));
}

TEST(GrownMtg, GrownPlantsComeBack) {
  for (const char* model : {"maple", "oak", "fern", "mint", "low-poly-palm"}) {
    SCOPED_TRACE(model);
    const std::string file = model_path(std::string(MERISTEM_SOURCE_DIR) + "/models", model);
    check_grown(read_document(read_text_file(file), file, builtin_components(), {}));
  }
}

TEST(GrownMtg, TreesThatNumberTheirMetamersComeBack) {
  check_grown(read_document(R"({"meristem": 1, "components": {"tree": {
    "type": "organize", "iterations": 9, "length": 0.1, "roots": [[0, 0, 0], [2, 0, 0]], "phyllotaxis": "decussate",
    "shedding": {"below": 0.2}, "operations": [{"at": 4, "do": "cut", "shoots": "main", "above": 3}]}}})",
                            "tree.json", builtin_components(), {}));
}

}  // namespace meristem::grown_mtg_test

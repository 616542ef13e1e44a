// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/dataset_folder.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/dataset/dataset_in_a_test.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/verify_dataset.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/temporary_folder.h"

namespace meristem::dataset_folder_test {

namespace fs = std::filesystem;

constexpr const char* kRods = R"({"meristem_dataset": 1, "name": "Rods", "licence": "CC0-1.0", "seeds": 25, "rows": 10,
  "files": [".ply"], "measures": ["height"], "vary": {"tall": {"uniform": [0.5, 2]}}})";

std::string error_of(const DatasetPlan& plan, const std::string& path,
                     DatasetOpening opening = DatasetOpening::resume) {
  try {
    Progress progress;
    const DatasetFolder folder(plan, path, opening, progress);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

std::vector<std::string> verified(const std::string& path) {
  Progress progress;
  return verify_dataset(path, builtin_components(), "", progress).errors;
}

TEST(DatasetFolder, IsTheSameInOneGoAndInPieces) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  EXPECT_EQ(make_plants(plan, folder / "whole"), 25U);
  EXPECT_GE(make_plants(plan, folder / "pieces", 4), 4U);
  make_plants(plan, folder / "pieces", 9);
  make_plants(plan, folder / "pieces");
  EXPECT_EQ(make_plants(plan, folder / "pieces"), 0U);
  const auto whole = files_below(folder / "whole");
  EXPECT_EQ(files_below(folder / "pieces"), whole);
  EXPECT_EQ(whole.size(), 25 + 2 * 3 + 5U)
      << "plants, tables and their hashes, dataset.json, two plans, document, card";
  EXPECT_TRUE(verified(folder / "whole").empty());
  EXPECT_FALSE(fs::exists(folder / "whole/partial/rows"));
}

TEST(DatasetFolder, IsTheSameFromPlantsThatWereMadeApart) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "whole");
  Progress progress;
  DatasetFolder apart(plan, folder / "apart", DatasetOpening::fresh, progress);
  unpack_documents(plan, folder / "worker");
  PlantMaker maker(plan, builtin_components(), {.documents = folder / "worker"});
  while (const auto range = apart.next()) {
    put_range(make_range_apart(maker, plan, *range, folder / "scratch", progress), plan, folder / "apart");
    apart.add(*range, 0.1);
  }
  apart.finish(progress);
  EXPECT_EQ(files_below(folder / "apart"), files_below(folder / "whole"));
}

TEST(DatasetFolder, IsAPlanOfItsOwn) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods", 5);
  const std::string file = folder / "rods/plan.json";
  const DatasetPlan again = read_dataset_plan(file_content(file), file, builtin_components());
  EXPECT_EQ(again.hash, plan.hash);
  make_plants(again, folder / "rods");
  make_plants(plan, folder / "whole");
  EXPECT_EQ(files_below(folder / "rods"), files_below(folder / "whole"));
}

TEST(DatasetFolder, MakesAgainWhatIsMissingOrHasAnotherSize) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  const auto whole = files_below(folder / "rods");
  fs::remove(folder / "rods/plants/0000/000003.ply");
  write_content(folder / "rods/plants/0000/000017.ply", "short");
  EXPECT_EQ(verified(folder / "rods").size(), 2U);
  EXPECT_EQ(make_plants(plan, folder / "rods"), 2U);
  EXPECT_EQ(files_below(folder / "rods"), whole);
}

TEST(DatasetFolder, RepairsABitThatHasTurned) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  const auto whole = files_below(folder / "rods");
  std::string bytes = file_content(folder / "rods/plants/0000/000020.ply");
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  write_content(folder / "rods/plants/0000/000020.ply", bytes);
  const auto errors = verified(folder / "rods");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("000020.ply has other bytes"), std::string::npos);
  EXPECT_EQ(make_plants(plan, folder / "rods"), 0U) << "sizes are right";
  EXPECT_EQ(make_plants(plan, folder / "rods", kMaxPlants, DatasetOpening::repair), 1U);
  EXPECT_EQ(files_below(folder / "rods"), whole);
}

TEST(DatasetFolder, RepairsTablesOfTheManifest) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  const auto whole = files_below(folder / "rods");
  std::string table = whole.at("manifest/00001.csv");
  table.resize(table.size() - 40);
  write_content(folder / "rods/manifest/00001.csv", table);
  fs::remove(folder / "rods/manifest/00002.csv");
  EXPECT_FALSE(verified(folder / "rods").empty());
  EXPECT_EQ(make_plants(plan, folder / "rods"), 6U) << "one row and a table of five";
  EXPECT_EQ(files_below(folder / "rods"), whole);
}

TEST(DatasetFolder, FindsStrangeFilesAndChangedDocuments) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  write_content(folder / "rods/plants/0000/stranger.ply", "");
  write_content(folder / "rods/documents/rod/rod.json", "{}");
  const auto errors = verified(folder / "rods");
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NE(errors[0].find("documents/rod/rod.json has changed"), std::string::npos);
  EXPECT_NE(errors[1].find("stranger.ply belongs to no row"), std::string::npos);
}

TEST(DatasetFolder, RepairsDocumentsAndRemovesStrangers) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  const auto whole = files_below(folder / "rods");
  write_content(folder / "rods/documents/rod/rod.json", "{}");
  write_content(folder / "rods/documents/rod/more.json", "{}");
  write_content(folder / "rods/plan.json", "{");
  write_content(folder / "rods/plants/0000/stranger.ply", "");
  write_content(folder / "rods/plants/0000/000003.ply", "ply");
  Progress progress;
  {
    const DatasetFolder opened(plan, folder / "rods", DatasetOpening::repair, progress);
    EXPECT_EQ(opened.error_count(), 5U);
    EXPECT_EQ(opened.found(), 24U);
  }
  make_plants(plan, folder / "rods");
  EXPECT_EQ(files_below(folder / "rods"), whole);
  EXPECT_TRUE(verified(folder / "rods").empty());
}

TEST(DatasetFolder, FilesThatAKilledProgramLeftHalfWrittenAreNoFaults) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  const auto whole = files_below(folder / "rods");
  write_content(folder / "rods/plants/0000/.000003.ply.4711-0.part", "ply");
  write_content(folder / "rods/documents/rod/.rod.json.4711-1.part", "{");
  EXPECT_TRUE(verified(folder / "rods").empty());
  Progress progress;
  EXPECT_EQ(DatasetFolder(plan, folder / "rods", DatasetOpening::repair, progress).error_count(), 0U);
  EXPECT_EQ(files_below(folder / "rods"), whole) << "they are removed";
}

TEST(DatasetFolder, TellsWhereADamagedDocumentOfItsOwnComesFrom) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  write_content(folder / "rods/documents/rod/rod.json", std::string(kRod) + " ");
  const std::string file = folder / "rods/plan.json";
  const DatasetPlan own = read_dataset_plan(file_content(file), file, builtin_components());
  EXPECT_NE(error_of(own, folder / "rods", DatasetOpening::repair).find("meristem dataset PLAN -o"), std::string::npos);
  EXPECT_EQ(error_of(plan, folder / "rods", DatasetOpening::repair), "");
  EXPECT_TRUE(verified(folder / "rods").empty());
}

TEST(DatasetFolder, IsCheckedPlantByPlantAndCanBeStopped) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(R"({"meristem_dataset": 1, "seeds": 60, "files": [".csv"]})");
  make_plants(plan, folder / "rods");
  for (const bool repairs : {false, true}) {
    Progress* asked = nullptr;
    int told = 0;
    Progress progress([&](std::string_view, double share) {
      if (share > 0) ++told;
      if (share >= 0.3) asked->cancel();
    });
    asked = &progress;
    const ThreadLimit one(1);
    const auto check = [&] {
      if (repairs) {
        const DatasetFolder opened(plan, folder / "rods", DatasetOpening::repair, progress);
      } else {
        verify_dataset(folder / "rods", builtin_components(), "", progress);
      }
    };
    EXPECT_THROW(check(), Cancelled);
    EXPECT_GT(told, 10);
  }
}

TEST(DatasetFolder, KeepsTheRowThatTellsWhatTheFilesAre) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods");
  const auto whole = files_below(folder / "rods");
  const std::string& table = whole.at("manifest/00000.csv");
  const std::size_t header = table.find('\n') + 1;
  std::string stale = table.substr(0, table.find('\n', header) + 1);
  const std::size_t hash = stale.find(',', stale.find("plants/0000") + 20);
  std::size_t digit = stale.find_first_of("0123456789abcdef", stale.find(',', hash + 1) + 1);
  stale[digit] = stale[digit] == '0' ? '1' : '0';
  fs::remove(folder / "rods/manifest/00000.csv");
  fs::create_directories(folder / "rods/partial/rows");
  write_content(folder / "rods/partial/rows/0000000000-0000000001.csv", stale);
  write_content(folder / "rods/partial/rows/0000000000-0000000010.csv", table);
  EXPECT_EQ(make_plants(plan, folder / "rods"), 0U);
  EXPECT_EQ(file_content(folder / "rods/manifest/00000.csv"), table);
}

TEST(DatasetFolder, RefusesWhatIsNotItsOwnAndChangesNothing) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "rods", 5);
  const auto before = files_below(folder / "rods");
  const DatasetPlan other = rod_plan(R"({"meristem_dataset": 1, "seeds": 3, "files": [".ply"]})");
  EXPECT_NE(error_of(other, folder / "rods").find("another plan: 'Rods', 25 plants"), std::string::npos);
  const DatasetPlan edited = rod_plan(kRods, std::string(kRod) + " ");
  EXPECT_NE(error_of(edited, folder / "rods").find("the document 'rod' or a file that it names has changed"),
            std::string::npos);
  EXPECT_NE(error_of(plan, folder / "rods", DatasetOpening::fresh).find("holds a data set already"), std::string::npos);
  EXPECT_EQ(files_below(folder / "rods"), before);

  fs::create_directory(folder / "mine");
  write_content(folder / "mine/letters.txt", "dear");
  EXPECT_NE(error_of(plan, folder / "mine").find("holds 'letters.txt' and no data set"), std::string::npos);
  EXPECT_EQ(files_below(folder / "mine").size(), 1U);
  EXPECT_NE(error_of(plan, folder / "mine/letters.txt").find("this is a file"), std::string::npos);
}

TEST(DatasetFolder, GoesOnAfterAFullDisk) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  make_plants(plan, folder / "whole");
  make_plants(plan, folder / "rods", 3);
  {
    const FileSizeLimit full(100);
    EXPECT_THROW(make_plants(plan, folder / "rods"), MachineError);
  }
  make_plants(plan, folder / "rods");
  EXPECT_EQ(files_below(folder / "rods"), files_below(folder / "whole"));
}

TEST(DatasetFolder, SizesRangesByTimeWithinATable) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(kRods);
  Progress progress;
  DatasetFolder dataset(plan, folder / "rods", DatasetOpening::fresh, progress);
  EXPECT_EQ(dataset.next(), (PlantRange{0, 1}));
  PlantMaker maker(plan, builtin_components(), {.documents = folder / "rods/documents"});
  make_range(maker, plan, {0, 1}, folder / "rods", progress);
  dataset.add({0, 1}, 0.1);
  EXPECT_EQ(dataset.next(100), (PlantRange{1, 3})) << "twice the largest so far";
  make_range(maker, plan, {1, 3}, folder / "rods", progress);
  dataset.add({1, 3}, 0.2);
  EXPECT_EQ(dataset.next(0.35), (PlantRange{3, 6}));
  make_range(maker, plan, {3, 6}, folder / "rods", progress);
  dataset.add({3, 6}, 0.3);
  EXPECT_EQ(dataset.next(100), (PlantRange{6, 10})) << "no range crosses the end of a table";
}

TEST(DatasetFolder, HasACardWithCountsAndHistograms) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(
      R"({"meristem_dataset": 1, "name": "Rods | <b>long</b>", "description": "# Not a [heading](x)\nand no <script>",
    "author": "*me*", "licence": "CC0-1.0", "seeds": 5,
    "files": [".ply"], "measures": ["triangles"], "grid": {"limits.triangles": [1000, 2]}})");
  make_plants(plan, folder / "rods");
  const std::string card = file_content(folder / "rods/README.md");
  EXPECT_TRUE(
      card.starts_with("# Rods \\| &lt;b&gt;long&lt;/b&gt;\n\n\\# Not a \\[heading\\](x) and no &lt;script&gt;\n\n"));
  EXPECT_NE(card.find("| Plants | 10 |\n| of them failed | 5 |"), std::string::npos) << card;
  EXPECT_NE(card.find("| `.ply` | 5 | "), std::string::npos);
  EXPECT_NE(card.find("CC0-1.0"), std::string::npos);
  EXPECT_NE(card.find("| Author | \\*me\\* |"), std::string::npos);
  EXPECT_NE(card.find("### triangles\n\n5 numbers from 12 to 12"), std::string::npos) << card;
  EXPECT_NE(card.find("- 000005: "), std::string::npos);
}

}  // namespace meristem::dataset_folder_test

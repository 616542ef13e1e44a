// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/dataset_plan.h"

#include <set>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/dataset/dataset_in_a_test.h"
#include "tests/support/check_sentence.h"
#include "tests/support/temporary_folder.h"

namespace meristem::dataset_plan_test {

std::vector<Diagnostic> errors_of(const std::string& text) {
  try {
    rod_plan(text);
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

double length_of(const PlannedPlant& plant) {
  for (const auto& [path, value] : plant.values) {
    if (path == "tall") return *value.number();
  }
  return 0;
}

TEST(DatasetPlan, RunsThroughSeedsFastest) {
  const DatasetPlan plan = rod_plan(R"({"meristem_dataset": 1, "seeds": [7, 9], "files": [".csv"],
    "grid": {"tall": [1, 2], "rod.size[0]": [0.1, 0.2, 0.3]}})");
  ASSERT_EQ(plan.count(), 12U);
  EXPECT_EQ(plan.columns, (std::vector<std::string>{"tall", "rod.size[0]"}));
  EXPECT_EQ(plan.plant(0).key, "000000");
  EXPECT_EQ(plan.plant(1).seed, 9U);
  EXPECT_EQ(plan.plant(2).seed, 7U);
  EXPECT_EQ(plan.plant(2).values, (PathValues{{"tall", 1}, {"rod.size[0]", 0.2}}));
  EXPECT_EQ(plan.plant(11).values, (PathValues{{"tall", 2}, {"rod.size[0]", 0.3}}));
  EXPECT_THROW(plan.plant(12), std::invalid_argument);
}

TEST(DatasetPlan, DrawsEachPlantByItsOwnKey) {
  const char* const few = R"({"meristem_dataset": 1, "seeds": 100, "files": [".csv"],
    "vary": {"tall": {"normal": [1, 1]}, "rod.size[0]": {"uniform": [0.1, 0.2]}}})";
  const char* const many = R"({"meristem_dataset": 1, "seeds": {"first": 51, "count": 1000}, "files": [".csv"],
    "vary": {"rod.size[0]": {"uniform": [0.1, 0.2]}, "tall": {"normal": [1, 1]}}})";
  const DatasetPlan one = rod_plan(few);
  const DatasetPlan other = rod_plan(many);
  std::set<double> lengths;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const double length = length_of(one.plant(k));
    EXPECT_GE(length, 0.5) << "the range of the variable";
    EXPECT_LE(length, 2);
    lengths.insert(length);
  }
  EXPECT_EQ(lengths.size(), 100U);
  EXPECT_EQ(length_of(one.plant(50)), length_of(other.plant(0))) << "seed 51 of both";
}

TEST(DatasetPlan, DrawsTheSameForAListOfSeedsAndForTheirCount) {
  const std::string rest = R"(, "files": [".csv"], "vary": {"tall": {"uniform": [0.5, 2]}}})";
  const DatasetPlan list = rod_plan(R"({"meristem_dataset": 1, "seeds": [1, 2, 3])" + rest);
  const DatasetPlan row = rod_plan(R"({"meristem_dataset": 1, "seeds": {"first": 1, "count": 3})" + rest);
  for (std::uint64_t k = 0; k < 3; ++k) EXPECT_EQ(list.plant(k).values, row.plant(k).values);
}

TEST(DatasetPlan, TellsTheNearestNameOfADocumentThatIsMissing) {
  const TemporaryFolder folder;
  write_content(folder / "rod.json", kRod);
  try {
    read_dataset_plan(R"({"meristem_dataset": 1, "measures": ["height"], "documents": ["rood.json"]})",
                      folder / "plan.json", builtin_components());
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    EXPECT_EQ(error.diagnostics()[0].path, "documents[0]");
    EXPECT_EQ(error.diagnostics()[0].nearest, "rod.json");
  }
}

TEST(DatasetPlan, ReadsDocumentsFromItsFolder) {
  const TemporaryFolder folder;
  write_content(folder / "rod.json", kRod);
  const std::string text = R"({"meristem_dataset": 1, "measures": ["height"],
    "documents": ["rod.json", {"file": "rod.json", "name": "long", "set": {"tall": 2}}]})";
  const DatasetPlan plan = read_dataset_plan(text, folder / "plan.json", builtin_components());
  ASSERT_EQ(plan.documents.size(), 2U);
  EXPECT_EQ(plan.documents[0].name, "rod");
  EXPECT_EQ(plan.documents[1].name, "long");
  EXPECT_EQ(plan.documents[1].title, "Rod");
  EXPECT_EQ(plan.count(), 2U);
}

TEST(DatasetPlan, HasAnotherHashOnlyWhereItMakesSomethingElse) {
  const std::string plain = rod_plan(R"({"meristem_dataset": 1, "seeds": 3, "files": [".csv"]})").hash;
  EXPECT_EQ(rod_plan(R"({"meristem_dataset": 1, /* more */ "name": "Rods", "seeds": 3, "files": [".csv"]})").hash,
            plain);
  EXPECT_NE(rod_plan(R"({"meristem_dataset": 1, "seeds": 4, "files": [".csv"]})").hash, plain);
}

TEST(DatasetPlan, TellsFaultsWithPlaceAndNearestName) {
  const auto errors = errors_of(
      "{\"meristem_dataset\": 1,\n \"seedz\": 3,\n \"files\": [\".gbl\"],\n"
      " \"measures\": [\"hight\"]}");
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0].file, "plan.json");
  EXPECT_EQ(errors[0].line, 2);
  EXPECT_EQ(errors[0].nearest, "seeds");
  EXPECT_EQ(errors[1].line, 3);
  EXPECT_EQ(errors[1].nearest, ".glb");
  EXPECT_EQ(errors[2].line, 4);
  EXPECT_EQ(errors[2].nearest, "height");
}

TEST(DatasetPlan, TellsValuesThatDoNotSuitADocumentWhereTheyStand) {
  const auto errors = errors_of(
      "{\"meristem_dataset\": 1, \"files\": [\".csv\"],\n \"set\": {\"talll\": 1},\n"
      " \"grid\": {\"rod.size[0]\": [0.1, \"wide\"]}}");
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors[0].line, 2);
  EXPECT_EQ(errors[0].nearest, "tall");
  const auto second = errors_of(
      "{\"meristem_dataset\": 1, \"files\": [\".csv\"],\n"
      " \"grid\": {\"rod.size[0]\":\n [0.1, \"wide\"]}}");
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].path, "grid.rod.size[0][1]");
  EXPECT_EQ(second[0].line, 3);
}

TEST(DatasetPlan, RefusesWhatItCannotMean) {
  const std::string head = R"({"meristem_dataset": 1, "files": [".csv"], )";
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"({"meristem_dataset": 1})", ""},
      {head + R"("seeds": 0})", "seeds"},
      {head + R"("seeds": [1, 1]})", "seeds[1]"},
      {head + R"("seeds": {"first": 3}})", "seeds"},
      {head + R"("seeds": {"count": "x"}})", "seeds.count"},
      {head + R"("set": {"seed": 3}})", "set.seed"},
      {head + R"("set": {"tall": 1}, "grid": {"tall": [1, 2]}})", "set.tall"},
      {head + R"("grid": {"tall": []}})", "grid.tall"},
      {head + R"("grid": {"tall": [1]}, "samples": [{"tall": 1}]})", "samples"},
      {head + R"("samples": [3]})", "samples[0]"},
      {head + R"("vary": {"tall": {"uniform": [50, 60]}}})", "vary.tall"},
      {head + R"("grid": {"tall": [1]}, "vary": {"tall": {"uniform": [1, 2]}}})", "vary.tall"},
      {head + R"("pictures": {"colour": "none"}})", "pictures"},
      {head + R"("pictures": {"colour": "jpg", "transparent": true}})", "pictures.colour"},
      {head + R"("pictures": {"views": [[10, 100]]}})", "pictures.views[0]"},
      {head + R"("pictures": {"views": [[10, 10]], "azimuth": {"uniform": [0, 90]}}})", "pictures.azimuth"},
      {head + R"("seeds": 1000000000, "grid": {"tall": [1, 2]}})", ""},
      {R"({"meristem_dataset": 1, "files": [{"ending": ".csv", "scale": 2}]})", "files[0].scale"},
      {R"({"meristem_dataset": 1, "files": [".csv", ".csv"]})", "files[1]"},
      {R"({"meristem_dataset": 1, "files": [{"ending": ".scan.las", "instrument": "dron"}]})", "files[0].instrument"},
      {R"({"meristem_dataset": 1, "files": [{"ending": ".scan.las", "aroun": 3}]})", "files[0].aroun"},
  };
  for (const auto& [text, path] : cases) {
    const auto errors = errors_of(text);
    ASSERT_EQ(errors.size(), 1U) << text;
    EXPECT_EQ(errors[0].path, path) << text;
    EXPECT_EQ(errors[0].file, "plan.json") << text;
    EXPECT_FALSE(errors[0].expected.empty()) << text;
  }
}

TEST(DatasetPlan, HasSentencesForItsRows) {
  for (const ParameterTable* table : {&plan_table(), &picture_plan_table()}) {
    for (const Parameter& row : table->parameters) EXPECT_EQ(sentence_error(row.doc), "") << row.name;
  }
}

}  // namespace meristem::dataset_plan_test

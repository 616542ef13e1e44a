// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/verify_dataset.h"

#include <filesystem>
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/dataset/dataset_in_a_test.h"
#include "meristem/dataset/dataset_links.h"
#include "meristem/dataset/table_hashes.h"
#include "meristem/document/json.h"
#include "tests/support/temporary_folder.h"

namespace meristem::verify_dataset_test {

namespace fs = std::filesystem;

constexpr const char* kRods = R"({"meristem_dataset": 1, "name": "Rods", "licence": "CC0-1.0", "seeds": 25, "rows": 10,
  "files": [".ply"], "measures": ["height", "triangles"], "vary": {"tall": {"uniform": [0.5, 2]}}})";

/// A stem whose height is the value that its plan draws.
constexpr const char* kStem = R"({"meristem": 1, "variables": {"tall": {"value": 1, "min": 0.5, "max": 2}},
  "components": {"rod": {"type": "tree", "length": "tall", "radius": 0.02, "segments": 4}}})";

DatasetPlan stem_plan(const std::string& text = kRods) { return rod_plan(text, kStem); }

DatasetCheck checked(const std::string& path, const DatasetCheckOptions& options = {}) {
  Progress progress;
  return verify_dataset(path, builtin_components(), "", progress, options);
}

std::vector<std::string> verified(const std::string& path) { return checked(path).errors; }

/// The folder's own plan, as the command line reads it for a repair.
DatasetPlan own_plan(const std::string& path) {
  return read_dataset_plan(begun_plan_text(path), folder_plan_path(path), builtin_components());
}

std::uint64_t repaired(const DatasetPlan& plan, const std::string& path) {
  return make_plants(plan, path, kMaxPlants, DatasetOpening::repair);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

/// The lines of a table, with their line ends.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::string_view rest = text;
  while (!rest.empty()) lines.emplace_back(std::string(take_line(rest)) + "\n");
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

/// A line with another field at a place; of a table without quotes.
std::string with_field(const std::string& line, std::size_t field,
                       const std::function<std::string(std::string)>& change) {
  std::size_t begin = 0;
  for (std::size_t k = 0; k < field; ++k) begin = line.find(',', begin) + 1;
  const std::size_t end = line.find_first_of(",\n", begin);
  return line.substr(0, begin) + change(line.substr(begin, end - begin)) + line.substr(end);
}

std::string field_of(const std::string& line, std::size_t field) {
  std::string found;
  with_field(line, field, [&found](std::string text) { return found = std::move(text); });
  return found;
}

std::string other_digit(std::string text) {
  const std::size_t digit = text.find_last_of("0123456789");
  text[digit] = text[digit] == '1' ? '2' : '1';
  return text;
}

// key, document, seed, tall, files, bytes, hashes, version, error, height, triangles
constexpr std::size_t kTall = 3;
constexpr std::size_t kHeight = 9;

/// The dataset.json of a whole set as the program wrote it before tables had hashes.
std::string as_of_format_1(const std::string& plan, const std::string& document) {
  return fmt::format(
      "{{\n  \"meristem_dataset_folder\": 1,\n  \"version\": \"0.1.0\",\n  \"name\": \"Rods\",\n"
      "  \"plan\": \"{}\",\n  \"plants\": 25,\n  \"rows\": 10,\n  \"documents\": [{{\"name\": "
      "\"rod\", \"document\": \"rod.json\", \"hash\": \"{}\"}}]\n}}\n",
      plan, document);
}

/// A way to damage a data set, the expected fault, and the number of plants that are made again.
struct Damage {
  const char* name;
  const char* file;
  std::function<std::string(const std::string&)> change;
  std::vector<std::string> told;
  std::uint64_t made;
};

std::vector<Damage> damages() {
  const auto in_lines = [](auto change) {
    return [change](const std::string& text) {
      std::vector<std::string> lines = lines_of(text);
      change(lines);
      return joined(lines);
    };
  };
  const char* const table = "manifest/00001.csv";
  return {
      {"one digit of a measure",
       table,
       in_lines([](auto& lines) { lines[4] = with_field(lines[4], kHeight, other_digit); }),
       {"manifest/00001.csv:5: row 000013, column 'height' ('"},
       1},
      {"one digit of a drawn value",
       table,
       in_lines([](auto& lines) { lines[4] = with_field(lines[4], kTall, other_digit); }),
       {"manifest/00001.csv:5: row 000013, column 'tall': '"},
       1},
      {"measures of two rows exchanged",
       table,
       in_lines([](auto& lines) {
         const std::string first = field_of(lines[2], kHeight);
         const std::string second = field_of(lines[7], kHeight);
         lines[2] = with_field(lines[2], kHeight, [&](const std::string&) { return second; });
         lines[7] = with_field(lines[7], kHeight, [&](const std::string&) { return first; });
       }),
       {"00001.csv:3: row 000011, column 'height'", "00001.csv:8: row 000016, column 'height'"},
       2},
      {"drawn values of two rows exchanged",
       table,
       in_lines([](auto& lines) {
         const std::string first = field_of(lines[2], kTall);
         const std::string second = field_of(lines[7], kTall);
         lines[2] = with_field(lines[2], kTall, [&](const std::string&) { return second; });
         lines[7] = with_field(lines[7], kTall, [&](const std::string&) { return first; });
       }),
       {"00001.csv:3: row 000011, column 'tall'", "00001.csv:8: row 000016, column 'tall'"},
       2},
      {"seed",
       table,
       in_lines([](auto& lines) { lines[1] = with_field(lines[1], 2, other_digit); }),
       {"00001.csv:2: row 000010, column 'seed': '"},
       1},
      {"version",
       table,
       in_lines([](auto& lines) { lines[1] = with_field(lines[1], 7, other_digit); }),
       {"00001.csv:2: row 000010, column 'version' ('"},
       1},
      {"an error that never was",
       table,
       in_lines([](auto& lines) { lines[1] = with_field(lines[1], 8, [](const std::string&) { return "no"; }); }),
       {"00001.csv:2: row 000010, column 'error' ('no')"},
       1},
      {"rows exchanged",
       table,
       in_lines([](auto& lines) { std::swap(lines[2], lines[3]); }),
       {"00001.csv:3: the row 000012 follows the row of the plant 10", ":4: the row 000011 follows",
        ":5: the row 000013"},
       0},
      {"a row twice",
       table,
       in_lines([](auto& lines) { lines.insert(lines.begin() + 2, lines[2]); }),
       {"00001.csv:4: the row 000011 stands twice"},
       0},
      {"a row is missing",
       table,
       in_lines([](auto& lines) { lines.erase(lines.begin() + 2); }),
       {"00001.csv:3: the row 000012 follows", "00001.csv: the row of the plant 11 is missing",
        "000011.ply belongs to no row"},
       1},
      {"a row of another table",
       table,
       in_lines([](auto& lines) { lines.push_back("000003" + lines[2].substr(6)); }),
       {"00001.csv:12: the row of the plant 000003 belongs to another table"},
       0},
      {"a label",
       table,
       [](const std::string& text) { return replaced(text, "height", "width"); },
       {"00001.csv:1: the label of column 10 is 'width'; expected 'height'"},
       0},
      {"the last line end",
       table,
       [](const std::string& text) { return text.substr(0, text.size() - 1); },
       {"00001.csv:11: this is no row", "the row of the plant 19 is missing", "000019.ply belongs to no row"},
       1},
      {"an empty line at the end",
       table,
       [](const std::string& text) { return text + "\n"; },
       {"00001.csv:12: this is no row"},
       0},
      {"the plan",
       "plan.json",
       [](const std::string& text) { return replaced(text, "25", "26"); },
       {"plan.json: the plan has changed since the data set was begun: 'seeds' is '26', and was '25'"},
       0},
      {"the licence in the plan",
       "plan.json",
       [](const std::string& text) { return replaced(text, "CC0", "CC1"); },
       {"'licence' is '\"CC1-1.0\"', and was '\"CC0-1.0\"'"},
       0},
      {"a plan that is no plan",
       "plan.json",
       [](const std::string&) { return "{"; },
       {"plan.json: the plan has changed since the data set was begun: "},
       0},
      {"the copy of the plan",
       "checks/plan.json",
       [](const std::string& text) { return text + " "; },
       {"checks/plan.json has other bytes than were written"},
       0},
      {"hashes of rows",
       "checks/00001.csv",
       [](const std::string& text) { return replaced(text, "row,", "tow,"); },
       {"checks/00001.csv has other bytes than were written"},
       0},
      {"the data card",
       "README.md",
       [](const std::string& text) { return text + "\n"; },
       {"README.md has other bytes than were written"},
       0},
      {"plants in dataset.json",
       "dataset.json",
       [](const std::string& text) { return replaced(text, "\"plants\": 25", "\"plants\": 24"); },
       {"dataset.json: 'plants' is 24; the plan says 25"},
       0},
      {"the format in dataset.json",
       "dataset.json",
       [](const std::string& text) {
         return replaced(text, "\"meristem_dataset_folder\": 2", "\"meristem_dataset_folder\": 1");
       },
       {"dataset.json: its format is 1, and 'hash' is of a later one"},
       0},
      {"the format in dataset.json and its hash",
       "dataset.json",
       [](const std::string& text) {
         const std::string older = replaced(text, "\"meristem_dataset_folder\": 2", "\"meristem_dataset_folder\": 1");
         return older.substr(0, older.rfind(",\n  \"hash\"")) + "\n}\n";
       },
       {"dataset.json: its format is 1, and 'tables' is of a later one"},
       0},
      {"dataset.json as of format 1",
       "dataset.json",
       [](const std::string& text) {
         const Value value = parse_json(text);
         return as_of_format_1(*value.find("plan")->text(),
                               *value.find("documents")->list()->front().find("hash")->text());
       },
       {"dataset.json: its format is 1, and checks/00000.csv is of a later one"},
       0},
      {"a hash in dataset.json",
       "dataset.json",
       [](const std::string& text) {
         const std::size_t at = text.find("\"tables\": [\"") + 12;
         return text.substr(0, at) + (text[at] == '0' ? '1' : '0') + text.substr(at + 1);
       },
       {"dataset.json: the hash of the table 0 is not that of "},
       0},
      {"a line end of dataset.json",
       "dataset.json",
       [](const std::string& text) { return text + "\n"; },
       {"dataset.json: the file has changed since it was written"},
       0},
      {"dataset.json is no JSON", "dataset.json", [](const std::string&) { return "{"; }, {"dataset.json:1:"}, 0},
  };
}

TEST(VerifyDataset, TellsEachDamageAndARepairMakesItGood) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  make_plants(stem_plan(), rods);
  const auto whole = files_below(rods);
  ASSERT_TRUE(verified(rods).empty());
  for (const Damage& damage : damages()) {
    SCOPED_TRACE(damage.name);
    write_content(fs::path(rods) / damage.file, damage.change(whole.at(damage.file)));
    const auto errors = verified(rods);
    ASSERT_EQ(errors.size(), damage.told.size()) << testing::PrintToString(errors);
    for (std::size_t k = 0; k < errors.size(); ++k) {
      EXPECT_NE(errors[k].find(damage.told[k]), std::string::npos) << errors[k];
    }
    EXPECT_EQ(repaired(own_plan(rods), rods), damage.made);
    const auto after = verified(rods);
    EXPECT_TRUE(after.empty()) << testing::PrintToString(after);
    ASSERT_EQ(files_below(rods), whole);
  }
}

TEST(VerifyDataset, ADatasetJsonThatNamesFilesElsewhereIsRefusedAndTheyStay) {
  const TemporaryFolder folder;
  const std::string rods = folder / "sets/rods";
  make_plants(stem_plan(), rods);
  const auto whole = files_below(rods);
  const std::string notes = folder / "notes.txt";
  write_content(notes, "mine");
  const DatasetInfo right = *read_dataset_info(rods);
  std::vector<DatasetInfo> crafted(5, right);
  crafted[0].files["../../notes.txt"] = text_hash("other");
  crafted[1].files[notes] = text_hash("other");
  crafted[2].documents[0].files.emplace_back("../../../../notes.txt", text_hash("other"));
  crafted[3].documents[0].files.emplace_back(notes, text_hash("other"));
  crafted[4].documents[0].name = "../../..";
  for (std::size_t k = 0; k < crafted.size(); ++k) {
    SCOPED_TRACE(k);
    write_content(dataset_info_path(rods), dataset_info_text(crafted[k]));
    const auto errors = verified(rods);
    ASSERT_EQ(errors.size(), 1U) << testing::PrintToString(errors);
    const std::string told =
        k < 2 ? "it names a file outside of its folder" : "it names a document outside of its folder";
    EXPECT_NE(errors[0].find(told), std::string::npos) << errors[0];
    repaired(own_plan(rods), rods);
    EXPECT_EQ(file_content(notes), "mine");
    EXPECT_TRUE(verified(rods).empty());
    ASSERT_EQ(files_below(rods), whole);
  }
}

TEST(VerifyDataset, TellsFilesThatAreMissingOrBelongToNothing) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  make_plants(stem_plan(), rods);
  const auto whole = files_below(rods);
  for (const char* const name : {"plan.json", "checks/plan.json", "checks/00001.csv", "README.md", "manifest/00002.csv",
                                 "plants/0000/000004.ply"}) {
    SCOPED_TRACE(name);
    fs::remove(fs::path(rods) / name);
    const auto errors = verified(rods);
    ASSERT_FALSE(errors.empty());
    EXPECT_NE(errors[0].find(std::string(name) + " is missing"), std::string::npos) << errors[0];
    repaired(own_plan(rods), rods);
    EXPECT_TRUE(verified(rods).empty());
    ASSERT_EQ(files_below(rods), whole);
  }
  for (const char* const name : {"manifest/00003.csv", "checks/00009.csv"}) {
    write_content(fs::path(rods) / name, whole.at("manifest/00002.csv"));
    const auto errors = verified(rods);
    ASSERT_FALSE(errors.empty());
    EXPECT_NE(testing::PrintToString(errors).find(std::string(name) + " belongs to no table"), std::string::npos)
        << errors[0];
  }
  repaired(own_plan(rods), rods);
  EXPECT_EQ(files_below(rods), whole);
}

TEST(VerifyDataset, AMissingDatasetJsonIsMadeAgainFromTheHashesOfTables) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  make_plants(plan, rods);
  const auto whole = files_below(rods);
  fs::remove(fs::path(rods) / "dataset.json");
  EXPECT_EQ(repaired(plan, rods), 0U);
  EXPECT_EQ(files_below(rods), whole);

  fs::remove(fs::path(rods) / "dataset.json");
  const DatasetPlan other = stem_plan(replaced(kRods, "\"uniform\": [0.5, 2]", "\"uniform\": [0.5, 1]"));
  EXPECT_THROW(repaired(other, rods), MachineError) << "it is of another plan";
}

TEST(VerifyDataset, ARepairSaysWhatItCannotRepair) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  make_plants(plan, rods);
  const auto whole = files_below(rods);
  write_content(fs::path(rods) / "documents/rod/rod.json", std::string(kStem) + " ");
  const auto errors = verified(rods);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("documents/rod/rod.json has changed since the data set was begun"), std::string::npos);
  try {
    repaired(own_plan(rods), rods);
    FAIL() << "nothing in the folder tells what the document was";
  } catch (const MachineError& error) {
    EXPECT_NE(std::string(error.what()).find("meristem dataset PLAN -o"), std::string::npos);
  }
  EXPECT_EQ(repaired(plan, rods), 0U);
  EXPECT_EQ(files_below(rods), whole);
}

TEST(VerifyDataset, GoingOnKeepsNoRowThatHasChanged) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  make_plants(plan, rods);
  const auto whole = files_below(rods);
  std::vector<std::string> lines = lines_of(whole.at("manifest/00000.csv"));
  lines[3] = with_field(lines[3], kHeight, other_digit);
  write_content(fs::path(rods) / "manifest/00000.csv", joined(lines));
  fs::remove(fs::path(rods) / "plants/0000/000005.ply");
  EXPECT_EQ(make_plants(plan, rods), 2U) << "the row that has changed and the plant without a file";
  EXPECT_EQ(files_below(rods), whole);
}

TEST(VerifyDataset, ATableWithoutHashesOfItsRowsIsMadeAgain) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  make_plants(stem_plan(), rods);
  const auto whole = files_below(rods);
  std::vector<std::string> lines = lines_of(whole.at("manifest/00000.csv"));
  lines[3] = with_field(lines[3], kHeight, other_digit);
  write_content(fs::path(rods) / "manifest/00000.csv", joined(lines));
  fs::remove(fs::path(rods) / "checks/00000.csv");
  const auto errors = verified(rods);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NE(errors[0].find("00000.csv: the table has other bytes than were written"), std::string::npos);
  EXPECT_EQ(repaired(own_plan(rods), rods), 10U);
  EXPECT_EQ(files_below(rods), whole);
}

TEST(VerifyDataset, AnUnfinishedSetTellsWhatIsMissing) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  const std::uint64_t made = make_plants(plan, rods, 12);
  ASSERT_LT(made, 20U);
  ASSERT_GT(made, 10U);
  const auto errors = verified(rods);
  ASSERT_EQ(errors.size(), 2U) << testing::PrintToString(errors);
  EXPECT_NE(errors[0].find(fmt::format("00001.csv is missing: 10 plants, {} of them have rows in partial/", made - 10)),
            std::string::npos)
      << errors[0];
  EXPECT_NE(errors[1].find("00002.csv is missing: 5 plants"), std::string::npos);
  EXPECT_EQ(file_content(fs::path(rods) / "dataset.json").find("\"tables\": [null"), std::string::npos)
      << "the first table has its hash";

  for (const auto& part : fs::directory_iterator(fs::path(rods) / "partial/rows")) {
    const std::string text = file_content(part.path());
    write_content(part.path(), other_digit(text));
  }
  const auto more = verified(rods);
  EXPECT_NE(testing::PrintToString(more).find("the rows have other bytes than were written"), std::string::npos);
  make_plants(plan, rods);
  make_plants(plan, folder / "whole");
  EXPECT_EQ(files_below(rods), files_below(folder / "whole"));
}

/// A folder as the program made it before tables had hashes.
void make_as_before(const std::string& rods, const DatasetPlan& plan) {
  make_plants(plan, rods);
  fs::remove_all(fs::path(rods) / "checks");
  write_content(fs::path(rods) / "dataset.json", as_of_format_1(plan.hash, plan.documents[0].bundle.hash()));
}

TEST(VerifyDataset, AFolderWithoutHashesIsNotCertifiedAndGetsThem) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  make_plants(plan, folder / "whole");
  make_as_before(rods, plan);
  const DatasetCheck check = checked(rods);
  EXPECT_TRUE(check.is_old);
  EXPECT_TRUE(check.warnings.empty());
  ASSERT_EQ(check.errors.size(), 1U) << testing::PrintToString(check.errors);
  EXPECT_NE(check.errors[0].find("dataset.json: the tables could not be checked"), std::string::npos);
  const DatasetCheck allowed = checked(rods, {.allow_old = true});
  EXPECT_TRUE(allowed.is_old);
  EXPECT_TRUE(allowed.errors.empty()) << testing::PrintToString(allowed.errors);
  EXPECT_EQ(allowed.warnings, check.errors);

  // Values from the plan are still checked.
  const std::string table = file_content(fs::path(rods) / "manifest/00000.csv");
  std::vector<std::string> lines = lines_of(table);
  lines[3] = with_field(lines[3], kTall, other_digit);
  write_content(fs::path(rods) / "manifest/00000.csv", joined(lines));
  const auto errors = checked(rods, {.allow_old = true}).errors;
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("00000.csv:4: row 000002, column 'tall'"), std::string::npos) << errors[0];
  EXPECT_EQ(verified(rods).size(), 2U);

  EXPECT_EQ(make_plants(plan, rods), 1U);
  EXPECT_EQ(files_below(rods), files_below(folder / "whole"));
  EXPECT_TRUE(verified(rods).empty());
  EXPECT_FALSE(checked(rods).is_old);
}

TEST(VerifyDataset, AFolderWithoutHashesGetsItsFormatBeforeFilesOfThatFormat) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  make_plants(plan, folder / "whole");
  make_as_before(rods, plan);
  // A folder that cannot be made stops the program as it goes on.
  write_content(fs::path(rods) / "checks", "");
  Progress progress;
  EXPECT_THROW(DatasetFolder(plan, rods, DatasetOpening::resume, progress), MachineError);
  fs::remove(fs::path(rods) / "checks");
  const auto info = read_dataset_info(rods);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->format, kDatasetFormat);
  EXPECT_TRUE(info->is_as_written);
  EXPECT_EQ(make_plants(plan, rods), 0U);
  EXPECT_EQ(files_below(rods), files_below(folder / "whole"));
}

TEST(VerifyDataset, LinksLeadIntoTheRootOrIntoTheFolder) {
  const TemporaryFolder folder;
  const std::string rods = folder / "sets/rods";
  make_plants(stem_plan(), rods);
  const fs::path plants = fs::path(rods) / "plants";
  const auto require = [&](const std::string& root) { require_links_within(rods, root); };
  EXPECT_NO_THROW(require(folder / "sets"));
  for (const char* const place : {"sets/moved", "sets/rods/moved"}) {
    fs::rename(plants, folder / place);
    fs::create_symlink(folder / place, plants);
    EXPECT_NO_THROW(require(folder / "sets"));
    fs::remove(plants);
    fs::rename(folder / place, plants);
  }
  fs::create_symlink(folder / "nowhere", fs::path(rods) / "b");
  fs::create_symlink("../../elsewhere", fs::path(rods) / "a");
  EXPECT_NO_THROW(require(""));
  EXPECT_NO_THROW(require_links_within(folder / "no folder", folder / "sets"));
  try {
    require(folder / "sets");
    FAIL() << "a link leads out of the root";
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    EXPECT_EQ(error.diagnostics()[0].message, "this link leads outside the folder that may be read");
    EXPECT_EQ(error.diagnostics()[0].file, (fs::path(rods) / "a").string());
  }
}

TEST(VerifyDataset, PlantsThatFailedAreCounted) {
  const TemporaryFolder folder;
  const DatasetPlan plan = rod_plan(R"({"meristem_dataset": 1, "seeds": 5, "rows": 3, "files": [".ply"],
    "grid": {"limits.triangles": [1000, 2]}})");
  Progress progress;
  make_plants(plan, folder / "rods");
  const DatasetFolder opened(plan, folder / "rods", DatasetOpening::resume, progress);
  EXPECT_EQ(opened.failed(), 5U);
  EXPECT_EQ(opened.failed_text().find("5 of 10 plants written, 5 failed: 000005: "), 0U) << opened.failed_text();
  EXPECT_NE(opened.failed_text().find("; 4 more in the column 'error'"), std::string::npos);
  EXPECT_EQ(checked(folder / "rods").failed, 5U);
  EXPECT_TRUE(verified(folder / "rods").empty());
}

TEST(VerifyDataset, ArraysThatWereMadeOfTablesAreChecked) {
  const TemporaryFolder folder;
  const std::string rods = folder / "rods";
  const DatasetPlan plan = stem_plan();
  make_plants(plan, rods);
  const std::string arrays = fs::path(rods) / "manifest.npz";
  write_content(arrays, "numbers");
  Progress progress;
  DatasetFolder(plan, rods, DatasetOpening::resume, progress).add_file("manifest.npz");
  EXPECT_TRUE(verified(rods).empty());
  write_content(arrays, "other");
  const auto errors = verified(rods);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("manifest.npz has other bytes than were written"), std::string::npos);
  repaired(own_plan(rods), rods);
  EXPECT_FALSE(fs::exists(arrays));
  EXPECT_TRUE(verified(rods).empty());
}

}  // namespace meristem::verify_dataset_test

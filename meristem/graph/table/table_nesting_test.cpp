// SPDX-License-Identifier: Apache-2.0
// Rows that hold more than values: tables within themselves, named tables, boxes, files, and rules on parameters that
// exclude or need each other.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/table.h"
#include "tests/support/temporary_folder.h"

namespace meristem::table_nesting_test {

struct Grain {
  double weight = 1;
};

struct Rock {
  double weight = 1;
  std::vector<Rock> pebbles;
  std::vector<std::pair<std::string, Grain>> named;
  std::optional<Box> box;
  Asset<std::string> file;
  double turn = 0;
  double age = 0;
};

template <class T>
void check_weight(const T& thing, const DocumentPath& path, ParameterReader& reader) {
  if (thing.weight == 8.5) reader.add_error(path, "too heavy for such a test");
}

std::string load(const std::string& file_path, const SizeLimits& limits) {
  std::ifstream stream(file_path);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text == "bad") throw InputError(Diagnostic{.message = "bad text", .file = file_path, .line = 3, .column = 4});
  if (text == "broken") throw MachineError("cannot read it");
  if (text.size() > limits.file_bytes) throw InputError(Diagnostic{.message = "too long", .file = file_path});
  return text;
}

const ParameterTable& grain_table() {
  static const ParameterTable table = Table<Grain>("a grain", "A grain.")
                                          .number("weight", &Grain::weight, {.min = 0, .max = 9}, "Weight.")
                                          .shorthand("weight")
                                          .check(check_weight);
  return table;
}

const ParameterTable& rock_table() {
  static const ParameterTable table = Table<Rock>("a rock", "A rock.")
                                          .number("weight", &Rock::weight, {.min = 0, .max = 9}, "Weight.")
                                          .list("pebbles", &Rock::pebbles, rock_table, "Rocks in it.")
                                          .map("named", &Rock::named, grain_table, "Grains in it by name.")
                                          .box("box", &Rock::box, {.min = -9, .max = 9}, "Its bounds.")
                                          .file("file", &Rock::file, load, "Its text.")
                                          .number("turn", &Rock::turn, {}, "Turn of the text.")
                                          .number("age", &Rock::age, {.fixed = true}, "Years.")
                                          .shorthand("weight")
                                          .only_with("file", {"turn"})
                                          .never_with("file", {"weight"})
                                          .check(check_weight);
  return table;
}

struct Result {
  Rock rock;
  std::vector<Varying> varyings;
  std::vector<Diagnostic> errors;
};

Result read(const Value& value, const std::string& folder = {}) {
  Result result;
  ParameterReader reader({}, SizeLimits{}, {.folder = folder});
  const DocumentPath top;
  result.varyings = reader.read_varying(rock_table(), &result.rock, value, DocumentPath(top, "rock"));
  result.errors = reader.take_diagnostics();
  return result;
}

std::string error(const Value& value, const std::string& folder = {}) {
  const Result result = read(value, folder);
  return result.errors.empty() ? "no fault" : result.errors[0].text();
}

TEST(NestedTable, MayContainItself) {
  const Value inner = Value::Object{{"pebbles", Value::List{3, Value::Object{{"weight", 4}}}}};
  const Rock rock = read(Value::Object{{"pebbles", Value::List{inner, 5}}}).rock;
  ASSERT_EQ(rock.pebbles.size(), 2U);
  EXPECT_EQ(rock.pebbles[0].pebbles.at(0).weight, 3);
  EXPECT_EQ(rock.pebbles[0].pebbles.at(1).weight, 4);
  EXPECT_EQ(rock.pebbles[1].weight, 5);
  const Value deep_error = Value::Object{{"pebbles", Value::List{Value::Object{{"pebbles", Value::List{-1}}}}}};
  EXPECT_EQ(error(deep_error),
            "rock.pebbles[0].pebbles[0]: the value -1 is out of range for 'weight'; expected a number from 0 to 9");
  EXPECT_TRUE(rock_table().contains_itself());
  EXPECT_EQ(rock_table().defaults().size(), rock_table().parameters.size());
}

TEST(NestedTable, MapsKeepTheirNamesInOrder) {
  const Rock rock = read(Value::Object{{"named", Value::Object{{"z", 1}, {"a b", 2}, {"", 3}}}}).rock;
  ASSERT_EQ(rock.named.size(), 3U);
  EXPECT_EQ(rock.named[0].first, "z");
  EXPECT_EQ(rock.named[1].first, "a b");
  EXPECT_EQ(rock.named[2].second.weight, 3);
  const Value shown = rock_table().find("named")->show(&rock);
  EXPECT_EQ(shown.find("a b")->find("weight")->number()[0], 2);
  EXPECT_EQ(error(Value::Object{{"named", Value::Object{{"z", 99}}}}),
            "rock.named.z: the value 99 is out of range for 'weight'; expected a number from 0 to 9");
  EXPECT_EQ(error(Value::Object{{"named", Value::List{}}}).substr(0, 48),
            "rock.named: 'named' cannot be an empty list; exp");
}

// The rock as the k-th of three siblings has it.
Rock instance(const Value& value, std::uint32_t k) {
  const Result result = read(value);
  EXPECT_TRUE(result.errors.empty()) << result.errors[0].text();
  Site site;
  site.i = k;
  site.n = 3;
  Rock copy = result.rock;
  VaryingValues(result.varyings, std::span(&site, 1), 0).apply(0, &copy);
  EXPECT_TRUE(result.rock.pebbles.empty() || result.rock.pebbles[0].weight == 1);  // the default stays
  return copy;
}

TEST(NestedTable, NumbersVaryInListsToo) {
  const Value inner = Value::Object{{"weight", Value::List{2, 4}}, {"pebbles", Value::List{7, "5 + i"}}};
  const Value value = Value::Object{{"weight", "1 + i"}, {"pebbles", Value::List{"v + i", inner}}};
  for (const std::uint32_t k : {0U, 1U, 2U}) {
    const Rock rock = instance(value, k);
    EXPECT_EQ(rock.weight, 1 + k);
    EXPECT_EQ(rock.pebbles.at(0).weight, 1 + k);
    EXPECT_EQ(rock.pebbles.at(1).weight, 2 + k);
    EXPECT_EQ(rock.pebbles.at(1).pebbles.at(0).weight, 7);
    EXPECT_EQ(rock.pebbles.at(1).pebbles.at(1).weight, 5 + k);
  }
}

TEST(NestedTable, NumbersVaryInMapsToo) {
  const Value named = Value::Object{{"sand", Value::Object{{"weight", "2 * i"}}}, {"grit", 3}};
  const Rock rock = instance(Value::Object{{"named", named}}, 2);
  EXPECT_EQ(rock.named.at(0).second.weight, 4);
  EXPECT_EQ(rock.named.at(1).second.weight, 3);
}

TEST(NestedTable, EachElementDrawsForItself) {
  const Result result = read(Value::Object{{"pebbles", Value::List{"rand()", "rand()"}}});
  ASSERT_EQ(result.varyings.size(), 2U);
  EXPECT_EQ(result.varyings[1].path, "rock.pebbles[1]");
  EXPECT_NE(result.varyings[0].name_hash, result.varyings[1].name_hash);
}

TEST(NestedTable, WhatIsFixedIsOneNumberInListsToo) {
  EXPECT_EQ(
      error(Value::Object{{"pebbles", Value::List{Value::Object{{"age", "1 + i"}}}}}),
      "rock.pebbles[0].age: 'age' is one number for all instances, and this expression differs between instances; "
      "expected an expression of numbers and the document's variables");
}

TEST(NestedTable, NothingVariesOutsideOfComponents) {
  Rock rock;
  ParameterReader reader({}, SizeLimits{});
  const DocumentPath top;
  reader.read(rock_table(), &rock, Value::Object{{"pebbles", Value::List{Value(Value::List{1, 2})}}}, top);
  ASSERT_EQ(reader.error_count(), 1U);
  EXPECT_EQ(reader.diagnostics()[0].message,
            "'weight' is one number (only those of components vary) and cannot be a list of 2");
}

TEST(NestedTable, RulesAreCheckedAtAnyDepth) {
  const auto errors = [](const Rock& rock) {
    ParameterReader reader({}, SizeLimits{});
    const DocumentPath top;
    rock_table().check_all(&rock, DocumentPath(top, "rock"), reader);
    std::vector<std::string> paths;
    for (const Diagnostic& found : reader.diagnostics()) paths.push_back(found.path);
    return paths;
  };
  Rock rock;
  rock.pebbles.resize(2);
  rock.pebbles[1].pebbles.resize(1);
  rock.named.emplace_back("sand", Grain{});
  EXPECT_EQ(errors(rock), std::vector<std::string>());
  rock.weight = 8.5;
  rock.pebbles[1].pebbles[0].weight = 8.5;
  rock.named[0].second.weight = 8.5;
  EXPECT_EQ(errors(rock), (std::vector<std::string>{"rock", "rock.pebbles[1].pebbles[0]", "rock.named.sand"}));
}

TEST(BoxRow, TakesTwoCorners) {
  const Value corners = Value::List{Value::List{-1, 0, "1+1"}, Value::List{1, 2, 3}};
  const Rock rock = read(Value::Object{{"box", corners}}).rock;
  EXPECT_EQ(rock.box->low, Vec3(-1, 0, 2));
  EXPECT_EQ(rock.box->high, Vec3(1, 2, 3));
  EXPECT_EQ(rock_table().find("box")->show(&rock), Value(Value::List{Value::List{-1, 0, 2}, Value::List{1, 2, 3}}));
  const Rock without;
  EXPECT_TRUE(rock_table().find("box")->show(&without).is_null());
  EXPECT_EQ(error(Value::Object{{"box", Value::List{1, 2}}}).substr(0, 11), "rock.box[0]");
  EXPECT_EQ(
      error(Value::Object{{"box", Value::List{Value(Value::List{1, 2, 3})}}}),
      "rock.box: 'box' cannot be a list of 1; expected two corners, the lower first, such as [[-1, 0, -1], [1, 2, 1]]");
  EXPECT_NE(
      error(Value::Object{{"box", Value::List{Value::List{1, 2, 3}, Value::List{1, 20, 3}}}}).find("rock.box[1][1]"),
      std::string::npos);
}

class FileRow : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "a.txt") << "hello";
    std::ofstream(folder_ / "bad.txt") << "bad";
    std::ofstream(folder_ / "broken.txt") << "broken";
  }
  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST_F(FileRow, IsReadFromTheFolderAndSharedByCopies) {
  const Rock rock = read(Value::Object{{"file", "a.txt"}}, folder_.string()).rock;
  ASSERT_TRUE(rock.file);
  EXPECT_EQ(*rock.file, "hello");
  EXPECT_EQ(rock_table().find("file")->show(&rock), Value("a.txt"));
  const Rock copy = rock;  // NOLINT(performance-unnecessary-copy-initialization): what is tested
  EXPECT_EQ(copy.file.content, rock.file.content);
  const std::string whole = (folder_ / "a.txt").string();
  EXPECT_EQ(*read(Value::Object{{"file", whole}}, "elsewhere").rock.file, "hello");
}

TEST_F(FileRow, FaultsNameBothPlaces) {
  EXPECT_EQ(error(Value::Object{{"file", "bad.txt"}}, folder_.string()), "rock.file: 'bad.txt:3:4': bad text");
  EXPECT_EQ(error(Value::Object{{"file", "broken.txt"}}, folder_.string()), "rock.file: cannot read it");
  EXPECT_EQ(error(Value::Object{{"file", 7}}), "rock.file: 'file' cannot be the number 7; expected the path of a file");
}

TEST_F(FileRow, RowsMayNeedOrExcludeIt) {
  EXPECT_EQ(error(Value::Object{{"file", "a.txt"}, {"turn", 2}}, folder_.string()), "no fault");
  EXPECT_EQ(error(Value::Object{{"turn", 2}}),
            "rock.turn: 'turn' has no meaning without 'file'; expected 'file' beside it");
  EXPECT_EQ(error(Value::Object{{"file", "a.txt"}, {"weight", 2}}, folder_.string()),
            "rock.weight: 'weight' has no meaning beside 'file'; expected only one of them");
}

}  // namespace meristem::table_nesting_test

// SPDX-License-Identifier: Apache-2.0
// Rows that hold more than values: tables within themselves, named tables, boxes, files, and who stands beside whom.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/table.h"
#include "tests/support/temporary_folder.h"

namespace meristem {
namespace {

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
};

std::string load(const std::string& path, const Limits& limits) {
  std::ifstream stream(path);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text == "bad") throw InputError(Diagnostic{.message = "bad text", .file = path, .line = 3, .column = 4});
  if (text == "broken") throw MachineError("cannot read it");
  if (text.size() > limits.file_bytes) throw InputError(Diagnostic{.message = "too long", .file = path});
  return text;
}

const ParameterTable& grain_table() {
  static const ParameterTable table = Table<Grain>("a grain", "A grain.")
                                          .number("weight", &Grain::weight, {.min = 0, .max = 9}, "Weight.")
                                          .shorthand("weight");
  return table;
}

const ParameterTable& rock_table() {
  static const ParameterTable table = Table<Rock>("a rock", "A rock.")
                                          .number("weight", &Rock::weight, {.min = 0, .max = 9}, "Weight.")
                                          .list("pebbles", &Rock::pebbles, rock_table, "Rocks in it.")
                                          .map("named", &Rock::named, grain_table, "Grains in it by name.")
                                          .box("box", &Rock::box, {.min = -9, .max = 9}, "Its bounds.")
                                          .file("file", &Rock::file, load, "Its text.")
                                          .number("turn", &Rock::turn, {}, "Of its text.")
                                          .shorthand("weight")
                                          .only_with("file", {"turn"})
                                          .never_with("file", {"weight"});
  return table;
}

struct Result {
  Rock rock;
  std::vector<Varying> varyings;
  std::vector<Diagnostic> faults;
};

Result read(const Value& value, const std::string& folder = {}) {
  Result result;
  ParameterReader reader({}, Limits{}, {.folder = folder});
  const Place top;
  result.varyings = reader.read_varying(rock_table(), &result.rock, sizeof(Rock), value, Place(top, "rock"));
  result.faults = reader.take_diagnostics();
  return result;
}

std::string fault(const Value& value, const std::string& folder = {}) {
  const Result result = read(value, folder);
  return result.faults.empty() ? "no fault" : result.faults[0].text();
}

TEST(NestedTable, MayContainItself) {
  const Value inner = Value::Object{{"pebbles", Value::List{3, Value::Object{{"weight", 4}}}}};
  const Rock rock = read(Value::Object{{"pebbles", Value::List{inner, 5}}}).rock;
  ASSERT_EQ(rock.pebbles.size(), 2U);
  EXPECT_EQ(rock.pebbles[0].pebbles.at(0).weight, 3);
  EXPECT_EQ(rock.pebbles[0].pebbles.at(1).weight, 4);
  EXPECT_EQ(rock.pebbles[1].weight, 5);
  const Value deep_fault = Value::Object{{"pebbles", Value::List{Value::Object{{"pebbles", Value::List{-1}}}}}};
  EXPECT_EQ(fault(deep_fault),
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
  EXPECT_EQ(fault(Value::Object{{"named", Value::Object{{"z", 99}}}}),
            "rock.named.z: the value 99 is out of range for 'weight'; expected a number from 0 to 9");
  EXPECT_EQ(fault(Value::Object{{"named", Value::List{}}}).substr(0, 48),
            "rock.named: 'named' cannot be an empty list; exp");
}

TEST(NestedTable, NumbersVaryOnlyInTheStructItself) {
  EXPECT_EQ(read(Value::Object{{"weight", "1 + i"}}).varyings.size(), 1U);
  EXPECT_NE(fault(Value::Object{{"pebbles", Value::List{"1 + i"}}}).find("one number for all instances"),
            std::string::npos);
}

TEST(BoxRow, TakesTwoCorners) {
  const Value corners = Value::List{Value::List{-1, 0, "1+1"}, Value::List{1, 2, 3}};
  const Rock rock = read(Value::Object{{"box", corners}}).rock;
  EXPECT_EQ(rock.box->low, Vec3(-1, 0, 2));
  EXPECT_EQ(rock.box->high, Vec3(1, 2, 3));
  EXPECT_EQ(rock_table().find("box")->show(&rock), Value(Value::List{Value::List{-1, 0, 2}, Value::List{1, 2, 3}}));
  const Rock without;
  EXPECT_TRUE(rock_table().find("box")->show(&without).is_null());
  EXPECT_EQ(fault(Value::Object{{"box", Value::List{1, 2}}}).substr(0, 11), "rock.box[0]");
  EXPECT_EQ(
      fault(Value::Object{{"box", Value::List{Value(Value::List{1, 2, 3})}}}),
      "rock.box: 'box' cannot be a list of 1; expected two corners, the lower first, such as [[-1, 0, -1], [1, 2, 1]]");
  EXPECT_NE(
      fault(Value::Object{{"box", Value::List{Value::List{1, 2, 3}, Value::List{1, 20, 3}}}}).find("rock.box[1][1]"),
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
  EXPECT_EQ(fault(Value::Object{{"file", "bad.txt"}}, folder_.string()), "rock.file: 'bad.txt:3:4': bad text");
  EXPECT_EQ(fault(Value::Object{{"file", "broken.txt"}}, folder_.string()), "rock.file: cannot read it");
  EXPECT_EQ(fault(Value::Object{{"file", 7}}), "rock.file: 'file' cannot be the number 7; expected the path of a file");
}

TEST_F(FileRow, RowsMayNeedOrExcludeIt) {
  EXPECT_EQ(fault(Value::Object{{"file", "a.txt"}, {"turn", 2}}, folder_.string()), "no fault");
  EXPECT_EQ(fault(Value::Object{{"turn", 2}}),
            "rock.turn: 'turn' has no meaning without 'file'; expected 'file' beside it");
  EXPECT_EQ(fault(Value::Object{{"file", "a.txt"}, {"weight", 2}}, folder_.string()),
            "rock.weight: 'weight' has no meaning beside 'file'; expected only one of them");
}

}  // namespace
}  // namespace meristem

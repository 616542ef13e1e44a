// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/number_reader.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem::number_reader_test {

const DocumentPath kTop;
const DocumentPath kLeaf(kTop, "leaf");
const DocumentPath kCurl(kLeaf, "curl");

struct Leaf {
  double length = 1;
  double curl = 0;
  std::vector<double> teeth{0, 0, 0};
};

void store_double(void* member, double value) { *static_cast<double*>(member) = value; }

Parameter row(Unit unit = Unit::none, double min = -360, double max = 360) {
  Parameter made;
  made.name = "curl";
  made.kind = ParameterKind::number;
  made.form = {.unit = unit, .min = min, .max = max};
  return made;
}

/// A reader of a document with the variable `tilt`, its errors, and a struct to read into.
struct Reading {
  ReadErrors errors{SizeLimits()};
  ExpressionReader expressions{{{"tilt", 40}}, errors};
  FileReader files{{}, errors};
  NumberReader reader{expressions, files, errors};
  Leaf leaf;

  void store(const Value& value, const Parameter& parameter = row()) {
    reader.store(parameter, value, kCurl, {&leaf.curl, store_double, 0});
  }
  /// Reads a value within a component and returns the numbers that vary.
  std::vector<Varying> varyings(const Value& value, const Parameter& parameter = row()) {
    reader.begin_component(&leaf);
    store(value, parameter);
    return reader.end_component();
  }
  std::string error() const { return errors.diagnostics().empty() ? "none" : errors.diagnostics()[0].text(); }
};

TEST(NumberReader, ReadsPlainNumbersAndExpressionsOfTheVariables) {
  Reading reading;
  EXPECT_EQ(reading.reader.read(row(), 12.5, kCurl), 12.5);
  EXPECT_EQ(reading.reader.read(row(), "tilt / 2", kCurl), 20);
  EXPECT_EQ(reading.reader.read(row(), 500, kCurl), std::nullopt);
  EXPECT_NE(reading.error().find("the value 500 is out of range"), std::string::npos) << reading.error();
}

TEST(NumberReader, ReadsClockTimesOfHours) {
  Reading reading;
  EXPECT_EQ(reading.reader.read(row(Unit::hour, 0, 24), "15:30", kCurl), 15.5);
  EXPECT_EQ(reading.reader.read(row(Unit::hour, 0, 24), "15:99", kCurl), std::nullopt);
}

TEST(NumberReader, StoresNumbersInTheUnitOfTheStruct) {
  Reading reading;
  reading.store(180, row(Unit::degree));
  EXPECT_DOUBLE_EQ(reading.leaf.curl, kPi);
}

TEST(NumberReader, OnlyNumbersOfComponentsVary) {
  Reading reading;
  reading.store(Value::List{1, 2});
  EXPECT_NE(reading.error().find("is one number (only those of components vary)"), std::string::npos)
      << reading.error();
  Reading fixed;
  Parameter fixed_row = row();
  fixed_row.form.fixed = true;
  EXPECT_TRUE(fixed.varyings(Value::List{1, 2}, fixed_row).empty());
  EXPECT_NE(fixed.error().find("is one number for all instances"), std::string::npos) << fixed.error();
}

TEST(NumberReader, ARangeVariesWithItsOffsetInTheStruct) {
  Reading reading;
  EXPECT_FALSE(reading.reader.reads_component());
  const std::vector<Varying> varyings = reading.varyings(Value::List{10, 20}, row(Unit::degree));
  ASSERT_EQ(varyings.size(), 1U) << reading.error();
  EXPECT_EQ(varyings[0].first, 10);
  EXPECT_EQ(varyings[0].last, 20);
  EXPECT_EQ(varyings[0].offset, static_cast<std::size_t>(reinterpret_cast<std::byte*>(&reading.leaf.curl) -
                                                         reinterpret_cast<std::byte*>(&reading.leaf)));
  EXPECT_EQ(varyings[0].path, "leaf.curl");
  EXPECT_FALSE(reading.reader.reads_component());
}

TEST(NumberReader, AnExpressionOfConstantsIsStoredAtOnce) {
  Reading reading;
  EXPECT_TRUE(reading.varyings("tilt + 2").empty());
  EXPECT_EQ(reading.leaf.curl, 42);
  EXPECT_EQ(reading.varyings("tilt + i").size(), 1U);
}

TEST(NumberReader, ANumberInAnElementVariesWithTheStepsToIt) {
  Reading reading;
  reading.reader.begin_component(&reading.leaf);
  {
    const NumberReader::InElement inside(reading.reader, &reading.leaf.teeth, nullptr, 2, &reading.leaf.teeth[2]);
    reading.reader.store(row(), Value::List{1, 2}, kCurl, {&reading.leaf.teeth[2], store_double, 0});
  }
  reading.store(Value::List{3, 4});
  const std::vector<Varying> varyings = reading.reader.end_component();
  ASSERT_EQ(varyings.size(), 2U) << reading.error();
  ASSERT_EQ(varyings[0].way.size(), 1U);
  EXPECT_EQ(varyings[0].way[0].index, 2U);
  EXPECT_EQ(varyings[0].offset, 0U);
  EXPECT_TRUE(varyings[1].way.empty()) << "after the element, numbers belong to the component again";
}

TEST(NumberReader, KeysAreOnlyReadWhereTheAnimationHasThem) {
  const Value keyed = Value::Object{{"keys", Value::List{Value::List{0, 1, 0}, Value::List{2, 5, 0}}}};
  Reading without;
  EXPECT_TRUE(without.varyings(keyed).empty());
  EXPECT_NE(without.error().find("'keys' does not belong to a value"), std::string::npos) << without.error();
  Reading with;
  with.reader.expect_keys({"leaf.curl"});
  const std::vector<Varying> varyings = with.varyings(keyed);
  ASSERT_EQ(varyings.size(), 1U) << with.error();
  EXPECT_NE(varyings[0].keys, nullptr);
}

TEST(NumberReader, KnowsWhichNumbersAreWorkedOut) {
  Reading reading;
  reading.store(3);
  EXPECT_FALSE(reading.reader.is_worked_out(kCurl));
  reading.store("tilt");
  EXPECT_TRUE(reading.reader.is_worked_out(kCurl));
}

TEST(NumberReader, ANumberPerChildVariesOutsideOfComponentsToo) {
  Reading reading;
  PerChild number;
  reading.reader.store_per_child(row(), 3, kCurl, number);
  EXPECT_EQ(number.plain, 3);
  EXPECT_FALSE(number.varying);
  reading.reader.store_per_child(row(), Value::List{1, 2}, kCurl, number);
  EXPECT_TRUE(number.varying) << reading.error();
}

TEST(NumberReader, WrongRangesAndSamplesAreErrors) {
  const auto error = [](const Value& value) {
    Reading reading;
    EXPECT_TRUE(reading.varyings(value).empty());
    return reading.error();
  };
  EXPECT_NE(error(Value::List{1}).find("the range of 'curl' is a list of 1"), std::string::npos);
  EXPECT_NE(error(Value::Object{{"sample", Value::List{}}}).find("has no values"), std::string::npos);
  EXPECT_NE(error(Value::Object{{"range", Value::List{1, 2}}, {"smooth", true}}).find("without a sample"),
            std::string::npos);
  EXPECT_NE(error(true).find("'curl' cannot be"), std::string::npos);
}

TEST(NumberReader, StopsOnRequest) {
  Reading reading;
  Progress progress;
  reading.reader.stop_with(&progress);
  EXPECT_EQ(reading.reader.read(row(), 1, kCurl), 1);
  progress.cancel();
  EXPECT_THROW(reading.reader.read(row(), 1, kCurl), Cancelled);
}

}  // namespace meristem::number_reader_test

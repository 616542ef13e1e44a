// SPDX-License-Identifier: Apache-2.0
#include "protocol/check.h"

#include <gtest/gtest.h>

#include "meristem/document/json.h"
#include "protocol/record_table.h"
#include "refusal.h"

namespace meristem::studio::check_test {

std::string error_of(const Form& form, const std::string& json) {
  const DocumentPath top;
  try {
    check_form(form, parse_json(json), DocumentPath(top, "part"));
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(CheckForm, NamesWhatIsExpected) {
  EXPECT_EQ(error_of(forms::flag(), "1"), "'part' is not true or false");
  EXPECT_EQ(error_of(forms::text(), "1"), "'part' is not a text");
  EXPECT_EQ(error_of(forms::text(), "null"), "'part' is not a text");
  EXPECT_EQ(error_of(forms::or_null(forms::text()), "null"), "");
  EXPECT_EQ(error_of(forms::number({0, 2, Unit::metre}), "2.5"), "'part' is not a number from 0 to 2 (m)");
  EXPECT_EQ(error_of(forms::number({0, 2, Unit::metre}), "2"), "");
  EXPECT_EQ(error_of(forms::number({.min = 1}), "0"), "'part' is not a number from 1");
  EXPECT_EQ(error_of(forms::number({.max = 1}), "2"), "'part' is not a number up to 1");
  EXPECT_EQ(error_of(forms::whole({0, 9}), "2.5"), "'part' is not a whole number from 0 to 9");
  EXPECT_EQ(error_of(forms::any(), "null"), "");
  EXPECT_EQ(error_of(forms::choice({"parent", "child"}), "\"chidl\""),
            "'part' is none of parent, child; did you mean 'child'?");
  EXPECT_EQ(error_of(forms::choice({"parent", "child"}), "3"), "'part' is none of parent, child");
}

TEST(CheckForm, NamesThePlaceInListsAndMaps) {
  EXPECT_EQ(error_of(forms::list(forms::text()), "{}"), "'part' is not a list");
  EXPECT_EQ(error_of(forms::list(forms::text()), R"(["a", 1])"), "'part[1]' is not a text");
  EXPECT_EQ(error_of(forms::list(forms::text(), 2), R"(["a", "b", "c"])"), "'part' has more than 2 parts");
  EXPECT_EQ(error_of(forms::list(forms::text(), 2, 1), "[]"), "'part' has fewer than 1 parts");
  EXPECT_EQ(error_of(forms::vector(), "[1, 2]"), "'part' is not a list [x, y, z]");
  EXPECT_EQ(error_of(forms::vector(), "[1, 2, true]"), "'part[2]' is not a number");
  EXPECT_EQ(error_of(forms::map(forms::number()), R"({"a": 1, "b.c": "2"})"), "'part.b.c' is not a number");
  EXPECT_EQ(error_of(forms::map(forms::number(), 1), R"({"a": 1, "b": 2})"), "'part' has more than 1 parts");
}

TEST(CheckForm, ShortensLongKeysInPaths) {
  const auto error_at = [](const std::string& key) {
    return error_of(forms::map(forms::number()), "{\"" + key + "\": true}");
  };
  EXPECT_EQ(error_at(std::string(100, 'k')), "'part." + std::string(100, 'k') + "' is not a number");
  EXPECT_EQ(error_at(std::string(100'000, 'k')), "'part." + std::string(35, 'k') + "...' is not a number");
}

struct Point {
  double at = 0;
  std::optional<std::string> name;
  bool is_large = false;
  std::vector<double> numbers;
};
struct Circle {
  double radius = 1;
};

const Record& point_record() {
  static const Record record = RecordTable<Point>("Point", "A point.")
                                   .number("at", &Point::at, {0, 10}, "Position.")
                                   .text("name", &Point::name, "Name.")
                                   .flag("large", &Point::is_large, "Size.")
                                   .or_default()
                                   .several("numbers", forms::list(forms::number()), &Point::numbers, "Numbers.")
                                   .optional()
                                   .rule([](const Point& point, const Value&) -> std::string {
                                     return point.is_large && !point.name ? "needs a 'name'" : "";
                                   });
  return record;
}

const Record& circle_record() {
  static const Record record =
      RecordTable<Circle>("Circle", "A circle.").number("radius", &Circle::radius, {}, "Radius.");
  return record;
}

std::string read(Point& point, const std::string& json) {
  const Value value = parse_json(json);
  try {
    check_record(point_record(), value, DocumentPath());
    store_record(point_record(), &point, value, DocumentPath());
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(RecordTable, ReadsMembersOfEachKind) {
  Point point;
  EXPECT_EQ(read(point, R"({"at": 3, "name": "a", "large": true, "numbers": [1, 2]})"), "");
  EXPECT_EQ(point.at, 3);
  EXPECT_EQ(point.name, "a");
  EXPECT_TRUE(point.is_large);
  EXPECT_EQ(point.numbers, (std::vector<double>{1, 2}));
  Point other;
  EXPECT_EQ(read(other, R"({"at": 0, "name": null, "large": null})"), "");
  EXPECT_EQ(other.name, std::nullopt);
  EXPECT_FALSE(other.is_large);
}

TEST(RecordTable, RefusesWhatIsNotDescribed) {
  Point point;
  EXPECT_EQ(read(point, "[]"), "the message is not an object");
  EXPECT_EQ(read(point, "{}"), "the message has no 'at'");
  EXPECT_EQ(read(point, R"({"at": null})"), "'at' is not a number from 0 to 10");
  EXPECT_EQ(read(point, R"({"at": 1, "lagre": true})"),
            "the message has an unknown member 'lagre'; did you mean 'large'?");
  EXPECT_EQ(read(point, R"({"at": 1, "q": true})"),
            "the message has an unknown member 'q'; the members are at, name, large, numbers");
  EXPECT_EQ(read(point, R"({"at": 1, "large": true})"), "the message needs a 'name'");
}

TEST(RecordTable, ReadsObjectsOfSeveralKinds) {
  const Form form = forms::kinds({point_record, circle_record});
  EXPECT_EQ(error_of(form, R"({"radius": 2})"), "");
  EXPECT_EQ(error_of(form, R"({"radius": 2, "at": null})"),
            "'part' has an unknown member 'at'; the members are radius");
  EXPECT_EQ(error_of(form, R"({"radus": 2})"), "'part' has none of at, radius; did you mean 'radius'?");
  EXPECT_EQ(error_of(form, "3"), "'part' is not an object");
  std::variant<Point, Circle> stored;
  store_kind(stored, form, parse_json(R"({"radius": 2})"), DocumentPath());
  EXPECT_EQ(std::get<Circle>(stored).radius, 2);
}

}  // namespace meristem::studio::check_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/plant_part.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/edit/session.h"

namespace meristem::plant_part_test {

const std::string kFlower = R"json({
  "meristem": 1,
  "variables": {
    "size": {"value": 0.1, "min": 0, "max": 1, "doc": "No other."}, // of all
    "half": "size/2",
    "other": {"value": 3, "min": 0, "max": 9}
  },
  "components": {
    "stem": {"type": "tree", "length": "other"},
    // The ring of petals.
    "ring": {
      "type": "wreath", // round
      "diameter": "half"
    },
    "petal": {"type": "leaf", "length": 0.05}
  },
  "links": [
    ["stem", "ring"], ["ring", "petal"] // five of them
  ]
})json";

TEST(PlantPart, HasComponentsNotesLinksAndVariablesAsWritten) {
  EXPECT_EQ(plant_part(kFlower, {"petal", "ring"}), R"json({
  "meristem": 1,
  "components": {
    // The ring of petals.
    "ring": {
      "type": "wreath", // round
      "diameter": "half"
    },
    "petal": {"type": "leaf", "length": 0.05}
  },
  "links": [
    ["ring", "petal"] // five of them
  ],
  "variables": {
    "size": {"value": 0.1, "min": 0, "max": 1, "doc": "No other."}, // of all
    "half": "size/2"
  }
}
)json");
  EXPECT_THROW(plant_part(kFlower, {"root"}), InputError);
}

std::string pasted(const std::string& text, const InsertPart& part) {
  Session session(text, "plant.json", builtin_components());
  session.edit({part});
  EXPECT_TRUE(session.is_good()) << session.errors()[0].text();
  const std::string changed = session.text();
  session.undo();
  EXPECT_EQ(session.text(), text);
  return changed;
}

TEST(PlantPart, IsWrittenAsTheOtherDocumentIs) {
  const std::string text =
      "{\n\t\"meristem\": 1,\n\t\"components\": {\n\t\t\"pole\": {\"type\": \"tree\"},\n\t\t\"ball\": {\"type\": "
      "\"simple\"}\n\t},\n\t\"links\": [[\"pole\", \"ball\"]]\n}\n";
  EXPECT_EQ(
      pasted(text, {.text = plant_part(kFlower, {"ring", "petal"}), .index = 1, .link_index = 0}),
      "{\n\t\"meristem\": 1,\n\t\"components\": {\n\t\t\"pole\": {\"type\": \"tree\"},\n\t\t// The ring of petals.\n"
      "\t\t\"ring\": {\n\t\t\t\"type\": \"wreath\", // round\n\t\t\t\"diameter\": \"half\"\n\t\t},\n\t\t\"petal\": "
      "{\"type\": \"leaf\", \"length\": 0.05},\n\t\t\"ball\": {\"type\": \"simple\"}\n\t},\n\t\"links\": "
      "[[\"ring\", \"petal\"], // five of them\n\t\t[\"pole\", \"ball\"]],\n\t\"variables\": {\n\t\t\"size\": "
      "{\"value\": 0.1, \"min\": "
      "0, \"max\": 1, \"doc\": \"No other.\"}, // of all\n\t\t\"half\": \"size/2\"\n\t}\n}\n");
}

TEST(PlantPart, GetsOtherNamesWithAllThatNamesThem) {
  // Names that go round in a circle, too.
  const std::string changed =
      pasted(R"json({"meristem": 1, "components": {"ring": {"type": "tree"}}})json",
             {.text = plant_part(kFlower, {"ring", "petal"}), .names = {{"ring", "petal"}, {"petal", "ring_2"}}});
  EXPECT_NE(changed.find(R"(["petal", "ring_2"])"), std::string::npos) << changed;
  EXPECT_NE(changed.find(R"("petal": {)"), std::string::npos) << changed;
  const std::string swapped =
      pasted(R"json({"meristem": 1, "components": {"a": {"type": "tree"}}})json",
             {.text = plant_part(kFlower, {"ring", "petal"}), .names = {{"ring", "petal"}, {"petal", "ring"}}});
  EXPECT_NE(swapped.find(R"(["petal", "ring"])"), std::string::npos) << swapped;
}

TEST(PlantPart, SharesVariablesThatSayTheSameAndRenamesOthers) {
  const std::string text = R"json({
  "meristem": 1,
  "variables": {"size": {"value": 2, "min": 0, "max": 4}, "half": "size/2"},
  "components": {"ball": {"type": "simple", "size": ["size", "half", 1]}}
})json";
  const std::string changed = pasted(text, {.text = plant_part(kFlower, {"ring"})});
  EXPECT_NE(changed.find(R"("size_2": {"value": 0.1)"), std::string::npos) << changed;
  EXPECT_NE(changed.find(R"("half_2": "size_2/2")"), std::string::npos) << changed;
  EXPECT_NE(changed.find(R"("diameter": "half_2")"), std::string::npos) << changed;
  EXPECT_EQ(pasted(kFlower, {.text = plant_part(kFlower, {"petal"}), .names = {{"petal", "petal_2"}}}).find("size_2"),
            std::string::npos);
}

TEST(PlantPart, IsRefusedWhereANameIsTaken) {
  Session session(kFlower, "plant.json", builtin_components());
  EXPECT_THROW(session.edit({InsertPart{.text = plant_part(kFlower, {"ring"})}}), InputError);
  EXPECT_EQ(session.text(), kFlower);
}

TEST(PlantPart, WhatWouldMakeALineTooLongBeginsALineOfItsOwn) {
  const std::string links =
      R"(["a", "b1"], ["a", "b2"], ["a", "b3"], ["a", "b4"], ["a", "b5"], ["a", "b6"], ["a", "b7"])";
  const std::string text = "{\n  \"meristem\": 1,\n  \"links\": [" + links + ", [\"a\", \"b8\"]]\n}\n";
  Session session(text, "plant.json", builtin_components());
  session.edit({InsertValue{.path = "links[7]", .value = Value::List{"a", "another"}}});
  EXPECT_EQ(session.text(),
            "{\n  \"meristem\": 1,\n  \"links\": [" + links + ",\n    [\"a\", \"another\"], [\"a\", \"b8\"]]\n}\n");
}

TEST(PlantPart, AListThatIsNotThereIsMadeForItsFirstElement) {
  Session session(R"({"meristem": 1, "components": {"a": {"type": "tree"}, "b": {"type": "leaf"}}})", "plant.json",
                  builtin_components());
  session.edit({InsertValue{.path = "links[]", .value = Value::List{"a", "b"}}});
  EXPECT_EQ(session.text(),
            R"({"meristem": 1, "components": {"a": {"type": "tree"}, "b": {"type": "leaf"}}, "links": [["a", "b"]]})");
}

}  // namespace meristem::plant_part_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/meaning.h"

#include <gtest/gtest.h>

#include "meristem/graph/table/table.h"

namespace meristem::meaning_test {

struct Nib {
  double width = 1;
  double slit = 0;
};

struct Pen {
  enum class Kind { ball, fountain, quill };
  Kind kind = Kind::ball;
  bool retracts = true;
  double spring = 1;
  double ink = 1;
  std::optional<double> cartridge;
  std::optional<Nib> nib;
  double feather = 1;
  double colour = 1;
};

const ParameterTable& nib_table() {
  static const ParameterTable table =
      Table<Nib>("a nib", "A nib.").number("width", &Nib::width, {}, "Width.").number("slit", &Nib::slit, {}, "Slit.");
  return table;
}

const ParameterTable& pen_table() {
  static const ParameterTable table = Table<Pen>("a pen", "A pen.")
                                          .choice("kind", &Pen::kind, {"ball", "fountain", "quill"}, "Kind.")
                                          .boolean("retracts", &Pen::retracts, "Retracts.")
                                          .number("spring", &Pen::spring, {}, "Spring.")
                                          .number("ink", &Pen::ink, {}, "Ink.")
                                          .number("cartridge", &Pen::cartridge, {}, "Cartridge.")
                                          .object("nib", &Pen::nib, nib_table, "Nib.")
                                          .number("feather", &Pen::feather, {}, "Feather.")
                                          .number("colour", &Pen::colour, {}, "Colour.")
                                          .only_where({{"kind", {"fountain", "quill"}}}, {"nib"})
                                          .only_where({{"retracts", {true}}}, {"spring"})
                                          .only_where({{"kind", {"quill"}}, {"cartridge"}}, {"ink", "nib.slit"})
                                          .only_where({{"nib.width"}}, {"feather"})
                                          .without({"colour"}, "ink has it");
  return table;
}

std::vector<Diagnostic> errors_in(const Value& value) {
  ParameterReader reader({}, SizeLimits{});
  Pen pen;
  reader.read(pen_table(), &pen, value, DocumentPath());
  return reader.take_diagnostics();
}

/// The path and the words of the only fault.
std::string error_of(const Value& value) {
  const std::vector<Diagnostic> errors = errors_in(value);
  if (errors.size() != 1) return std::to_string(errors.size()) + " faults";
  return errors[0].path + ": " + errors[0].message + " (" + errors[0].expected + ")";
}

using Object = Value::Object;

TEST(Meaning, AParameterOfAnotherChoiceIsAFaultWhateverItsValue) {
  EXPECT_EQ(error_of(Object{{"nib", Object{}}}),
            "nib: 'nib' has no meaning where 'kind' is \"ball\" (\"kind\": \"fountain\" or \"quill\", or no such key)");
  EXPECT_EQ(error_of(Object{{"retracts", false}, {"spring", 1}}),
            "spring: 'spring' has no meaning where 'retracts' is false (\"retracts\": true, or no such key)");
}

TEST(Meaning, ADefaultGivesItAsAGivenValueDoes) {
  EXPECT_TRUE(errors_in(Object{{"spring", 2}}).empty());
  EXPECT_TRUE(errors_in(Object{{"spring", 2}, {"retracts", true}}).empty());
  EXPECT_TRUE(errors_in(Object{{"nib", Object{}}, {"kind", "quill"}}).empty());
}

TEST(Meaning, AnyOfSeveralGiversWillDo) {
  EXPECT_EQ(error_of(Object{{"ink", 1}}),
            "ink: 'ink' has no meaning here (\"kind\": \"quill\", 'cartridge' beside it, or no such key)");
  EXPECT_TRUE(errors_in(Object{{"ink", 1}, {"cartridge", 3}}).empty());
  EXPECT_TRUE(errors_in(Object{{"ink", 1}, {"kind", "quill"}}).empty());
}

TEST(Meaning, ReachesIntoNestedTables) {
  EXPECT_EQ(error_of(Object{{"kind", "fountain"}, {"nib", Object{{"slit", 1}}}}).substr(0, 8), "nib.slit");
  EXPECT_EQ(error_of(Object{{"feather", 1}}),
            "feather: 'feather' has no meaning without 'nib.width' ('nib.width' beside it, or no such key)");
  EXPECT_TRUE(errors_in(Object{{"kind", "quill"}, {"nib", Object{{"width", 1}}}, {"feather", 1}}).empty());
}

TEST(Meaning, WhatNothingGivesAMeaningIsNoRowAndSaysWhy) {
  EXPECT_EQ(pen_table().find("colour"), nullptr);
  EXPECT_EQ(error_of(Object{{"colour", 1}}), "colour: 'colour' has no meaning here: ink has it (no such key)");
}

TEST(Meaning, IsNotAskedForWhereTheGiverCouldNotBeRead) {
  EXPECT_EQ(errors_in(Object{{"kind", "crayon"}, {"nib", Object{}}}).size(), 1U);
}

}  // namespace meristem::meaning_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/mtg/mtg.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"
#include "tests/support/test_data.h"

namespace meristem::mtg_test {

// 17 lines; the codes begin on line 18.
constexpr const char* kHeader =
    "CODE:\tFORM-A\n"
    "CLASSES:\n"
    "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
    "$\t0\tFREE\tFREE\tIMPLICIT\n"
    "P\t1\tCONNECTED\tFREE\tEXPLICIT\n"
    "A\t2\tLINEAR\tFREE\tEXPLICIT\n"
    "S\t3\tFREE\tFREE\tEXPLICIT\n"
    "DESCRIPTION:\n"
    "LEFT\tRIGHT\tRELTYPE\tMAX\n"
    "A\tA\t+\t?\n"
    "FEATURES:\n"
    "NAME\tTYPE\n"
    "Alias\tALPHA\n"
    "Length\tREAL\n"
    "State\tSTRING\n"
    "MTG:\n"
    "ENTITY-CODE\t\t\t\tAlias\tLength\tState\n";

MtgTree read(const std::string& codes) { return read_mtg(kHeader + codes, "plant.mtg", {}); }

/// Lists the joints in the order of the file: "S2<S1" for an entity that follows another, "S1/A1" for an entity in A1
/// without a parent.
std::string joints(const MtgTree& tree) {
  std::string text;
  for (MtgVertex vertex = 1; vertex < tree.vertex_count(); ++vertex) {
    if (!text.empty()) text += ' ';
    const MtgVertex parent = tree.parent[vertex];
    text += parent == kNoVertex ? fmt::format("{}/{}", tree.label(vertex), tree.label(tree.complex[vertex]))
                                : fmt::format("{}{}{}", tree.label(vertex),
                                              tree.edge[vertex] == MtgEdge::branch ? '+' : '<', tree.label(parent));
  }
  return text;
}

/// Returns the message of the only error.
std::string error(const std::string& text) {
  try {
    read_mtg(text, "plant.mtg", {});
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U) << error.what();
    return error.what();
  }
  return "no fault";
}

void expect_error(const std::string& codes, const std::string& message) {
  const std::string found = error(kHeader + codes);
  EXPECT_TRUE(found.starts_with("plant.mtg:" + message)) << found;
}

TEST(Mtg, ColumnsAndCaretsSayWhatFollowsWhat) {
  const MtgTree tree = read(
      "/P1/A1\n"
      "^/S1\n"
      "\t+A1\n"
      "\t^/S1\n"
      "\t^<S2\n"
      "^<S2\n"
      "\t+A2/S1\n");
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S1/A1 A1+A1 S1+S1 S2<S1 S2<S1 A2+A1 S1+S2");
  EXPECT_EQ(tree.parent[7], 3U) << "the second S2 is in the first column";
  EXPECT_EQ(tree.complex[7], 2U);
  EXPECT_EQ(tree.complex[6], 4U);
  EXPECT_EQ(tree.finest_scale(), 3);
  EXPECT_EQ(tree.line[4], 20U);
}

TEST(Mtg, TheFirstPartHangsWhereItsWholeWasSetOn) {
  // This also works through two scales. Further parts are joined to nothing.
  const MtgTree tree = read("/P1/A1/S1+P2/A1/S5/S6\n");
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S1/A1 P2+P1 A1+A1 S5+S1 S6/A1");
}

TEST(Mtg, WhatIsFinerThanAnAxisWithoutPartsGoesOnWhereThatWasSetOn) {
  const std::string stem = "/P1/A1\n^/S1<<S3\n";
  const std::string begin = "P1/$ A1/P1 S1/A1 S2<S1 S3<S2 ";
  // Axes without parts, each in the column of the entity that bears it.
  EXPECT_EQ(joints(read(stem + "^+A31\n^<S4\n")), begin + "A31+A1 S4<S3");
  EXPECT_EQ(joints(read(stem + "^+A31<S4\n")), begin + "A31+A1 S4<S3");
  EXPECT_EQ(joints(read(stem + "^+A31\n^+A32\n^<S4\n")), begin + "A31+A1 A32+A31 S4<S3");
  EXPECT_EQ(joints(read(stem + "\t+A31\n\t^<S4\n")), begin + "A31+A1 S4<S3");
  EXPECT_EQ(joints(read(stem + "^+A31\n^<<S5\n")), begin + "A31+A1 S4<S3 S5<S4");
  // The parts of an axis are coded in a further column.
  EXPECT_EQ(joints(read(stem + "^+A31\n\t/S1\n^<S4\n")), begin + "A31+A1 S1+S3 S4<S3");
  const MtgTree tree = read(stem + "^+A31\n^<S4\n");
  EXPECT_EQ(tree.complex[7], 2U) << "S4 belongs to the axis of S3";
}

TEST(Mtg, RunsNameTheEntitiesBetween) {
  const MtgTree tree = read("/P1/A1/S3<<S6\n^++S8\n");
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S3/A1 S4<S3 S5<S4 S6<S5 S7+S6 S8+S7");
}

TEST(Mtg, ValuesBelongToTheLastEntityOrToARunThatSharesThem) {
  const MtgTree tree = read(
      "/P1/A1/S1<<S3\t\t\t\t\t2.5\n"
      "^<S4<.<S6\t\t\t\t\t-1e-3\tdead\n"
      "^<S7\n");
  const std::vector<double> length = tree.numbers(*tree.find_feature("Length"));
  for (const MtgVertex vertex : {1, 2, 3, 4, 9}) EXPECT_TRUE(std::isnan(length[vertex])) << vertex;
  EXPECT_EQ(length[5], 2.5);
  for (const MtgVertex vertex : {6, 7, 8}) EXPECT_EQ(length[vertex], -1e-3) << vertex;
  EXPECT_EQ(tree.texts(*tree.find_feature("State"))[7], "dead");
  EXPECT_EQ(tree.texts(*tree.find_feature("State"))[9], "");
}

TEST(Mtg, ALaterLookReplacesValues) {
  const MtgTree tree = read("/P1/A1/S1\t\t\t\t\t1\talive\n*\t\t\t\t\t2\n");
  EXPECT_EQ(tree.vertex_count(), 4U);
  EXPECT_EQ(tree.numbers(1)[3], 2);
  EXPECT_EQ(tree.texts(2)[3], "alive") << "what is not said anew stays";
}

TEST(Mtg, WholeNamesGoThroughKnownEntities) {
  const MtgTree tree = read(
      "/P1/A1\n"
      "/P1/A1/S1<S2+A1\n"
      "/P1/A1/S1<S2+A2/S1\n"
      "/P1/A1/S1<S2<S3\n");
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S1/A1 S2<S1 A1+A1 A2+A1 S1+S2 S3<S2");
}

TEST(Mtg, AliasesStandForNames) {
  const MtgTree tree = read("/P1/A1/S1\t\t\t\tfoot\n(foot)<S2<S3\n(foot)<S2+A1\n");
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S1/A1 S2<S1 S3<S2 A1+A1");
}

TEST(Mtg, TwinsOfOneNameAreTwo) {
  const MtgTree tree = read("/P1/A1\n^/S1\n\t+A1/S1\n\t+A1/S1\n");
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S1/A1 A1+A1 S1+S1 A1+A1 S1+S1");
}

TEST(Mtg, SeveralPlantsStandInTheScene) {
  EXPECT_EQ(joints(read("/P1/A1/S1\n/P2/A1/S1\n")), "P1/$ A1/P1 S1/A1 P2/$ A1/P2 S1/A1");
}

TEST(Mtg, TheSceneMayBeNamed) { EXPECT_EQ(joints(read("/Scene0\n^/P1\n^/A1\n")), "P1/$ A1/P1"); }

TEST(Mtg, CarriageReturnsCommentsBlanksAndMarksDoNotMatter) {
  std::string text =
      std::string("# a plant\n") + kHeader + "\n  # nothing\n/P1/A1  # the trunk\t\t\t\t\t9\n ^/S1 \t\t\t\t\t 3 \n\n";
  EXPECT_TRUE(std::isnan(read_mtg(text, "plant.mtg", {}).numbers(1)[2]));
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  const MtgTree tree = read_mtg("\xEF\xBB\xBF" + text, "plant.mtg", {});
  EXPECT_EQ(joints(tree), "P1/$ A1/P1 S1/A1");
  EXPECT_EQ(tree.numbers(1)[3], 3);
}

TEST(Mtg, FaultsInCodesHaveTheirPlace) {
  expect_error("/P1/A1\n^/Sx1\n", "19:3: 'Sx' is not a class; expected one that CLASSES declares");
  expect_error("/P1/A1\n\t^/S1\n", "19:2: there is no entity above in this column");
  expect_error("/P1/S1\n", "18:4: S of scale 3 cannot follow P1 of scale 1; expected '/' and an entity of scale 2");
  expect_error("/P1/A1<S1\n", "18:7: S of scale 3 cannot follow A1 of scale 2");
  expect_error("/P1/A1!\n", "18:7: '!' does not say how it is joined; expected one of '/', '<', '+', '<<', '++'");
  expect_error("/P1/A1/\n", "18:8: a label is missing behind '/'");
  expect_error("/P1/A1/S3<<S3\n", "18:10: '<<' cannot lead from S3 to S3");
  expect_error("/P1/A1<<S3\n", "18:7: '<<' cannot lead from A1 to S3");
  expect_error("/P1/A99999999999\n", "18:6: the number '99999999999' is too large; expected at most 2147483647");
  expect_error("/P1/A1/S1\t\t\t\tfoot\n(fot)<S2\n",
               "19:1: 'fot' is not an alias; expected the value of a feature Alias "
               "before it; did you mean 'foot'?");
  expect_error("/P1\t\t\t\t\ttwo\n", "18:9: 'two' cannot be the Length of P1; expected a number or nothing");
  expect_error("/P1\t\t\t\t\tnan\n", "18:9: 'nan' cannot be the Length of P1");
  expect_error("/P1\n\t\t\t\t\t3\n",
               "19:6: values without an entity; expected the code of an entity in one of the first "
               "4 columns");
}

TEST(Mtg, FaultsInHeadersHaveTheirPlace) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = std::string(kHeader) + "/P1\n";
    text.replace(text.find(from), from.size(), to);
    return error(text);
  };
  EXPECT_EQ(changed("FORM-A", "FORM-B"), "plant.mtg:1:7: 'FORM-B' is not a form that can be read; expected FORM-A");
  EXPECT_EQ(
      changed("CODE:\tFORM-A", "COED:"),
      "plant.mtg:1:1: 'COED:' is not a section; expected one of CODE, CLASSES, DESCRIPTION, FEATURES, MTG; did you "
      "mean 'CODE'?");
  EXPECT_EQ(changed("A\t2", "A\ttwo"),
            "plant.mtg:6:3: the class 'A' has no scale; expected a whole number from 0 to 32");
  EXPECT_EQ(changed("S\t3", "A\t3"), "plant.mtg:7:3: the class 'A' has two scales; expected 2 again");
  EXPECT_EQ(changed("S\t3", "S1\t3"), "plant.mtg:7:1: 'S1' cannot be a class; expected letters alone");
  EXPECT_EQ(changed("A\tA\t+", "A\tAxis,A\t+"),
            "plant.mtg:10:3: 'Axis' is not a class; expected one that CLASSES declares");
  EXPECT_EQ(changed("A\tA\t+\t?", "A\tA"), "plant.mtg:10:4: the rule has no relation; expected '<' or '+'");
  EXPECT_TRUE(changed("REAL", "REEL").starts_with("plant.mtg:14:8: 'REEL' is not a type of features"))
      << changed("REAL", "REEL");
  EXPECT_TRUE(changed("REAL", "REEL").ends_with("did you mean 'REAL'?"));
  EXPECT_EQ(changed("State\tSTRING", "Length\tINT"),
            "plant.mtg:15:1: the feature 'Length' is declared twice; expected it once");
  EXPECT_EQ(changed("Alias\tLength\tState\n", "Alias\tLenght\tState\n"),
            "plant.mtg:17:22: 'Lenght' is not a feature; expected one that FEATURES declares; did you mean 'Length'?");
  EXPECT_EQ(
      changed("ENTITY-CODE", "ENTITY-COD"),
      "plant.mtg:17:1: 'ENTITY-COD' does not begin a line of columns; expected ENTITY-CODE or TOPO, and the names "
      "of features; did you mean 'ENTITY-CODE'?");
  EXPECT_EQ(error("CODE: FORM-A\nCLASSES:\n"),
            "plant.mtg:2:1: the file ends without entities; expected a section that begins with MTG:");
  EXPECT_EQ(
      error("MTG:\n"),
      "plant.mtg:1:1: the file ends before its entities; expected ENTITY-CODE or TOPO, and the names of features");
}

TEST(Mtg, AllFaultsAreToldUpToTheLimit) {
  std::string codes = "/P1/A1\n";
  for (int k = 0; k < 300; ++k) codes += "^/X1\n";
  try {
    read(codes);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), SizeLimits{}.diagnostics);
    EXPECT_EQ(error.diagnostics().back().line, 18 + 100);
  }
}

TEST(Mtg, EntitiesAreLimitedBeforeTheyAreMade) {
  expect_error("/P1/A1/S1<<S2000000000\n",
               "18:10: 2000000003 entities are too many; expected at most 20000000 (limits.nodes)");
  EXPECT_THROW(read_mtg(std::string(kHeader) + "/P1/A1/S1\n", "plant.mtg", {.nodes = 3}), InputError);
}

TEST(Mtg, ColumnsOfFaultsCountCharacters) {
  expect_error("\xC3\xA9t\xC3\xA9\n", "18:1: ");
  expect_error("/P1\t\t\t\t\xC3\xA9t\xC3\xA9\tx\n", "18:12: 'x' cannot be the Length");
}

struct DatedFacts {
  const char* joints;
  const char* size;  ///< a feature of type ALPHA
  double sixth;      ///< its value of vertex 6
  const char* date;  ///< a feature of type DD/MM/YY
  const char* fourth;
};

TEST(Mtg, FilesWithNumbersDatesAndNotes) {
  for (const auto& [file, facts] : data_sets<DatedFacts>(
           {{"tests/data/trees/dated_shoot.mtg",
             {"Plant1/$ Stem1/Plant1 Node1/Stem1 Blade1+Node1 Node2<Node1 Blade1+Node2 Blade2+Node2", "Span", 0.15,
              "dateSeen", "03/05/2024"}}},
           {{"trees/simple_plant.mtg",
             {"Individual0/$ Axis0/Individual0 Internode0/Axis0 Leaf0+Internode0 Internode1<Internode0 "
              "Leaf0+Internode1",
              "Width", 0.1, "dateDeath", "24/08/2022"}}})) {
    SCOPED_TRACE(file);
    const MtgTree plant = read_mtg(read_file(file, 1'000'000), file, {});
    EXPECT_EQ(joints(plant), facts.joints);
    EXPECT_EQ(plant.numbers(*plant.find_feature(facts.size))[6], facts.sixth);
    EXPECT_EQ(plant.texts(*plant.find_feature(facts.date))[4], facts.fourth);
  }
}

struct CodedFacts {
  std::size_t vertices;
  int finest_scale;
  MtgVertex inner;  ///< a vertex within a growth unit
  const char* label;
  const char* unit;  ///< the label of its growth unit
  MtgVertex first;   ///< the first internode of a second growth unit
  MtgVertex last;    ///< the last one of the unit before
};

TEST(Mtg, FilesCodedByHand) {
  for (const auto& [file, facts] :
       data_sets<CodedFacts>({{"tests/data/trees/coded_shoot.mtg", {23, 3, 14, "N6", "Y2", 18, 16}}},
                             {{"trees/monopodial_plant.mtg", {40, 4, 21, "E8", "U2", 19, 15}}})) {
    SCOPED_TRACE(file);
    const MtgTree shoot = read_mtg(read_file(file, 1'000'000), file, {});
    EXPECT_EQ(shoot.vertex_count(), facts.vertices);
    EXPECT_EQ(shoot.finest_scale(), facts.finest_scale);
    EXPECT_EQ(shoot.label(facts.inner), facts.label);
    EXPECT_EQ(shoot.label(shoot.complex[facts.inner]), facts.unit);
    EXPECT_EQ(shoot.parent[facts.first], facts.last) << "the first of a unit follows the last one of the unit before";
  }
}

}  // namespace meristem::mtg_test

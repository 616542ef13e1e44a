// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/obstacle_warnings.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/grow.h"

namespace meristem::obstacle_warnings_test {

// Returns the warnings for components beside a wall from x = 1 to 1.5.
std::vector<Diagnostic> warnings_of(const std::string& components, const std::string& links = "[]",
                                    const std::string& box = "[[1, -1, -5], [1.5, 9, 5]]") {
  const std::string text = fmt::format(
      "{{\"meristem\": 1, \"scene\": {{\"obstacles\": [{{\"box\": {}}}]}},\n\"components\": {{{}}}, \"links\": {}}}",
      box, components, links);
  const Document document = read_document(text, "d.json", builtin_components());
  Progress progress;
  return grow_document(document, progress, {.up_to = GrownPart::plant}).warnings;
}

constexpr const char* kLeaning = R"("length": 3, "frame": {"rotate": [0, 0, -90], "translate": [0, 1, 0]})";

TEST(ObstacleWarnings, ATreeThatIsToldIntoAWallIsNamedWithThePlace) {
  const auto warnings = warnings_of(fmt::format(R"("limb": {{"type": "tree", {}}})", kLeaning));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].severity, Severity::warning);
  EXPECT_EQ(warnings[0].path, "components.limb");
  EXPECT_EQ(warnings[0].line, 2) << "placed in the text";
  EXPECT_NE(warnings[0].message.find("'limb' does not avoid obstacles and goes into them with"), std::string::npos)
      << warnings[0].message;
  EXPECT_NE(warnings[0].message.find(", 1, "), std::string::npos) << "at a height of 1 m: " << warnings[0].message;
}

// Along x at the height of 0.
constexpr const char* kWeed =
    R"j("weed": {"type": "lsystem", "steps": 1, "grammar": "F(2)", "frame": {"rotate": [0, 0, -90]}})j";

TEST(ObstacleWarnings, AHornAndAGrammarAreNamedToo) {
  const auto horn = warnings_of(fmt::format(R"("cob": {{"type": "horn", {}}})", kLeaning));
  ASSERT_FALSE(horn.empty());
  EXPECT_EQ(horn[0].path, "components.cob");
  const auto grammar = warnings_of(kWeed);
  ASSERT_EQ(grammar.size(), 1U);
  EXPECT_EQ(grammar[0].path, "components.weed");
}

TEST(ObstacleWarnings, AWallThatIsThinnerThanASegmentIsNotMissed) {
  EXPECT_EQ(warnings_of(kWeed, "[]", "[[1, -1, -5], [1.001, 9, 5]]").size(), 1U);
}

TEST(ObstacleWarnings, WhatStaysOutsideIsNotNamed) {
  EXPECT_TRUE(warnings_of(R"("limb": {"type": "tree", "length": 3})").empty());
  EXPECT_TRUE(warnings_of(R"("limb": {"type": "tree", "length": 3})", "[]", "[[-5, -1, -5], [5, 0, 5]]").empty())
      << "it stands on the obstacle";
}

TEST(ObstacleWarnings, WhatGrowsKeepsOutAndIsNotNamed) {
  EXPECT_TRUE(warnings_of(R"("tree": {"type": "colonize", "crown": {"sphere": {"centre": [0.5, 2, 0], "radius": 1}},
                             "points": 200, "step": 0.1, "influence": 1, "kill": 0.2})")
                  .empty());
}

}  // namespace meristem::obstacle_warnings_test

// SPDX-License-Identifier: Apache-2.0
// Crown links in documents: what they set where, and what is wrong with them.
#include <string>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "tests/support/build_graph.h"

namespace meristem::crown_link_test {

std::string text(const std::string& surface, const std::string& link) {
  return R"({"meristem": 1, "components": {
    "tree": {"type": "lsystem", "grammar": "#axiom\nF[+F][-F]F[]", "steps": 0, "length": 1, "width": 0.1, "surface": )" +
         surface + R"(},
    "leaf": {"type": "leaf"}, "box": {"type": "simple"}},
  "links": [["tree", "box"], )" +
         link + "]}";
}

const std::string kCrown = R"({"crown": {"diameter": 1, "fuse": 0.2, "hidden": true}})";
const std::string kLink = R"({"from": "tree", "to": "leaf", "kind": "crown", "density": 100})";

Plant grown(const std::string& document) {
  Progress progress;
  return grow_document(read_document(document, "test.json", builtin_components()), progress).plant;
}

TEST(CrownLink, SetsLeavesIntoTheCrown) {
  const Plant plant = grown(text(kCrown, kLink));
  const std::vector<Organ> leaves = organs_of(plant, "leaf");
  // Three balls of half a cubic metre each, which overlap.
  EXPECT_GT(leaves.size(), 80U);
  EXPECT_LT(leaves.size(), 180U);
}

TEST(CrownLink, ScalesWithWhatTheTreeHangsOn) {
  std::string larger = text(kCrown, kLink);
  larger.replace(larger.find("\"steps\""), 7, R"("frame": {"scale": [2, 2, 2]}, "steps")");
  const double ratio = static_cast<double>(organs_of(grown(larger), "leaf").size()) /
                       static_cast<double>(organs_of(grown(text(kCrown, kLink)), "leaf").size());
  EXPECT_NEAR(ratio, 8, 1.5);
}

TEST(CrownLink, WantsACrown) {
  const auto errors = errors_of([] { grown(text("{}", kLink)); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "links[1].kind");
  EXPECT_EQ(errors[0].message, "the surface of 'tree' has no crown");
}

TEST(CrownLink, WantsStems) {
  const auto errors = errors_of([] { grown(text(kCrown, R"({"from": "box", "to": "leaf", "kind": "crown"})")); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].message, "'box' makes no stems that could have a crown");
}

TEST(CrownLink, KnowsNoKeysOfBranchLinks) {
  const auto errors =
      errors_of([] { grown(text(kCrown, R"({"from": "tree", "to": "leaf", "kind": "crown", "whorl": 3})")); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "links[1].whorl");
}

}  // namespace meristem::crown_link_test

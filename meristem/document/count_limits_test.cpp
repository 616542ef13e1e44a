// SPDX-License-Identifier: Apache-2.0
// Documents whose counts alone pass limits are refused before anything grows, and documents that may stay below are
// not.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"

namespace meristem::count_limits_test {

std::string document(const std::string& components, const std::string& links, const std::string& limits = "") {
  return fmt::format(R"({{"meristem": 1, "components": {{{}}}, "links": [{}], "limits": {{{}}}}})", components, links,
                     limits);
}

/// How growth ends if it is cancelled from the start: refusals by counts come before anything else.
std::vector<std::string> outcome(const std::string& text) {
  const Document document = read_document(text, "d.json", builtin_components());
  Progress progress;
  progress.cancel();
  try {
    grow_document(document, progress);
  } catch (const Cancelled&) {
    return {"cancelled"};
  } catch (const InputError& error) {
    std::vector<std::string> messages;
    for (const Diagnostic& fault : error.diagnostics()) messages.push_back(fault.message + "; " + fault.expected);
    return messages;
  }
  return {"grown"};
}

using Messages = std::vector<std::string>;
const Messages kCancelled{"cancelled"};

constexpr const char* kLeaf = R"("leaf": {"type": "leaf"})";

std::string star(const std::string& id, const std::string& rows) {
  return fmt::format(R"("{}": {{"type": "hydra", {}}}, )", id, rows);
}

TEST(CountLimits, CountsOfMultipliersMultiply) {
  const std::string stars =
      star("a", R"("number": 300)") + star("b", R"("number": 700)") + star("c", R"("number": 999)");
  EXPECT_EQ(outcome(document(stars + kLeaf, R"(["a", "b"], ["b", "c"], ["c", "leaf"])")),
            Messages{"2.1e+08 instances, of which leaf 2.1e+08 (100 %), are too many; at most 20000000 "
                     "(limits.instances)"});
  EXPECT_EQ(outcome(document(stars + kLeaf, R"(["a", "b"], ["b", "c"], ["c", "leaf"])", R"("instances": 3e8)")),
            kCancelled);
}

TEST(CountLimits, TheLargestShareIsNamed) {
  const std::string text = document(star("crown", R"("number": 10)") + star("twig", R"("number": 9)") + kLeaf,
                                    R"(["crown", "twig"], ["twig", "leaf"])", R"("instances": 101)");
  // The camera, one crown, 10 twigs and 90 leaves.
  EXPECT_EQ(outcome(text),
            Messages{"102 instances, of which leaf 90 (88 %), are too many; at most 101 (limits.instances)"});
}

TEST(CountLimits, ExactlyAsManyAsTheLimitAreNotTooMany) {
  const std::string components = star("crown", R"("number": 10)") + kLeaf;
  EXPECT_EQ(outcome(document(components, R"(["crown", "leaf"])", R"("instances": 12)")), kCancelled);
  EXPECT_EQ(outcome(document(components, R"(["crown", "leaf"])", R"("instances": 11)")).size(), 1U);
}

TEST(CountLimits, NestedRecursionsAreCountedWithoutBeingMade) {
  // Each recursion of 100 lies within the one before.
  std::string components;
  for (const char id : {'a', 'b', 'c', 'd'}) {
    components += fmt::format(R"({}"{}": {{"type": "simple", "recursion": 100}})", id == 'a' ? "" : ", ", id);
  }
  const Messages messages = outcome(
      document(components, R"(["a", "b"], ["b", "c"], ["c", "d"], ["d", "d"], ["d", "c"], ["d", "b"], ["d", "a"])"));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("instances, of which d"), std::string::npos) << messages[0];
}

TEST(CountLimits, AllLimitsArePassedAtOnce) {
  const std::string text =
      document(R"("wood": {"type": "field", "rows": 1000, "plants": 1000},
                  "stem": {"type": "tree", "segments": 99}, )" +
                   std::string(kLeaf),
               R"(["wood", "stem"], {"from": "stem", "to": "leaf", "kind": "branch", "count": 60})");
  EXPECT_EQ(
      outcome(text),
      (Messages{"6.1e+07 instances, of which leaf 6e+07 (98 %), are too many; at most 20000000 (limits.instances)",
                "1e+08 skeleton nodes, of which stem 1e+08 (100 %), are too many; at most 20000000 "
                "(limits.nodes)"}));
}

TEST(CountLimits, OfACountThatVariesTheSmallestValueCounts) {
  const auto text = [](const std::string& number) {
    return document(star("a", R"("number": 5000)") + star("b", "\"number\": " + number) + kLeaf,
                    R"(["a", "b"], ["b", "leaf"])");
  };
  EXPECT_EQ(outcome(text("[5000, 6000]")).front().substr(0, 18), "2.5e+07 instances,");
  EXPECT_EQ(outcome(text("[10, 20000]")), kCancelled);
  EXPECT_EQ(outcome(text("\"5000 + 1000*rand()\"")), kCancelled) << "nothing is known of an expression";
}

TEST(CountLimits, NothingIsCountedThatMayNotBeThere) {
  const auto text = [](const std::string& rows, const std::string& more = "") {
    return document(star("a", R"("number": 5000)") + star("b", "\"number\": 5000, " + rows) + more + kLeaf,
                    R"(["a", "b"], ["b", "leaf"])");
  };
  EXPECT_NE(outcome(text(R"j("arc": 90)j")), kCancelled);
  EXPECT_EQ(outcome(text(R"j("size": "rand()")j")), kCancelled) << "children may have no size";
  EXPECT_EQ(outcome(text(R"j("frame": {"scale": ["rand()", 1, 1]})j")), kCancelled);
  EXPECT_EQ(outcome(text(R"j("omit": ["i == 0"])j")), kCancelled);
  // Each instance of the recursion is smaller than its parent, and vanished instances have no children.
  const auto shrinking = [](const std::string& size) {
    return document(R"j("twig": {"type": "hydra", "number": 2, "recursion": 60, "size": )j" + size + "}",
                    R"j(["twig", "twig"])j");
  };
  EXPECT_NE(outcome(shrinking("0.5")), kCancelled) << "2 to the power of 25 are there before they vanish";
  EXPECT_EQ(outcome(shrinking("0.0001")), kCancelled);
}

TEST(CountLimits, LimitsAlsoBoundTheMemoryOfInstances) {
  // A stem of two nodes takes more memory than limits.instances and limits.nodes stand for.
  const Document stems = read_document(document(R"("field": {"type": "field", "rows": 500, "plants": 500},
                  "stem": {"type": "tree", "length": 0.1, "segments": 1})",
                                                R"(["field", "stem"])", R"("instances": 250002, "nodes": 500000)"),
                                       "d.json", builtin_components());
  Progress progress;
  try {
    grow_document(stems, progress, {.up_to = GrownPart::plant});
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("bytes of memory, which are too many"), std::string::npos) << text;
    EXPECT_NE(text.find("160 for each of 250002 (limits.instances)"), std::string::npos) << text;
  }
}

TEST(CountLimits, SitesOfAWideFieldAreNoMemoryThatIsKept) {
  const Document field =
      read_document(document(R"("field": {"type": "field", "rows": 300, "plants": 300}, "leaf": {"type": "leaf"})",
                             R"(["field", "leaf"])", R"("instances": 90002, "nodes": 1)"),
                    "d.json", builtin_components());
  Progress progress;
  EXPECT_EQ(grow_document(field, progress, {.up_to = GrownPart::plant}).plant.organs.size(), 90000U);
  GrowthCache cache;
  EXPECT_EQ(grow_document(field, progress, {.up_to = GrownPart::plant, .cache = &cache}).plant.organs.size(), 90000U);
}

TEST(CountLimits, StemsThatEndWithinTheBarkOfTheirParentBearNothing) {
  const Document trunk = read_document(document(R"("trunk": {"type": "tree", "length": 4, "radius": 2},
                  "spine": {"type": "tree", "length": 0.2, "radius": 0.01}, "leaf": {"type": "leaf"})",
                                                R"({"from": "trunk", "to": "spine", "kind": "branch", "count": 80},
                  {"from": "spine", "to": "leaf", "kind": "branch", "count": 900})",
                                                R"("instances": 1000)"),
                                       "d.json", builtin_components());
  Progress progress;
  EXPECT_EQ(grow_document(trunk, progress, {.up_to = GrownPart::plant}).plant.organs.size(), 0U);
}

}  // namespace meristem::count_limits_test

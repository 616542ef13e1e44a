// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/plan.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/graph/batch.h"
#include "meristem/plant/operation_record.h"
#include "tests/support/build_graph.h"

namespace meristem::plan_test {

constexpr const char* kPruned = R"j({
  "meristem": 1, "seed": 2, "variables": {"kept": 2},
  "components": {
    "tree": {"type": "organize", "iterations": 12, "length": 0.1, "roots": [[0, 0, 0], [0.6, 0, 0]],
             "operations": [{"do": "cut", "from": 6, "every": 6, "shoots": "rank == 1 && length > 0.2", "above": "kept"}]},
    "bush": {"type": "organize", "iterations": 12, "length": 0.1, "roots": [[0.3, 0, 0.5]]},
    "leaf": {"type": "leaf", "length": 0.06, "width": 0.03}
  },
  "links": [["tree", "leaf"]]
})j";

constexpr const char* kWhole = R"j({"do": "cut", "shoots": "main.3", "above": 0})j";
constexpr const char* kThin = R"j({"do": "cut", "shoots": "rank == 2 && age > 1", "above": 0})j";

Document read(const std::vector<ValueOverride>& overrides = {}, const std::string& text = kPruned) {
  return read_document(text, "test.json", builtin_components(), {.overrides = overrides});
}

GrownDocument grown(const Document& document, const GrowthView& view = {}, GrowthCache* cache = nullptr) {
  Progress progress;
  return grow_document(document, progress, {.up_to = GrownPart::meshes, .cache = cache, .view = view});
}

/// Returns a hash of everything that is visible or reported of a plant.
std::string hash_of(const GrownDocument& grown) {
  std::string text;
  for (const Stem& stem : grown.plant.stems) {
    text += skeleton_hash(stem.skeleton);
    for (const auto& [name, values] : stem.skeleton.extra) {
      text += name;
      for (const float value : values) text += std::to_string(value) + ",";
    }
    for (const OperationRecord& record : stem.skeleton.operations) text += record.operation + record.shoot;
  }
  for (const MeshInstances& instances : grown.meshes.meshes) {
    text += instances.component + std::to_string(instances.mesh->triangle_count());
    for (const Frame& frame : instances.frames) text += std::to_string(frame.origin.y) + ",";
  }
  return text;
}

TEST(Plan, TheTreesBeforeAndAfterItAreOneGrowth) {
  // The rule acts on both components, after the last iteration of each.
  const PlanRules rules{{parse_json(kThin)}};
  const Document asked = read();
  const Document done = read(with_rules(asked, rules));
  const Document planned = read(only_planned(asked, rules));
  GrowthCache cache;
  const GrownDocument before = grown(planned, {{}, {TracePart::outcome}}, &cache);
  EXPECT_GT(cache.reuse<GrownBatch>().made, 0U);
  const GrownDocument after = grown(planned, {{}, {TracePart::outcome}, true}, &cache);
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 0U);
  EXPECT_EQ(hash_of(before), hash_of(grown(planned))) << "no plan knows who asks for its outcome";
  std::size_t by_rule = 0;
  for (const Stem& stem : before.plant.stems) {
    for (const OperationRecord& one : stem.skeleton.operations) {
      by_rule += one.operation == "components.bush.operations[0]" ? 1 : 0;
    }
  }
  EXPECT_GT(by_rule, 0U);
  EXPECT_EQ(hash_of(after), hash_of(grown(done)));
  // Without a cache it is grown again, to the same bytes.
  EXPECT_EQ(hash_of(after), hash_of(grown(planned, {{}, {}, true})));
}

TEST(Plan, ComponentsWithoutOperationsPlanNothing) {
  const std::vector<ValueOverride> overrides = only_planned(read(), {});
  ASSERT_EQ(overrides.size(), 1U);
  EXPECT_EQ(overrides[0].path, "components.tree.plan");
  EXPECT_NO_THROW(read(overrides));
}

TEST(Plan, RulesGoOnWhereTheDocumentEnds) {
  const Document asked = read();
  const std::vector<ValueOverride> overrides = with_rules(
      asked, {{parse_json(kWhole), parse_json(R"j({"do": "mark", "from": 2, "shoots": "inward"})j")}, "--rule"});
  ASSERT_EQ(overrides.size(), 2U);
  EXPECT_EQ(overrides[0].path, "components.tree.operations");
  EXPECT_EQ(overrides[0].name, "--rule");
  const Value::List& operations = *overrides[0].value.list();
  ASSERT_EQ(operations.size(), 3U);
  EXPECT_EQ(*operations[0].find("above"), Value("kept"));
  EXPECT_EQ(*operations[1].find("at"), Value(12));
  EXPECT_EQ(operations[2].find("at"), nullptr);
  EXPECT_EQ(*overrides[1].value.list()->at(0).find("at"), Value(12)) << "of the bush";
  EXPECT_TRUE(with_rules(asked, {}).empty());
  // Operations that were set when the document was read stay, too.
  const Document set = read({parse_override(R"j(tree.operations=[{"do":"spur"}])j")});
  EXPECT_EQ(*with_rules(set, {{parse_json(kWhole)}})[0].value.list()->at(0).find("do"), Value("spur"));
}

TEST(Plan, WhatCannotBePlannedIsAFault) {
  const auto message = [](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      return error.diagnostics().at(0).message;
    }
    return std::string("no fault");
  };
  const Document asked = read();
  EXPECT_EQ(message([&] { with_rules(asked, {{Value(7)}}); }), "rules cannot be the number 7");
  const Value summer = parse_json(R"j({"do": "cut", "season": "summer", "shoots": "inward", "above": 0})j");
  EXPECT_EQ(message([&] { with_rules(asked, {{summer}}); }),
            "what is planned acts after all growth of the last iteration, and not in summer");
  const Document box = read({}, R"j({"meristem": 1, "components": {"box": {"type": "simple"}}})j");
  EXPECT_EQ(message([&] { only_planned(box, {}); }), "'test.json' has no trees that operations act on");
}

}  // namespace meristem::plan_test

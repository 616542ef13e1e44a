// SPDX-License-Identifier: Apache-2.0
// Documents that grow after one another with one cache: the same bytes as without, and no more work than there must be.
#include <fstream>
#include <span>

#include <gtest/gtest.h>

#include "meristem/base/hash.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/document/models.h"
#include "meristem/graph/batch.h"
#include "meristem/shape/stem/cached_meshes.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::growth_cache_test {

constexpr const char* kTwoTrees = R"j({
  "meristem": 1,
  "variables": {"leafy": 30, "spread": 0.5, "thick": 8},
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [1, 1], [0.2, 2]]}, "points": 500,
             "step": 0.05, "influence": "spread", "kill": 0.15, "surface": {"sides": "thick"}},
    "shrub": {"type": "colonize", "crown": {"profile": [[0.2, 0.3], [0.5, 0.5], [0.2, 1]]}, "points": 200,
              "step": 0.05, "influence": 0.5, "kill": 0.15, "frame": {"translate": [1, 0, 0]}, "alone": false},
    "leaf": {"type": "leaf", "length": "0.05*(1 + 0.3*gauss(0,1))", "curl": "20*rand(-1,1)"}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": "leafy", "angle_spread": 20}]
})j";

Document read(const std::string& text, const std::vector<std::string>& overrides = {},
              const std::string& file = "test.json") {
  std::vector<ValueOverride> parsed;
  for (const std::string& each : overrides) parsed.push_back(parse_override(each));
  return read_document(text, file, builtin_components(), {.overrides = parsed});
}

template <class T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
  const auto more = std::as_bytes(std::span(values));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Hash of the plant, and of every vertex, index, placement and tint of its meshes.
std::string hash_of(const GrownDocument& grown) {
  std::vector<std::byte> bytes;
  for (const MeshInstances& instances : grown.meshes.meshes) {
    append(bytes, std::vector<char>(instances.component.begin(), instances.component.end()));
    append(bytes, std::vector<std::uint32_t>{instances.material});
    append(bytes, instances.mesh->positions);
    append(bytes, instances.mesh->normals);
    append(bytes, instances.mesh->uvs);
    append(bytes, instances.mesh->tangents);
    append(bytes, instances.mesh->triangles);
    append(bytes, instances.frames);
    append(bytes, instances.tints);
  }
  for (const Material& material : grown.meshes.materials) append(bytes, std::vector<Vec3>{material.colour});
  return hash_of(grown.plant) + hash128_hex(bytes);
}

GrownDocument grow(const Document& document, GrowthCache* cache = nullptr, double time = 0) {
  Progress progress;
  return grow_document(document, progress, {.time = time, .cache = cache});
}

/// Grows the two trees, then with a change, which must give what it gives without a cache.
struct Changed {
  GrowthCache cache;

  explicit Changed(const std::string& change) {
    grow(read(kTwoTrees), &cache);
    const Document document = read(kTwoTrees, {change});
    EXPECT_EQ(hash_of(grow(document, &cache)), hash_of(grow(document))) << change;
  }
};

TEST(GrowthCache, EditingLeavesNeitherGrowsTreesNorClothesThem) {
  for (const char* change : {"leafy=40", "leaf.length=0.1", "leaf.colour=\"#aabbcc\"", "links[0].angle=20"}) {
    const Changed changed(change);
    EXPECT_EQ(changed.cache.reuse<GrownBatch>().made, 0U) << change;
    EXPECT_EQ(changed.cache.reuse<GrownBatch>().reused, 2U) << change;
    EXPECT_EQ(changed.cache.reuse<StemTubes>().made, 0U) << change;
  }
}

TEST(GrowthCache, LooksOfATreeDoNotGrowItAnew) {
  for (const char* change : {"thick=5", "tree.colour=\"#aabbcc\"", "tree.surface.smooth=1", "tree.hidden=true",
                             "tree.shed=\"height < 1 && radius < 0.004\""}) {
    EXPECT_EQ(Changed(change).cache.reuse<GrownBatch>().made, 0U) << change;
  }
}

TEST(GrowthCache, AtAnotherTimeOnlyWhatAsksForItIsMadeAnew) {
  const Document document = read(kTwoTrees, {"leaf.curl=\"20 + t\""});
  GrowthCache cache;
  grow(document, &cache);
  EXPECT_EQ(hash_of(grow(document, &cache, 3)), hash_of(grow(document, nullptr, 3)));
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 0U);
  EXPECT_GT(cache.reuse<BatchResult>().made, 0U);
  EXPECT_EQ(cache.reuse<BatchResult>().reused, 3U);  // the camera and both trees
  EXPECT_EQ(cache.reuse<StemTubes>().made, 0U);
}

TEST(GrowthCache, WhatCompetesGrowsAnewTogether) {
  for (const char* change : {"spread=0.4", "tree.points=400", "shrub.frame.translate[0]=1.2", "seed=3"}) {
    EXPECT_EQ(Changed(change).cache.reuse<GrownBatch>().made, 2U) << change;
  }
  std::string text = kTwoTrees;
  text.replace(text.find("\"alone\": false"), 14, "\"alone\": true");
  GrowthCache cache;
  grow(read(text), &cache);
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 2U);
  grow(read(text, {"spread=0.4"}), &cache);
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 1U);
}

TEST(GrowthCache, TheSceneAndItsVariablesGrowAllAnew) {
  std::string text = kTwoTrees;
  text.replace(text.find("\"leafy\""), 0, "\"north\": 48, ");
  text.insert(text.find("\"components\""),
              "\"scene\": {\"latitude\": \"north\", \"sun\": {\"day\": 172, \"hour\": 10}}, ");
  GrowthCache cache;
  grow(read(text), &cache);
  const Document changed = read(text, {"north=60"});
  EXPECT_EQ(hash_of(grow(changed, &cache)), hash_of(grow(changed)));
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 2U);
  EXPECT_EQ(cache.reuse<BatchResult>().reused, 0U);
}

TEST(GrowthCache, WhatIsDerivedFromAVariableGrowsAnewWithIt) {
  std::string text = kTwoTrees;
  text.replace(text.find("\"spread\": 0.5"), 13,
               R"("spread": {"value": "reach/2", "private": true}, "reach": "far", "far": 1)");
  text.replace(text.find("\"leafy\": 30"), 11, R"("leafy": "lush*10", "lush": 3)");
  GrowthCache cache;
  grow(read(text), &cache);
  const Document far = read(text, {"far=0.8"});
  EXPECT_EQ(hash_of(grow(far, &cache)), hash_of(grow(far)));
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 2U);  // they compete
  EXPECT_NE(hash_of(grow(far)), hash_of(grow(read(text))));
  // Leaves follow their own variable and leave the trees as they are.
  const Document lush = read(text, {"far=0.8", "lush=4"});
  EXPECT_EQ(hash_of(grow(lush, &cache)), hash_of(grow(lush)));
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 0U);
  EXPECT_NE(hash_of(grow(lush)), hash_of(grow(far)));
  // A variable with another expression of equal value leaves unchanged what uses it.
  const Document same = read(text, {"far=2", "reach=far*0.4", "lush=4"});
  EXPECT_EQ(hash_of(grow(same, &cache)), hash_of(grow(lush)));
  EXPECT_EQ(cache.reuse<GrownBatch>().made, 0U);
}

TEST(GrowthCache, WhatStandsInFilesCountsNotTheirNames) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& text) { std::ofstream(folder / "plant.l") << text; };
  write("#axiom A\n#rules\nA -> F[+A]F\n");
  const std::string text =
      R"j({"meristem": 1, "components": {"weed": {"type": "lsystem", "file": "plant.l", "steps": 3}}})j";
  const std::string file = (folder / "weed.json").string();
  GrowthCache cache;
  const std::string first = hash_of(grow(read(text, {}, file), &cache));
  EXPECT_EQ(hash_of(grow(read(text, {}, file), &cache)), first);
  EXPECT_EQ(cache.reuse<BatchResult>().made, 0U);
  write("#axiom A\n#rules\nA -> F[-A]F\n");
  const std::string second = hash_of(grow(read(text, {}, file), &cache));
  EXPECT_NE(second, first);
  EXPECT_EQ(second, hash_of(grow(read(text, {}, file))));
}

TEST(GrowthCache, TexturesStayInUseBetweenGrowths) {
  const std::string text = R"j({"meristem": 1, "components": {"leaf": {"type": "leaf",
    "texture": {"leaf": {"veins": "pinnate"}, "pixels": 32}}}})j";
  GrowthCache cache;
  const Texture* const first = grow(read(text), &cache).meshes.materials.at(0).texture.get();
  EXPECT_EQ(grow(read(text), &cache).meshes.materials.at(0).texture.get(), first);
}

TEST(GrowthCache, ModelsGiveTheSameBytesWhateverChangesBefore) {
  for (const char* model : {"mint", "fern", "low-poly-shrub"}) {
    const std::string file = model_path(std::string(MERISTEM_SOURCE_DIR) + "/models", model);
    const std::string text = read_text_file(file);
    GrowthCache cache;
    for (const Variable& variable : read(text, {}, file).variables) {
      for (const double share : {0.6}) {
        const double value = variable.min + share * (variable.max - variable.min);
        const Document document = read(text, {variable.name + "=" + std::to_string(value)}, file);
        EXPECT_EQ(hash_of(grow(document, &cache)), hash_of(grow(document))) << model << " " << variable.name;
      }
    }
    const Document document = read(text, {}, file);
    for (const double time : {0.0, 1.0}) {
      EXPECT_EQ(hash_of(grow(document, &cache, time)), hash_of(grow(document, nullptr, time))) << model;
    }
  }
}

/// A component that a grammar places is missing after an edit: the cached growth before does not hide it.
TEST(GrowthCache, APlacedComponentThatIsTakenAwayIsMissed) {
  const auto text = [](const std::string& other) {
    return R"j({"meristem": 1, "components": {"plant": {"type": "lsystem", "steps": 0,
      "grammar": "#symbols leaf\n#axiom F~A~B\n#rules\nA -> leaf\nB -> leaf\n"},
      "leaf": {"type": "leaf"}, "B": {"type": "leaf"})j" +
           other + "}}";
  };
  GrowthCache cache;
  Progress progress;
  grow_document(read(text(R"(, "A": {"type": "leaf"})")), progress, {.cache = &cache});
  EXPECT_THROW(grow_document(read(text("")), progress, {.cache = &cache}), InputError);
  EXPECT_THROW(grow_document(read(text("")), progress), InputError);
}

}  // namespace meristem::growth_cache_test

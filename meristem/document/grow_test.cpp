// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/grow.h"

#include <span>

#include <gtest/gtest.h>

#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"

namespace meristem::grow_test {

constexpr const char* kTree = R"j({
  "meristem": 1,
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [1, 1], [0.2, 2]]}, "points": 800,
             "step": 0.05, "influence": 0.5, "kill": 0.15},
    "leaf": {"type": "leaf", "length": "0.05*(1 + 0.3*gauss(0,1))", "curl": "20*rand(-1,1)"}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 30, "angle_spread": 20}]
})j";

Document read(const std::string& text, const std::vector<ValueOverride>& overrides = {}) {
  return read_document(text, "tree.json", builtin_components(), {.overrides = overrides});
}

template <class T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
  const auto more = std::as_bytes(std::span(values));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Hash of every vertex, index and placement of the mesh scene.
std::string hash_of(const Document& document) {
  Progress progress;
  const MeshScene meshes = grow_document(document, progress).meshes;
  std::vector<std::byte> bytes;
  for (const MeshInstances& instances : meshes.meshes) {
    append(bytes, instances.mesh->positions);
    append(bytes, instances.mesh->normals);
    append(bytes, instances.mesh->triangles);
    append(bytes, instances.frames);
  }
  return hash128_hex(bytes);
}

std::string error_of(const std::string& text, const std::vector<ValueOverride>& overrides = {}) {
  const Document document = read(text, overrides);
  try {
    Progress progress;
    grow_document(document, progress);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(GrowDocument, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Document document = read(kTree);
  const std::string expected = hash_of(document);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(hash_of(document), expected) << threads << " threads";
  }
}

TEST(GrowDocument, GivesOtherBytesForAnotherSeed) {
  EXPECT_NE(hash_of(read_document(kTree, "", builtin_components(), {.seed = 5})),
            hash_of(read_document(kTree, "", builtin_components(), {.seed = 6})));
}

TEST(GrowDocument, PlacesTheFaultOfALimitInTheText) {
  std::string text = kTree;
  text.insert(text.find("\"components\""), "\"limits\": {\"nodes\": 20}, ");
  const std::string nodes = error_of(text);
  EXPECT_EQ(nodes.substr(0, 10), "tree.json:") << nodes;
  EXPECT_NE(nodes.find("components.tree"), std::string::npos) << nodes;
  EXPECT_NE(nodes.find("(limits.nodes)"), std::string::npos) << nodes;

  text = kTree;
  text.insert(text.find("\"components\""), "\"limits\": {\"instances\": 20}, ");
  const std::string instances = error_of(text);
  EXPECT_EQ(instances.substr(0, 34), "tree.json:8:73: links[0].density: ") << instances;
}

TEST(GrowDocument, PlacesAFaultAtTheOverrideThatBroughtIt) {
  const std::string error = error_of(kTree, {parse_override("links[0].density=1e8")});
  EXPECT_EQ(error.substr(0, 24), "--set links[0].density: ") << error;
}

TEST(GrowDocument, PlacesNumbersThatAreNotFinite) {
  std::string text = kTree;
  text.replace(text.find("20*rand(-1,1)"), 13, "sqrt(-1 - i)");
  const std::string error = error_of(text);
  EXPECT_EQ(error.substr(0, 40), "tree.json:6:77: components.leaf.curl: th") << error;
}

TEST(GrowDocument, StopsWhenCancelled) {
  const Document document = read(kTree);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(grow_document(document, progress), Cancelled);
}

}  // namespace meristem::grow_test

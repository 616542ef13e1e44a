// SPDX-License-Identifier: Apache-2.0
// Writes one binary glTF of each kind that the writer knows into a directory, for an independent validator to judge.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/random.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/gltf/gltf_layout.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {
namespace {

MeshScene empty_scene() {
  MeshScene scene;
  Material wood;
  wood.name = "stem";
  wood.colour = {0.42F, 0.34F, 0.27F};
  Material leaf;
  leaf.name = "leaf";
  leaf.colour = {0.35F, 0.47F, 0.17F};
  leaf.two_sided = true;
  leaf.translucency = 0.4F;
  scene.materials = {wood, leaf};
  return scene;
}

void add_stem(MeshScene& scene, int segments) {
  scene.meshes.push_back({"stem", std::make_shared<const Mesh>(make_cylinder(0.1, 2, segments)), 0, {Frame()}});
}

/// Leaves turned and scaled every way: unevenly, mirrored, sheared and flat ones too.
void add_leaves(MeshScene& scene, int count) {
  const RandomKey key(11);
  std::vector<Frame> frames;
  for (int i = 0; i < count; ++i) {
    Frame frame = frame_along(Vec3(0, 2, 0) + key.direction(i), key.child(3).direction(i), kUp);
    frame.axes[0] *= static_cast<float>(key.child(1).uniform(i, 0.5, 2.0)) * (i % 5 == 0 ? -1.0F : 1.0F);
    frame.axes[1] *= static_cast<float>(key.child(2).uniform(i, 0.5, 2.0));
    if (i % 31 == 7) frame.axes[1] += 0.3F * frame.axes[2];
    if (i % 97 == 8) frame.axes[2] = Vec3(0);
    frames.push_back(frame);
  }
  LeafBlade blade;
  blade.curl = 0.5;
  blade.petiole = 0.02;
  scene.meshes.push_back({"leaf", std::make_shared<const Mesh>(make_leaf_blade(blade)), 1, std::move(frames)});
}

int count_inexpressible(const MeshScene& scene) {
  int count = 0;
  for (const MeshInstances& instances : scene.meshes) {
    for (const Frame& frame : instances.frames) count += is_expressible_as_node(frame) ? 0 : 1;
  }
  return count;
}

/// A checkered picture with a hole in the middle, and normals that lean to its corners.
std::shared_ptr<const Texture> sample_texture() {
  constexpr int kPixels = 32;
  Texture texture;
  texture.name = "sample";
  texture.masked = true;
  texture.mean = Vec3(0.6F, 0.7F, 0.5F);
  texture.colour = texture.normals = {kPixels, kPixels, std::vector<std::uint8_t>(4 * kPixels * kPixels)};
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const bool is_light = (x / 4 + y / 4) % 2 == 0;
      const bool is_hole = std::abs(2 * x - kPixels) + std::abs(2 * y - kPixels) < kPixels / 4;
      const auto light = static_cast<std::uint8_t>(is_light ? 220 : 170);
      std::uint8_t* const colour = texture.colour.pixel(x, y);
      std::uint8_t* const normal = texture.normals.pixel(x, y);
      const std::uint8_t alpha = is_hole ? 0 : 255;
      const std::array<std::uint8_t, 4> colours{light, light, 150, alpha};
      const std::array<std::uint8_t, 4> normals{static_cast<std::uint8_t>(120 + x / 2),
                                                static_cast<std::uint8_t>(120 + y / 2), 250, 255};
      std::copy(colours.begin(), colours.end(), colour);
      std::copy(normals.begin(), normals.end(), normal);
    }
  }
  return std::make_shared<const Texture>(std::move(texture));
}

/// The tree with textures and tangents on both materials and a tint on every leaf.
MeshScene textured(MeshScene scene) {
  const RandomKey key(12);
  for (Material& material : scene.materials) material.texture = sample_texture();
  for (MeshInstances& instances : scene.meshes) {
    instances.mesh = with_needed_tangents(instances.mesh, scene.materials[instances.material]);
    if (instances.frames.size() == 1) continue;
    for (std::size_t i = 0; i < instances.frames.size(); ++i) {
      instances.tints.emplace_back(key.child(0).uniform(i, 0.5, 1.6), key.child(1).uniform(i, 0.5, 1.2), 1);
    }
  }
  return scene;
}

/// The content that a reader must find in a file besides its triangles.
struct Expected {
  int instanced_meshes = 0;
  int instance_colours = 0;
  int vertex_colours = 0;
  int tangents = 0;
  int materials_with_map = 0;
};

/// Writes files, and what is in them for a reader to be compared with.
class Samples {
 public:
  explicit Samples(std::string directory) : directory_(std::move(directory)) {}

  void write(const MeshScene& scene, const std::string& name, std::uint64_t flatten_triangles, Expected expected,
             bool instanced = false) {
    GltfOptions options;
    options.flatten_triangles = flatten_triangles;
    options.instances = instanced ? GltfInstances::rows : GltfInstances::nodes;
    options.provenance = {"Sample \"plant\" \xC3\xA9", "A. Author", "CC0-1.0", 7, "0.1.0"};
    Progress progress;
    write_glb(scene, directory_ + "/" + name, options, progress);
    const Box box = scene.bounds();
    const bool is_empty = scene.triangle_count() == 0;
    text_ += fmt::format("{}\n  \"{}\": {{\"triangles\": {}, \"low\": {}, \"high\": {}", text_.empty() ? "{" : ",",
                         name, scene.triangle_count(), is_empty ? 1 : box.low.y, is_empty ? 0 : box.high.y);
    text_ += fmt::format(", \"instanced_meshes\": {}, \"instance_colours\": {}, \"vertex_colours\": {}",
                         expected.instanced_meshes, expected.instance_colours, expected.vertex_colours);
    text_ += fmt::format(
        ", \"tangents\": {}, \"materials_with_map\": {}, \"materials_with_normal_map\": {}, \"masked_materials\": {}}}",
        expected.tangents, expected.materials_with_map, expected.materials_with_map, expected.materials_with_map);
  }

  void write_expectations() const {
    AtomicFile file(directory_ + "/expected.json");
    file.write(text_ + "\n}\n");
    file.commit();
  }

 private:
  std::string directory_;
  std::string text_;
};

/// The tree as three plants, whose leaves change from one plant to the next.
MeshScene divided(MeshScene scene) {
  scene.individuals = {{"tree", 0, {-3, 0, 0}}, {"tree", 1, {0, 0, 0}}, {"tree", 2, {3, 0.5F, 0}}};
  std::uint32_t next = 0;
  for (MeshInstances& instances : scene.meshes) {
    for (std::size_t i = 0; i < instances.frames.size(); ++i) instances.individuals.push_back(next++ % 3);
  }
  return scene;
}

void write_all(const std::string& directory) {
  constexpr std::uint64_t kNoLimit = 1'000'000;
  MeshScene stem = empty_scene();
  add_stem(stem, 12);
  MeshScene tree = stem;
  add_leaves(tree, 1000);
  MeshScene large = empty_scene();
  add_stem(large, 40000);
  Samples samples(directory);
  samples.write(empty_scene(), "empty.glb", 0, {});
  samples.write(stem, "stem.glb", kNoLimit, {});
  samples.write(tree, "flattened.glb", kNoLimit, {});
  samples.write(tree, "shared.glb", 0, {});
  samples.write(large, "wide_indices.glb", kNoLimit, {});
  // The stem, and the leaves: upright, mirrored, and flattened.
  samples.write(tree, "instanced.glb", kNoLimit, {.instanced_meshes = 2}, true);
  samples.write(textured(tree), "textured.glb", kNoLimit,
                {.vertex_colours = 1, .tangents = 2, .materials_with_map = 2});
  // three.js makes two materials of one that meshes have with and without vertex colours.
  samples.write(
      textured(tree), "textured_instanced.glb", kNoLimit,
      {.instanced_meshes = 2, .instance_colours = 2, .vertex_colours = 1, .tangents = 4, .materials_with_map = 3},
      true);
  // The stem, eight colours of leaves, and the flattened leaves: each leaf that is a node counts as a mesh.
  const int nodes = 1000 - count_inexpressible(tree);
  samples.write(textured(tree), "textured_shared.glb", 0,
                {.vertex_colours = 1, .tangents = nodes + 2, .materials_with_map = 10});
  samples.write(divided(tree), "plants.glb", kNoLimit, {});
  samples.write(divided(tree), "plants_shared.glb", 0, {});
  // The leaves of each plant, as they are and mirrored.
  samples.write(divided(tree), "plants_instanced.glb", kNoLimit, {.instanced_meshes = 6}, true);
  samples.write_expectations();
}

}  // namespace
}  // namespace meristem

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: glb_samples DIRECTORY\n", stderr);
    return 2;
  }
  try {
    meristem::write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glb_samples: %s\n", error.what());
    return 1;
  }
}

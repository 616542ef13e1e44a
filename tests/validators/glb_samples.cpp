// SPDX-License-Identifier: Apache-2.0
// Writes one binary glTF of each kind that the writer knows into a directory, for an independent validator to judge.
#include <cstdio>
#include <exception>
#include <string>

#include "meristem/base/random.h"
#include "meristem/output/gltf.h"
#include "meristem/shape/leaf_blade.h"
#include "meristem/shape/primitives.h"

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

void write(const MeshScene& scene, const std::string& path, std::uint64_t flatten_triangles) {
  GltfOptions options;
  options.flatten_triangles = flatten_triangles;
  options.provenance = {"Sample \"plant\" \xC3\xA9", "A. Author", "CC0-1.0", 7, "0.1.0"};
  Progress progress;
  write_glb(scene, path, options, progress);
}

void write_all(const std::string& directory) {
  MeshScene stem = empty_scene();
  add_stem(stem, 12);
  MeshScene tree = stem;
  add_leaves(tree, 1000);
  MeshScene large = empty_scene();
  add_stem(large, 40000);
  write(empty_scene(), directory + "/empty.glb", 0);
  write(stem, directory + "/stem.glb", 1'000'000);
  write(tree, directory + "/flattened.glb", 1'000'000);
  write(tree, directory + "/shared.glb", 0);
  write(large, directory + "/wide_indices.glb", 1'000'000);
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

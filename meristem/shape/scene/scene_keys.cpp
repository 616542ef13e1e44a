// SPDX-License-Identifier: Apache-2.0
// Hashes meshes, materials and instances of scenes, and compares the keys of two scenes. Hashes of shared meshes are
// remembered by address as long as the mesh exists.
#include "meristem/shape/scene/scene_keys.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "meristem/base/fingerprint.h"

namespace meristem {

namespace {

std::uint64_t hash_of(const Mesh& mesh) {
  return Fingerprint()
      .add_array(mesh.positions)
      .add_array(mesh.normals)
      .add_array(mesh.uvs)
      .add_array(mesh.triangles)
      .add_array(mesh.tangents)
      .hash();
}

void add(const Vec3& vector, Fingerprint& to) { to.add(vector.x).add(vector.y).add(vector.z); }

std::uint64_t hash_of(const Texture& texture) {
  Fingerprint fingerprint;
  if (texture.fingerprint != 0) return fingerprint.add(texture.fingerprint).add(texture.is_painted()).hash();
  fingerprint.add_text(texture.name).add(texture.masked);
  add(texture.mean, fingerprint);
  for (const Image* image : {&texture.colour, &texture.normals}) {
    fingerprint.add(image->width).add(image->height).add_array(image->rgba);
  }
  return fingerprint.hash();
}

using Name = std::pair<std::string_view, std::uint32_t>;

std::map<Name, std::size_t> places_of(const SceneKeys& keys) {
  std::map<Name, std::size_t> places;
  for (std::size_t k = 0; k < keys.batches.size(); ++k) {
    places.emplace(Name(keys.batches[k].component, keys.batches[k].number), k);
  }
  return places;
}

SceneDifference::Keys difference_of(std::vector<std::uint64_t> before, std::vector<std::uint64_t> after) {
  for (std::vector<std::uint64_t>* keys : {&before, &after}) {
    std::sort(keys->begin(), keys->end());
    keys->erase(std::unique(keys->begin(), keys->end()), keys->end());
  }
  SceneDifference::Keys keys;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(keys.added));
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(keys.removed));
  return keys;
}

std::vector<std::uint64_t> meshes_of(const SceneKeys& keys) {
  std::vector<std::uint64_t> meshes;
  for (const SceneKeys::Batch& batch : keys.batches) meshes.push_back(batch.mesh);
  return meshes;
}

}  // namespace

template <class Content>
std::uint64_t SceneKeyMaker::key_of(const std::shared_ptr<const Content>& content) {
  if (content == nullptr) return 0;
  Known& known = known_[content.get()];
  if (known.content.lock() != content) known = {content, hash_of(*content)};
  return known.key;
}

SceneKeys SceneKeyMaker::keys_of(const MeshScene& scene) {
  SceneKeys keys;
  for (const Material& material : scene.materials) {
    Fingerprint fingerprint;
    fingerprint.add_text(material.name)
        .add(material.roughness)
        .add(material.translucency)
        .add(material.opacity)
        .add(material.two_sided);
    add(material.colour, fingerprint);
    keys.materials.push_back(fingerprint.add(key_of(material.texture)).hash());
  }
  std::map<std::string_view, std::uint32_t> counts;
  for (const MeshInstances& instances : scene.meshes) {
    Fingerprint placed;
    placed.add_array(instances.frames).add_array(instances.tints);
    if (instances.places != nullptr) placed.add_array(*instances.places);
    keys.batches.push_back({.component = instances.component,
                            .number = counts[instances.component]++,
                            .mesh = key_of(instances.mesh),
                            .material = keys.materials[instances.material],
                            .instances = placed.hash()});
  }
  std::erase_if(known_, [](const auto& entry) { return entry.second.content.expired(); });
  return keys;
}

SceneDifference difference(const SceneKeys& before, const SceneKeys& after) {
  SceneDifference found;
  found.materials = difference_of(before.materials, after.materials);
  found.meshes = difference_of(meshes_of(before), meshes_of(after));
  const std::map<Name, std::size_t> were = places_of(before);
  const std::map<Name, std::size_t> are = places_of(after);
  for (std::size_t k = 0; k < after.batches.size(); ++k) {
    const auto was = were.find(Name(after.batches[k].component, after.batches[k].number));
    if (was == were.end()) {
      found.batches.added.push_back(k);
    } else if (before.batches[was->second] != after.batches[k]) {
      found.batches.changed.push_back(k);
    }
  }
  for (std::size_t k = 0; k < before.batches.size(); ++k) {
    if (!are.contains(Name(before.batches[k].component, before.batches[k].number))) found.batches.removed.push_back(k);
  }
  return found;
}

}  // namespace meristem

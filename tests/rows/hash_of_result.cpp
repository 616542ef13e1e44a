// SPDX-License-Identifier: Apache-2.0
#include "tests/rows/hash_of_result.h"

#include "meristem/base/fingerprint.h"
#include "meristem/components/camera.h"
#include "meristem/document/grow.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

namespace {

void add(Fingerprint& hash, Vec3 vector) { hash.add(vector.x).add(vector.y).add(vector.z); }

template <class T>
void add(Fingerprint& hash, const std::optional<T>& value) {
  hash.add(value.has_value());
  if (value) add(hash, *value);
}

void add(Fingerprint& hash, const Skeleton& skeleton) {
  hash.add_array(skeleton.parent).add_array(skeleton.position).add_array(skeleton.radius).add_array(skeleton.axis);
  hash.add_array(skeleton.order).add_array(skeleton.birth);
  for (const auto& [name, values] : skeleton.extra) hash.add_text(name).add_array(values);
  for (const OperationRecord& record : skeleton.operations) {
    hash.add_text(record.operation).add_text(record.act).add_text(record.shoot);
    hash.add(record.iteration).add(record.metamer).add(record.metamers);
  }
}

void add(Fingerprint& hash, const Mesh& mesh) {
  hash.add_array(mesh.positions).add_array(mesh.normals).add_array(mesh.uvs).add_array(mesh.triangles);
  hash.add_array(mesh.tangents);
}

void add(Fingerprint& hash, const Material& material) {
  add(hash, material.colour);
  hash.add(material.roughness).add(material.translucency).add(material.opacity).add(material.two_sided);
  if (material.texture == nullptr) return;
  hash.add(material.texture->masked).add_array(material.texture->colour.rgba);
  hash.add_array(material.texture->normals.rgba);
}

void add(Fingerprint& hash, const Scene& scene) {
  for (const auto* lights : {&scene.light.sun, &scene.light.sky}) {
    for (const DirectionalLight& light : *lights) {
      add(hash, light.toward);
      hash.add(light.strength);
    }
  }
  for (const Lamp& lamp : scene.light.lamps) {
    add(hash, lamp.position);
    hash.add(lamp.strength);
    add(hash, lamp.colour);
    add(hash, lamp.target);
    hash.add(lamp.angle).add(lamp.radius.value_or(-1));
  }
  hash.add(scene.sun.azimuth).add(scene.sun.altitude);
  hash.add(scene.latitude.value_or(100));
  if (scene.clock) hash.add(scene.clock->longitude).add(scene.clock->utc_offset);
  add(hash, scene.ground_colour);
  for (const Obstacle& body : scene.obstacles.bodies()) {
    for (const DVec3 position : body.mesh.positions) hash.add(position.x).add(position.y).add(position.z);
    hash.add_array(body.mesh.triangles).add(body.is_hidden).add(body.is_broken).add_text(body.name);
    add(hash, body.colour);
  }
}

void add(Fingerprint& hash, const CameraView& view) {
  add(hash, view.position);
  add(hash, view.target);
  hash.add(view.roll).add(view.azimuth).add(view.altitude).add(view.field_of_view);
  add(hash, view.background);
  hash.add(view.haze.value_or(0)).add(view.clouds);
}

}  // namespace

std::uint64_t hash_of_result(const Document& document) {
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  Fingerprint hash;
  for (const Stem& stem : grown.plant.stems) add(hash, stem.skeleton);
  for (const MeshInstances& instances : grown.meshes.meshes) {
    add(hash, *instances.mesh);
    add(hash, grown.meshes.materials[instances.material]);
    hash.add_array(instances.frames).add_array(instances.tints);
    if (instances.places != nullptr) hash.add_array(*instances.places);
  }
  add(hash, document.scene);
  add(hash, camera_view(document.graph));
  hash.add_array(document.output.size).add(document.output.samples).add(document.output.lod).add(document.output.cards);
  return hash.hash();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Hashes everything that a picture depends on, without drawing it.
#include "meristem/export/picture/picture_fingerprint.h"

#include <optional>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/output/picture/obstacle_meshes.h"

namespace meristem {

namespace {

/// Must be raised when equal scenes look different after a change of the camera, the path tracer, the sky or the tone
/// map.
constexpr int kLookOfStills = 1;

void add(const Vec3& vector, Fingerprint& to) { to.add(vector.x).add(vector.y).add(vector.z); }

void add(const std::optional<Vec3>& vector, Fingerprint& to) {
  to.add(vector.has_value());
  if (vector) add(*vector, to);
}

void add(const Image& image, Fingerprint& to) { to.add(image.width).add(image.height).add_array(image.rgba); }

void add(const Material& material, Fingerprint& to) {
  add(material.colour, to);
  to.add(material.roughness).add(material.translucency).add(material.two_sided).add(material.texture != nullptr);
  if (material.opacity < 1) to.add_text("opacity").add(material.opacity);
  if (material.texture == nullptr) return;
  add(material.texture->colour, to);
  add(material.texture->normals, to);
  add(material.texture->mean, to);
  to.add(material.texture->masked);
}

void add(const Mesh& mesh, Fingerprint& to) {
  to.add_array(mesh.positions).add_array(mesh.normals).add_array(mesh.uvs).add_array(mesh.triangles);
}

void add(const MeshScene& meshes, Fingerprint& to) {
  to.add(meshes.materials.size());
  for (const Material& material : meshes.materials) add(material, to);
  to.add(meshes.meshes.size());
  for (const MeshInstances& instances : meshes.meshes) {
    add(*instances.mesh, to);
    to.add(instances.material).add_array(instances.frames).add_array(instances.tints);
    if (instances.places != nullptr) to.add_array(*instances.places);
  }
}

}  // namespace

std::string picture_fingerprint(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                                const PictureOptions& options) {
  Fingerprint all;
  all.add(kLookOfStills).add(options.crown_hulls);
  const StillOptions& still = options.still;
  all.add(still.width).add(still.height).add(still.samples).add(still.transparent).add(still.ground);
  const CameraView& view = options.view;
  add(view.position, all);
  add(view.target, all);
  if (!view.position) all.add(view.azimuth).add(view.altitude);  // a position replaces both
  all.add(view.field_of_view);
  add(view.background, all);
  if (view.haze) all.add_text("haze").add(*view.haze);
  if (view.roll != 0) all.add_text("roll").add(view.roll);
  if (view.clouds > 0) all.add_text("clouds").add(view.clouds);
  all.add(scene.sun.azimuth).add(scene.sun.altitude);
  for (const Lamp& lamp : scene.light.lamps) {
    add(lamp.position, all);
    all.add(lamp.strength);
    if (lamp.colour) add(lamp.colour, all.add_text("colour"));
    if (lamp.target) add(lamp.target, all.add_text("target").add(lamp.angle));
    if (lamp.radius) all.add_text("radius").add(*lamp.radius);
  }
  add(scene.ground_colour, all);
  const bool shows_obstacles = !still.transparent && has_visible(scene.obstacles);
  const auto add_meshes = [&](const MeshScene& meshes) {
    add(shows_obstacles ? with_obstacles(meshes, scene.obstacles) : meshes, all);
  };
  if (options.overlays.empty() && options.plants) {
    add_meshes(grown.meshes);
    return fmt::format("{:016x}", all.hash());
  }
  const PictureScene picture = picture_scene(grown, limits, scene, options, Progress());
  add_meshes(picture.meshes);
  for (const OverlayLayer& layer : picture.layers) {
    for (const OverlayLabel& label : layer.labels) all.add_text(label.text);
    for (const OverlayKey& key : layer.legend) all.add_text(key.text);
  }
  return fmt::format("{:016x}", all.hash());
}

}  // namespace meristem

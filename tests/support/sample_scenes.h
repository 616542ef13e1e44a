// SPDX-License-Identifier: Apache-2.0
// Small mesh scenes for tests of writers.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

inline std::shared_ptr<const Mesh> triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.uvs = {{0, 0}, {1, 0}, {0.25F, 1}};
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// A strip of `count` triangles, without normals and uvs.
inline std::shared_ptr<const Mesh> strip(std::uint32_t count) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count + 2; ++i) mesh.positions.emplace_back(i * 0.5F, i % 2, 0);
  for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({i, i + 1 + i % 2, i + 2 - i % 2});
  return std::make_shared<const Mesh>(std::move(mesh));
}

inline Frame shifted(Vec3 by) { return {Mat3(1), by}; }

inline Frame mirror() {
  Frame frame;
  frame.axes[0].x = -1;
  return frame;
}

inline Frame sheared() {
  Frame frame;
  frame.axes[1] = {0.5F, 1, 0};
  return frame;
}

/// One mesh with the material and component "leaf".
inline MeshScene scene_of(std::shared_ptr<const Mesh> mesh, std::vector<Frame> frames) {
  MeshScene scene;
  Material material;
  material.name = "leaf";
  scene.materials = {material};
  scene.meshes = {{"leaf", std::move(mesh), 0, std::move(frames)}};
  return scene;
}

/// A stem without normals and uvs, and many leaves with random rotations and scales. A third of the leaves is mirrored.
inline MeshScene leafy_scene(std::size_t leaves) {
  const RandomKey key(5);
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < leaves; ++i) {
    Frame frame = frame_along(3.0F * key.direction(2 * i), key.direction(2 * i + 1), kUp);
    frame.axes *= static_cast<float>(key.child(1).uniform(i, 0.5, 2.0));
    if (i % 3 == 0) frame = frame * mirror();
    frames.push_back(frame);
  }
  MeshScene scene = scene_of(triangle(), frames);
  Material wood;
  wood.name = "stem";
  wood.colour = {0.4F, 0.3F, 0.2F};
  scene.materials.push_back(wood);
  scene.meshes.push_back({"stem", strip(5000), 1, {Frame()}});
  return scene;
}

/// A picture with one colour. If `masked`, its alpha varies along x.
inline Image plain_image(int size, std::array<std::uint8_t, 3> colour, bool masked) {
  Image image{size, size, {}};
  for (int i = 0; i < size * size; ++i) {
    image.rgba.insert(image.rgba.end(), colour.begin(), colour.end());
    image.rgba.push_back(masked && i % size == 0 ? 0 : 255);
  }
  return image;
}

/// A masked texture with normals. Its mean is one half in each channel.
inline std::shared_ptr<const Texture> plain_texture() {
  Texture texture;
  texture.name = "plain";
  texture.colour = plain_image(4, {188, 188, 188}, true);
  texture.normals = plain_image(2, {128, 128, 255}, false);
  texture.mean = Vec3(0.5F);
  texture.masked = true;
  return std::make_shared<const Texture>(std::move(texture));
}

/// The triangle with tangents along x.
inline std::shared_ptr<const Mesh> triangle_with_tangents() {
  Mesh mesh = *triangle();
  mesh.tangents.assign(3, Vec4(1, 0, 0, 1));
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// Returns all instances as one mesh, like a file that flattens them. Missing normals and uvs are 0.
inline Mesh flattened(const MeshScene& scene) {
  Mesh all;
  for (const MeshInstances& instances : scene.meshes) {
    const Mesh& mesh = *instances.mesh;
    for (const Frame& frame : instances.frames) {
      const auto base = static_cast<std::uint32_t>(all.positions.size());
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        all.positions.push_back(frame.point(mesh.positions[v]));
        all.normals.push_back(mesh.normals.empty() ? Vec3(0) : frame.normal(mesh.normals[v]));
        all.uvs.push_back(mesh.uvs.empty() ? Vec2(0) : mesh.uvs[v]);
      }
      const bool is_turned = glm::determinant(frame.axes) < 0;
      for (const auto [a, b, c] : mesh.triangles) {
        all.triangles.push_back({base + a, base + (is_turned ? c : b), base + (is_turned ? b : c)});
      }
    }
  }
  return all;
}

}  // namespace meristem

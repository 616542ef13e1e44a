// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/scene/mesh_scene.h"

#include <cstddef>

#include <glm/vector_relational.hpp>

#include "meristem/plant/plant_bounds.h"

namespace meristem {
namespace {

Box box_of(const Mesh& mesh, const Frame& frame) {
  Box box;
  for (const Vec3 position : mesh.positions) box.add(frame.point(position));
  return box;
}

bool contains(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) && glm::all(glm::lessThanEqual(inner.high, outer.high));
}

}  // namespace

std::string object_name(const MeshInstances& instances) {
  return instances.is_crown ? instances.component + "_crown" : instances.component;
}

std::uint64_t MeshScene::triangle_count() const {
  std::uint64_t count = 0;
  for (const MeshInstances& instances : meshes) count += instances.triangle_count();
  return count;
}

std::uint64_t MeshScene::instance_count() const {
  std::uint64_t count = 0;
  for (const MeshInstances& instances : meshes) count += instances.count();
  return count;
}

Box MeshScene::bounds() const {
  Box box;
  for (const MeshInstances& instances : meshes) {
    const Box mesh_box = box_of(*instances.mesh, Frame{});
    // Most instances cannot extend the box further. Check all vertices only for the others.
    for (std::size_t i = 0; i < instances.count(); ++i) {
      const Frame frame = instances.frame(i);
      if (!contains(box, box_in(mesh_box, frame))) box.add(box_of(*instances.mesh, frame));
    }
  }
  return box;
}

}  // namespace meristem

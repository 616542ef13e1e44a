// SPDX-License-Identifier: Apache-2.0
// Computes the cache keys of stems. A key covers the skeleton, the deformation and everything else that shapes the
// meshes of a stem.
#include "meristem/shape/stem/cached_meshes.h"

#include <optional>

#include "meristem/shape/stem/deformation_hashes.h"

namespace meristem {

namespace {

template <class Number>
void add_optional(const std::optional<Number>& number, Fingerprint& to) {
  to.add(number.has_value()).add(number.value_or(0));
}

void add_colour(Vec3 colour, Fingerprint& to) { to.add(colour.r).add(colour.g).add(colour.b); }

void add_crown(const CrownBody& crown, Fingerprint& to) {
  const auto& [diameter, offset, fuse, blend, resolution, triangles, colour, hidden] = crown;
  to.add(diameter).add(offset).add(fuse).add(blend).add(resolution);
  add_optional(triangles, to);
  add_colour(colour, to);
  to.add(hidden);
}

}  // namespace

std::uint64_t VariantMeshes::bytes() const {
  std::uint64_t sum = 0;
  for (const MeshInstances& instances : scene.meshes) {
    sum += instances.mesh->bytes() + instances.frames.size() * (sizeof(Frame) + sizeof(Vec3));
  }
  return sum;
}

void add_skeleton(const Stem& stem, Fingerprint& to) {
  // The records of operations do not affect the surface.
  const auto& [parent, position, radius, axis, order, birth, extra, operations] = stem.skeleton_of_surface();
  // The choice of a tube's rings also depends on the positions of the deformed nodes.
  to.add(stem.undeformed != nullptr);
  if (stem.undeformed != nullptr) to.add_array(stem.skeleton.position);
  DeformationHashes hashes;
  for (const StemPart& part : stem.parts) to.add(hashes.of(part.deformation));
  to.add_array(parent).add_array(position).add_array(radius).add_array(axis).add_array(order).add_array(birth);
  for (const auto& [name, values] : extra) to.add_text(name).add_array(values);
}

void add_surface(const SurfaceOptions& surface, Fingerprint& to) {
  const auto& [style, shading, crown, sides, error, uv_scale, shift_u, shift_v, turn, mirror, smooth, collar, flare,
               cap, resolution, blend, thicken, triangles] = surface;
  to.add(style).add(shading).add(crown.has_value());
  if (crown) add_crown(*crown, to);
  to.add(sides)
      .add(error)
      .add(uv_scale)
      .add(shift_u)
      .add(shift_v)
      .add(turn)
      .add(mirror)
      .add(smooth)
      .add(collar)
      .add(flare)
      .add(cap);
  to.add(resolution).add(blend).add(thicken);
  add_optional(triangles, to);
}

void add_detail(const MeshDetail& detail, Fingerprint& to) {
  to.add(detail.level).add(detail.share).add(detail.is_quick);
}

std::uint64_t StemTubes::bytes() const {
  std::uint64_t sum = 0;
  for (const std::shared_ptr<const Mesh>& mesh : meshes) sum += mesh->bytes();
  for (const auto& of_mesh : tubes) sum += of_mesh->size() * sizeof(AxisTriangles);
  return sum;
}

}  // namespace meristem

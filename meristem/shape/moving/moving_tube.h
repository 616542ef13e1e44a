// SPDX-License-Identifier: Apache-2.0
// One tube over time: the shapes that an axis has at some keys, all with the vertices and triangles of the key at which
// it has most rings.
//
// A tube's rings stand at metres along it. Where an earlier tube is the beginning of the later one, as of a stem that
// grows at its tip, rings keep their metres, and those beyond the tip lie at it. Where it is not, as of a stem whose
// length has keys, rings keep their share of the length.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

/// The tube of one axis at one key, as it stands in its mesh: the start's vertices, rings of `sides` + 1, and the
/// end's.
struct TubeShape {
  std::uint32_t sides = 0;
  std::uint32_t rings = 0;
  std::uint32_t start_vertices = 0;  ///< 1, or a disc of `sides` + 1
  std::uint32_t end_vertices = 0;    ///< a point per side, or a disc of `sides` + 1
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;

  bool operator==(const TubeShape&) const = default;
  std::uint32_t ring_vertex(std::uint32_t ring, std::uint32_t side) const {
    return start_vertices + ring * (sides + 1) + side;
  }
};

/// The tube of an axis in the meshes that make_tubes has made of the plan; nothing where it has none.
std::optional<TubeShape> tube_shape(const TubePlan& plan, AxisIndex axis, const std::vector<Mesh>& meshes);

/// Which of the shapes of one axis (null where it is not there) has most rings: the last of those.
std::size_t fullest_shape(const std::vector<std::shared_ptr<const TubeShape>>& shapes);

/// The triangles of a tube whose first vertex has the number `first`, appended.
void add_tube_triangles(const TubeShape& tube, std::uint32_t first, Mesh& to);

/// The vertices of `tube` as `model` has them: as many, at the same places around and along it. Appended to `to`.
/// On the rings of `tube` they lie on its sides, so that corners that `model` has not are cut.
void add_tube_vertices(const TubeShape& tube, const TubeShape& model, Mesh& to);

/// As many vertices as `model` has, all at the base of `tube`. Appended to `to`.
void add_collapsed_vertices(const TubeShape& tube, const TubeShape& model, Mesh& to);

}  // namespace meristem

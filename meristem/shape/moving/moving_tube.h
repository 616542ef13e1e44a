// SPDX-License-Identifier: Apache-2.0
// One tube over time: the shapes of an axis at several keys, all with the vertices and triangles of the key with the
// most rings.
//
// A tube's rings are positioned in metres along it. An earlier tube can be the beginning of the later one, as in a stem
// that grows at its tip. Then rings keep their metres, and rings beyond the tip lie at the tip. Otherwise, as in a stem
// with keyed length, rings keep their share of the length.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

/// The tube of one axis at one key, as it lies in its mesh: the start's vertices, rings of `sides` + 1 vertices, and
/// the end's vertices.
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

/// Returns the tube of an axis in the meshes that make_tubes has made of the plan. Returns nothing if the axis has no
/// tube.
std::optional<TubeShape> tube_shape(const TubePlan& plan, AxisIndex axis, const std::vector<Mesh>& meshes);

/// Returns which shape of one axis (null if it does not exist) has the most rings. Ties go to the last shape.
std::size_t fullest_shape(const std::vector<std::shared_ptr<const TubeShape>>& shapes);

/// Appends the triangles of a tube whose first vertex has the number `first`.
void add_tube_triangles(const TubeShape& tube, std::uint32_t first, Mesh& to);

/// Appends the vertices of `tube` in the layout of `model`: equally many, at equal positions around and along it. They
/// lie on the sides of the rings of `tube`, so corners that `model` does not have are cut.
void add_tube_vertices(const TubeShape& tube, const TubeShape& model, Mesh& to);

/// Appends as many vertices as `model` has, all at the base of `tube`.
void add_collapsed_vertices(const TubeShape& tube, const TubeShape& model, Mesh& to);

}  // namespace meristem

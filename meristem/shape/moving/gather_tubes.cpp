// SPDX-License-Identifier: Apache-2.0
// Turns the tubes of axes over time into meshes that move. Each tube keeps the rings of its fullest key, and axes that
// look alike at all keys are joined in one mesh.
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/parallel.h"
#include "meristem/shape/moving/moving_likeness.h"
#include "meristem/shape/moving/moving_meshes.h"

namespace meristem {

namespace {

/// Returns the colours of an axis at all keys, each at the nearest key at which the axis exists.
std::string tints_of(const MovingParts& parts, const AxisTrack& track) {
  std::string tints;
  for (const std::size_t there : track.nearest()) {
    const Vec3 tint = parts.tint_at(track.look, track.tints[there], there);
    tints.append(reinterpret_cast<const char*>(&tint), sizeof(tint));
  }
  return tints;
}

/// Axes with equal look and equal colours at all keys, which become one mesh.
struct AxisGroup {
  std::span<AxisTrack* const> axes;
  std::vector<std::size_t> model;                 // by axis: the key whose shape has the most vertices
  std::vector<std::vector<std::size_t>> nearest;  // by axis and key: the nearest key at which the axis exists

  explicit AxisGroup(std::span<AxisTrack* const> group) : axes(group) {
    for (const AxisTrack* axis : axes) {
      model.push_back(fullest_shape(axis->shapes));
      nearest.push_back(axis->nearest());
    }
  }
  const TubeShape& model_of(std::size_t axis) const { return *axes[axis]->shapes[model[axis]]; }
};

/// Returns the triangles and uvs of all axes of the group, without vertices.
Mesh triangles_of(const AxisGroup& group) {
  Mesh whole;
  for (std::size_t a = 0; a < group.axes.size(); ++a) {
    const TubeShape& tube = group.model_of(a);
    add_tube_triangles(tube, static_cast<std::uint32_t>(whole.uvs.size()), whole);
    whole.uvs.insert(whole.uvs.end(), tube.uvs.begin(), tube.uvs.end());
  }
  return whole;
}

/// Returns for each key the positions and normals of `vertices` vertices, in the order of the triangles. An axis that
/// does not exist at a key collapses to a point of its nearest shape.
std::vector<Mesh> vertices_by_key(const AxisGroup& group, std::size_t keys, std::size_t vertices, Progress& progress) {
  std::vector<Mesh> of_key(keys);
  parallel_for(keys, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      of_key[k].positions.reserve(vertices);
      of_key[k].normals.reserve(vertices);
      for (std::size_t a = 0; a < group.axes.size(); ++a) {
        if (a % 256 == 0) progress.check();
        const auto& shapes = group.axes[a]->shapes;
        if (shapes[k]) {
          add_tube_vertices(*shapes[k], group.model_of(a), of_key[k]);
        } else {
          add_collapsed_vertices(*shapes[group.nearest[a][k]], group.model_of(a), of_key[k]);
        }
      }
    }
  });
  return of_key;
}

/// Joins the axes of a group into one mesh, so that a tree with thousands of axes makes few meshes. The mesh shows the
/// last key. It moves if its vertices or its colour differ at another key. Frees the shapes of the axes.
void join_axes(const MovingParts& parts, std::span<AxisTrack* const> axes, MovingMeshes& to, Progress& progress) {
  const std::size_t keys = parts.key_count;
  const AxisGroup group(axes);
  Mesh whole = triangles_of(group);
  std::vector<Mesh> of_key = vertices_by_key(group, keys, whole.uvs.size(), progress);

  // All axes have the look and the colours of the first one.
  MovingMesh joined;
  const MovingLook& look = axes[0]->look;
  const auto tint = [&](std::size_t key) {
    const std::size_t there = group.nearest[0][key];
    return parts.tint_at(look, axes[0]->tints[there], there);
  };
  joined.instances.component = parts.components[look.component];
  joined.instances.material = look.material;
  joined.instances.frames = {Frame{}};
  joined.instances.individuals = {look.individual};
  joined.instances.tints = {tint(keys - 1)};

  // Compare all keys with the last one.
  bool moves = false;
  bool changes_colour = false;
  for (std::size_t k = 0; k < keys; ++k) {
    progress.check();
    moves = moves || of_key[k].positions != of_key.back().positions;
    changes_colour = changes_colour || tint(k) != joined.instances.tints[0];
    joined.motion.turns = joined.motion.turns || are_turned(of_key[k].normals, of_key.back().normals);
  }
  whole.positions = of_key.back().positions;
  whole.normals = of_key.back().normals;
  joined.instances.mesh = std::make_shared<const Mesh>(std::move(whole));
  if (moves || changes_colour) {
    joined.motion.kind = MeshMotion::Kind::shape;
    for (Mesh& mesh : of_key) joined.motion.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    for (std::size_t k = 0; changes_colour && k < keys; ++k) joined.motion.tints.push_back({tint(k)});
  }
  for (AxisTrack* axis : axes) axis->shapes.clear();
  to.add(std::move(joined), parts.materials);
}

}  // namespace

void gather_tubes(MovingParts& parts, MovingMeshes& to, Progress& progress) {
  using Key = std::pair<MovingLook, std::string>;
  std::map<Key, std::vector<AxisTrack*>> groups;
  std::vector<const Key*> order;
  for (AxisTrack& track : parts.axes) {
    const auto [group, is_new] = groups.try_emplace({track.look, tints_of(parts, track)});
    if (is_new) order.push_back(&group->first);
    group->second.push_back(&track);
  }
  for (const Key* key : order) join_axes(parts, groups[*key], to, progress);
  parts.axes.clear();
}

}  // namespace meristem

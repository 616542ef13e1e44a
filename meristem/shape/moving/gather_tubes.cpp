// SPDX-License-Identifier: Apache-2.0
// Turns the tubes of axes over time into meshes that move. Each tube keeps the rings of its fullest key, and axes that
// look alike at all keys are joined in one mesh.
#include <map>
#include <span>
#include <string>
#include <utility>

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

/// Joins axes with equal look and equal colours at all keys into one mesh, so that a tree with thousands of axes makes
/// few meshes. The axis's shape at the key with the most vertices determines its triangles and uvs. At every key the
/// vertices of all axes are written in that order. An axis that does not exist at a key collapses to a point of its
/// nearest shape. If neither shape nor colour changes, the mesh is static.
void gather_alike(const MovingParts& parts, std::span<AxisTrack* const> group, MovingMeshes& to, Progress& progress) {
  const std::size_t keys = parts.key_count;
  std::vector<std::size_t> model(group.size());
  std::vector<std::vector<std::size_t>> nearest(group.size());
  Mesh whole;
  for (std::size_t a = 0; a < group.size(); ++a) {
    nearest[a] = group[a]->nearest();
    model[a] = fullest_shape(group[a]->shapes);
    const TubeShape& tube = *group[a]->shapes[model[a]];
    add_tube_triangles(tube, static_cast<std::uint32_t>(whole.uvs.size()), whole);
    whole.uvs.insert(whole.uvs.end(), tube.uvs.begin(), tube.uvs.end());
  }
  std::vector<Mesh> of_key(keys);
  parallel_for(keys, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      of_key[k].positions.reserve(whole.uvs.size());
      of_key[k].normals.reserve(whole.uvs.size());
      for (std::size_t a = 0; a < group.size(); ++a) {
        if (a % 256 == 0) progress.check();
        const auto& shapes = group[a]->shapes;
        const TubeShape& own_model = *shapes[model[a]];
        if (shapes[k]) {
          add_tube_vertices(*shapes[k], own_model, of_key[k]);
        } else {
          add_collapsed_vertices(*shapes[nearest[a][k]], own_model, of_key[k]);
        }
      }
    }
  });
  MovingMesh all;
  const MovingLook& look = group[0]->look;
  all.instances.component = parts.components[look.component];
  all.instances.material = look.material;
  all.instances.frames = {Frame{}};
  all.instances.individuals = {look.individual};
  const auto tint = [&](std::size_t key) {
    const std::size_t there = nearest[0][key];
    return parts.tint_at(look, group[0]->tints[there], there);
  };
  all.instances.tints = {tint(keys - 1)};
  bool moves = false;
  bool changes = false;
  for (std::size_t k = 0; k < keys; ++k) {
    progress.check();
    moves = moves || of_key[k].positions != of_key.back().positions;
    changes = changes || tint(k) != all.instances.tints[0];
    all.motion.turns = all.motion.turns || are_turned(of_key[k].normals, of_key.back().normals);
  }
  whole.positions = of_key.back().positions;
  whole.normals = of_key.back().normals;
  all.instances.mesh = std::make_shared<const Mesh>(std::move(whole));
  if (moves || changes) {
    all.motion.kind = MeshMotion::Kind::shape;
    for (Mesh& mesh : of_key) all.motion.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    for (std::size_t k = 0; changes && k < keys; ++k) all.motion.tints.push_back({tint(k)});
  }
  for (AxisTrack* track : group) track->shapes.clear();
  to.add(std::move(all), parts.materials);
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
  for (const Key* key : order) gather_alike(parts, groups[*key], to, progress);
  parts.axes.clear();
}

}  // namespace meristem

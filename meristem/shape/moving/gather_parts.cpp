// SPDX-License-Identifier: Apache-2.0
// Turns organs and bodies over time into meshes that move. Parts with equal meshes at all keys become instances of one
// mesh. Rigid parts become nodes of their own while there is room, and all other moving parts move by their vertices.
#include <algorithm>
#include <compare>
#include <map>
#include <utility>

#include "meristem/shape/moving/moving_blade.h"
#include "meristem/shape/moving/moving_likeness.h"
#include "meristem/shape/moving/moving_meshes.h"

namespace meristem {

namespace {

using Motion = MeshMotion::Kind;

/// The common properties of the instances of one mesh.
struct PartGroup {
  std::uint32_t component = 0;
  std::uint32_t material = 0;
  bool is_crown = false;
  Motion kind = Motion::still;
  bool has_tints = false;           ///< tints change
  std::size_t shown_at = 0;         ///< index of a key
  std::vector<const Mesh*> meshes;  ///< one per key, or a single one

  auto operator<=>(const PartGroup&) const = default;
};

/// Returns the blade with the vertices of the model, or null if this is impossible.
SharedMesh cut_as(const Mesh& blade, const Mesh& model) {
  std::optional<Mesh> cut = as_model_is_cut(blade, model);
  if (!cut) return nullptr;
  cut->uvs = model.uvs;
  cut->triangles = model.triangles;
  cut->stalk_triangles = model.stalk_triangles;
  return std::make_shared<const Mesh>(std::move(*cut));
}

class PartGatherer {
 public:
  PartGatherer(MovingParts& parts, std::size_t rigid_instances, const Progress& progress)
      : parts_(parts), rigid_instances_(rigid_instances), progress_(progress) {}

  std::vector<MovingMesh> gather();

 private:
  std::size_t key_count() const { return parts_.key_count; }
  Vec3 tint_at(const MovingPart& part, std::size_t key) const {
    return parts_.tint_at(part.look, part.keys[key].tint, key);
  }
  void cut_alike(MovingPart& part);
  void count_rigid();
  Motion kind_of(const MovingPart& part) const;
  bool can_be_rigid(const MovingPart& part) const;
  bool changes_tint(const MovingPart& part) const;
  void add(const MovingPart& part);
  void add_shown(const MovingPart& part);
  MovingMesh& group(PartGroup key, const std::shared_ptr<const Mesh>& mesh);

  MovingParts& parts_;
  const std::size_t rigid_instances_;
  const Progress& progress_;
  std::map<std::pair<const Mesh*, const Mesh*>, SharedMesh> cut_meshes_;  // the first mesh with the vertices of the
                                                                          // second; null if this is impossible
  std::map<MovingLook, std::size_t> rigid_;                               // number of parts of each look that may be
                                                                          // nodes
  std::vector<MovingMesh> made_;
  std::map<PartGroup, std::size_t> number_of_;
};

/// Gives all blades of a part the vertices of the blade with the most vertices, if they are cut differently.
void PartGatherer::cut_alike(MovingPart& part) {
  SharedMesh model;
  for (const PartKey& key : part.keys) {
    if (key.mesh != nullptr && (model == nullptr || key.mesh->vertex_count() >= model->vertex_count()))
      model = key.mesh;
  }
  std::vector<SharedMesh> cut;
  for (const PartKey& key : part.keys) {
    cut.push_back(key.mesh);
    if (key.mesh == nullptr || are_of_one_form(*key.mesh, *model)) continue;
    const auto [known, is_new] = cut_meshes_.try_emplace({key.mesh.get(), model.get()});
    if (is_new) known->second = cut_as(*key.mesh, *model);
    if (known->second == nullptr) return;
    cut.back() = known->second;
  }
  for (std::size_t k = 0; k < cut.size(); ++k) part.keys[k].mesh = cut[k];
}

bool PartGatherer::changes_tint(const MovingPart& part) const {
  const Vec3 shown = tint_at(part, part.nearest().back());
  for (std::size_t k = 0; k < key_count(); ++k) {
    if (part.keys[k].mesh != nullptr && tint_at(part, k) != shown) return true;
  }
  return false;
}

Motion PartGatherer::kind_of(const MovingPart& part) const {
  const PartKey& first = part.keys[part.nearest().front()];
  bool is_still = !changes_tint(part);
  bool is_one_mesh = true;
  for (const PartKey& key : part.keys) {
    is_still = is_still && key.mesh == first.mesh && are_one_frame(key.frame, first.frame);
    if (key.mesh == nullptr || key.mesh == first.mesh) continue;
    is_one_mesh = false;
    if (!are_of_one_form(*key.mesh, *first.mesh)) return Motion::shown;
  }
  if (is_still) return Motion::still;
  return is_one_mesh ? Motion::rigid : Motion::shape;
}

bool PartGatherer::can_be_rigid(const MovingPart& part) const {
  if (changes_tint(part)) return false;
  return std::ranges::all_of(part.keys,
                             [](const PartKey& key) { return key.mesh == nullptr || is_rigid_frame(key.frame); });
}

/// Chooses the looks whose rigid parts become nodes. Each look, in the order of looks, is chosen if there is still room
/// for all of its parts.
void PartGatherer::count_rigid() {
  std::map<MovingLook, std::size_t> wanted;
  for (const MovingPart& part : parts_.parts) {
    progress_.check();
    if (kind_of(part) == Motion::rigid && can_be_rigid(part)) ++wanted[part.look];
  }
  std::size_t room = rigid_instances_;
  for (const auto& [look, count] : wanted) {
    if (count > room) continue;
    room -= count;
    rigid_[look] = count;
  }
}

MovingMesh& PartGatherer::group(PartGroup key, const SharedMesh& mesh) {
  const auto [entry, is_new] = number_of_.try_emplace(std::move(key), made_.size());
  if (is_new) {
    MovingMesh& fresh = made_.emplace_back();
    fresh.instances.component = parts_.components[entry->first.component];
    fresh.instances.mesh = mesh;
    fresh.instances.material = entry->first.material;
    fresh.instances.is_crown = entry->first.is_crown;
    fresh.motion.kind = entry->first.kind;
  }
  return made_[entry->second];
}

void PartGatherer::add(const MovingPart& part) {
  PartGroup key{.component = part.look.component,
                .material = part.look.material,
                .is_crown = part.look.is_crown,
                .kind = kind_of(part),
                .meshes = {}};
  if (key.kind == Motion::shown) return add_shown(part);
  if (key.kind == Motion::rigid && !(rigid_.contains(part.look) && can_be_rigid(part))) key.kind = Motion::shape;
  key.has_tints = key.kind == Motion::shape && changes_tint(part);
  const bool is_still = key.kind == Motion::still;
  const bool has_tints = key.has_tints;
  const std::vector<std::size_t> nearest = part.nearest();
  const std::size_t last = nearest.back();
  const auto frame_at = [&](std::size_t k) {
    const Frame& there = part.keys[nearest[k]].frame;
    return nearest[k] == k ? there : Frame{Mat3(0), there.origin};
  };

  // Parts with equal meshes at all keys are instances of one mesh.
  std::vector<SharedMesh> of_keys;
  for (const std::size_t there : nearest) of_keys.push_back(part.keys[there].mesh);
  const bool is_one_mesh = std::ranges::all_of(of_keys, [&](const SharedMesh& mesh) { return mesh == of_keys[0]; });
  for (const SharedMesh& mesh : of_keys) {
    key.meshes.push_back(mesh.get());
    if (is_one_mesh) break;
  }
  MovingMesh& all = group(std::move(key), part.keys[last].mesh);
  all.instances.frames.push_back(frame_at(key_count() - 1));
  all.instances.tints.push_back(tint_at(part, last));
  all.instances.individuals.push_back(part.look.individual);
  if (is_still) return;
  if (!is_one_mesh && all.motion.meshes.empty()) {
    all.motion.meshes = of_keys;
    for (const SharedMesh& mesh : of_keys) {
      all.motion.turns = all.motion.turns || are_turned(mesh->normals, all.instances.mesh->normals);
    }
  }
  all.motion.frames.resize(key_count());
  if (has_tints) all.motion.tints.resize(key_count());
  for (std::size_t k = 0; k < key_count(); ++k) {
    const Frame frame = frame_at(k);
    const bool are_seen = is_there(frame) && is_there(part.keys[last].frame);
    if (are_seen && are_turned(frame, part.keys[last].frame)) all.motion.turns = true;
    all.motion.frames[k].push_back(frame);
    if (has_tints) all.motion.tints[k].push_back(tint_at(part, nearest[k]));
  }
}

void PartGatherer::add_shown(const MovingPart& part) {
  for (std::size_t k = 0; k < key_count(); ++k) {
    const PartKey& then = part.keys[k];
    if (then.mesh == nullptr) continue;
    MovingMesh& all = group({.component = part.look.component,
                             .material = part.look.material,
                             .is_crown = part.look.is_crown,
                             .kind = Motion::shown,
                             .shown_at = k,
                             .meshes = {then.mesh.get()}},
                            then.mesh);
    all.motion.shown_at = k;
    all.instances.frames.push_back(then.frame);
    all.instances.tints.push_back(tint_at(part, k));
    all.instances.individuals.push_back(part.look.individual);
  }
}

std::vector<MovingMesh> PartGatherer::gather() {
  for (MovingPart& part : parts_.parts) {
    progress_.check();
    cut_alike(part);
  }
  count_rigid();
  for (const MovingPart& part : parts_.parts) {
    progress_.check();
    add(part);
  }
  return std::move(made_);
}

}  // namespace

void gather_parts(MovingParts& parts, std::size_t rigid_instances, MovingMeshes& to, Progress& progress) {
  for (MovingMesh& mesh : PartGatherer(parts, rigid_instances, progress).gather()) {
    progress.check();
    to.add(std::move(mesh), parts.materials);
  }
  parts.parts.clear();
}

}  // namespace meristem

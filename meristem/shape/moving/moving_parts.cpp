// SPDX-License-Identifier: Apache-2.0
// Collects the parts of plants key by key. Each part is found by its name, and equal meshes are shared by their hash.
// Limits are checked as early as possible.
#include "meristem/shape/moving/moving_parts.h"

#include <algorithm>
#include <deque>
#include <typeinfo>

#include <fmt/format.h>

#include "meristem/base/colour.h"
#include "meristem/base/fingerprint.h"
#include "meristem/base/random.h"
#include "meristem/shape/stem/body_meshes.h"
#include "meristem/shape/stem/cached_meshes.h"
#include "meristem/shape/stem/scene_tally.h"

namespace meristem {

namespace {

constexpr float kMinColour = 1e-4F;

std::uint64_t hash_of_mesh(const Mesh& mesh) {
  return Fingerprint()
      .add_array(mesh.positions)
      .add_array(mesh.normals)
      .add_array(mesh.uvs)
      .add_array(mesh.triangles)
      .hash();
}

/// Return the entry at the nearest key before `now`, or after it, or nothing if no such key exists.
template <class Noted>
Noted before(const std::vector<Noted>& keys, std::size_t now) {
  for (std::size_t key = now; key-- > 0;) {
    if (keys[key]) return keys[key];
  }
  return {};
}

template <class Noted>
Noted after(const std::vector<Noted>& keys, std::size_t now) {
  for (std::size_t key = now + 1; key < keys.size(); ++key) {
    if (keys[key]) return keys[key];
  }
  return {};
}

/// Throws InputError if the plant's scene would exceed a limit of meshes.
void check_scene(const Plant& plant, const std::vector<MeshInstances>& bodies, const std::deque<StemPlan>& stems,
                 const SizeLimits& limits) {
  SceneTally tally;
  for (const MeshInstances& body : bodies) tally.add_mesh(body.component, *body.mesh);
  for (const StemPlan& stem : stems) tally.add_tubes(stem.looks, stem.tubes.sizes());
  std::vector<std::uint64_t> counts(plant.prototypes.size());
  for (const Organ& organ : plant.organs) ++counts[organ.prototype];
  for (std::size_t k = 0; k < counts.size(); ++k) {
    tally.add_organs(plant.prototypes[k].component, *plant.prototypes[k].mesh, counts[k]);
  }
  tally.check(limits);
}

}  // namespace

void check_moving_bytes(std::uint64_t wanted, std::size_t keys, const MovingLimits& limits) {
  if (wanted <= limits.bytes) return;
  throw InputError(Diagnostic{
      .message = fmt::format("what moves takes {:.0f} MB in {} keys", static_cast<double>(wanted) * 1e-6, keys),
      .expected = fmt::format("at most {:.0f} MB: fewer keys, or leaves and surfaces with fewer triangles",
                              static_cast<double>(limits.bytes) * 1e-6),
      .path = "animation"});
}

std::vector<std::uint32_t> MovingParts::note_materials(const std::vector<Material>& of_plant) {
  std::vector<std::uint32_t> numbers;
  std::map<std::string, std::uint32_t> before;
  for (const Material& material : of_plant) {
    const auto next = static_cast<std::uint32_t>(materials.size());
    const auto [entry, is_new] = number_of_material_.try_emplace({material.name, before[material.name]++}, next);
    if (is_new) {
      materials.emplace_back();
      colours_.emplace_back(key_count);
    }
    std::vector<std::optional<Vec3>>& own = colours_[entry->second];
    if (after(own, now_) == std::nullopt) materials[entry->second] = material;  // uses the material of the last key
    own[now_] = linear_from_srgb(material.colour);
    numbers.push_back(entry->second);
  }
  return numbers;
}

std::vector<std::uint32_t> MovingParts::note_individuals(const std::vector<Individual>& of_plant) {
  std::vector<std::uint32_t> numbers;
  for (const Individual& individual : of_plant) {
    const auto next = static_cast<std::uint32_t>(individuals.size());
    const auto [entry, is_new] = number_of_individual_.try_emplace({individual.component, individual.number}, next);
    if (is_new) {
      individuals.emplace_back();
      individual_keys_.emplace_back(now_);
    }
    if (individual_keys_[entry->second] <= now_) {
      individuals[entry->second] = individual;
      individual_keys_[entry->second] = now_;
    }
    numbers.push_back(entry->second);
  }
  if (numbers.empty()) numbers.push_back(0);
  return numbers;
}

std::uint32_t MovingParts::number_of(const std::string& component) {
  const auto next = static_cast<std::uint32_t>(components.size());
  const auto [entry, is_new] = number_of_component_.try_emplace(component, next);
  if (is_new) components.push_back(component);
  return entry->second;
}

SharedMesh MovingParts::shared(const SharedMesh& mesh) {
  auto& [kept, one] = known_[mesh.get()];
  if (one != nullptr) return one;
  kept = mesh;  // keeps its address in use
  return one = meshes_.try_emplace(hash_of_mesh(*mesh), mesh).first->second;
}

void MovingParts::check_part_keys() const {
  if ((parts.size() + 1) * key_count <= moving_.part_keys) return;
  throw InputError(Diagnostic{
      .message = fmt::format("the animation has more than {} organs and bodies in {} keys", parts.size(), key_count),
      .expected = fmt::format("at most {} in all keys together: fewer keys, or fewer leaves", moving_.part_keys),
      .path = "animation"});
}

/// Two parts with one name at one key are distinguished by their order.
MovingPart& MovingParts::part_of(std::uint64_t name, const MovingLook& look) {
  while (true) {
    const auto [entry, is_new] = part_by_name_.try_emplace(name, parts.size());
    if (is_new) {
      check_part_keys();
      parts.push_back({look, std::vector<PartKey>(key_count)});
    }
    MovingPart& part = parts[entry->second];
    if (part.keys[now_].mesh == nullptr && part.look.component == look.component) {
      const auto is_there = [](const PartKey& key) { return key.mesh != nullptr; };
      if (std::none_of(part.keys.begin() + static_cast<std::ptrdiff_t>(now_), part.keys.end(), is_there)) {
        part.look = look;
      }
      return part;
    }
    name = RandomKey(name).child("again").bits();
  }
}

/// Counts the minimum data of a moving axis: positions at all keys except one.
void MovingParts::count_motion(AxisTrack& track, bool moves, std::uint64_t vertices) {
  const auto counted = [&] { return track.moves ? track.vertices : 0; };
  tube_vertices_ -= counted();
  track.moves = track.moves || moves;
  track.vertices = std::max(track.vertices, vertices);
  tube_vertices_ += counted();
}

/// Two axes with one name at one key are distinguished by their order.
void MovingParts::add_shape(std::uint64_t name, const MovingLook& look, Vec3 tint, TubeShape shape) {
  while (true) {
    const auto [entry, is_new] = axis_by_name_.try_emplace(name, axes.size());
    if (is_new) {
      AxisTrack& fresh = axes.emplace_back();
      fresh.shapes.resize(key_count);
      fresh.tints.resize(key_count);
      fresh.moves = std::ranges::count(is_added_, true) > 0;
    }
    AxisTrack& track = axes[entry->second];
    if (track.shapes[now_] != nullptr) {
      name = RandomKey(name).child("again").bits();
      continue;
    }
    std::shared_ptr<const TubeShape> same;
    bool is_other = false;
    for (const std::shared_ptr<const TubeShape>& known : {before(track.shapes, now_), after(track.shapes, now_)}) {
      if (known == nullptr) continue;
      const bool is_same = *known == shape;
      if (is_same) same = known;
      is_other = is_other || !is_same;
    }
    if (after(track.shapes, now_) == nullptr) track.look = look;
    const std::uint64_t vertices = shape.positions.size();
    track.shapes[now_] = same != nullptr ? same : std::make_shared<const TubeShape>(std::move(shape));
    track.tints[now_] = tint;
    count_motion(track, is_other, vertices);
    return;
  }
}

void MovingParts::add_stem(const StemPlan& plan, std::size_t number, const std::vector<std::uint32_t>& material_numbers,
                           const std::vector<std::uint32_t>& numbers, Progress& progress) {
  const Stem& stem = plan.stem;
  const std::vector<Mesh> tubes = make_stem_tubes(plan.tubes, plan.looks, progress);
  const std::vector<std::uint32_t> individual_of_axis = stem.individual_of_axis();
  for (AxisIndex axis = 0; axis < plan.tubes.axis_count(); ++axis) {
    std::optional<TubeShape> shape = tube_shape(plan.tubes, axis, tubes);
    if (!shape) continue;
    const StemPart& part = stem.part(axis);
    const std::uint32_t own = axis < individual_of_axis.size() ? individual_of_axis[axis] : 0;
    const MovingLook look{number_of(part.component), material_numbers[part.material],
                          own < numbers.size() ? numbers[own] : kNoIndividual};
    const std::uint64_t name =
        axis < stem.axis_names.size() ? stem.axis_names[axis] : RandomKey(number).child("axis").child(axis).bits();
    add_shape(name, look, part.tint, std::move(*shape));
  }
  check_moving_bytes(tube_vertices_ * sizeof(Vec3) * (key_count - 1), key_count, moving_);
}

void MovingParts::add(std::size_t key, double time, const Plant& plant, Progress& progress) {
  now_ = key;
  times[key] = time;
  std::vector<Material> of_plant = plant.materials;
  CacheRun no_results(nullptr, {typeid(BodyMesh)});
  const std::vector<MeshInstances> bodies = make_body_meshes(plant, {}, limits_, of_plant, progress, no_results);
  std::deque<StemPlan> stems;
  for (const Stem& stem : plant.stems) {
    progress.check();
    stems.emplace_back(stem);
  }
  check_scene(plant, bodies, stems, limits_);
  const std::vector<std::uint32_t> material_numbers = note_materials(of_plant);
  const std::vector<std::uint32_t> numbers = note_individuals(plant.individuals);
  const auto individual = [&](std::uint32_t own) { return own < numbers.size() ? numbers[own] : kNoIndividual; };

  progress.begin("following parts", plant.node_count() + plant.organs.size());
  for (std::size_t k = 0; !stems.empty(); ++k, stems.pop_front()) {
    if (stems.front().stem.skeleton.node_count() > 0) add_stem(stems.front(), k, material_numbers, numbers, progress);
  }
  // Missing axes grow from nothing, or vanish.
  for (AxisTrack& track : axes) {
    if (track.shapes[key] == nullptr) count_motion(track, true, 0);
  }
  check_moving_bytes(tube_vertices_ * sizeof(Vec3) * (key_count - 1), key_count, moving_);
  std::map<std::uint32_t, std::uint64_t> bodies_of;  // for each component
  for (const MeshInstances& body : bodies) {
    const MovingLook look{number_of(body.component), material_numbers[body.material], individual(body.individual(0))};
    const std::uint64_t ordinal = bodies_of[look.component]++;
    MovingPart& part = part_of(RandomKey(look.component).child("body").child(ordinal).bits(), look);
    part.keys[now_] = {shared(body.mesh), body.frames[0], body.tint(0)};
  }
  std::vector<SharedMesh> of_prototype;
  std::vector<std::uint32_t> component_of_prototype;
  for (const OrganPrototype& prototype : plant.prototypes) {
    of_prototype.push_back(shared(prototype.mesh));
    component_of_prototype.push_back(number_of(prototype.component));
  }
  for (std::size_t k = 0; k < plant.organs.size(); ++k) {
    const Organ& organ = plant.organs[k];
    const OrganPrototype& prototype = plant.prototypes[organ.prototype];
    const MovingLook look{component_of_prototype[organ.prototype], material_numbers[prototype.material],
                          individual(organ.individual)};
    const std::uint64_t name = organ.name != 0 ? organ.name : RandomKey(look.component).child("organ").child(k).bits();
    part_of(name, look).keys[now_] = {of_prototype[organ.prototype], organ.frame, organ.tint};
    if (k % 1024 == 1023) progress.advance(1024);
  }
  is_added_[key] = true;
}

/// Returns the tint as a factor on the colour of the scene's material.
Vec3 MovingParts::tint_at(const MovingLook& look, Vec3 tint, std::size_t key) const {
  const std::optional<Vec3>& then = colours_[look.material][key];
  if (!then) return tint;
  const Vec3 shown = linear_from_srgb(materials[look.material].colour);
  return *then == shown ? tint : tint * *then / glm::max(shown, Vec3(kMinColour));
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/moving/moving_parts.h"

#include <algorithm>
#include <typeinfo>

#include <fmt/format.h>

#include "meristem/base/colour.h"
#include "meristem/base/fingerprint.h"
#include "meristem/base/random.h"
#include "meristem/shape/body_meshes.h"
#include "meristem/shape/cached_meshes.h"
#include "meristem/shape/stem_looks.h"
#include "meristem/shape/stem_tubes.h"

namespace meristem {

namespace {

constexpr float kLeastColour = 1e-4F;

std::uint64_t hash_of_mesh(const Mesh& mesh) {
  return Fingerprint()
      .add_array(mesh.positions)
      .add_array(mesh.normals)
      .add_array(mesh.uvs)
      .add_array(mesh.triangles)
      .hash();
}

}  // namespace

void check_moving_bytes(std::uint64_t wanted, std::size_t keys, const MovingLimits& limits) {
  if (wanted <= limits.bytes) return;
  throw InputError(Diagnostic{
      .message = fmt::format("what moves takes {:.0f} MB in {} keys", static_cast<double>(wanted) * 1e-6, keys),
      .expected = fmt::format("at most {:.0f} MB: fewer keys (--keys N), or leaves and surfaces with fewer triangles",
                              static_cast<double>(limits.bytes) * 1e-6)});
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
    materials[entry->second] = material;  // the latest
    colours_[entry->second][now_] = linear_from_srgb(material.colour);
    numbers.push_back(entry->second);
  }
  return numbers;
}

std::vector<std::uint32_t> MovingParts::note_individuals(const std::vector<Individual>& of_plant) {
  std::vector<std::uint32_t> numbers;
  for (const Individual& individual : of_plant) {
    const auto next = static_cast<std::uint32_t>(individuals.size());
    const auto [entry, is_new] = number_of_individual_.try_emplace({individual.component, individual.number}, next);
    if (is_new) individuals.emplace_back();
    individuals[entry->second] = individual;
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
  kept = mesh;  // so that its address stays its own
  return one = meshes_.try_emplace(hash_of_mesh(*mesh), mesh).first->second;
}

/// Two parts of one name and one key are told apart by their order.
MovingPart& MovingParts::part_of(std::uint64_t name, const MovingLook& look) {
  while (true) {
    const auto [entry, is_new] = part_by_name_.try_emplace(name, parts.size());
    if (is_new) parts.push_back({look, std::vector<PartKey>(key_count)});
    MovingPart& part = parts[entry->second];
    if (part.keys[now_].mesh == nullptr && part.look.component == look.component) {
      part.look = look;
      return part;
    }
    name = RandomKey(name).child("again").bits();
  }
}

void MovingParts::check_triangles(std::uint64_t triangles, const std::string& component) const {
  if (triangles <= limits_.triangles) return;
  throw_limit("triangles", static_cast<double>(triangles), limits_.triangles, "triangles", "components." + component);
}

void MovingParts::add_stem(const Stem& stem, std::size_t number, const std::vector<std::uint32_t>& material_numbers,
                           const std::vector<std::uint32_t>& numbers, Progress& progress) {
  if (stem.skeleton.node_count() == 0) return;
  const StemLooks looks(stem);
  const TubePlan plan = plan_stem(stem, looks, 1);
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  for (const TubeSize& size : plan.sizes()) {
    triangles += size.triangles;
    vertices += size.vertices;
  }
  check_triangles(triangles, stem.parts[0].component);
  tube_bytes_ = std::max(tube_bytes_, vertices * sizeof(Vec3) * (key_count - 1));
  check_moving_bytes(tube_bytes_, key_count, moving_);
  const std::vector<Mesh> tubes = make_stem_tubes(plan, looks, progress);
  const std::vector<std::uint32_t> individual_of_axis = stem.individual_of_axis();
  for (AxisIndex axis = 0; axis < plan.axis_count(); ++axis) {
    std::optional<TubeShape> shape = tube_shape(plan, axis, tubes);
    if (!shape) continue;
    const StemPart& part = stem.part(axis);
    const std::uint32_t own = axis < individual_of_axis.size() ? individual_of_axis[axis] : 0;
    const MovingLook look{number_of(part.component), material_numbers[part.material],
                          own < numbers.size() ? numbers[own] : kNoIndividual};
    std::uint64_t name =
        axis < stem.axis_names.size() ? stem.axis_names[axis] : RandomKey(number).child("axis").child(axis).bits();
    while (true) {
      const auto [entry, is_new] = axis_by_name_.try_emplace(name, axes.size());
      if (is_new)
        axes.push_back({look, std::vector<std::optional<TubeShape>>(key_count), std::vector<Vec3>(key_count)});
      AxisTrack& track = axes[entry->second];
      if (!track.shapes[now_]) {
        track.look = look;
        track.shapes[now_] = std::move(shape);
        track.tints[now_] = part.tint;
        break;
      }
      name = RandomKey(name).child("again").bits();
    }
  }
}

void MovingParts::add(double time, const Plant& plant, Progress& progress) {
  times.push_back(time);
  std::vector<Material> of_plant = plant.materials;
  CacheRun no_results(nullptr, {typeid(BodyMesh)});
  const std::vector<MeshInstances> bodies = make_body_meshes(plant, {}, limits_, of_plant, progress, no_results);
  const std::vector<std::uint32_t> material_numbers = note_materials(of_plant);
  const std::vector<std::uint32_t> numbers = note_individuals(plant.individuals);
  const auto individual = [&](std::uint32_t own) { return own < numbers.size() ? numbers[own] : kNoIndividual; };

  progress.begin("following parts", plant.node_count() + plant.organs.size());
  for (std::size_t k = 0; k < plant.stems.size(); ++k) add_stem(plant.stems[k], k, material_numbers, numbers, progress);
  std::map<std::uint32_t, std::uint64_t> bodies_of;  // by component
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
  std::uint64_t triangles = 0;
  for (std::size_t k = 0; k < plant.organs.size(); ++k) {
    const Organ& organ = plant.organs[k];
    const OrganPrototype& prototype = plant.prototypes[organ.prototype];
    const MovingLook look{component_of_prototype[organ.prototype], material_numbers[prototype.material],
                          individual(organ.individual)};
    triangles += prototype.mesh->triangle_count();
    if (triangles > limits_.triangles) check_triangles(triangles, prototype.component);
    const std::uint64_t name = organ.name != 0 ? organ.name : RandomKey(look.component).child("organ").child(k).bits();
    part_of(name, look).keys[now_] = {of_prototype[organ.prototype], organ.frame, organ.tint};
    if (k % 1024 == 1023) progress.advance(1024);
  }
  ++now_;
}

/// The tint as a factor on the colour that the scene's material has.
Vec3 MovingParts::tint_at(const MovingLook& look, Vec3 tint, std::size_t key) const {
  const std::optional<Vec3>& then = colours_[look.material][key];
  if (!then) return tint;
  const Vec3 shown = linear_from_srgb(materials[look.material].colour);
  return *then == shown ? tint : tint * *then / glm::max(shown, Vec3(kLeastColour));
}

}  // namespace meristem

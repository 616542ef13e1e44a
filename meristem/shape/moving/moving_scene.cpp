// SPDX-License-Identifier: Apache-2.0
// While plants are added, each part's keys are noted by its name: organs and bodies with mesh, frame and tint, axes
// with their tube. When all are there, each part is told by what of it changes, and parts that change alike and look
// alike become instances of one mesh of the scene.
#include "meristem/shape/moving/moving_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <typeinfo>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/colour.h"
#include "meristem/base/fingerprint.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/body_meshes.h"
#include "meristem/shape/cached_meshes.h"
#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/moving/moving_blade.h"
#include "meristem/shape/moving/moving_tube.h"
#include "meristem/shape/moving/nearest_keys.h"
#include "meristem/shape/stem_looks.h"
#include "meristem/shape/stem_tubes.h"

namespace meristem {

namespace {

constexpr float kTurned = 0.94F;       // cosine, 20 degrees, of the turn from which on normals move with their faces
constexpr double kTurnedShare = 0.01;  // of vertices
constexpr float kShear = 4e-6F;        // as a node of glTF can hold
constexpr float kLeastColour = 1e-4F;
constexpr float kPlaceOnPicture = 0.02F;  // of a picture's width

using SharedMesh = std::shared_ptr<const Mesh>;

/// What tells parts apart to the eye.
struct MovingLook {
  std::uint32_t component = 0;
  std::uint32_t material = 0;
  std::uint32_t individual = 0;
  auto operator<=>(const MovingLook&) const = default;
};

/// A part at one key; no mesh where it is not there.
struct PartKey {
  SharedMesh mesh;
  Frame frame;
  Vec3 tint{1};
};

struct MovingPart {
  MovingLook look;
  std::vector<PartKey> keys;

  /// By key: the nearest one at which it is there.
  std::vector<std::size_t> nearest() const {
    return nearest_keys(keys.size(), [this](std::size_t key) { return keys[key].mesh != nullptr; });
  }
};

struct AxisTrack {
  MovingLook look;
  std::vector<std::optional<TubeShape>> shapes;
  std::vector<Vec3> tints;

  std::vector<std::size_t> nearest() const {
    return nearest_keys(shapes.size(), [this](std::size_t key) { return shapes[key].has_value(); });
  }
};

bool are_one_frame(const Frame& a, const Frame& b) { return a.axes == b.axes && a.origin == b.origin; }

/// Made of turn, shift and scale alone, so that a node can hold it.
bool is_rigid_frame(const Frame& frame) {
  const Mat3& axes = frame.axes;
  const Vec3 length(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  if (!(length.x > 0 && length.y > 0 && length.z > 0) || glm::determinant(axes) < 0) return false;
  return std::abs(glm::dot(axes[0], axes[1])) <= kShear * length.x * length.y &&
         std::abs(glm::dot(axes[1], axes[2])) <= kShear * length.y * length.z &&
         std::abs(glm::dot(axes[2], axes[0])) <= kShear * length.z * length.x;
}

/// Whether the vertices of one mesh can move to those of the other: they have the same triangles, or lie at the same
/// places of the same picture. Blades of other proportions may be cut otherwise between equal vertices.
bool are_of_one_form(const Mesh& a, const Mesh& b) {
  if (&a == &b) return true;
  if (a.vertex_count() != b.vertex_count() || a.normals.size() != b.normals.size()) return false;
  if (a.triangles == b.triangles) return true;
  if (a.uvs.empty() || a.uvs.size() != b.uvs.size() || a.triangle_count() != b.triangle_count()) return false;
  for (std::size_t k = 0; k < a.uvs.size(); ++k) {
    if (glm::distance(a.uvs[k], b.uvs[k]) > kPlaceOnPicture) return false;
  }
  return true;
}

bool are_turned(const Frame& a, const Frame& b) {
  const Vec3 some = glm::normalize(Vec3(1, 2, 3));
  const Vec3 other = glm::normalize(Vec3(2, -3, 1));
  return glm::dot(a.normal(some), b.normal(some)) < kTurned || glm::dot(a.normal(other), b.normal(other)) < kTurned;
}

bool are_turned(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::size_t turned = 0;
  for (std::size_t k = 0; k < a.size(); ++k) turned += glm::dot(a[k], b[k]) < kTurned ? 1 : 0;
  return static_cast<double>(turned) > kTurnedShare * static_cast<double>(a.size());
}

std::uint64_t hash_of_mesh(const Mesh& mesh) {
  return Fingerprint()
      .add_array(mesh.positions)
      .add_array(mesh.normals)
      .add_array(mesh.uvs)
      .add_array(mesh.triangles)
      .hash();
}

/// One mesh of the scene, with its motion.
struct Moving {
  MeshInstances instances;
  MeshMotion motion;
};

}  // namespace

struct MovingSceneMaker::State {
  State(const Limits& of_meshes, const MovingLimits& of_motion, std::size_t count)
      : limits(of_meshes), moving(of_motion), key_count(count) {}

  void add(double time, const Plant& plant, Progress& progress);
  MovingScene take(Progress& progress);

  // Adding.
  std::vector<std::uint32_t> note_materials(const std::vector<Material>& of_plant);
  std::vector<std::uint32_t> note_individuals(const std::vector<Individual>& of_plant);
  std::uint32_t number_of(const std::string& component);
  SharedMesh shared(const SharedMesh& mesh);
  MovingPart& part_of(std::uint64_t name, const MovingLook& look);
  void add_stem(const Stem& stem, std::size_t number, const std::vector<std::uint32_t>& materials,
                const std::vector<std::uint32_t>& numbers, Progress& progress);
  void check_triangles(std::uint64_t triangles, const std::string& component) const;
  void check_bytes(std::uint64_t bytes) const;

  // Taking.
  void take_parts();
  void cut_alike(MovingPart& part);
  void count_rigid();
  Vec3 tint_at(const MovingLook& look, Vec3 tint, std::size_t key) const;
  Vec3 tint_at(const MovingPart& part, std::size_t key) const { return tint_at(part.look, part.keys[key].tint, key); }
  MeshMotion::Kind kind_of(const MovingPart& part) const;
  bool can_be_rigid(const MovingPart& part) const;
  bool changes_tint(const MovingPart& part) const;
  void add_part(const MovingPart& part);
  void add_shown(const MovingPart& part);
  Moving& group(const std::string& key, const MovingLook& look, const SharedMesh& mesh, MeshMotion::Kind kind);
  void take_tubes(Progress& progress);
  void take_tubes(std::span<AxisTrack* const> axes, Progress& progress);
  void finish(Moving& made);
  MovingScene scene();

  const Limits limits;
  const MovingLimits moving;
  const std::size_t key_count;
  std::size_t now = 0;  // the key that is added
  std::vector<double> times;
  std::vector<std::string> components;
  std::unordered_map<std::string, std::uint32_t> number_of_component;
  std::vector<Material> materials;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> number_of_material;  // by name and how many before it
  std::vector<std::vector<std::optional<Vec3>>> colours;                              // linear, by material and key
  std::vector<Individual> individuals;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> number_of_individual;
  std::unordered_map<std::uint64_t, SharedMesh> meshes;  // by their hash
  std::unordered_map<const Mesh*, std::pair<SharedMesh, SharedMesh>>
      known;                                                             // as they were given, and as they are shared
  std::map<std::pair<const Mesh*, const Mesh*>, SharedMesh> cut_meshes;  // as the second is cut
  std::vector<MovingPart> parts;
  std::unordered_map<std::uint64_t, std::size_t> part_by_name;
  std::vector<AxisTrack> axes;
  std::unordered_map<std::uint64_t, std::size_t> axis_by_name;
  std::uint64_t tube_bytes = 0;  // of what moves, so far

  std::map<MovingLook, std::size_t> rigid;  // how many parts of a look may be nodes
  std::vector<Moving> made;
  std::unordered_map<std::string, std::size_t> made_by_key;
  std::uint64_t bytes = 0;
};

// Adding.

std::vector<std::uint32_t> MovingSceneMaker::State::note_materials(const std::vector<Material>& of_plant) {
  std::vector<std::uint32_t> numbers;
  std::map<std::string, std::uint32_t> before;
  for (const Material& material : of_plant) {
    const auto next = static_cast<std::uint32_t>(materials.size());
    const auto [entry, is_new] = number_of_material.try_emplace({material.name, before[material.name]++}, next);
    if (is_new) {
      materials.emplace_back();
      colours.emplace_back(key_count);
    }
    materials[entry->second] = material;  // the latest
    colours[entry->second][now] = linear_from_srgb(material.colour);
    numbers.push_back(entry->second);
  }
  return numbers;
}

std::vector<std::uint32_t> MovingSceneMaker::State::note_individuals(const std::vector<Individual>& of_plant) {
  std::vector<std::uint32_t> numbers;
  for (const Individual& individual : of_plant) {
    const auto next = static_cast<std::uint32_t>(individuals.size());
    const auto [entry, is_new] = number_of_individual.try_emplace({individual.component, individual.number}, next);
    if (is_new) individuals.emplace_back();
    individuals[entry->second] = individual;
    numbers.push_back(entry->second);
  }
  if (numbers.empty()) numbers.push_back(0);
  return numbers;
}

std::uint32_t MovingSceneMaker::State::number_of(const std::string& component) {
  const auto next = static_cast<std::uint32_t>(components.size());
  const auto [entry, is_new] = number_of_component.try_emplace(component, next);
  if (is_new) components.push_back(component);
  return entry->second;
}

SharedMesh MovingSceneMaker::State::shared(const SharedMesh& mesh) {
  auto& [kept, one] = known[mesh.get()];
  if (one != nullptr) return one;
  kept = mesh;  // so that its address stays its own
  return one = meshes.try_emplace(hash_of_mesh(*mesh), mesh).first->second;
}

/// Two parts of one name and one key are told apart by their order.
MovingPart& MovingSceneMaker::State::part_of(std::uint64_t name, const MovingLook& look) {
  while (true) {
    const auto [entry, is_new] = part_by_name.try_emplace(name, parts.size());
    if (is_new) parts.push_back({look, std::vector<PartKey>(key_count)});
    MovingPart& part = parts[entry->second];
    if (part.keys[now].mesh == nullptr && part.look.component == look.component) {
      part.look = look;
      return part;
    }
    name = RandomKey(name).child("again").bits();
  }
}

void MovingSceneMaker::State::check_triangles(std::uint64_t triangles, const std::string& component) const {
  if (triangles <= limits.triangles) return;
  throw_limit("triangles", static_cast<double>(triangles), limits.triangles, "triangles", "components." + component);
}

void MovingSceneMaker::State::check_bytes(std::uint64_t wanted) const {
  if (wanted <= moving.bytes) return;
  throw InputError(Diagnostic{
      .message = fmt::format("what moves takes {:.0f} MB in {} keys", static_cast<double>(wanted) * 1e-6, key_count),
      .expected = fmt::format("at most {:.0f} MB: fewer keys (--keys N), or leaves and surfaces with fewer triangles",
                              static_cast<double>(moving.bytes) * 1e-6)});
}

void MovingSceneMaker::State::add_stem(const Stem& stem, std::size_t number,
                                       const std::vector<std::uint32_t>& material_numbers,
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
  tube_bytes = std::max(tube_bytes, vertices * sizeof(Vec3) * (key_count - 1));
  check_bytes(tube_bytes);
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
      const auto [entry, is_new] = axis_by_name.try_emplace(name, axes.size());
      if (is_new)
        axes.push_back({look, std::vector<std::optional<TubeShape>>(key_count), std::vector<Vec3>(key_count)});
      AxisTrack& track = axes[entry->second];
      if (!track.shapes[now]) {
        track.look = look;
        track.shapes[now] = std::move(shape);
        track.tints[now] = part.tint;
        break;
      }
      name = RandomKey(name).child("again").bits();
    }
  }
}

void MovingSceneMaker::State::add(double time, const Plant& plant, Progress& progress) {
  times.push_back(time);
  std::vector<Material> of_plant = plant.materials;
  CacheRun no_results(nullptr, {typeid(BodyMesh)});
  const std::vector<MeshInstances> bodies = make_body_meshes(plant, {}, limits, of_plant, progress, no_results);
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
    part.keys[now] = {shared(body.mesh), body.frames[0], body.tint(0)};
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
    if (triangles > limits.triangles) check_triangles(triangles, prototype.component);
    const std::uint64_t name = organ.name != 0 ? organ.name : RandomKey(look.component).child("organ").child(k).bits();
    part_of(name, look).keys[now] = {of_prototype[organ.prototype], organ.frame, organ.tint};
    if (k % 1024 == 1023) progress.advance(1024);
  }
  ++now;
}

// Taking.

/// The tint as a factor on the colour that the scene's material has.
Vec3 MovingSceneMaker::State::tint_at(const MovingLook& look, Vec3 tint, std::size_t key) const {
  const std::optional<Vec3>& then = colours[look.material][key];
  if (!then) return tint;
  const Vec3 shown = linear_from_srgb(materials[look.material].colour);
  return *then == shown ? tint : tint * *then / glm::max(shown, Vec3(kLeastColour));
}

bool MovingSceneMaker::State::changes_tint(const MovingPart& part) const {
  const Vec3 shown = tint_at(part, part.nearest().back());
  for (std::size_t k = 0; k < key_count; ++k) {
    if (part.keys[k].mesh != nullptr && tint_at(part, k) != shown) return true;
  }
  return false;
}

MeshMotion::Kind MovingSceneMaker::State::kind_of(const MovingPart& part) const {
  using Kind = MeshMotion::Kind;
  const PartKey& first = part.keys[part.nearest().front()];
  bool is_still = !changes_tint(part);
  bool is_one_mesh = true;
  for (const PartKey& key : part.keys) {
    is_still = is_still && key.mesh == first.mesh && are_one_frame(key.frame, first.frame);
    if (key.mesh == nullptr || key.mesh == first.mesh) continue;
    is_one_mesh = false;
    if (!are_of_one_form(*key.mesh, *first.mesh)) return Kind::shown;
  }
  if (is_still) return Kind::still;
  return is_one_mesh ? Kind::rigid : Kind::shape;
}

bool MovingSceneMaker::State::can_be_rigid(const MovingPart& part) const {
  if (changes_tint(part)) return false;
  return std::ranges::all_of(part.keys,
                             [](const PartKey& key) { return key.mesh == nullptr || is_rigid_frame(key.frame); });
}

/// Looks of which few parts move are nodes, in their order, as long as there is room for them.
void MovingSceneMaker::State::count_rigid() {
  std::map<MovingLook, std::size_t> wanted;
  for (const MovingPart& part : parts) {
    if (kind_of(part) == MeshMotion::Kind::rigid && can_be_rigid(part)) ++wanted[part.look];
  }
  std::size_t room = moving.rigid_instances;
  for (const auto& [look, count] : wanted) {
    if (count > room) continue;
    room -= count;
    rigid[look] = count;
  }
}

Moving& MovingSceneMaker::State::group(const std::string& key, const MovingLook& look, const SharedMesh& mesh,
                                       MeshMotion::Kind kind) {
  const auto [entry, is_new] = made_by_key.try_emplace(key, made.size());
  if (is_new) {
    Moving& fresh = made.emplace_back();
    fresh.instances.component = components[look.component];
    fresh.instances.mesh = mesh;
    fresh.instances.material = look.material;
    fresh.motion.kind = kind;
  }
  return made[entry->second];
}

void MovingSceneMaker::State::add_part(const MovingPart& part) {
  using Kind = MeshMotion::Kind;
  Kind kind = kind_of(part);
  if (kind == Kind::shown) return add_shown(part);
  if (kind == Kind::rigid && !(rigid.contains(part.look) && can_be_rigid(part))) kind = Kind::shape;
  const bool has_tints = kind == Kind::shape && changes_tint(part);
  const std::vector<std::size_t> nearest = part.nearest();
  const std::size_t last = nearest.back();
  const auto frame_at = [&](std::size_t k) {
    const Frame& there = part.keys[nearest[k]].frame;
    return nearest[k] == k ? there : Frame{Mat3(0), there.origin};
  };

  // Parts with the same meshes at all keys are instances of one.
  bool is_one_mesh = true;
  std::string key =
      fmt::format("{} {} {} {}", part.look.component, part.look.material, static_cast<int>(kind), has_tints);
  std::vector<SharedMesh> of_keys;
  for (std::size_t k = 0; k < key_count; ++k) {
    of_keys.push_back(part.keys[nearest[k]].mesh);
    is_one_mesh = is_one_mesh && of_keys.back() == of_keys.front();
  }
  for (const SharedMesh& mesh : of_keys) {
    key += fmt::format(" {}", static_cast<const void*>(mesh.get()));
    if (is_one_mesh) break;
  }
  Moving& all = group(key, part.look, part.keys[last].mesh, kind);
  all.instances.frames.push_back(frame_at(key_count - 1));
  all.instances.tints.push_back(tint_at(part, last));
  all.instances.individuals.push_back(part.look.individual);
  if (kind == Kind::still) return;
  if (!is_one_mesh && all.motion.meshes.empty()) {
    all.motion.meshes = of_keys;
    for (const SharedMesh& mesh : of_keys) {
      all.motion.turns = all.motion.turns || are_turned(mesh->normals, all.instances.mesh->normals);
    }
  }
  all.motion.frames.resize(key_count);
  if (has_tints) all.motion.tints.resize(key_count);
  for (std::size_t k = 0; k < key_count; ++k) {
    const Frame frame = frame_at(k);
    const bool are_seen = is_there(frame) && is_there(part.keys[last].frame);
    if (are_seen && are_turned(frame, part.keys[last].frame)) all.motion.turns = true;
    all.motion.frames[k].push_back(frame);
    if (has_tints) all.motion.tints[k].push_back(tint_at(part, nearest[k]));
  }
}

void MovingSceneMaker::State::add_shown(const MovingPart& part) {
  for (std::size_t k = 0; k < key_count; ++k) {
    const PartKey& then = part.keys[k];
    if (then.mesh == nullptr) continue;
    const std::string key = fmt::format("{} {} shown {} {}", part.look.component, part.look.material, k,
                                        static_cast<const void*>(then.mesh.get()));
    Moving& all = group(key, part.look, then.mesh, MeshMotion::Kind::shown);
    all.motion.shown_at = k;
    all.instances.frames.push_back(then.frame);
    all.instances.tints.push_back(tint_at(part, k));
    all.instances.individuals.push_back(part.look.individual);
  }
}

/// Gives the blades of a part that are cut in several ways the vertices of the one that has most.
void MovingSceneMaker::State::cut_alike(MovingPart& part) {
  SharedMesh model;
  for (const PartKey& key : part.keys) {
    if (key.mesh != nullptr && (model == nullptr || key.mesh->vertex_count() >= model->vertex_count()))
      model = key.mesh;
  }
  std::vector<SharedMesh> cut;
  for (const PartKey& key : part.keys) {
    cut.push_back(key.mesh);
    if (key.mesh == nullptr || are_of_one_form(*key.mesh, *model)) continue;
    SharedMesh& known_cut = cut_meshes[{key.mesh.get(), model.get()}];
    if (known_cut == nullptr) {
      std::optional<Mesh> made_alike = as_model_is_cut(*key.mesh, *model);
      if (!made_alike) return;
      made_alike->uvs = model->uvs;
      made_alike->triangles = model->triangles;
      made_alike->stalk_triangles = model->stalk_triangles;
      known_cut = std::make_shared<const Mesh>(std::move(*made_alike));
    }
    cut.back() = known_cut;
  }
  for (std::size_t k = 0; k < cut.size(); ++k) part.keys[k].mesh = cut[k];
}

void MovingSceneMaker::State::take_parts() {
  for (MovingPart& part : parts) cut_alike(part);
  const std::size_t tubes = made.size();
  count_rigid();
  for (const MovingPart& part : parts) add_part(part);
  for (std::size_t k = tubes; k < made.size(); ++k) finish(made[k]);
  parts.clear();
}

/// Leaves out what says nothing, counts what moves, and gives the mesh what its material needs.
void MovingSceneMaker::State::finish(Moving& all) {
  const auto is_plain = [](Vec3 tint) { return tint == Vec3(1); };
  const bool has_tints = !all.motion.tints.empty();
  if (!has_tints && std::ranges::all_of(all.instances.tints, is_plain)) all.instances.tints = {};
  const auto is_first = [](std::uint32_t individual) { return individual == 0; };
  if (std::ranges::all_of(all.instances.individuals, is_first)) all.instances.individuals = {};
  all.instances.mesh = with_needed_tangents(all.instances.mesh, materials[all.instances.material]);
  if (all.motion.kind != MeshMotion::Kind::shape) return;
  const std::uint64_t of_vertex = sizeof(Vec3) * (all.motion.turns ? 2 : 1) + (has_tints ? sizeof(Vec4) : 0);
  bytes += of_vertex * all.instances.mesh->vertex_count() * all.instances.frames.size() * (key_count - 1);
  check_bytes(bytes);
}

void MovingSceneMaker::State::take_tubes(Progress& progress) {
  // Axes that look alike at all keys are one mesh.
  std::map<std::pair<MovingLook, std::string>, std::vector<AxisTrack*>> groups;
  std::vector<std::pair<MovingLook, std::string>> order;
  for (AxisTrack& track : axes) {
    const std::vector<std::size_t> nearest = track.nearest();
    std::string tints;
    for (const std::size_t there : nearest) {
      const Vec3 tint = tint_at(track.look, track.tints[there], there);
      tints.append(reinterpret_cast<const char*>(&tint), sizeof(tint));
    }
    const std::pair key(track.look, tints);
    if (groups[key].empty()) order.push_back(key);
    groups[key].push_back(&track);
  }
  for (const auto& key : order) take_tubes(groups[key], progress);
}

void MovingSceneMaker::State::take_tubes(std::span<AxisTrack* const> of_group, Progress& progress) {
  std::vector<std::size_t> model(of_group.size());
  std::vector<std::vector<std::size_t>> nearest(of_group.size());
  Mesh whole;
  for (std::size_t a = 0; a < of_group.size(); ++a) {
    nearest[a] = of_group[a]->nearest();
    model[a] = fullest_shape(of_group[a]->shapes);
    const TubeShape& tube = *of_group[a]->shapes[model[a]];
    add_tube_triangles(tube, static_cast<std::uint32_t>(whole.uvs.size()), whole);
    whole.uvs.insert(whole.uvs.end(), tube.uvs.begin(), tube.uvs.end());
  }
  std::vector<Mesh> of_key(key_count);
  parallel_for(key_count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      of_key[k].positions.reserve(whole.uvs.size());
      of_key[k].normals.reserve(whole.uvs.size());
      for (std::size_t a = 0; a < of_group.size(); ++a) {
        if (a % 256 == 0) progress.check();
        const auto& shapes = of_group[a]->shapes;
        const TubeShape& own_model = *shapes[model[a]];
        if (shapes[k]) {
          add_tube_vertices(*shapes[k], own_model, of_key[k]);
          continue;
        }
        add_collapsed_vertices(*shapes[nearest[a][k]], own_model, of_key[k]);
      }
    }
  });
  Moving& all = made.emplace_back();
  const MovingLook& look = of_group[0]->look;
  all.instances.component = components[look.component];
  all.instances.material = look.material;
  all.instances.frames = {Frame{}};
  all.instances.individuals = {look.individual};
  const auto& first = *of_group[0];
  const auto tint = [&](std::size_t key) {
    const std::size_t there = nearest[0][key];
    return tint_at(look, first.tints[there], there);
  };
  all.instances.tints = {tint(key_count - 1)};
  bool moves = false;
  bool changes = false;
  for (std::size_t k = 0; k < key_count; ++k) {
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
    for (std::size_t k = 0; changes && k < key_count; ++k) all.motion.tints.push_back({tint(k)});
  }
  for (AxisTrack* track : of_group) track->shapes.clear();
  finish(all);
}

MovingScene MovingSceneMaker::State::take(Progress& progress) {
  progress.begin("following motion", 2);
  take_tubes(progress);
  axes.clear();
  progress.advance();
  take_parts();
  progress.advance();
  return scene();
}

MovingScene MovingSceneMaker::State::scene() {
  std::erase_if(made, [](const Moving& all) { return all.instances.triangle_count() == 0; });
  std::stable_sort(made.begin(), made.end(), [this](const Moving& a, const Moving& b) {
    return number_of_component.at(a.instances.component) < number_of_component.at(b.instances.component);
  });
  MovingScene scene;
  scene.times = times;
  scene.scene.materials = materials;
  scene.scene.individuals = individuals;
  for (Moving& all : made) {
    scene.scene.meshes.push_back(std::move(all.instances));
    scene.motions.push_back(std::move(all.motion));
  }
  return scene;
}

MovingSceneMaker::MovingSceneMaker(const Limits& limits, const MovingLimits& moving, std::size_t keys)
    : state_(std::make_unique<State>(limits, moving, keys)) {}

MovingSceneMaker::~MovingSceneMaker() = default;

void MovingSceneMaker::add(double time, const Plant& plant, Progress& progress) { state_->add(time, plant, progress); }

MovingScene MovingSceneMaker::take(Progress& progress) { return state_->take(progress); }

}  // namespace meristem

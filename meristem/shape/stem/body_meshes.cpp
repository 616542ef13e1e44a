// SPDX-License-Identifier: Apache-2.0
// Meshes blended stems and crowns. All parts of a stem with one component, material and deformation form one implicit
// body. Its isosurface is simplified to the wanted number of triangles, then deformed and shaded.
#include "meristem/shape/stem/body_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/shape/implicit/isosurface.h"
#include "meristem/shape/implicit/plant_body.h"
#include "meristem/shape/mesh/front_normals.h"
#include "meristem/shape/mesh/shading.h"
#include "meristem/shape/mesh/simplify.h"
#include "meristem/shape/stem/cached_meshes.h"
#include "meristem/shape/stem/deformation_hashes.h"

namespace meristem {

namespace {

constexpr std::size_t kToldOneByOne = 8;  // up to this number, bodies are meshed one by one with their own progress;
                                          // more are meshed in parallel
constexpr std::size_t kFewestQuickTriangles = 60;
constexpr int kFewestQuickCells = 24;          // minimum number of cells along a body's longest side; with fewer,
                                               // branches looked like clubs
constexpr double kTrianglesPerSquare = 4;      // triangles of a tree per square of its longest side in cells,
                                               // approximately
constexpr double kQuickOversampling = 2;       // triangles that are made per triangle that is kept
constexpr std::size_t kFewestTriangles = 200;  // minimum for a body at any level; with a quarter of this number, crowns
                                               // looked like boulders

/// One body to mesh: all parts of a stem with one component, material and deformation, whatever their tints.
struct BodyTask {
  const Stem* stem = nullptr;
  std::vector<const StemPart*> parts;
  std::vector<std::vector<AxisIndex>> axes_of_part;
  bool is_crown = false;

  const StemPart& first() const { return *parts[0]; }
  const SurfaceOptions& surface() const { return first().surface; }
  int resolution() const { return is_crown ? surface().crown->resolution : surface().resolution; }
  std::optional<int> wanted_triangles() const { return is_crown ? surface().crown->triangles : surface().triangles; }
  /// Returns the origin of the body's mesh. Floats are more precise near it.
  Vec3 origin() const { return stem->skeleton.position[0]; }
  /// Returns the origin of the body's mesh before the deformation.
  Vec3 undeformed_origin() const { return stem->skeleton_of_surface().position[0]; }
  std::vector<AxisIndex> axes() const {
    std::vector<AxisIndex> all;
    for (const std::vector<AxisIndex>& axes : axes_of_part) all.insert(all.end(), axes.begin(), axes.end());
    return all;
  }
  /// Returns the tint of all parts, or no tint if their tints differ.
  Vec3 tint() const {
    const auto has_first = [this](const StemPart* part) { return part->tint == first().tint; };
    return std::all_of(parts.begin(), parts.end(), has_first) ? first().tint : Vec3(1);
  }
  std::string path() const {
    return "components." + first().component + (is_crown ? ".surface.crown.resolution" : ".surface.resolution");
  }
};

/// Groups a stem's parts and their axes by component and material.
std::vector<BodyTask> groups_of(const Stem& stem) {
  std::vector<std::vector<AxisIndex>> axes_of_part(stem.parts.size());
  AxisIndex axes = 0;
  for (const AxisIndex axis : stem.skeleton.axis) axes = std::max(axes, axis + 1);
  for (AxisIndex axis = 0; axis < axes; ++axis) axes_of_part[stem.part_index(axis)].push_back(axis);
  std::map<std::tuple<std::string_view, std::uint32_t, std::uint64_t>, std::size_t> number;
  std::vector<BodyTask> groups;
  DeformationHashes hashes;
  for (std::size_t k = 0; k < stem.parts.size(); ++k) {
    const StemPart& part = stem.parts[k];
    const auto [known, is_new] =
        number.try_emplace({part.component, part.material, hashes.of(part.deformation)}, groups.size());
    if (is_new) groups.emplace_back().stem = &stem;
    groups[known->second].parts.push_back(&part);
    groups[known->second].axes_of_part.push_back(std::move(axes_of_part[k]));
  }
  return groups;
}

std::vector<BodyTask> tasks_of(const Plant& plant) {
  std::vector<BodyTask> tasks;
  for (const Stem& stem : plant.stems) {
    if (stem.skeleton.node_count() == 0) continue;
    for (BodyTask& group : groups_of(stem)) {
      const SurfaceOptions& surface = group.surface();
      const bool has_crown = surface.crown && !surface.crown->hidden;
      if (surface.style == SurfaceOptions::Style::blend) tasks.push_back(group);
      if (!has_crown) continue;
      group.is_crown = true;
      tasks.push_back(std::move(group));
    }
  }
  return tasks;
}

/// Returns the body of a task with `resolution` cells along its longest side.
ImplicitBody body_of(const BodyTask& task, int resolution) {
  const Skeleton& skeleton = task.stem->skeleton_of_surface();
  SurfaceOptions surface = task.surface();
  surface.resolution = resolution;
  const Vec3 origin = task.undeformed_origin();
  if (!task.is_crown) {
    const std::vector<AxisIndex> axes = task.axes();
    const double min_radius = find_thickening(skeleton, axes, surface).min_radius;
    return make_stem_body(skeleton, axes, surface, min_radius, origin);
  }
  // Each part has balls of its own scale.
  ImplicitBody body;
  for (std::size_t k = 0; k < task.parts.size(); ++k) {
    const CrownBody& crown = *task.parts[k]->surface.crown;
    body.blend(make_crown_body(skeleton, task.axes_of_part[k], crown, origin), crown.blend, crown.fuse);
  }
  return body;
}

/// Returns the wanted number of triangles for a body of `made` triangles. `wanted` is the maximum that the document
/// sets.
std::size_t triangles_of(std::size_t made, const std::optional<int>& wanted, const MeshDetail& detail) {
  const std::size_t whole = wanted ? std::min(made, static_cast<std::size_t>(*wanted)) : made;
  const auto wanted_at_level = static_cast<std::size_t>(detail.kept() * static_cast<double>(whole));
  return std::max(wanted_at_level, std::min(whole, detail.is_quick ? kFewestQuickTriangles : kFewestTriangles));
}

/// Returns about how many triangles a body has if the document allows at most `wanted`.
double about_triangles(int resolution, const std::optional<int>& wanted) {
  const double made = kTrianglesPerSquare * resolution * resolution;
  return wanted ? std::min(made, static_cast<double>(*wanted)) : made;
}

/// Returns the number of cells along the longest side of a body. A quick level has as many as its triangles need.
int resolution_of(const BodyTask& task, const std::optional<int>& wanted, const MeshDetail& detail) {
  const int whole = task.resolution();
  if (!detail.is_quick || detail.level == 0) return whole;
  const double triangles =
      std::max(detail.kept() * about_triangles(whole, wanted), static_cast<double>(kFewestQuickTriangles));
  const double cells = std::sqrt(kQuickOversampling * triangles / kTrianglesPerSquare);
  return std::min(whole, std::max(kFewestQuickCells, static_cast<int>(std::ceil(cells))));
}

Mesh mesh_of(const BodyTask& task, const MeshDetail& detail, const SizeLimits& limits, Progress& progress) {
  const SurfaceOptions& surface = task.surface();
  const std::optional<int> triangles = task.wanted_triangles();
  const bool is_flat = surface.shading == SurfaceOptions::Shading::flat;
  IsosurfaceOptions options;
  options.resolution = resolution_of(task, triangles, detail);
  options.normals = !is_flat;
  Mesh mesh = extract_isosurface(body_of(task, options.resolution), options, limits, task.path(), progress);
  if (detail.work != nullptr) detail.work->triangles += mesh.triangle_count();
  // A body made of larger cells already has the share of the triangles.
  const double cells = static_cast<double>(options.resolution) / task.resolution();
  const auto whole = static_cast<std::size_t>(static_cast<double>(mesh.triangle_count()) / (cells * cells));
  const std::size_t target = triangles_of(whole, triangles, detail);
  if (target < mesh.triangle_count()) {
    progress.begin("simplifying bodies", mesh.triangle_count() - target);
    mesh = simplify(mesh, {.triangles = target}, progress);
    if (!is_flat) turn_to_front(mesh, progress);
  }
  if (const auto& deformation = task.first().deformation; deformation != nullptr) {
    deformation->map(mesh, task.undeformed_origin(), task.origin(), task.first().component);
  }
  if (is_flat) mesh = flat_shaded(mesh, progress);
  return mesh;
}

/// Meshes the tasks whose indices are in `missing`.
void mesh_bodies(const std::vector<BodyTask>& tasks, const std::vector<std::size_t>& missing, const MeshDetail& detail,
                 const SizeLimits& limits, Progress& progress, std::vector<std::shared_ptr<const Mesh>>& meshes) {
  const auto mesh_one = [&](std::size_t task, Progress& told) {
    meshes[task] = std::make_shared<const Mesh>(mesh_of(tasks[task], detail, limits, told));
  };
  if (missing.size() <= kToldOneByOne) {
    for (const std::size_t task : missing) mesh_one(task, progress);
    return;
  }
  progress.begin("meshing bodies", missing.size());
  parallel_for(missing.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Progress part(&progress);
      mesh_one(missing[k], part);
      progress.advance();
    }
  });
}

/// Returns the hash of everything that shapes a body.
std::uint64_t key_of(const BodyTask& task, const MeshDetail& detail, const SizeLimits& limits) {
  static_assert(std::has_unique_object_representations_v<SizeLimits>);
  Fingerprint key;
  add_skeleton(*task.stem, key);
  add_detail(detail, key);
  key.add(task.is_crown).add_text({reinterpret_cast<const char*>(&limits), sizeof(limits)});
  for (std::size_t k = 0; k < task.parts.size(); ++k) {
    add_surface(task.parts[k]->surface, key);
    key.add_array(task.axes_of_part[k]);
  }
  return key.hash();
}

/// Returns the number of a material in `materials`, and appends it if it is new.
std::uint32_t number_of(const Material& material, std::vector<Material>& materials) {
  const auto found = std::find(materials.begin(), materials.end(), material);
  if (found != materials.end()) return static_cast<std::uint32_t>(found - materials.begin());
  materials.push_back(material);
  return static_cast<std::uint32_t>(materials.size() - 1);
}

Material material_of(const BodyTask& task, const Material& stems) {
  Material material = stems;
  material.texture = nullptr;
  if (!task.is_crown) return material;
  material.name += "_crown";
  material.colour = task.surface().crown->colour;
  return material;
}

}  // namespace

double about_body_triangles(const Plant& plant) {
  double triangles = 0;
  for (const BodyTask& task : tasks_of(plant)) triangles += about_triangles(task.resolution(), task.wanted_triangles());
  return triangles;
}

void add_thickening(const Plant& plant, BodyThickening& whole) {
  for (const BodyTask& task : tasks_of(plant)) {
    if (task.is_crown) continue;
    const BodyThickening thickening = find_thickening(task.stem->skeleton_of_surface(), task.axes(), task.surface());
    whole.min_radius = std::max(whole.min_radius, thickening.min_radius);
    whole.length += thickening.length;
    whole.thickened += thickening.thickened;
    whole.volume += thickening.volume;
    whole.added += thickening.added;
  }
}

bool has_bodies(const Plant& plant) {
  return std::ranges::any_of(plant.stems, [](const Stem& stem) {
    return std::ranges::any_of(stem.parts, [](const StemPart& part) {
      const SurfaceOptions& surface = part.surface;
      return surface.style == SurfaceOptions::Style::blend || (surface.crown && !surface.crown->hidden);
    });
  });
}

std::vector<BodyCells> find_body_cells(const Plant& plant, const Progress& progress) {
  std::vector<BodyCells> found;
  for (const BodyTask& task : tasks_of(plant)) {
    progress.check();
    const ImplicitBody body = body_of(task, task.resolution());
    if (body.is_empty()) continue;
    const DVec3 origin(task.undeformed_origin());
    found.push_back({{Vec3(origin + body.low()), Vec3(origin + body.high())}, cell_size(body, task.resolution())});
  }
  return found;
}

std::vector<MeshInstances> make_body_meshes(const Plant& plant, const MeshDetail& detail, const SizeLimits& limits,
                                            std::vector<Material>& materials, Progress& progress, CacheRun& results) {
  const std::vector<BodyTask> tasks = tasks_of(plant);
  std::vector<CacheKey> keys;
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<std::size_t> missing;
  for (const BodyTask& task : tasks) {
    keys.push_back(results.key([&] { return key_of(task, detail, limits); }));
    const auto found = results.find<const BodyMesh>(keys.back());
    results.count<BodyMesh>(found != nullptr);
    meshes.push_back(found != nullptr ? found->mesh : nullptr);
    if (found == nullptr) missing.push_back(meshes.size() - 1);
  }
  mesh_bodies(tasks, missing, detail, limits, progress, meshes);
  for (const std::size_t k : missing) results.store(keys[k], std::make_shared<const BodyMesh>(BodyMesh{meshes[k]}));

  std::vector<MeshInstances> made(tasks.size());
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const StemPart& part = tasks[k].first();
    made[k].component = part.component;
    made[k].is_crown = tasks[k].is_crown;
    made[k].mesh = std::move(meshes[k]);
    made[k].material = number_of(material_of(tasks[k], plant.materials[part.material]), materials);
    made[k].frames = {Frame{.origin = tasks[k].origin()}};
    made[k].origin = std::make_shared<const MeshOrigin>(
        MeshOrigin{.stem = static_cast<std::uint32_t>(tasks[k].stem - plant.stems.data())});
    // A body of several plants belongs to none of them.
    if (tasks[k].stem->individual() != 0) made[k].individuals = {tasks[k].stem->individual()};
    // A crown has its own colour, but shares the tint that distinguishes its stem from others.
    if (tasks[k].tint() != Vec3(1)) made[k].tints = {tasks[k].tint()};
  }
  return made;
}

}  // namespace meristem

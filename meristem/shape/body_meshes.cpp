// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/body_meshes.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/shape/front_normals.h"
#include "meristem/shape/isosurface.h"
#include "meristem/shape/plant_body.h"
#include "meristem/shape/shading.h"
#include "meristem/shape/simplify.h"
#include "meristem/shape/stem_looks.h"

namespace meristem {

namespace {

constexpr std::size_t kFewestTriangles = 200;  // of a body in any level; with a quarter of that crowns were boulders

/// One body to mesh.
struct BodyTask {
  const Stem* stem = nullptr;
  const StemPart* part = nullptr;
  std::vector<AxisIndex> axes;
  bool is_crown = false;

  const Surface& surface() const { return part->surface; }
  std::string path() const {
    return "components." + part->component + (is_crown ? ".surface.crown.resolution" : ".surface.resolution");
  }
};

std::vector<BodyTask> tasks_of(const Plant& plant) {
  std::vector<BodyTask> tasks;
  for (const Stem& stem : plant.stems) {
    const StemLooks looks(stem);
    const std::vector<std::vector<AxisIndex>> axes = looks.axes(stem);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const StemPart* const part = looks.first_part[k];
      const Surface& surface = part->surface;
      if (surface.style == Surface::Style::blend) tasks.push_back({&stem, part, axes[k], false});
      if (surface.crown && !surface.crown->hidden) tasks.push_back({&stem, part, axes[k], true});
    }
  }
  return tasks;
}

ImplicitBody body_of(const BodyTask& task) {
  const Skeleton& skeleton = task.stem->skeleton;
  const Surface& surface = task.surface();
  if (task.is_crown) return make_crown_body(skeleton, task.axes, *surface.crown);
  const double least_radius = find_thickening(skeleton, task.axes, surface).least_radius;
  return make_stem_body(skeleton, task.axes, surface, least_radius);
}

/// How many triangles a body of `made` is to have, of which the document wants at most `wanted`.
std::size_t triangles_of(std::size_t made, const std::optional<int>& wanted, const Detail& detail) {
  const std::size_t whole = wanted ? std::min(made, static_cast<std::size_t>(*wanted)) : made;
  const auto wanted_at_level = static_cast<std::size_t>(detail.kept() * static_cast<double>(whole));
  return std::max(wanted_at_level, std::min(whole, kFewestTriangles));
}

Mesh mesh_of(const BodyTask& task, const Detail& detail, const Limits& limits, Progress& progress) {
  const Surface& surface = task.surface();
  const std::optional<int> triangles = task.is_crown ? surface.crown->triangles : surface.triangles;
  const bool is_flat = surface.shading == Surface::Shading::flat;
  IsosurfaceOptions options;
  options.resolution = task.is_crown ? surface.crown->resolution : surface.resolution;
  options.normals = !is_flat;
  Mesh mesh = extract_isosurface(body_of(task), options, limits, task.path(), progress);
  const std::size_t target = triangles_of(mesh.triangle_count(), triangles, detail);
  if (target < mesh.triangle_count()) {
    mesh = simplify(mesh, {.triangles = target}, progress);
    if (!is_flat) turn_to_front(mesh);
  }
  return is_flat ? flat_shaded(mesh) : mesh;
}

/// The number of a material among `materials`, appended if it is not among them.
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

Thickening find_thickening(const Plant& plant) {
  Thickening whole;
  for (const BodyTask& task : tasks_of(plant)) {
    if (task.is_crown) continue;
    const Thickening thickening = find_thickening(task.stem->skeleton, task.axes, task.surface());
    whole.least_radius = std::max(whole.least_radius, thickening.least_radius);
    whole.length += thickening.length;
    whole.thickened += thickening.thickened;
    whole.volume += thickening.volume;
    whole.added += thickening.added;
  }
  return whole;
}

std::vector<MeshInstances> make_body_meshes(const Plant& plant, const Detail& detail, const Limits& limits,
                                            std::vector<Material>& materials, Progress& progress) {
  const std::vector<BodyTask> tasks = tasks_of(plant);
  std::vector<MeshInstances> made(tasks.size());
  if (tasks.empty()) return made;
  std::vector<Mesh> meshes(tasks.size());
  if (tasks.size() == 1) {
    meshes[0] = mesh_of(tasks[0], detail, limits, progress);
  } else {
    progress.begin("meshing bodies", tasks.size());
    parallel_for(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        Progress part(&progress);
        meshes[k] = mesh_of(tasks[k], detail, limits, part);
        progress.advance();
      }
    });
  }
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const StemPart& part = *tasks[k].part;
    made[k].component = part.component;
    made[k].mesh = std::make_shared<const Mesh>(std::move(meshes[k]));
    made[k].material = number_of(material_of(tasks[k], plant.materials[part.material]), materials);
    made[k].frames = {Frame{}};
    // A crown has its own colour; the shade that tells its stem from others is its, too.
    if (part.tint != Vec3(1)) made[k].tints = {part.tint};
  }
  return made;
}

}  // namespace meristem

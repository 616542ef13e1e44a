// SPDX-License-Identifier: Apache-2.0
// The table of all output formats: their endings, what they need, and the functions that write them. Files of one
// document may have companions, such as the MTL of an OBJ, which are listed here as well.
#include "meristem/export/formats.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/version.h"
#include "meristem/export/overlay/trace_csv.h"
#include "meristem/measure/surface_labels.h"
#include "meristem/output/mesh/chosen_objects.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/mesh/ply.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "meristem/output/skeleton/cylinder_csv.h"
#include "meristem/output/skeleton/operation_csv.h"
#include "meristem/output/skeleton/skeleton_csv.h"
#include "meristem/output/skeleton/skeleton_mtg.h"
#include "meristem/output/skeleton/tree_file.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

/// Returns the MTL and all pictures that the components may need. After growth it is known which of them exist.
std::vector<std::string> obj_companions(const Document& document, const std::string& path) {
  std::vector<std::string> paths{material_path(path)};
  for (const Prototype& component : document.graph.components) {
    for (std::string& picture : picture_paths(path, component.id)) paths.push_back(std::move(picture));
  }
  return paths;
}

/// Calls `write` with the chosen meshes, and with the meshes of the scene's obstacles if options request them.
template <class Write>
void write_meshes(const Document& document, const GrownDocument& grown, const FormatOptions& options, Write write) {
  const bool has_obstacles = options.obstacles && has_visible(document.scene.obstacles);
  if (options.only.empty() && !has_obstacles) return write(grown.meshes);
  const MeshScene chosen = chosen_objects(grown.meshes, options.only, "--only");
  if (!has_obstacles) return write(chosen);
  write(with_obstacles(chosen, document.scene.obstacles));
}

constexpr FileFormat kFormats[] = {
    {.ending = ".glb",
     .doc = "glTF 2.0 binary, for Blender, Godot, three.js and most others",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions& options,
            Progress& progress) {
           write_meshes(document, grown, options, [&](const MeshScene& meshes) {
             write_glb(
                 meshes, path,
                 {.instances = options.instances, .provenance = provenance_of(document), .pictures = options.pictures},
                 progress);
           });
         },
     .needs = GrownPart::textures,
     .can_instance = true,
     .can_animate = true},
    {.ending = ".obj",
     .doc = "Wavefront OBJ with its MTL file and pictures beside it",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions& options,
            Progress& progress) {
           write_meshes(document, grown, options, [&](const MeshScene& meshes) {
             write_obj(meshes, path, {provenance_of(document), options.pictures}, progress);
           });
         },
     .needs = GrownPart::textures,
     .companions = obj_companions},
    {.ending = ".ply",
     .doc = "the mesh as binary PLY, for MeshLab, Open3D and Blender",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions& options,
            Progress& progress) {
           write_meshes(document, grown, options, [&](const MeshScene& meshes) {
             write_mesh_ply(meshes, path,
                            {.provenance = provenance_of(document), .shared_vertices = options.shared_vertices},
                            progress);
           });
         },
     .needs = GrownPart::meshes},
    {.ending = ".labels.ply",
     .doc = "the mesh with the tree, component, instance and shoot of each face, in binary PLY",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
            Progress& progress) {
           const SurfaceLabels labels(grown.plant, document.graph.limits, grown.meshes, progress);
           write_mesh_ply(grown.meshes, path, {provenance_of(document), &labels}, progress);
         },
     .needs = GrownPart::meshes,
     .is_whole = true},
    {.ending = ".skeleton.ply",
     .doc = "the skeletons as points with radius, and edges, in binary PLY",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
            Progress& progress) {
           write_skeleton_ply(grown.plant, document.graph.limits, path, {provenance_of(document)}, progress);
         }},
    {.ending = ".csv",
     .doc = "the skeletons as a table, one row per node",
     .write = [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
                 Progress& progress) { write_skeleton_csv(grown.plant, document.graph.limits, path, progress); }},
    {.ending = ".qsm.csv",
     .doc = "the skeletons as cylinders in the columns of TreeQSM, z up, one row per cylinder",
     .write = [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
                 Progress& progress) { write_cylinder_csv(grown.plant, document.graph.limits, path, progress); }},
    {.ending = ".trees.txt",
     .doc = "the skeletons as a tree file of treetools and raycloudtools, z up, one line per tree",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
            Progress& progress) {
           write_tree_file(grown.plant, document.graph.limits, path, provenance_of(document), progress);
         }},
    {.ending = ".operations.csv",
     .doc = "what operations did to self-organizing trees as a table, one row per cut, ring, bend, tie or mark",
     .write = [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
                 Progress& progress) { write_operation_csv(grown.plant, document.graph.limits, path, progress); }},
    {.ending = ".points.csv",
     .doc =
         "the attraction points of trees that colonize space as a table, one row per point: left, used up or removed",
     .write = [](const Document&, const GrownDocument& grown, const std::string& path, const FormatOptions&,
                 Progress& progress) { write_points_csv(grown.traces, path, progress); },
     .request = {TracePart::points}},
    {.ending = ".mtg",
     .doc = "the skeletons as a multiscale tree graph, for OpenAlea and MultiScaleTreeGraph.jl",
     .write =
         [](const Document& document, const GrownDocument& grown, const std::string& path, const FormatOptions&,
            Progress& progress) {
           write_skeleton_mtg(grown.plant, document.graph.limits, path, {provenance_of(document)}, progress);
         }},
};

std::vector<std::string> endings() {
  std::vector<std::string> known;
  for (const FileFormat& format : kFormats) known.emplace_back(format.ending);
  return known;
}

/// Returns a list such as `.glb, .obj or .ply`.
std::string listed(const std::vector<std::string>& known) {
  const auto last = known.end() - 1;
  return fmt::format("{} or {}", fmt::join(known.begin(), last, ", "), *last);
}

/// Returns the known ending that is nearest to one of the possible endings of `name`. Longer endings are tried first.
std::string nearest_ending(const std::string& name) {
  for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
    if (std::string nearest = nearest_name(name.substr(dot), endings()); !nearest.empty()) return nearest;
  }
  return {};
}

}  // namespace

Provenance provenance_of(const Document& document) {
  return {.name = document.name,
          .author = document.author,
          .licence = document.licence,
          .seed = document.graph.seed,
          .version = std::string(version()),
          .sets = document.source.sets};
}

std::span<const FileFormat> formats() { return kFormats; }

std::string detail_path(const FileFormat& format, const std::string& path, int level) {
  if (level == 0) return path;
  const std::size_t stem = path.size() - format.ending.size();
  return fmt::format("{}_lod{}{}", path.substr(0, stem), level, path.substr(stem));
}

std::string cards_path(const FileFormat& format, const std::string& path) {
  const std::size_t stem = path.size() - format.ending.size();
  return fmt::format("{}_cards{}", path.substr(0, stem), path.substr(stem));
}

GrownPart needed_part(std::span<const FileFormat* const> formats) {
  GrownPart part = GrownPart::plant;
  for (const FileFormat* format : formats) part = std::max(part, format->needs);
  return part;
}

TraceRequest needed_request(std::span<const FileFormat* const> formats) {
  TraceRequest request;
  for (const FileFormat* format : formats) request = request | format->request;
  return request;
}

const FileFormat& format_of(const std::string& path) {
  if (path == "-") return kFormats[0];
  const std::string name = lower_case(path.substr(path.find_last_of('/') + 1));
  const FileFormat* best = nullptr;
  for (const FileFormat& format : kFormats) {
    if (name.ends_with(format.ending) && (best == nullptr || format.ending.size() > best->ending.size()))
      best = &format;
  }
  if (best != nullptr) return *best;
  const std::size_t dot = name.find_last_of('.');
  throw InputError(Diagnostic{
      .message = dot == std::string::npos ? fmt::format("'{}' has no ending that names a format", path)
                                          : fmt::format("'{}' is not a format that can be written", name.substr(dot)),
      .expected = "a file that ends in " + listed(endings()),
      .nearest = nearest_ending(name)});
}

}  // namespace meristem

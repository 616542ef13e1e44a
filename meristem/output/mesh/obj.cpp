// SPDX-License-Identifier: Apache-2.0
// Writes Wavefront OBJ. An OBJ counts positions, texture coordinates and normals over the whole file, each from 1.
// Every mesh with its instances is written as four runs (positions, texture coordinates, normals, faces), and three
// offsets are carried along.
//
// Based on: Wavefront Technologies, Advanced Visualizer manual, appendix B1 (1995), OBJ; colours behind positions as
// MeshLab, Blender and three.js read them.
#include "meristem/output/mesh/obj.h"

#include <algorithm>
#include <array>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/colour.h"
#include "meristem/output/mesh/obj_materials.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/colour_factors.h"
#include "meristem/output/write/finite.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

constexpr std::size_t kVectorBytes = 96;  // "v -1.2345678e-10 -1.2345678e-10 -1.2345678e-10 0.1234 0.1234 0.1234"
constexpr std::size_t kFaceBytes = 256;   // nine numbers of up to 20 digits

/// Names of materials and components. Each name is a unique word.
struct ObjNames {
  std::vector<std::string> materials;     // for each of MeshScene::materials
  std::vector<std::string> components;    // in the order of their first occurrence in the scene
  std::vector<std::size_t> component_of;  // for each of MeshScene::meshes, an index into `components`
  std::vector<bool> has_colours;          // for each component, whether some instances have tints
};

ObjNames names_of(const MeshScene& scene) {
  ObjNames names;
  std::vector<std::string> materials;
  for (const Material& material : scene.materials) materials.push_back(material.name);
  names.materials = distinct_words(materials);
  std::vector<std::string> components;
  for (const MeshInstances& instances : scene.meshes) {
    if (components.empty() || components.back() != instances.component) {
      components.push_back(instances.component);
      names.has_colours.push_back(false);
    }
    names.component_of.push_back(components.size() - 1);
    if (!instances.tints.empty()) names.has_colours.back() = true;
  }
  names.components = distinct_words(components);
  return names;
}

/// Appends a line in `format`. The numbers must be finite.
template <class Format, class... Values>
void append_line(std::string& out, const Format& format, const Values&... values) {
  (require_finite_value(values), ...);
  std::array<char, kFaceBytes> line;
  const char* end = fmt::format_to(line.data(), format, values...);
  out.append(line.data(), static_cast<std::size_t>(end - line.data()));
}

/// Numbers of the first elements of a mesh in the file.
struct Offsets {
  std::uint64_t position = 1;
  std::uint64_t uv = 1;
  std::uint64_t normal = 1;
};

/// Appends a face with the attributes that the mesh has.
void append_face(std::string& out, const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, const Offsets& at) {
  const auto [a, b, c] = triangle;
  const bool has_uvs = !mesh.uvs.empty();
  if (has_uvs && !mesh.normals.empty()) {
    append_line(out, FMT_COMPILE("f {}/{}/{} {}/{}/{} {}/{}/{}\n"), at.position + a, at.uv + a, at.normal + a,
                at.position + b, at.uv + b, at.normal + b, at.position + c, at.uv + c, at.normal + c);
  } else if (has_uvs) {
    append_line(out, FMT_COMPILE("f {}/{} {}/{} {}/{}\n"), at.position + a, at.uv + a, at.position + b, at.uv + b,
                at.position + c, at.uv + c);
  } else if (!mesh.normals.empty()) {
    append_line(out, FMT_COMPILE("f {}//{} {}//{} {}//{}\n"), at.position + a, at.normal + a, at.position + b,
                at.normal + b, at.position + c, at.normal + c);
  } else {
    append_line(out, FMT_COMPILE("f {} {} {}\n"), at.position + a, at.position + b, at.position + c);
  }
}

/// Writes positions, followed by the colours of the instances.
void write_coloured_positions(BlockWriter& writer, const MeshInstances& instances, const ColourFactors& factors) {
  const Mesh& mesh = *instances.mesh;
  const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
    const Vec3 colour = srgb_from_linear(factors.instance(instances.tint(frame)));
    const std::string tail = fmt::format(" {:.4g} {:.4g} {:.4g}\n", colour.r, colour.g, colour.b);
    const Frame place = instances.frame(frame);
    for (std::size_t v = first; v < last; ++v) {
      const Vec3 point = place.point(mesh.positions[v]);
      append_line(out, FMT_COMPILE("v {} {} {}"), point.x, point.y, point.z);
      out += tail;
    }
  };
  write_for_frames(writer, instances.count(), mesh.positions.size(), kVectorBytes, fill);
}

void write_vertices(BlockWriter& writer, const MeshInstances& instances, const ColourFactors* colours) {
  const Mesh& mesh = *instances.mesh;
  const auto write = [&](std::size_t per_frame, auto append) {
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
      const Frame place = instances.frame(frame);
      for (std::size_t v = first; v < last; ++v) append(out, place, v);
    };
    write_for_frames(writer, instances.count(), per_frame, kVectorBytes, fill);
  };
  if (colours != nullptr) {
    write_coloured_positions(writer, instances, *colours);
  } else {
    write(mesh.positions.size(), [&](std::string& out, const Frame& frame, std::size_t v) {
      const Vec3 point = frame.point(mesh.positions[v]);
      append_line(out, FMT_COMPILE("v {} {} {}\n"), point.x, point.y, point.z);
    });
  }
  write(mesh.uvs.size(), [&](std::string& out, const Frame&, std::size_t v) {
    append_line(out, FMT_COMPILE("vt {} {}\n"), mesh.uvs[v].x, mesh.uvs[v].y);
  });
  write(mesh.normals.size(), [&](std::string& out, const Frame& frame, std::size_t v) {
    const Vec3 normal = frame.normal(mesh.normals[v]);
    append_line(out, FMT_COMPILE("vn {} {} {}\n"), normal.x, normal.y, normal.z);
  });
}

void write_faces(BlockWriter& writer, const MeshInstances& instances, const Offsets& offsets) {
  const Mesh& mesh = *instances.mesh;
  const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
    const Offsets at{offsets.position + frame * mesh.positions.size(), offsets.uv + frame * mesh.uvs.size(),
                     offsets.normal + frame * mesh.normals.size()};
    const bool flips = is_mirrored(instances.frame(frame));
    for (std::size_t t = first; t < last; ++t) {
      std::array<std::uint32_t, 3> triangle = mesh.triangles[t];
      if (flips) std::swap(triangle[1], triangle[2]);
      append_face(out, mesh, triangle, at);
    }
  };
  write_for_frames(writer, instances.count(), mesh.triangle_count(), kFaceBytes, fill);
}

void write_geometry(const MeshScene& scene, const std::vector<ColourFactors>& factors, const ObjNames& names,
                    AtomicFile& file, Progress& progress) {
  BlockWriter writer(file, progress);
  Offsets offsets;
  for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
    const MeshInstances& instances = scene.meshes[k];
    const bool is_new = k == 0 || names.component_of[k] != names.component_of[k - 1];
    if (is_new) file.write(fmt::format("\no {0}\ng {0}\n", names.components[names.component_of[k]]));
    if (is_new || instances.material != scene.meshes[k - 1].material) {
      file.write(fmt::format("usemtl {}\n", names.materials[instances.material]));
    }
    const bool has_colours = names.has_colours[names.component_of[k]];
    write_vertices(writer, instances, has_colours ? &factors[instances.material] : nullptr);
    write_faces(writer, instances, offsets);
    const Mesh& mesh = *instances.mesh;
    offsets.position += mesh.positions.size() * instances.count();
    offsets.uv += mesh.uvs.size() * instances.count();
    offsets.normal += mesh.normals.size() * instances.count();
  }
}

std::uint64_t element_count(const MeshScene& scene) {
  std::uint64_t count = 0;
  for (const MeshInstances& instances : scene.meshes) {
    const Mesh& mesh = *instances.mesh;
    count +=
        instances.count() * (mesh.positions.size() + mesh.uvs.size() + mesh.normals.size() + mesh.triangle_count());
  }
  return count;
}

}  // namespace

namespace {

/// Returns `dir/oak` for `dir/oak.obj`.
std::string stem_of(const std::string& obj_path) {
  constexpr std::string_view kEnding = ".obj";
  const std::size_t name_at = obj_path.rfind('/') + 1;  // 0 if there is no slash
  std::string name = obj_path.substr(name_at);
  if (name.size() > kEnding.size() && lower_case(name).ends_with(kEnding)) name.resize(name.size() - kEnding.size());
  return obj_path.substr(0, name_at) + single_word(name);
}

}  // namespace

std::string material_path(const std::string& obj_path) { return stem_of(obj_path) + ".mtl"; }

std::array<std::string, 3> picture_paths(const std::string& obj_path, const std::string& material) {
  const std::string stem = stem_of(obj_path) + "_" + file_word(material);
  return {stem + "_colour.png", stem + "_normals.png", stem + "_mask.png"};
}

void write_obj(const MeshScene& scene, const std::string& path, const ObjOptions& options, Progress& progress) {
  require_finite(scene);
  progress.begin("writing OBJ", element_count(scene));
  const ObjNames names = names_of(scene);
  const std::vector<ColourFactors> factors = colour_factors(scene);
  FileSet files;
  AtomicFile file(path);
  for (const std::string& line : provenance_lines(options.provenance)) file.write("# " + line + "\n");
  if (!file.is_stream()) {
    write_companions(scene, factors, names.materials, path, options, progress);
    const std::string materials = material_path(path);
    file.write(fmt::format("mtllib {}\n", materials.substr(materials.rfind('/') + 1)));
  }
  write_geometry(scene, factors, names, file, progress);
  file.commit();
  files.commit();
}

}  // namespace meristem

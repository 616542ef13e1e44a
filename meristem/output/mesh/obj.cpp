// SPDX-License-Identifier: Apache-2.0
// Writes Wavefront OBJ. An OBJ counts positions, texture coordinates and normals over the whole file, each from 1.
// Every mesh with its instances is written as four runs (positions, texture coordinates, normals, faces), and three
// offsets are carried along. Flat shaded meshes have one normal for each face, and their faces share positions.
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
#include "meristem/output/mesh/shared_vertices.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/colour_factors.h"
#include "meristem/output/write/finite.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

constexpr std::size_t kVectorBytes = 96;  // "v -1.2345678e-10 -1.2345678e-10 -1.2345678e-10 0.1234 0.1234 0.1234"
constexpr std::size_t kFaceBytes = 256;   // nine numbers of up to 20 digits

/// Names of materials and objects. Each name is a unique word.
struct ObjNames {
  std::vector<std::string> materials;  // for each of MeshScene::materials
  std::vector<std::string> objects;    // in the order of the file
  std::vector<std::size_t> object_of;  // for each of MeshScene::meshes, an index into `objects`
  std::vector<bool> has_colours;       // for each object, whether some instances have tints
};

/// Returns the meshes in the order of the file. The crown bodies of a component follow its other meshes.
std::vector<const MeshInstances*> ordered_meshes(const MeshScene& scene) {
  std::vector<const MeshInstances*> meshes;
  for (std::size_t first = 0, end = 0; first < scene.meshes.size(); first = end) {
    while (end < scene.meshes.size() && scene.meshes[end].component == scene.meshes[first].component) ++end;
    for (const bool crowns : {false, true}) {
      for (std::size_t k = first; k < end; ++k) {
        if (scene.meshes[k].is_crown == crowns) meshes.push_back(&scene.meshes[k]);
      }
    }
  }
  return meshes;
}

ObjNames names_of(const MeshScene& scene, const std::vector<const MeshInstances*>& meshes) {
  ObjNames names;
  std::vector<std::string> materials;
  for (const Material& material : scene.materials) materials.push_back(material.name);
  names.materials = distinct_words(materials);
  std::vector<std::string> objects;
  for (const MeshInstances* instances : meshes) {
    std::string object = object_name(*instances);
    if (objects.empty() || objects.back() != object) {
      objects.push_back(std::move(object));
      names.has_colours.push_back(false);
    }
    names.object_of.push_back(objects.size() - 1);
    if (!instances->tints.empty()) names.has_colours.back() = true;
  }
  names.objects = distinct_words(objects);
  return names;
}

/// The positions and normals of a mesh that stand in the file.
class FileVertices {
 public:
  explicit FileVertices(const Mesh& mesh) : mesh_(&mesh), is_flat_(is_flat_shaded(mesh)) {
    if (is_flat_) shared_ = share_vertices(mesh, false);
  }
  std::size_t position_count() const { return is_flat_ ? shared_.first.size() : mesh_->positions.size(); }
  std::size_t normal_count() const { return is_flat_ ? mesh_->triangle_count() : mesh_->normals.size(); }
  /// Returns the vertex of the mesh whose position or normal stands at this place of the file.
  std::size_t position_vertex(std::size_t k) const { return is_flat_ ? shared_.first[k] : k; }
  std::size_t normal_vertex(std::size_t k) const { return is_flat_ ? 3 * k : k; }
  /// Returns the place of a vertex of the mesh.
  std::uint64_t position(std::uint32_t vertex) const { return is_flat_ ? shared_.number[vertex] : vertex; }
  std::uint64_t normal(std::uint32_t vertex) const { return is_flat_ ? vertex / 3 : vertex; }

 private:
  const Mesh* mesh_;
  bool is_flat_;
  SharedVertices shared_;
};

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
void append_face(std::string& out, const Mesh& mesh, const FileVertices& vertices,
                 const std::array<std::uint32_t, 3>& triangle, const Offsets& at) {
  const auto [a, b, c] = triangle;
  const auto v = [&](std::uint32_t vertex) { return at.position + vertices.position(vertex); };
  const auto n = [&](std::uint32_t vertex) { return at.normal + vertices.normal(vertex); };
  const bool has_uvs = !mesh.uvs.empty();
  if (has_uvs && !mesh.normals.empty()) {
    append_line(out, FMT_COMPILE("f {}/{}/{} {}/{}/{} {}/{}/{}\n"), v(a), at.uv + a, n(a), v(b), at.uv + b, n(b), v(c),
                at.uv + c, n(c));
  } else if (has_uvs) {
    append_line(out, FMT_COMPILE("f {}/{} {}/{} {}/{}\n"), v(a), at.uv + a, v(b), at.uv + b, v(c), at.uv + c);
  } else if (!mesh.normals.empty()) {
    append_line(out, FMT_COMPILE("f {}//{} {}//{} {}//{}\n"), v(a), n(a), v(b), n(b), v(c), n(c));
  } else {
    append_line(out, FMT_COMPILE("f {} {} {}\n"), v(a), v(b), v(c));
  }
}

/// Writes positions, followed by the colours of the instances.
void write_coloured_positions(BlockWriter& writer, const MeshInstances& instances, const FileVertices& vertices,
                              const ColourFactors& factors) {
  const Mesh& mesh = *instances.mesh;
  const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
    const Vec3 colour = srgb_from_linear(factors.instance(instances.tint(frame)));
    const std::string tail = fmt::format(" {:.4g} {:.4g} {:.4g}\n", colour.r, colour.g, colour.b);
    const Frame place = instances.frame(frame);
    for (std::size_t v = first; v < last; ++v) {
      const Vec3 point = place.point(mesh.positions[vertices.position_vertex(v)]);
      append_line(out, FMT_COMPILE("v {} {} {}"), point.x, point.y, point.z);
      out += tail;
    }
  };
  write_for_frames(writer, instances.count(), vertices.position_count(), kVectorBytes, fill);
}

void write_vertices(BlockWriter& writer, const MeshInstances& instances, const FileVertices& vertices,
                    const ColourFactors* colours) {
  const Mesh& mesh = *instances.mesh;
  const auto write = [&](std::size_t per_frame, auto append) {
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
      const Frame place = instances.frame(frame);
      for (std::size_t v = first; v < last; ++v) append(out, place, v);
    };
    write_for_frames(writer, instances.count(), per_frame, kVectorBytes, fill);
  };
  if (colours != nullptr) {
    write_coloured_positions(writer, instances, vertices, *colours);
  } else {
    write(vertices.position_count(), [&](std::string& out, const Frame& frame, std::size_t v) {
      const Vec3 point = frame.point(mesh.positions[vertices.position_vertex(v)]);
      append_line(out, FMT_COMPILE("v {} {} {}\n"), point.x, point.y, point.z);
    });
  }
  write(mesh.uvs.size(), [&](std::string& out, const Frame&, std::size_t v) {
    append_line(out, FMT_COMPILE("vt {} {}\n"), mesh.uvs[v].x, mesh.uvs[v].y);
  });
  write(vertices.normal_count(), [&](std::string& out, const Frame& frame, std::size_t v) {
    const Vec3 normal = frame.normal(mesh.normals[vertices.normal_vertex(v)]);
    append_line(out, FMT_COMPILE("vn {} {} {}\n"), normal.x, normal.y, normal.z);
  });
}

void write_faces(BlockWriter& writer, const MeshInstances& instances, const FileVertices& vertices,
                 const Offsets& offsets) {
  const Mesh& mesh = *instances.mesh;
  const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
    const Offsets at{offsets.position + frame * vertices.position_count(), offsets.uv + frame * mesh.uvs.size(),
                     offsets.normal + frame * vertices.normal_count()};
    const bool flips = is_mirrored(instances.frame(frame));
    for (std::size_t t = first; t < last; ++t) {
      std::array<std::uint32_t, 3> triangle = mesh.triangles[t];
      if (flips) std::swap(triangle[1], triangle[2]);
      append_face(out, mesh, vertices, triangle, at);
    }
  };
  write_for_frames(writer, instances.count(), mesh.triangle_count(), kFaceBytes, fill);
}

/// The meshes of a file in their order, with the vertices of each.
struct FileMeshes {
  std::vector<const MeshInstances*> meshes;
  std::vector<FileVertices> vertices;

  std::uint64_t element_count() const {
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      const Mesh& mesh = *meshes[k]->mesh;
      count += meshes[k]->count() *
               (vertices[k].position_count() + mesh.uvs.size() + vertices[k].normal_count() + mesh.triangle_count());
    }
    return count;
  }
};

FileMeshes file_meshes(const MeshScene& scene, const Progress& progress) {
  FileMeshes meshes{.meshes = ordered_meshes(scene), .vertices = {}};
  for (const MeshInstances* instances : meshes.meshes) {
    progress.check();
    meshes.vertices.emplace_back(*instances->mesh);
  }
  return meshes;
}

void write_geometry(const FileMeshes& meshes, const std::vector<ColourFactors>& factors, const ObjNames& names,
                    AtomicFile& file, Progress& progress) {
  BlockWriter writer(file, progress);
  Offsets offsets;
  for (std::size_t k = 0; k < meshes.meshes.size(); ++k) {
    const MeshInstances& instances = *meshes.meshes[k];
    const FileVertices& vertices = meshes.vertices[k];
    const bool is_new = k == 0 || names.object_of[k] != names.object_of[k - 1];
    if (is_new) file.write(fmt::format("\no {0}\ng {0}\n", names.objects[names.object_of[k]]));
    if (is_new || instances.material != meshes.meshes[k - 1]->material) {
      file.write(fmt::format("usemtl {}\n", names.materials[instances.material]));
    }
    const bool has_colours = names.has_colours[names.object_of[k]];
    write_vertices(writer, instances, vertices, has_colours ? &factors[instances.material] : nullptr);
    write_faces(writer, instances, vertices, offsets);
    offsets.position += vertices.position_count() * instances.count();
    offsets.uv += instances.mesh->uvs.size() * instances.count();
    offsets.normal += vertices.normal_count() * instances.count();
  }
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
  const FileMeshes meshes = file_meshes(scene, progress);
  progress.begin("writing OBJ", meshes.element_count());
  const ObjNames names = names_of(scene, meshes.meshes);
  const std::vector<ColourFactors> factors = colour_factors(scene);
  FileSet files;
  AtomicFile file(path);
  for (const std::string& line : provenance_lines(options.provenance)) file.write("# " + line + "\n");
  if (!file.is_stream()) {
    write_companions(scene, factors, names.materials, path, options, progress);
    const std::string materials = material_path(path);
    file.write(fmt::format("mtllib {}\n", materials.substr(materials.rfind('/') + 1)));
  }
  write_geometry(meshes, factors, names, file, progress);
  file.commit();
  files.commit();
}

}  // namespace meristem

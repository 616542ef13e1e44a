// SPDX-License-Identifier: Apache-2.0
// Writes PLY files: a header in text, then vertices, then faces or edges as packed records.
//
// Based on: G. Turk: The PLY polygon file format (1994). Blender, MeshLab and Open3D know these property names and
// types.
#include "meristem/output/mesh/ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/colour.h"
#include "meristem/base/diagnostic.h"
#include "meristem/output/mesh/shared_vertices.h"
#include "meristem/output/skeleton/skeleton_table.h"
#include "meristem/output/write/append_bytes.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/finite.h"
#include "meristem/output/write/names.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

void check_count(std::string_view what, std::uint64_t count) {
  constexpr std::uint64_t kMax = std::numeric_limits<std::int32_t>::max();
  if (count <= kMax) return;
  Diagnostic error;
  error.message = fmt::format("the plant has {} {}", count, what);
  error.expected = fmt::format("at most {}, the format's limit: fewer organs, or surfaces with fewer triangles", kMax);
  throw InputError(std::move(error));
}

/// Returns the first lines of a header.
std::string header_of(const Provenance& provenance, const std::vector<std::string>& components) {
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& line : provenance_lines(provenance)) header += "comment " + line + "\n";
  for (std::size_t k = 0; k < components.size(); ++k) {
    header += fmt::format("comment component {} {}\n", k, single_line(components[k]));
  }
  return header;
}

/// Returns a colour channel as a byte.
std::uint8_t byte_of(float channel) {
  return static_cast<std::uint8_t>(std::floor(std::clamp(channel, 0.0F, 1.0F) * 255 + 0.5F));
}

class MeshPly {
 public:
  MeshPly(const MeshScene& scene, const PlyOptions& options, AtomicFile& file, Progress& progress)
      : scene_(scene), labels_(options.labels), file_(file), writer_(file, progress) {
    for (const MeshInstances& instances : scene.meshes) {
      progress.check();
      if (options.shared_vertices) {
        shared_.push_back(share_vertices(*instances.mesh, false));
      } else {
        has_normals_ |= !instances.mesh->normals.empty();
        has_uvs_ |= !instances.mesh->uvs.empty();
      }
      if (components_.empty() || components_.back() != instances.component) {
        components_.push_back(instances.component);
      }
    }
  }

  /// Returns the number of vertices of all instances in the file.
  std::uint64_t vertex_count() const {
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < scene_.meshes.size(); ++k) count += vertex_count(k) * scene_.meshes[k].count();
    return count;
  }

  void write_header(const Provenance& provenance, std::uint64_t vertices) {
    std::string header = header_of(provenance, components_);
    header += fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n", vertices);
    if (has_normals_) header += "property float nx\nproperty float ny\nproperty float nz\n";
    if (has_uvs_) header += "property float s\nproperty float t\n";
    header += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int component\n";
    header += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", scene_.triangle_count());
    if (labels_ != nullptr) {
      header += "property uchar kind\nproperty ushort order\n";
      for (const char* name : {"tree", "component", "instance", "shoot"}) {
        header += fmt::format("property int {}\n", name);
      }
      header += fmt::format("element shoot {}\nproperty list uchar uchar label\n", labels_->shoot_count());
    }
    file_.write(header + "end_header\n");
  }

  void write_vertices() {
    std::int32_t component = -1;
    for (std::size_t k = 0; k < scene_.meshes.size(); ++k) {
      const MeshInstances& instances = scene_.meshes[k];
      if (k == 0 || instances.component != scene_.meshes[k - 1].component) ++component;
      const Vec3 colour = scene_.materials[instances.material].colour;
      const std::string plain_tail = tail_of(colour, component);
      const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
        const std::string tail =
            instances.tints.empty()
                ? plain_tail
                : tail_of(srgb_from_linear(linear_from_srgb(colour) * instances.tint(frame)), component);
        const Frame place = instances.frame(frame);
        for (std::size_t v = first; v < last; ++v) {
          append_vertex(*instances.mesh, place, shared_.empty() ? v : shared_[k].first[v], out);
          out += tail;
        }
      };
      write_for_frames(writer_, instances.count(), vertex_count(k), kMaxVertexBytes, fill);
    }
  }

  void write_faces() {
    std::size_t base = 0;
    for (std::uint32_t part = 0; part < scene_.meshes.size(); ++part) {
      const MeshInstances& instances = scene_.meshes[part];
      const Mesh& mesh = *instances.mesh;
      const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, std::string& out) {
        const auto offset = static_cast<std::uint32_t>(base + frame * vertex_count(part));
        const bool flips = is_mirrored(instances.frame(frame));
        for (std::size_t t = first; t < last; ++t) {
          auto [a, b, c] = mesh.triangles[t];
          if (flips) std::swap(b, c);
          for (std::uint32_t* vertex : {&a, &b, &c})
            *vertex = shared_.empty() ? *vertex : shared_[part].number[*vertex];
          out += '\3';
          append_bytes(out, std::array{offset + a, offset + b, offset + c});
          if (labels_ != nullptr) append_label(part, frame, t, out);
        }
      };
      write_for_frames(writer_, instances.count(), mesh.triangle_count(), kFaceBytes, fill);
      base += vertex_count(part) * instances.count();
    }
  }

  void write_shoots() {
    if (labels_ == nullptr) return;
    for (std::uint32_t shoot = 0; shoot < labels_->shoot_count(); ++shoot) {
      const std::string label = labels_->shoot_label(shoot).substr(0, kLongestLabelText);
      file_.write(std::string(1, static_cast<char>(label.size())) + label);
    }
  }

 private:
  std::size_t vertex_count(std::size_t mesh) const {
    return shared_.empty() ? scene_.meshes[mesh].mesh->vertex_count() : shared_[mesh].first.size();
  }

  static constexpr std::size_t kMaxVertexBytes = 8 * 4 + 3 + 4;
  static constexpr std::size_t kFaceBytes = 1 + 3 * 4 + 3 + 4 * 4;
  static constexpr std::size_t kLongestLabelText = 255;

  /// Returns the last bytes of all vertices of one colour (sRGB) and component.
  static std::string tail_of(Vec3 colour, std::int32_t component) {
    std::string tail;
    for (int channel = 0; channel < 3; ++channel) append_bytes(tail, byte_of(colour[channel]));
    append_bytes(tail, component);
    return tail;
  }

  void append_vertex(const Mesh& mesh, const Frame& frame, std::size_t v, std::string& out) const {
    append_bytes(out, frame.point(mesh.positions[v]));
    if (has_normals_) append_bytes(out, mesh.normals.empty() ? Vec3(0) : frame.normal(mesh.normals[v]));
    if (has_uvs_) append_bytes(out, mesh.uvs.empty() ? Vec2(0) : mesh.uvs[v]);
  }

  void append_label(std::uint32_t part, std::size_t instance, std::size_t triangle, std::string& out) const {
    const Mesh& mesh = *scene_.meshes[part].mesh;
    const auto [a, b, c] = mesh.triangles[triangle];
    const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F;
    const SurfaceLabel label =
        labels_->of(part, static_cast<std::uint32_t>(instance), static_cast<std::uint32_t>(triangle),
                    scene_.meshes[part].frame(instance).point(middle));
    append_bytes(out, static_cast<std::uint8_t>(label.kind));
    append_bytes(out, label.order);
    // The largest number marks a missing object and becomes -1.
    append_bytes(out, std::array{label.tree, label.component, label.instance, label.shoot});
  }

  const MeshScene& scene_;
  const SurfaceLabels* labels_;
  AtomicFile& file_;
  BlockWriter writer_;
  std::vector<std::string> components_;
  std::vector<SharedVertices> shared_;  // for each mesh; empty if faces do not share vertices
  bool has_normals_ = false;
  bool has_uvs_ = false;
};

/// Returns the columns in the order of the file, as indices into the table's columns. Positions come first, as viewers
/// expect. The row's number and the label, which is a text, are left out.
std::vector<std::size_t> ply_columns(const SkeletonTable& table) {
  static constexpr std::array<std::string_view, 8> kFirst{"x", "y", "z", "radius", "parent", "axis", "order", "birth"};
  const auto rank = [&](std::size_t column) {
    return std::find(kFirst.begin(), kFirst.end(), table.columns()[column].name) - kFirst.begin();
  };
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    const SkeletonColumn& column = table.columns()[k];
    if (column.name != "node" && column.kind != SkeletonColumn::Kind::label) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

bool is_whole(SkeletonColumn::Kind kind) { return kind != SkeletonColumn::Kind::number; }

void write_skeleton_header(const SkeletonTable& table, const std::vector<std::size_t>& columns, std::size_t edges,
                           const Provenance& provenance, AtomicFile& file) {
  std::string header = header_of(provenance, table.components());
  header += fmt::format("element vertex {}\n", table.row_count());
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const std::size_t column : columns) names.push_back(table.columns()[column].name);
  names = distinct_words(names);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const bool whole = is_whole(table.columns()[columns[k]].kind);
    header += fmt::format("property {} {}\n", whole ? "int" : "float", names[k]);
  }
  header += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n", edges);
  file.write(header);
}

/// The bits of the NaN that marks an unknown value.
constexpr std::uint32_t kUnknown = 0x7fc00000;

void write_nodes(const SkeletonTable& table, const std::vector<std::size_t>& columns, BlockWriter& writer) {
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    table.for_each_row(begin, end, [&](const SkeletonRow& row) {
      for (const std::size_t column : columns) {
        const double value = table.value(row, column);
        if (is_whole(table.columns()[column].kind)) {
          append_bytes(out, static_cast<std::int32_t>(value));
        } else if (std::isnan(value)) {
          append_bytes(out, kUnknown);
        } else {
          append_bytes(out, static_cast<float>(value));
        }
      }
    });
  };
  writer.write(table.row_count(), 4 * columns.size(), fill);
}

void write_edges(const SkeletonTable& table, BlockWriter& writer) {
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    table.for_each_row(begin, end, [&](const SkeletonRow& row) {
      const auto parent = static_cast<std::int32_t>(table.parent(row));
      if (parent >= 0) append_bytes(out, std::array{parent, static_cast<std::int32_t>(row.row)});
    });
  };
  writer.write(table.row_count(), 8, fill);
}

std::size_t edge_count(const Plant& plant) {
  std::size_t count = 0;
  for (const Stem& stem : plant.stems) {
    const std::vector<NodeIndex>& parents = stem.skeleton.parent;
    count += parents.size() - static_cast<std::size_t>(std::count(parents.begin(), parents.end(), kNoNode));
  }
  return count;
}

}  // namespace

void write_mesh_ply(const MeshScene& scene, const std::string& path, const PlyOptions& options, Progress& progress) {
  require_finite(scene);
  AtomicFile file(path);
  MeshPly ply(scene, options, file, progress);
  const std::uint64_t vertices = ply.vertex_count();
  check_count("vertices", vertices);
  check_count("triangles", scene.triangle_count());
  progress.begin("writing PLY", vertices + scene.triangle_count());
  ply.write_header(options.provenance, vertices);
  ply.write_vertices();
  ply.write_faces();
  ply.write_shoots();
  file.commit();
}

void write_skeleton_ply(const Plant& grown, const SizeLimits& limits, const std::string& path,
                        const PlyOptions& options, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  const Plant& plant = *expanded;
  require_finite(plant);
  const SkeletonTable table(plant);
  check_count("nodes", table.row_count());
  progress.begin("writing PLY", 2 * table.row_count());
  AtomicFile file(path);
  const std::vector<std::size_t> columns = ply_columns(table);
  write_skeleton_header(table, columns, edge_count(plant), options.provenance, file);
  BlockWriter writer(file, progress);
  write_nodes(table, columns, writer);
  write_edges(table, writer);
  file.commit();
}

}  // namespace meristem

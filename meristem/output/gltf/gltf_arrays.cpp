// SPDX-License-Identifier: Apache-2.0
// Writes the vertices of instances. They are moved by their frames on all threads, in batches that stay in the cache
// until they are written in order.
#include "meristem/output/gltf/gltf_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "meristem/base/parallel.h"
#include "meristem/output/gltf/turned_vectors.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/finite.h"

namespace meristem {

namespace {

// Number of elements (vertices, triangles) that one thread computes at once. Each has at most 16 bytes.
constexpr std::size_t kBatch = std::size_t{1} << 18;
constexpr std::size_t kBlock = std::size_t{1} << 14;

using Bytes4 = std::array<std::uint8_t, 4>;

bool is_identity(const Frame& frame) { return frame.axes == Mat3(1) && frame.origin == Vec3(0); }

bool is_unmoved(const GltfPiece& piece) { return piece.count() == 1 && is_identity(piece.frame(0)); }

/// Returns a colour factor as normalized bytes. The fourth byte is the opacity.
Bytes4 bytes_of(Vec3 factor) {
  const auto byte = [](float channel) { return static_cast<std::uint8_t>(channel * 255 + 0.5F); };
  return {byte(factor.r), byte(factor.g), byte(factor.b), 255};
}

class ArrayWriter {
 public:
  ArrayWriter(const GltfLayout& layout, AtomicFile& file, Progress& progress)
      : layout_(layout), file_(file), progress_(progress) {}

  void write() {
    for (const GltfMesh& mesh : layout_.meshes) {
      for (const GltfPrimitive& primitive : mesh.primitives) write_primitive(primitive);
    }
    if (layout_.has_instance_rows) {
      for (const GltfComponent& component : layout_.components) {
        for (const GltfSharedMesh& shared : component.shared) write_rows(shared);
      }
    }
    require_finite_values(std::span<const float>(layout_.animation.data));
    file_.write(std::span<const float>(layout_.animation.data));
    for (const GltfImage& image : layout_.images) {
      progress_.check();
      file_.write(*image.png);
      pad_gltf(file_, image.range.bytes, 0);
    }
  }

 private:
  void write_primitive(const GltfPrimitive& primitive) {
    if (primitive.has_wide_indices()) {
      write_indices<std::uint32_t>(primitive);
    } else {
      write_indices<std::uint16_t>(primitive);
    }
    pad_gltf(file_, primitive.index_range.bytes, 0);
    for (const GltfPiece& piece : primitive.pieces) write_positions(piece);
    if (primitive.has.normals) {
      for (const GltfPiece& piece : primitive.pieces) write_normals(piece);
    }
    if (primitive.has.tangents) {
      for (const GltfPiece& piece : primitive.pieces) write_tangents(piece);
    }
    if (primitive.has.uvs) {
      for (const GltfPiece& piece : primitive.pieces) write_uvs(piece);
    }
    if (primitive.has.colours) {
      const ColourFactors& factors = layout_.factors[layout_.materials[primitive.material].source];
      for (const GltfPiece& piece : primitive.pieces) write_colours(piece, factors);
    }
    for (std::size_t key = 0; key < primitive.targets.size(); ++key) write_target(primitive, key);
  }

  /// Writes the differences of positions, normals and colours at a key.
  void write_target(const GltfPrimitive& primitive, std::size_t key) {
    for (const GltfPiece& piece : primitive.pieces) {
      write_differences(piece, key, [](const GltfPiece& of, const Frame& frame, std::size_t v) {
        return frame.point(of.mesh->positions[v]);
      });
    }
    if (primitive.turns) {
      for (const GltfPiece& piece : primitive.pieces) write_turns(piece, key);
    }
    if (!primitive.changes_colour) return;
    const ColourFactors& factors = layout_.factors[layout_.materials[primitive.material].source];
    for (const GltfPiece& piece : primitive.pieces) {
      const GltfPiece then = piece.at(key);
      const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Vec4* out) {
        const Vec3 change = factors.instance(then.tint(frame)) - factors.instance(piece.tint(frame));
        std::fill(out, out + (last - first), Vec4(change, 0));
      };
      write_elements<Vec4>(piece.count(), piece.mesh->vertex_count(), fill);
    }
  }

  /// Writes the difference between `value(piece, frame, vertex)` at a key and the present value.
  template <class Value>
  void write_differences(const GltfPiece& piece, std::size_t key, Value value) {
    const GltfPiece then = piece.at(key);
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Vec3* out) {
      const Frame now = piece.frame(frame), other = then.frame(frame);
      for (std::size_t v = first; v < last; ++v) *out++ = value(then, other, v) - value(piece, now, v);
    };
    write_elements<Vec3>(piece.count(), piece.mesh->vertex_count(), fill);
  }

  /// Parts without size keep their normals.
  void write_turns(const GltfPiece& piece, std::size_t key) {
    const GltfPiece then = piece.at(key);
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Vec3* out) {
      const Frame now = piece.frame(frame), other = then.frame(frame);
      if (glm::determinant(now.axes) == 0 || glm::determinant(other.axes) == 0) {
        std::fill(out, out + (last - first), Vec3(0));
        return;
      }
      const VectorTurner turner(now), other_turner(other);
      for (std::size_t v = first; v < last; ++v) {
        *out++ = other_turner.normal(then.mesh->normals[v]) - turner.normal(piece.mesh->normals[v]);
      }
    };
    write_elements<Vec3>(piece.count(), piece.mesh->vertex_count(), fill);
  }

  template <class Index>
  void write_indices(const GltfPrimitive& primitive) {
    using Triangle = std::array<Index, 3>;
    std::uint64_t base = 0;
    for (const GltfPiece& piece : primitive.pieces) {
      const Mesh& mesh = *piece.mesh;
      const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Triangle* out) {
        const auto offset = static_cast<std::uint32_t>(base + frame * mesh.vertex_count());
        const bool flips = is_mirrored(piece.frame(frame));
        for (std::size_t t = first; t < last; ++t) {
          const auto [a, b, c] = mesh.triangles[t];
          const auto index = [&](std::uint32_t vertex) { return static_cast<Index>(offset + vertex); };
          *out++ = flips ? Triangle{index(a), index(c), index(b)} : Triangle{index(a), index(b), index(c)};
        }
      };
      write_elements<Triangle>(piece.count(), mesh.triangle_count(), fill);
      base += piece.vertex_count();
    }
  }

  void write_positions(const GltfPiece& piece) {
    if (is_unmoved(piece)) return write_unmoved(piece.mesh->positions);
    write_vertices<Vec3>(piece,
                         [](const Mesh& mesh, const Frame& frame, std::size_t first, std::size_t last, Vec3* out) {
                           for (std::size_t v = first; v < last; ++v) *out++ = frame.point(mesh.positions[v]);
                         });
  }

  void write_normals(const GltfPiece& piece) {
    if (is_unmoved(piece)) return write_unmoved(piece.mesh->normals);
    write_vertices<Vec3>(piece,
                         [](const Mesh& mesh, const Frame& frame, std::size_t first, std::size_t last, Vec3* out) {
                           const VectorTurner turner(frame);
                           for (std::size_t v = first; v < last; ++v) *out++ = turner.normal(mesh.normals[v]);
                         });
  }

  /// The sign of w stays unchanged. The green channel of a normal map points to the upper edge of the picture, where
  /// our v rises, although glTF's v falls there.
  void write_tangents(const GltfPiece& piece) {
    if (is_unmoved(piece)) return write_unmoved(piece.mesh->tangents);
    write_vertices<Vec4>(piece,
                         [](const Mesh& mesh, const Frame& frame, std::size_t first, std::size_t last, Vec4* out) {
                           const VectorTurner turner(frame);
                           for (std::size_t v = first; v < last; ++v) {
                             *out++ = turner.tangent(mesh.tangents[v], turner.normal(mesh.normals[v]));
                           }
                         });
  }

  /// Pictures in glTF begin at their upper edge, ours at the lower edge.
  void write_uvs(const GltfPiece& piece) {
    write_vertices<Vec2>(piece, [](const Mesh& mesh, const Frame&, std::size_t first, std::size_t last, Vec2* out) {
      for (std::size_t v = first; v < last; ++v) *out++ = Vec2(mesh.uvs[v].x, 1 - mesh.uvs[v].y);
    });
  }

  void write_colours(const GltfPiece& piece, const ColourFactors& factors) {
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Bytes4* out) {
      std::fill(out, out + (last - first), bytes_of(factors.instance(piece.tint(frame))));
    };
    write_elements<Bytes4>(piece.count(), piece.mesh->vertex_count(), fill);
  }

  /// Writes the transforms and colours of instances as arrays with one row per instance.
  void write_rows(const GltfSharedMesh& shared) {
    write_row_array<Vec3>(shared, [&](std::size_t row) { return shared.frame(row).origin; });
    write_row_array<Vec4>(shared, [&](std::size_t row) {
      const Mat3 axes = shared.frame(row).axes;
      const Mat3 turn(glm::normalize(axes[0]), glm::normalize(axes[1]), glm::normalize(axes[2]));
      const glm::quat rotation = glm::normalize(glm::quat_cast(turn));
      return Vec4(rotation.x, rotation.y, rotation.z, rotation.w);
    });
    write_row_array<Vec3>(shared, [&](std::size_t row) {
      const Mat3 axes = shared.frame(row).axes;
      return Vec3(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
    });
    if (shared.colour_range.bytes == 0) return;
    const ColourFactors& factors = layout_.factors[shared.source->material];
    write_row_array<Bytes4>(shared, [&](std::size_t row) {
      return bytes_of(factors.instance(shared.source->tint(shared.instances[row])));
    });
  }

  template <class Element, class Value>
  void write_row_array(const GltfSharedMesh& shared, Value value) {
    const auto fill = [&](std::size_t row, std::size_t, std::size_t, Element* out) { *out = value(row); };
    write_elements<Element>(shared.instances.size(), 1, fill);
  }

  /// Writes one vertex attribute. `turn(mesh, frame, first, last, out)` computes it for some vertices of one instance.
  template <class Element, class Turn>
  void write_vertices(const GltfPiece& piece, Turn turn) {
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Element* out) {
      turn(*piece.mesh, piece.frame(frame), first, last, out);
    };
    write_elements<Element>(piece.count(), piece.mesh->vertex_count(), fill);
  }

  template <class Element>
  void write_unmoved(const std::vector<Element>& elements) {
    for (std::size_t start = 0; start < elements.size(); start += kBatch) {
      progress_.check();
      const std::size_t size = std::min(kBatch, elements.size() - start);
      file_.write(std::span<const Element>(elements.data() + start, size));
      progress_.advance(size);
    }
  }

  /// Writes `frames * per_frame` elements. `fill(frame, first, last, out)` computes the elements from `first` to `last`
  /// of one frame.
  template <class Element, class Fill>
  void write_elements(std::size_t frames, std::size_t per_frame, Fill fill) {
    const std::size_t count = frames * per_frame;
    batch_.resize(std::max(batch_.size(), std::min(count, kBatch) * sizeof(Element)));
    auto* const batch = reinterpret_cast<Element*>(batch_.data());
    for (std::size_t start = 0; start < count; start += kBatch) {
      const std::size_t size = std::min(kBatch, count - start);
      parallel_for(size, kBlock, [&](std::size_t begin, std::size_t end) {
        progress_.check();
        Element* out = batch + begin;
        for_each_run(start + begin, start + end, per_frame,
                     [&](std::size_t frame, std::size_t first, std::size_t last) {
                       fill(frame, first, last, out);
                       require_finite_values(std::span<const Element>(out, last - first));
                       out += last - first;
                     });
      });
      file_.write(std::span<const Element>(batch, size));
      progress_.advance(size);
    }
  }

  const GltfLayout& layout_;
  AtomicFile& file_;
  Progress& progress_;
  std::vector<std::byte> batch_;  // kept, so that its memory is reused
};

}  // namespace

std::uint64_t gltf_element_count(const GltfLayout& layout) {
  std::uint64_t count = 0;
  for (const GltfMesh& mesh : layout.meshes) {
    for (const GltfPrimitive& primitive : mesh.primitives) {
      const GltfAttributes has = primitive.has;
      count += primitive.triangles + primitive.vertices * (1 + has.normals + has.uvs + has.tangents + has.colours);
      count += primitive.targets.size() * primitive.vertices * (1 + primitive.turns + primitive.changes_colour);
    }
  }
  if (!layout.has_instance_rows) return count;
  for (const GltfComponent& component : layout.components) {
    for (const GltfSharedMesh& shared : component.shared) {
      count += shared.instances.size() * (shared.colour_range.bytes > 0 ? 4 : 3);
    }
  }
  return count;
}

void write_gltf_arrays(const GltfLayout& layout, AtomicFile& file, Progress& progress) {
  ArrayWriter(layout, file, progress).write();
}

void pad_gltf(AtomicFile& file, std::uint64_t bytes, char with) {
  const std::array<char, 4> padding{with, with, with, with};
  file.write(padding.data(), (4 - bytes % 4) % 4);
}

}  // namespace meristem

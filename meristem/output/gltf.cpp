// SPDX-License-Identifier: Apache-2.0
// Layout, JSON chunk, binary chunk: the file is written front to back without ever being held. Vertices of instances
// are moved by their frames in blocks of a fixed size, on all threads, and written in order.
//
// Based on: Khronos Group, glTF 2.0 Specification (2021), sections 3.6 to 3.9 and 4.4 (GLB).
#include "meristem/output/gltf.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/output/block_writer.h"
#include "meristem/output/gltf_json.h"
#include "meristem/output/gltf_layout.h"

namespace meristem {

namespace {

// Elements (vertices, triangles) that are computed at once and by one thread; at most 12 bytes each, so 12 MB.
constexpr std::size_t kBatch = std::size_t{1} << 20;
constexpr std::size_t kBlock = std::size_t{1} << 15;

constexpr std::uint64_t kHeaderBytes = 12;
constexpr std::uint64_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

void check_size(std::uint64_t bytes) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (bytes <= kMost) return;
  Diagnostic fault;
  fault.message = fmt::format("the plant needs {:.1f} GB as one binary glTF", static_cast<double>(bytes) * 1e-9);
  fault.expected = "at most 4.2 GB, the format's limit: fewer organs, or surfaces with fewer triangles";
  throw InputError(std::move(fault));
}

/// Writes `frames * per_frame` elements. `fill(frame, first, last, out)` computes those from `first` to `last` of one
/// frame.
template <class Element, class Fill>
void stream_elements(std::size_t frames, std::size_t per_frame, AtomicFile& file, Progress& progress, Fill fill) {
  const std::size_t count = frames * per_frame;
  std::vector<Element> batch(std::min(count, kBatch));
  for (std::size_t start = 0; start < count; start += kBatch) {
    const std::size_t size = std::min(kBatch, count - start);
    parallel_for(size, kBlock, [&](std::size_t begin, std::size_t end) {
      progress.check();
      Element* out = batch.data() + begin;
      for_each_run(start + begin, start + end, per_frame, [&](std::size_t frame, std::size_t first, std::size_t last) {
        fill(frame, first, last, out);
        out += last - first;
      });
    });
    file.write(std::span<const Element>(batch.data(), size));
    progress.advance(size);
  }
}

template <class Index>
void stream_indices(const GltfPrimitive& primitive, AtomicFile& file, Progress& progress) {
  std::uint64_t base = 0;
  for (const GltfPiece& piece : primitive.pieces) {
    const Mesh& mesh = *piece.mesh;
    using Triangle = std::array<Index, 3>;
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Triangle* out) {
      const std::uint64_t offset = base + frame * mesh.vertex_count();
      const bool flips = is_mirrored(piece.frames[frame]);
      for (std::size_t t = first; t < last; ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        const auto index = [&](std::uint32_t vertex) { return static_cast<Index>(offset + vertex); };
        *out++ = flips ? Triangle{index(a), index(c), index(b)} : Triangle{index(a), index(b), index(c)};
      }
    };
    stream_elements<Triangle>(piece.frames.size(), mesh.triangle_count(), file, progress, fill);
    base += piece.vertex_count();
  }
}

/// Writes one vertex attribute of all pieces; `value(mesh, frame, vertex)` computes it.
template <class Element, class Value>
void stream_vertices(const GltfPrimitive& primitive, AtomicFile& file, Progress& progress, Value value) {
  for (const GltfPiece& piece : primitive.pieces) {
    const Mesh& mesh = *piece.mesh;
    const auto fill = [&](std::size_t frame, std::size_t first, std::size_t last, Element* out) {
      for (std::size_t v = first; v < last; ++v) *out++ = value(mesh, piece.frames[frame], v);
    };
    stream_elements<Element>(piece.frames.size(), mesh.vertex_count(), file, progress, fill);
  }
}

void pad(AtomicFile& file, std::uint64_t bytes, char with) {
  const std::array<char, 4> padding{with, with, with, with};
  file.write(padding.data(), padded(bytes) - bytes);
}

void stream_primitive(const GltfPrimitive& primitive, AtomicFile& file, Progress& progress) {
  if (primitive.has_wide_indices()) {
    stream_indices<std::uint32_t>(primitive, file, progress);
  } else {
    stream_indices<std::uint16_t>(primitive, file, progress);
  }
  pad(file, primitive.index_range.bytes, 0);
  stream_vertices<Vec3>(primitive, file, progress, [](const Mesh& mesh, const Frame& frame, std::size_t v) {
    return frame.point(mesh.positions[v]);
  });
  if (primitive.has_normals) {
    stream_vertices<Vec3>(primitive, file, progress, [](const Mesh& mesh, const Frame& frame, std::size_t v) {
      return frame.normal(mesh.normals[v]);
    });
  }
  if (primitive.has_uvs) {
    // glTF images begin at their upper edge, ours at the lower.
    stream_vertices<Vec2>(primitive, file, progress, [](const Mesh& mesh, const Frame&, std::size_t v) {
      return Vec2(mesh.uvs[v].x, 1 - mesh.uvs[v].y);
    });
  }
}

std::uint64_t element_count(const GltfLayout& layout) {
  std::uint64_t count = 0;
  for (const GltfMesh& mesh : layout.meshes) {
    for (const GltfPrimitive& primitive : mesh.primitives) {
      count += primitive.triangles + primitive.vertices * (1 + primitive.has_normals + primitive.has_uvs);
    }
  }
  return count;
}

void write_words(AtomicFile& file, std::initializer_list<std::uint64_t> words) {
  for (const std::uint64_t word : words) {
    const auto narrow = static_cast<std::uint32_t>(word);
    file.write(&narrow, sizeof(narrow));
  }
}

}  // namespace

void write_glb(const MeshScene& scene, const std::string& path, const GltfOptions& options, Progress& progress) {
  // Decide what goes where, and how long the JSON will be.
  GltfLayout layout = lay_out_gltf(scene, options.flatten_triangles);
  check_size(layout.binary_bytes);
  progress.begin("writing glTF", element_count(layout));
  measure_bounds(layout, progress);
  const auto emit_json = [&](FunctionRef<void(std::string_view)> sink) {
    emit_gltf_json(layout, scene.materials, options.provenance, sink, progress);
  };
  std::uint64_t json_bytes = 0;
  emit_json([&](std::string_view piece) { json_bytes += piece.size(); });
  const std::uint64_t binary_chunk = layout.binary_bytes == 0 ? 0 : kChunkHeaderBytes + layout.binary_bytes;
  const std::uint64_t total = kHeaderBytes + kChunkHeaderBytes + padded(json_bytes) + binary_chunk;
  check_size(total);

  // Write header, JSON chunk and binary chunk in this order.
  AtomicFile file(path);
  write_words(file, {kMagic, 2, total, padded(json_bytes), kJsonChunk});
  emit_json([&](std::string_view piece) { file.write(piece.data(), piece.size()); });
  pad(file, json_bytes, ' ');
  if (binary_chunk > 0) write_words(file, {layout.binary_bytes, kBinaryChunk});
  for (const GltfMesh& mesh : layout.meshes) {
    for (const GltfPrimitive& primitive : mesh.primitives) stream_primitive(primitive, file, progress);
  }
  file.commit();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Writes a binary glTF: layout, JSON chunk, binary chunk. The file is written from front to back and is never held in
// memory.
//
// Based on: Khronos Group, glTF 2.0 Specification (2021), sections 3.6 to 3.9 and 4.4 (GLB).
#include "meristem/output/gltf/gltf.h"

#include <limits>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/output/gltf/gltf_arrays.h"
#include "meristem/output/gltf/gltf_json.h"
#include "meristem/output/gltf/gltf_layout.h"
#include "meristem/output/write/finite.h"

namespace meristem {

namespace {

constexpr std::uint64_t kHeaderBytes = 12;
constexpr std::uint64_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

void check_size(std::uint64_t bytes) {
  constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();
  if (bytes <= kMax) return;
  Diagnostic error;
  error.message = fmt::format("the plant needs {:.1f} GB as one binary glTF", static_cast<double>(bytes) * 1e-9);
  error.expected = "at most 4.2 GB, the format's limit: fewer organs, or surfaces with fewer triangles";
  throw InputError(std::move(error));
}

void write_words(AtomicFile& file, std::initializer_list<std::uint64_t> words) {
  for (const std::uint64_t word : words) {
    const auto narrow = static_cast<std::uint32_t>(word);
    file.write(&narrow, sizeof(narrow));
  }
}

void write_laid_out(GltfLayout layout, const MeshScene& scene, const std::string& path, const GltfOptions& options,
                    Progress& progress) {
  require_finite(scene);
  // Compute the length of the JSON.
  check_size(layout.binary_bytes);
  progress.begin("writing glTF", gltf_element_count(layout));
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
  pad_gltf(file, json_bytes, ' ');
  if (binary_chunk > 0) write_words(file, {layout.binary_bytes, kBinaryChunk});
  write_gltf_arrays(layout, file, progress);
  file.commit();
}

}  // namespace

void write_glb(const MeshScene& scene, const std::string& path, const GltfOptions& options, Progress& progress) {
  write_laid_out(lay_out_gltf(scene, options, progress), scene, path, options, progress);
}

void write_moving_glb(const MovingScene& moving, const std::string& path, const GltfOptions& options,
                      Progress& progress) {
  write_laid_out(lay_out_gltf(moving, options, progress), moving.scene, path, options, progress);
}

}  // namespace meristem

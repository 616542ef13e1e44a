// SPDX-License-Identifier: Apache-2.0
// Reads closed meshes from files. OBJ has its own parser here: a closed body needs only the statements `v` and `f`, and
// common libraries (such as tinyobjloader) do not report the line of an error.
#include "meristem/scene/file/read_mesh.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/number_limit.h"
#include "meristem/base/read_file.h"
#include "meristem/scene/file/glb_mesh.h"
#include "meristem/scene/file/ply_file.h"
#include "meristem/scene/file/text_scanner.h"

namespace meristem {

namespace {

constexpr double kLastIndex = 4294967295.0;

/// Adds a polygon as a fan of triangles around its first vertex.
void add_polygon(const std::vector<std::uint32_t>& corners, const std::string& file, const SizeLimits& limits,
                 TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size() + corners.size() - 2;
  if (count > limits.triangles) {
    Diagnostic diagnostic =
        limit_diagnostic("triangles of a file", static_cast<double>(count), limits.triangles, "triangles", "");
    diagnostic.file = file;
    throw InputError(std::move(diagnostic));
  }
  for (std::size_t k = 2; k < corners.size(); ++k) {
    mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
}

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& file, const SizeLimits& limits)
      : text_(bytes, file), file_(file), limits_(limits) {}

  TriangleMesh read() {
    do {
      const std::string_view keyword = text_.word();
      if (keyword == "v") read_vertex();
      if (keyword == "f") read_face();
    } while (text_.next_line());
    if (max_ >= mesh_.positions.size() && !mesh_.triangles.empty()) {
      max_at_.fail(fmt::format("there is no vertex {}", max_ + 1), fmt::format("at most {}", mesh_.positions.size()));
    }
    return std::move(mesh_);
  }

 private:
  void read_vertex() {
    DVec3& position = mesh_.positions.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = text_.word();
      const std::optional<double> number = parse_number(word);
      if (word.empty()) text_.fail("the vertex has fewer than three coordinates", "v x y z");
      if (!number || !std::isfinite(*number)) {
        text_.fail(fmt::format("{} is not a finite number", in_quotes(word)), "a coordinate");
      }
      if (!kFileCoordinate.holds(*number)) text_.fail(number_error(in_quotes(word), kFileCoordinate));
      position[k] = *number;
    }
  }

  void read_face() {
    corners_.clear();
    for (std::string_view word = text_.word(); !word.empty() && word[0] != '#'; word = text_.word()) {
      corners_.push_back(corner(word));
    }
    if (corners_.size() < 3) text_.fail("the face has fewer than three corners", "f a b c");
    add_polygon(corners_, file_, limits_, mesh_);
  }

  /// Returns the vertex index of "7", "7/2", "7//3" or, counted from the end, "-1".
  std::uint32_t corner(std::string_view word) {
    const std::string_view digits = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != digits.data() + digits.size() || number == 0 ||
        number > static_cast<std::int64_t>(kLastIndex)) {
      text_.fail(fmt::format("{} is not a vertex", in_quotes(word)), "a number from 1, or from -1 down");
    }
    const auto count = static_cast<std::int64_t>(mesh_.positions.size());
    if (number < -count) text_.fail(fmt::format("there is no vertex {}", number), fmt::format("at least {}", -count));
    const auto index = static_cast<std::uint32_t>(number < 0 ? count + number : number - 1);
    if (index >= max_) {
      max_ = index;
      max_at_ = text_;
    }
    return index;
  }

  TextScanner text_;
  const std::string& file_;
  const SizeLimits& limits_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;
  // The largest index so far. It is checked at the end, because faces may come before their vertices.
  std::uint32_t max_ = 0;
  TextScanner max_at_ = text_;
};

TriangleMesh parse_ply(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  const PlyFile ply(bytes, file);
  const PlyElement* vertices = ply.find("vertex");
  const PlyElement* faces = ply.find("face");
  if (vertices == nullptr || faces == nullptr) {
    throw InputError(
        Diagnostic{.message = fmt::format("the file has no element '{}'", vertices == nullptr ? "vertex" : "face"),
                   .expected = "the elements 'vertex' and 'face'",
                   .file = file});
  }
  const std::array<std::size_t, 3> columns{ply.need(*vertices, "x"), ply.need(*vertices, "y"),
                                           ply.need(*vertices, "z")};
  const std::size_t list =
      faces->find("vertex_index") ? *faces->find("vertex_index") : ply.need(*faces, "vertex_indices");
  TriangleMesh mesh;
  std::vector<std::uint32_t> corners;
  ply.read([&](const PlyElement& element, const PlyRow& row) {
    if (&element == vertices) {
      DVec3& position = mesh.positions.emplace_back();
      for (int k = 0; k < 3; ++k) {
        position[k] = row.values[columns[static_cast<std::size_t>(k)]];
        if (!std::isfinite(position[k])) ply.fail(element, row, "a coordinate is not a finite number", "a number");
        if (kFileCoordinate.holds(position[k])) continue;
        const Diagnostic error = number_error(fmt::format("the coordinate {:.6g}", position[k]), kFileCoordinate);
        ply.fail(element, row, error.message, error.expected);
      }
    } else if (&element == faces) {
      corners.clear();
      for (const double index : row.lists[list]) {
        if (!(index >= 0 && index < static_cast<double>(vertices->count) && index < kLastIndex)) {
          ply.fail(element, row, fmt::format("there is no vertex {:.12g}", index),
                   fmt::format("0 to {}", vertices->count - 1));
        }
        corners.push_back(static_cast<std::uint32_t>(index));
      }
      if (corners.size() < 3) ply.fail(element, row, "the face has fewer than three corners");
      add_polygon(corners, file, limits, mesh);
    }
  });
  return mesh;
}

}  // namespace

TriangleMesh parse_mesh(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  TriangleMesh mesh = begins_glb(bytes)        ? parse_glb(bytes, file, limits)
                      : PlyFile::begins(bytes) ? parse_ply(bytes, file, limits)
                                               : ObjReader(bytes, file, limits).read();
  if (mesh.triangles.empty()) {
    throw InputError(
        Diagnostic{.message = "the file has no faces", .expected = "an OBJ, PLY or GLB file with faces", .file = file});
  }
  return mesh;
}

TriangleMesh read_mesh(const std::string& path, const SizeLimits& limits) {
  return parse_mesh(read_file(path, limits.file_bytes), path, limits);
}

ClosedMesh read_closed_mesh(const std::string& path, const SizeLimits& limits) {
  const TriangleMesh mesh = read_mesh(path, limits);
  std::vector<Diagnostic> diagnostics;
  for (std::string& error : closedness_errors(mesh)) {
    diagnostics.push_back({.message = std::move(error),
                           .expected = "a closed mesh, in which every edge has a triangle on both sides",
                           .path = {},
                           .file = path});
  }
  if (!diagnostics.empty()) throw InputError(std::move(diagnostics));
  if (const std::string error = body_error(mesh); !error.empty()) {
    throw InputError(
        Diagnostic{.message = "the mesh " + error, .expected = "a closed mesh that faces outward", .file = path});
  }
  return ClosedMesh(mesh);
}

}  // namespace meristem

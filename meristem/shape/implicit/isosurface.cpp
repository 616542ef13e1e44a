// SPDX-License-Identifier: Apache-2.0
// Extracts the surface of a body or of a sampled field: values in bricks, marching cubes over the bricks, then normals
// from the gradient of the function.
#include "meristem/shape/implicit/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "meristem/base/require.h"
#include "meristem/shape/implicit/brick_field.h"
#include "meristem/shape/implicit/brick_mesh.h"
#include "meristem/shape/mesh/front_normals.h"

namespace meristem {

namespace {

constexpr int kMinResolution = 10;
constexpr int kMaxResolution = 1024;
constexpr double kGradientStep = 0.25;  // share of a cell

/// Computes normals from a body's function, with four values around each position.
class NormalSampler {
 public:
  NormalSampler(const ImplicitBody& body, const BodyBricks& bricks)
      : body_(body), bricks_(bricks), step_(static_cast<float>(kGradientStep * bricks.grid.cell)), sampler_(body) {}

  void find(std::size_t chunk, std::size_t brick, std::span<const Vec3> places, Vec3* normals) {
    const DVec3 centre = bricks_.centre(bricks_.grid.chunks[chunk].at[brick]);
    const std::span<const FieldStep> steps = bricks_.parts[chunk].of(brick);
    near_.rebase(body_, steps, centre);
    const std::size_t count = kCorners.size() * places.size();
    x_.resize(count);
    y_.resize(count);
    z_.resize(count);
    values_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 position(DVec3(places[k / kCorners.size()]) - centre);
      const Vec3 beside = position + step_ * kCorners[k % kCorners.size()];
      x_[k] = beside.x;
      y_[k] = beside.y;
      z_[k] = beside.z;
    }
    sampler_.sample(steps, near_, x_.data(), y_.data(), z_.data(), count, values_.data());
    for (std::size_t k = 0; k < places.size(); ++k) {
      Vec3 gradient{0};
      for (std::size_t c = 0; c < kCorners.size(); ++c) gradient += kCorners[c] * values_[kCorners.size() * k + c];
      normals[k] = normalized_or(gradient, kUp);
    }
  }

 private:
  static constexpr std::array<Vec3, 4> kCorners{Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, 1, 1)};

  const ImplicitBody& body_;
  const BodyBricks& bricks_;
  float step_;
  NearSolids near_;
  FieldSampler sampler_;
  std::vector<float> x_, y_, z_, values_;
};

void add_normals(const ImplicitBody& body, const BodyBricks& bricks, BrickMesh& made, Progress& progress) {
  Mesh& mesh = made.mesh;
  mesh.normals.resize(mesh.positions.size());
  parallel_for(bricks.grid.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
    NormalSampler sampler(body, bricks);
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      const std::vector<std::uint32_t>& first = made.first_vertex[chunk];
      for (std::size_t brick = 0; brick + 1 < first.size(); ++brick) {
        progress.check();
        const std::span places = std::span(mesh.positions).subspan(first[brick], first[brick + 1] - first[brick]);
        if (!places.empty()) sampler.find(chunk, brick, places, mesh.normals.data() + first[brick]);
      }
    }
  });
  NormalSampler sampler(body, bricks);
  const std::size_t first_inner = mesh.positions.size() - made.inner.size();
  for (std::size_t k = 0; k < made.inner.size(); ++k) {
    const auto [chunk, brick] = made.inner[k];
    sampler.find(chunk, brick, std::span(mesh.positions).subspan(first_inner + k, 1),
                 mesh.normals.data() + first_inner + k);
  }
  turn_to_front(mesh, progress);
}

/// Returns the field in bricks, with a surrounding layer of outside values. Each layer of bricks is a chunk.
BrickGrid bricks_of(const SampledField& field, float isovalue, Progress& progress) {
  BrickGrid grid{.origin = field.origin - field.spacing, .cell = field.spacing};
  const glm::ivec3 count = (field.size + 2 + (kBrickSide - 1)) / kBrickSide;
  grid.chunks.resize(count.z);
  parallel_for(grid.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (auto z = static_cast<int>(begin); z < static_cast<int>(end); ++z) {
      BrickChunk& chunk = grid.chunks[z];
      for (int k = 0; k < count.x * count.y; ++k) {
        progress.check();
        const glm::ivec3 at(k % count.x, k / count.x, z);
        chunk.at.push_back(at);
        for (int c = 0; c < kBrickSize; ++c) {
          const glm::ivec3 corner(c % kBrickSide, c / kBrickSide % kBrickSide, c / (kBrickSide * kBrickSide));
          const glm::ivec3 p = kBrickSide * at + corner - 1;
          const bool is_in =
              glm::all(glm::greaterThanEqual(p, glm::ivec3(0))) && glm::all(glm::lessThan(p, field.size));
          const std::size_t index =
              is_in ? (static_cast<std::size_t>(p.z) * field.size.y + p.y) * field.size.x + p.x : 0;
          const float value = is_in ? field.values[index] - isovalue : std::numeric_limits<float>::infinity();
          chunk.values.push_back(std::isnan(value) ? std::numeric_limits<float>::infinity() : value);
        }
      }
    }
  });
  return grid;
}

}  // namespace

double cell_size(const ImplicitBody& body, int resolution) {
  const DVec3 size = body.high() - body.low();
  const double longest = std::max({size.x, size.y, size.z});
  // Blends wider than the solids make a body of a different size.
  return (longest + 2 * std::max(0.0, body.reach() - longest)) / resolution;
}

Mesh extract_isosurface(const ImplicitBody& body, const IsosurfaceOptions& options, const SizeLimits& limits,
                        const std::string& path, Progress& progress) {
  require(options.resolution >= kMinResolution && options.resolution <= kMaxResolution,
          "a resolution must be 10 to 1024 cells");
  if (body.is_empty()) return {};
  const double cell = cell_size(body, options.resolution);
  if (!(cell > 0)) return {};
  const BodyBricks bricks = sample_body(body, cell, limits, path, progress);
  BrickMesh made = mesh_bricks(bricks.grid, limits, path, progress);
  if (options.normals) add_normals(body, bricks, made, progress);
  return std::move(made.mesh);
}

Mesh extract_isosurface(const SampledField& field, float isovalue, const SizeLimits& limits, const std::string& path,
                        Progress& progress) {
  require(glm::all(glm::greaterThanEqual(field.size, glm::ivec3(0))), "a field's size must not be negative");
  // Products of more than 2^64 would overflow.
  const glm::dvec3 size(field.size);
  require(size.x * size.y * size.z == static_cast<double>(field.values.size()), "a field's size must fit its values");
  require(field.spacing > 0 && std::isfinite(field.spacing) && std::isfinite(isovalue),
          "a field's spacing must be above 0 and finite, and its isovalue finite");
  require(std::isfinite(field.origin.x + field.origin.y + field.origin.z), "a field's origin must be finite");
  if (field.values.empty()) return {};
  const glm::dvec3 bricks = glm::ceil((size + 2.0) / static_cast<double>(kBrickSide));
  const double bytes = bricks.x * bricks.y * bricks.z * kBrickSize * sizeof(float);
  if (bytes > static_cast<double>(limits.mesh_bytes)) {
    throw_limit("bytes of field values", bytes, limits.mesh_bytes, "mesh_bytes", path);
  }
  return std::move(mesh_bricks(bricks_of(field, isovalue, progress), limits, path, progress).mesh);
}

}  // namespace meristem

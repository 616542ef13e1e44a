// SPDX-License-Identifier: Apache-2.0
// Samples the function of a body in bricks near its surface. Interval bounds of the function decide which regions can
// contain surface, and drop clauses that have no effect in a region (field_part.h). Regions run in parallel.
#include "meristem/shape/implicit/brick_field.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <span>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr double kFieldError = 1e-4;   // share of a cell
constexpr double kExactReach = 2;      // in cells: distance from the surface up to which values must be exact; ends of
                                       // edges have 1
constexpr double kSafety = 1e-2;       // in cells: minimum distance from the surface of a region that is skipped
constexpr std::size_t kChunks = 192;   // minimum number of regions to distribute
constexpr double kMargin = 2;          // cells around the body
constexpr double kMaxCells = 1 << 28;  // maximum number of cells along a body with its blends
constexpr int kMaxDepth = 40;          // maximum number of halvings

constexpr double kHalfDiagonal = 0.866;  // of a cube of side 1, slightly less than sqrt(3) / 2
constexpr int kBlockSide = kBrickSide / 2;
constexpr int kBlockSize = kBlockSide * kBlockSide * kBlockSide;
constexpr double kMiddle = kBlockSide - 0.5;  // middle of a brick, including the cells that touch its blocks from below

/// A cube of blocks, with the clauses that have an effect in it and in the cells that touch it from below.
struct Region {
  glm::ivec3 at{0};
  int side = 1;
  std::vector<FieldStep> steps;
};

glm::ivec3 corner_of(int k, int side) { return {k % side, k / side % side, k / (side * side)}; }

/// The positions of the corners of a brick's blocks, relative to the brick's middle.
struct BlockPlaces {
  std::array<float, kBrickSize> x, y, z;  // block after block

  explicit BlockPlaces(double cell) {
    for (int k = 0; k < kBrickSize; ++k) {
      const glm::ivec3 corner = kBlockSide * corner_of(k / kBlockSize, 2) + corner_of(k % kBlockSize, kBlockSide);
      const DVec3 position = cell * (DVec3(corner) - kMiddle);
      x[k] = static_cast<float>(position.x);
      y[k] = static_cast<float>(position.y);
      z[k] = static_cast<float>(position.z);
    }
  }
};

/// Counts the bytes of all threads against the limit.
class BrickBudget {
 public:
  BrickBudget(const SizeLimits& limits, const std::string& path) : limits_(limits), path_(path) {}

  void spend(std::uint64_t bytes) {
    if ((bytes_ += bytes) <= limits_.mesh_bytes) return;
    // Report only one byte more: the total depends on the threads.
    throw_limit("bytes of field values at this resolution or more", static_cast<double>(limits_.mesh_bytes) + 1,
                limits_.mesh_bytes, "mesh_bytes", path_);
  }

 private:
  const SizeLimits& limits_;
  const std::string& path_;
  std::atomic<std::uint64_t> bytes_{0};
};

/// Descends into regions. Each thread uses its own object.
class Descent {
 public:
  Descent(const ImplicitBody& body, std::span<const float> gaps, BodyBricks& bricks, const BlockPlaces& places,
          BrickBudget& budget, Progress& progress)
      : body_(body),
        bricks_(bricks),
        places_(places),
        budget_(budget),
        progress_(progress),
        pruner_(body, gaps, kExactReach * bricks.grid.cell),
        sampler_(body),
        levels_(kMaxDepth) {}

  /// Returns the eighths of a region that may contain surface.
  std::vector<Region> halved(const Region& region) {
    std::vector<Region> parts;
    const Level& level = halve(region.at, region.side, region.steps, 0);
    for (int k = 0; k < 8; ++k) {
      if (!level.holds_surface(k)) continue;
      parts.push_back({region.at + region.side / 2 * corner_of(k, 2), region.side / 2, level.steps[k]});
    }
    return parts;
  }

  /// Samples all bricks of a region that may contain surface.
  void fill(const Region& region, std::size_t chunk) {
    fill(region.at, region.side, region.steps, 0, bricks_.grid.chunks[chunk], bricks_.parts[chunk]);
    bricks_.parts[chunk].first.push_back(bricks_.parts[chunk].steps.size());
  }

 private:
  struct Level {              // the eighths of one region
    std::array<int, 8> sign;  // 0 where surface is possible
    std::array<std::vector<FieldStep>, 8> steps;
    bool holds_surface(int k) const { return sign[k] == 0; }
  };

  Level& halve(glm::ivec3 at, int side, std::span<const FieldStep> steps, int depth) {
    progress_.check();
    const double cell = bricks_.grid.cell;
    const double half = 0.5 * kBlockSide * side;  // cells from eighth to eighth
    // Each eighth extends one cell below its corners, into the cells that touch them.
    const DVec3 middle = static_cast<double>(kBlockSide) * DVec3(at) + half - 0.5;
    const auto safety = static_cast<float>(kSafety * cell);
    near_.rebase(body_, steps, bricks_.grid.origin + cell * middle);
    pruner_.bound(steps, near_, {0.5 * half * cell, (half + 1) * cell});
    Level& level = levels_[depth];
    std::uint32_t open = 0;
    for (int k = 0; k < 8; ++k) {
      const ValueRange range = pruner_.range(k);
      level.sign[k] = range.low > safety ? 1 : range.high < -safety ? -1 : 0;
      if (level.holds_surface(k)) open |= 1U << k;
    }
    if (open == 0) return level;
    // Cubes of single blocks are sampled only at the corners, which lie a cell inside them.
    pruner_.keep(open, side == 2 ? kHalfDiagonal * 2 * cell : 0, level.steps);
    return level;
  }

  // The recursion depth is the number of halvings of a region.
  void fill(glm::ivec3 at, int side, std::span<const FieldStep> steps, int depth, BrickChunk& chunk,
            BodyBricks::Parts& parts) {
    const Level& level = halve(at, side, steps, depth);
    if (side == 2) {
      if (std::any_of(level.sign.begin(), level.sign.end(), [](int sign) { return sign == 0; })) {
        sample(at / 2, steps, level, chunk, parts);
      }
      return;
    }
    for (int k = 0; k < 8; ++k) {
      if (!level.holds_surface(k)) continue;
      fill(at + side / 2 * corner_of(k, 2), side / 2, level.steps[k], depth + 1, chunk, parts);
    }
  }

  /// Samples a brick of eight blocks. If a block has no surface in its cells, only the sign is stored.
  void sample(glm::ivec3 at, std::span<const FieldStep> steps, const Level& level, BrickChunk& chunk,
              BodyBricks::Parts& parts) {
    budget_.spend(sizeof(float) * kBrickSize + steps.size_bytes());
    chunk.at.push_back(at);
    const std::size_t first = chunk.values.size();
    chunk.values.resize(first + kBrickSize);
    for (int k = 0; k < 8; ++k) {
      std::array<float, kBlockSize> values;
      if (level.holds_surface(k)) {
        const int position = kBlockSize * k;
        sampler_.sample(level.steps[k], near_, &places_.x[position], &places_.y[position], &places_.z[position],
                        kBlockSize, values.data());
      } else {
        values.fill(static_cast<float>(level.sign[k] * bricks_.grid.cell));
      }
      const glm::ivec3 base = kBlockSide * corner_of(k, 2);
      float* const out = chunk.values.data() + first + base.x + kBrickSide * (base.y + kBrickSide * base.z);
      for (int row = 0; row < kBlockSide * kBlockSide; ++row) {
        std::copy_n(values.data() + kBlockSide * row, kBlockSide,
                    out + kBrickSide * (row % kBlockSide + kBrickSide * (row / kBlockSide)));
      }
    }
    parts.first.push_back(parts.steps.size());
    parts.steps.insert(parts.steps.end(), steps.begin(), steps.end());
  }

  const ImplicitBody& body_;
  BodyBricks& bricks_;
  const BlockPlaces& places_;
  BrickBudget& budget_;
  Progress& progress_;
  NearSolids near_;
  FieldPruner pruner_;
  FieldSampler sampler_;
  std::vector<Level> levels_;
};

/// Returns a cube of blocks around the whole body.
Region whole_region(const ImplicitBody& body, BodyBricks& bricks, const std::string& path) {
  const double cell = bricks.grid.cell;
  const DVec3 margin(body.reach() + kMargin * cell);
  bricks.grid.origin = body.low() - margin;
  const DVec3 size = body.high() + margin - bricks.grid.origin;
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest <= kMaxCells * cell)) {
    throw_limit("cells along a body", longest / cell, static_cast<std::uint64_t>(kMaxCells), "mesh_bytes", path);
  }
  Region region{.side = 2};
  while (region.side * kBlockSide * cell < longest) region.side *= 2;
  region.steps = all_steps(body);
  return region;
}

}  // namespace

BodyBricks sample_body(const ImplicitBody& body, double cell, const SizeLimits& limits, const std::string& path,
                       Progress& progress) {
  BodyBricks bricks;
  bricks.grid.cell = cell;
  bricks.error = kFieldError * cell;
  if (body.is_empty()) return bricks;
  const BlockPlaces places(cell);
  BrickBudget budget(limits, path);
  const std::vector<float> gaps = blend_gaps(body, bricks.error);
  const auto descent = [&] { return Descent(body, gaps, bricks, places, budget, progress); };

  // Halve until there are enough regions to distribute.
  std::vector<Region> regions{whole_region(body, bricks, path)};
  progress.begin("sampling bodies", 1);
  while (!regions.empty() && regions.size() < kChunks && regions[0].side > 2) {
    std::vector<std::vector<Region>> parts(regions.size());
    parallel_for(regions.size(), 1, [&](std::size_t begin, std::size_t end) {
      Descent halving = descent();
      for (std::size_t k = begin; k < end; ++k) {
        progress.check();
        parts[k] = halving.halved(regions[k]);
      }
    });
    regions.clear();
    for (std::vector<Region>& part : parts) std::move(part.begin(), part.end(), std::back_inserter(regions));
  }

  progress.begin("sampling bodies", regions.size());
  bricks.grid.chunks.resize(regions.size());
  bricks.parts.resize(regions.size());
  parallel_for(regions.size(), 1, [&](std::size_t begin, std::size_t end) {
    Descent filling = descent();
    for (std::size_t k = begin; k < end; ++k) {
      filling.fill(regions[k], k);
      progress.advance();
    }
  });
  return bricks;
}

}  // namespace meristem

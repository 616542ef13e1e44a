// SPDX-License-Identifier: Apache-2.0
// Casts shade in sparse bricks of 8 x 8 x 8 voxels. Shaders are sorted by brick and cast in groups, and threads share
// the bricks by slabs along z. See shadow_grid.h.
#include "meristem/scene/light/shadow_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/base/require.h"

namespace meristem {

namespace {

constexpr double kFullShade = 4294967296;  // fixed-point value of one shade
constexpr double kMaxShade = 1e6;
constexpr double kFarthest = 1e10;  // voxels
constexpr int kDeepest = 64;
constexpr int kLongestReach = 4;  // limits a neighbourhood to two bricks in each direction
constexpr int kBits = 3;          // bits of a voxel's coordinate in its brick
constexpr int kMask = 7;

/// Rounds to the nearest whole number, halves away from 0, so that both signs are symmetric.
std::int64_t rounded(double value) {
  const auto whole = static_cast<std::int64_t>(std::floor(std::abs(value) + 0.5));
  return value < 0 ? -whole : whole;
}

/// Returns the axis along which the layers are stacked.
int main_axis(DVec3 toward_light) {
  const DVec3 size(std::abs(toward_light.x), std::abs(toward_light.y), std::abs(toward_light.z));
  if (size.y >= size.x && size.y >= size.z) return 1;
  return size.x >= size.z ? 0 : 2;
}

std::size_t index_in_brick(std::int64_t x, std::int64_t y, std::int64_t z) {
  return static_cast<std::size_t>((x & kMask) | (y & kMask) << kBits | (z & kMask) << (2 * kBits));
}

double as_number(std::uint64_t shade) { return static_cast<double>(static_cast<std::int64_t>(shade)); }

void check(const ShadowParameters& form) {
  require(form.voxel > 0 && std::isfinite(form.voxel), "ShadowParameters::voxel is not above 0");
  require(form.amount >= 0 && form.amount <= kMaxShade, "ShadowParameters::amount is out of range");
  require(form.base >= 1 && std::isfinite(form.base), "ShadowParameters::base is below 1");
  require(form.depth >= 0 && form.depth <= kDeepest, "ShadowParameters::depth is out of range");
  require(form.reach >= 1 && form.reach <= kLongestReach, "ShadowParameters::reach is out of range");
  const DVec3 light(form.toward_light);
  require(std::abs(glm::dot(light, light) - 1) < 1e-3, "ShadowParameters::toward_light is not a unit vector");
}

constexpr std::size_t kAskedAtOnce = 16;  // positions whose voxels are fetched together
constexpr int kKeyBits = 21;
constexpr std::uint64_t kPartOfKey = (1U << kKeyBits) - 1;
constexpr std::size_t kFew = 64;  // shaders that are cast by one thread
// Shaders per batch; small, so that little is cast after a stop or beyond a limit.
constexpr std::size_t kTogether = 8192;

}  // namespace

std::size_t ShadowGrid::Bricks::home_of(const BrickCell& position) const {
  std::uint64_t bits = 0;
  for (const std::int32_t k : position) {
    bits = (bits ^ static_cast<std::uint32_t>(k)) * 0x9E3779B97F4A7C15U;
    bits ^= bits >> 32;
  }
  return static_cast<std::size_t>(bits) & (table_.size() - 1);
}

/// Returns the index of a brick's entry in the table, or of the free entry where it would be inserted.
std::size_t ShadowGrid::Bricks::entry_of(const BrickCell& position) const {
  std::size_t at = home_of(position);
  while (table_[at].brick != kNone && !is_same(table_[at].position, position)) at = (at + 1) & (table_.size() - 1);
  return at;
}

ShadowGrid::Brick& ShadowGrid::Bricks::add(const BrickCell& position) {
  if (2 * (size() + 1) > table_.size()) {
    const std::vector<Entry> before =
        std::exchange(table_, std::vector<Entry>(std::max<std::size_t>(2 * table_.size(), 16)));
    for (const Entry& entry : before) {
      if (entry.brick != kNone) table_[entry_of(entry.position)] = entry;
    }
  }
  Entry& entry = table_[entry_of(position)];
  if (entry.brick != kNone) return bricks_[entry.brick];
  entry.position = position;
  if (free_.empty()) {
    entry.brick = static_cast<std::uint32_t>(bricks_.size());
    return bricks_.emplace_back();
  }
  entry.brick = free_.back();
  free_.pop_back();
  return bricks_[entry.brick];
}

void ShadowGrid::Bricks::erase(const BrickCell& position) {
  std::size_t hole = entry_of(position);
  free_.push_back(table_[hole].brick);
  // Move back the following entries that were displaced by this entry.
  for (std::size_t at = (hole + 1) & (table_.size() - 1); table_[at].brick != kNone;
       at = (at + 1) & (table_.size() - 1)) {
    const std::size_t way_from_home = (at - home_of(table_[at].position)) & (table_.size() - 1);
    const std::size_t way_from_hole = (at - hole) & (table_.size() - 1);
    if (way_from_home < way_from_hole) continue;
    table_[hole] = table_[at];
    hole = at;
  }
  table_[hole] = {};
}

ShadowGrid::ShadowGrid(const ShadowParameters& form) : form_(form) {
  check(form);

  // The layers of the pyramid: each is one step further from the light and is shifted sideways by the slope of the
  // light.
  const DVec3 light(form.toward_light);
  const int main = main_axis(light);
  double shade = form.amount;
  for (int q = 0; q <= form.depth; ++q) {
    Layer layer;
    layer.shade = shade;
    for (int k = 0; k < 3; ++k) {
      const auto middle = static_cast<int>(rounded(-q * light[k] / std::abs(light[main])));
      const int half = k == main ? 0 : q;
      layer.block.low[k] = middle - half;
      layer.block.high[k] = middle + half;
      bounds_.low[k] = std::min(bounds_.low[k], layer.block.low[k]);
      bounds_.high[k] = std::max(bounds_.high[k], layer.block.high[k]);
    }
    layers_.push_back(layer);
    shade /= form.base;
  }

  // One voxel of each pair of opposite neighbours: all 26 neighbours for a reach of 1, a ball for larger reaches.
  const int reach = form.reach;
  for (int x = 0; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const bool is_first = x > 0 || y > 0 || (y == 0 && z > 0);
        const int square = x * x + y * y + z * z;
        if (!is_first || square > std::max(reach * reach, 3)) continue;
        neighbours_.push_back({{x, y, z}, DVec3(x, y, z) / std::sqrt(square)});
      }
    }
  }
}

ShadowGrid::Voxel ShadowGrid::voxel_at(Vec3 position) const {
  Voxel voxel;
  for (int k = 0; k < 3; ++k) {
    const double at = std::floor(static_cast<double>(position[k]) / form_.voxel);
    require(std::abs(at) <= kFarthest, "a position is too far away for its shade");
    voxel[k] = static_cast<std::int64_t>(at);
  }
  return voxel;
}

bool ShadowGrid::reaches(Vec3 position) const {
  const double farthest = kFarthest * form_.voxel;
  return std::abs(position.x) <= farthest && std::abs(position.y) <= farthest && std::abs(position.z) <= farthest;
}

/// Shaders with their amounts of shade in each layer, grouped by brick.
/// Shaders that are cast together: one per voxel, grouped by brick, and the slabs on which each group casts shade.
struct ShadowGrid::Together {
  std::vector<Voxel> voxels;           // one per shader, by brick
  std::vector<std::uint64_t> amounts;  // by shader and layer
  std::vector<Group> groups;
  std::array<std::vector<Fall>, kSlabs> falls;  // work of each slab
  std::size_t layers;

  Together(const ShadowGrid& grid, std::span<const ShadeSource> shaders);

  const std::uint64_t* amounts_of(std::size_t shader) const { return amounts.data() + shader * layers; }

 private:
  /// A shader with its sort keys.
  struct Placed {
    std::uint64_t key;  // of its brick; distant bricks may have equal keys
    std::uint32_t voxel;
    std::uint32_t shader;
  };

  static Placed placed(const Voxel& voxel, std::size_t shader);
  void add_voxel(const Voxel& voxel);
};

ShadowGrid::Together::Placed ShadowGrid::Together::placed(const Voxel& voxel, std::size_t shader) {
  const auto part = [&](int axis) { return static_cast<std::uint64_t>(voxel[axis] >> kBits) & kPartOfKey; };
  return {part(0) | part(1) << kKeyBits | part(2) << 2 * kKeyBits,
          static_cast<std::uint32_t>(index_in_brick(voxel[0], voxel[1], voxel[2])), static_cast<std::uint32_t>(shader)};
}

/// Adds a voxel without shade to the group of its brick. A brick gets a second group if its shaders alternate with
/// those of a distant brick with an equal key.
void ShadowGrid::Together::add_voxel(const Voxel& voxel) {
  const BrickCell brick = brick_of(voxel);
  const auto index = static_cast<std::uint32_t>(voxels.size());
  if (groups.empty() || !is_same(groups.back().brick, brick)) groups.push_back({brick, index, 0});
  groups.back().end = index + 1;
  voxels.push_back(voxel);
  amounts.resize(amounts.size() + layers, 0);
}

ShadowGrid::Together::Together(const ShadowGrid& grid, std::span<const ShadeSource> shaders)
    : layers(grid.layers_.size()) {
  // Sort the shaders by brick and voxel.
  std::vector<Placed> order(shaders.size());
  std::vector<Voxel> voxel_of(shaders.size());
  for (std::size_t k = 0; k < shaders.size(); ++k) {
    require(std::abs(shaders[k].weight) * grid.form_.amount <= kMaxShade, "the weight of a shader is out of range");
    voxel_of[k] = grid.voxel_at(shaders[k].position);
    order[k] = placed(voxel_of[k], k);
  }
  std::sort(order.begin(), order.end(), [](const Placed& a, const Placed& b) {
    if (a.key != b.key) return a.key < b.key;
    return a.voxel != b.voxel ? a.voxel < b.voxel : a.shader < b.shader;
  });

  // Add up the shaders of each voxel.
  voxels.reserve(order.size());
  amounts.reserve(order.size() * layers);
  for (const Placed& placed : order) {
    const Voxel& voxel = voxel_of[placed.shader];
    if (voxels.empty() || voxels.back() != voxel) add_voxel(voxel);
    std::uint64_t* const own = amounts.data() + amounts.size() - layers;
    for (std::size_t q = 0; q < layers; ++q) {
      own[q] += static_cast<std::uint64_t>(rounded(shaders[placed.shader].weight * grid.layers_[q].shade * kFullShade));
    }
  }

  // A group casts shade on the bricks around it, at several heights.
  for (std::uint32_t k = 0; k < groups.size(); ++k) {
    for (int z = grid.bounds_.low[2] >> kBits; z <= (kSide - 1 + grid.bounds_.high[2]) >> kBits; ++z) {
      const BrickCell above{0, 0, groups[k].brick[2] + z};
      falls[static_cast<std::size_t>(slab_of(above))].push_back({k, z});
    }
  }
}

/// Casts the shade that falls on the bricks of one slab. The shaders of a group reach the same neighbouring bricks, so
/// each of these bricks is looked up once per group.
class ShadowGrid::SlabCaster {
 public:
  SlabCaster(const ShadowGrid& grid, const Together& together, Bricks& bricks, std::atomic<std::uint64_t>& made,
             std::uint64_t max_made, const Progress& progress)
      : grid_(grid), together_(together), bricks_(bricks), made_(made), max_made_(max_made), progress_(progress) {
    for (int k = 0; k < 3; ++k) {
      first_[k] = grid.bounds_.low[k] >> kBits;
      count_[k] = ((kSide - 1 + grid.bounds_.high[k]) >> kBits) - first_[k] + 1;
    }
    near_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]));
  }

  void cast(const Fall& fall) {
    const Group& group = together_.groups[fall.group];
    std::fill(near_.begin(), near_.end(), nullptr);
    z_ = fall.z;
    for (std::uint32_t shader = group.begin; shader < group.end; ++shader) {
      progress_.check();  // the deepest pyramids take a millisecond each
      const Voxel& voxel = together_.voxels[shader];
      const std::uint64_t* const amounts = together_.amounts_of(shader);
      for (std::size_t q = 0; q < together_.layers; ++q) {
        if (amounts[q] != 0) cast_layer(group, voxel, grid_.layers_[q].block, amounts[q]);
      }
    }
    for (std::size_t k = 0; k < near_.size(); ++k) {
      if (near_[k] != nullptr && near_[k]->sum == 0) unsummed_.push_back(place_of(group, k));
    }
  }

  /// Removes bricks without shade.
  void drop_empty() {
    for (const BrickCell& position : unsummed_) {
      const Brick* const found = bricks_.find(position);
      // The sum may wrap to 0 although some voxels are not 0.
      if (found == nullptr || found->sum != 0) continue;
      const auto& shade = found->shade;
      if (std::all_of(shade.begin(), shade.end(), [](std::uint64_t s) { return s == 0; })) bricks_.erase(position);
    }
  }

 private:
  void cast_layer(const Group& group, const Voxel& voxel, const Block& layer, std::uint64_t amount) {
    // The voxels of the layer, relative to the first voxel of the group's brick.
    std::array<int, 3> low;
    std::array<int, 3> high;
    for (int k = 0; k < 3; ++k) {
      low[k] = static_cast<int>(voxel[k] & kMask) + layer.low[k];
      high[k] = static_cast<int>(voxel[k] & kMask) + layer.high[k];
    }
    Block part;
    part.low[2] = std::max(low[2] - kSide * z_, 0);
    part.high[2] = std::min(high[2] - kSide * z_, kSide - 1);
    if (part.low[2] > part.high[2]) return;
    for (int y = low[1] >> kBits; y <= high[1] >> kBits; ++y) {
      part.low[1] = std::max(low[1] - kSide * y, 0);
      part.high[1] = std::min(high[1] - kSide * y, kSide - 1);
      for (int x = low[0] >> kBits; x <= high[0] >> kBits; ++x) {
        part.low[0] = std::max(low[0] - kSide * x, 0);
        part.high[0] = std::min(high[0] - kSide * x, kSide - 1);
        change_block(brick_at(group, x, y), part, amount);
      }
    }
  }

  BrickCell place_of(const Group& group, std::size_t near) const {
    const auto width = static_cast<std::size_t>(count_[0]);
    return {group.brick[0] + first_[0] + static_cast<std::int32_t>(near % width),
            group.brick[1] + first_[1] + static_cast<std::int32_t>(near / width), group.brick[2] + z_};
  }

  Brick& brick_at(const Group& group, int x, int y) {
    const auto k = static_cast<std::size_t>((y - first_[1]) * count_[0] + x - first_[0]);
    if (near_[k] != nullptr) return *near_[k];
    const std::size_t before = bricks_.size();
    near_[k] = &bricks_.add(place_of(group, k));
    const bool is_new = bricks_.size() > before;
    if (is_new && made_.fetch_add(1, std::memory_order_relaxed) >= max_made_) throw TooMuchMemory();
    return *near_[k];
  }

  const ShadowGrid& grid_;
  const Together& together_;
  Bricks& bricks_;
  std::atomic<std::uint64_t>& made_;
  std::uint64_t max_made_;
  const Progress& progress_;
  std::array<int, 3> first_;  // lowest offset of a brick that a group's shaders may reach
  std::array<int, 3> count_;
  std::vector<Brick*> near_;  // bricks at z_, by x and y; null until shade falls there
  int z_ = 0;
  std::vector<BrickCell> unsummed_;
};

ShadowGrid::BrickCell ShadowGrid::brick_of(const Voxel& voxel) {
  return {static_cast<std::int32_t>(voxel[0] >> kBits), static_cast<std::int32_t>(voxel[1] >> kBits),
          static_cast<std::int32_t>(voxel[2] >> kBits)};
}

void ShadowGrid::add(Vec3 position, double weight) {
  const ShadeSource shader{position, weight};
  cast_together({&shader, 1}, Progress(), std::numeric_limits<std::uint64_t>::max());
}

void ShadowGrid::cast(std::span<const ShadeSource> shaders, const Progress& progress, std::uint64_t max_bytes) {
  for (std::size_t first = 0; first < shaders.size(); first += kTogether) {
    cast_together(shaders.subspan(first, std::min(kTogether, shaders.size() - first)), progress,
                  max_bytes / kBrickBytes);
  }
}

/// Casts the shade of all shaders on the grid. Slabs are the bricks of one height; their threads change no brick of
/// another slab. Shade is counted in whole numbers, so the order of the shaders does not change the result. Throws
/// TooMuchMemory if more than `max_bricks` bricks would exist.
void ShadowGrid::cast_together(std::span<const ShadeSource> shaders, const Progress& progress,
                               std::uint64_t max_bricks) {
  progress.check();
  const Together together(*this, shaders);
  const std::uint64_t before = brick_count();
  const std::uint64_t max_made = max_bricks > before ? max_bricks - before : 0;
  std::atomic<std::uint64_t> made{0};
  // For few shaders, one thread is faster than waking others.
  const std::size_t grain = shaders.size() < kFew ? kSlabs : 1;
  parallel_for(kSlabs, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slab = begin; slab < end; ++slab) {
      if (together.falls[slab].empty()) continue;
      SlabCaster caster(*this, together, bricks_[slab], made, max_made, progress);
      for (const Fall& fall : together.falls[slab]) caster.cast(fall);
      caster.drop_empty();
    }
  });
}

void ShadowGrid::change_block(Brick& brick, const Block& block, std::uint64_t amount) {
  const int width = block.high[0] - block.low[0] + 1;
  for (int z = block.low[2]; z <= block.high[2]; ++z) {
    for (int y = block.low[1]; y <= block.high[1]; ++y) {
      std::uint64_t* const row = brick.shade.data() + index_in_brick(block.low[0], y, z);
      for (int x = 0; x < width; ++x) row[x] += amount;
    }
  }
  const int rows = (block.high[1] - block.low[1] + 1) * (block.high[2] - block.low[2] + 1);
  brick.sum += amount * static_cast<std::uint64_t>(width * rows);
}

std::size_t ShadowGrid::brick_count() const {
  std::size_t count = 0;
  for (const Bricks& slab : bricks_) count += slab.size();
  return count;
}

const ShadowGrid::Brick* ShadowGrid::find(const BrickCell& position) const {
  return bricks_[static_cast<std::size_t>(slab_of(position))].find(position);
}

const ShadowGrid::Brick* ShadowGrid::find(const BrickCell& position, Recent& recent) const {
  const auto lane = static_cast<std::size_t>((position[0] & 1) | (position[1] & 1) << 1 | (position[2] & 1) << 2);
  if (!is_same(recent.places_[lane], position)) {
    recent.places_[lane] = position;
    recent.bricks_[lane] = find(position);
  }
  return recent.bricks_[lane];
}

double ShadowGrid::shade(Vec3 position) const {
  Recent recent;
  double found = 0;
  shade({&position, 1}, {&found, 1}, recent);
  return found;
}

void ShadowGrid::shade(std::span<const Vec3> places, std::span<double> found, Recent& recent) const {
  // Start fetching the voxels of several positions before reading the first one.
  std::array<const std::uint64_t*, kAskedAtOnce> voxels;
  for (std::size_t first = 0; first < places.size(); first += kAskedAtOnce) {
    const std::size_t count = std::min(kAskedAtOnce, places.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
      const Voxel voxel = voxel_at(places[first + k]);
      const Brick* const brick = find(brick_of(voxel), recent);
      voxels[k] = brick == nullptr ? nullptr : brick->shade.data() + index_in_brick(voxel[0], voxel[1], voxel[2]);
      __builtin_prefetch(voxels[k]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      found[first + k] = voxels[k] == nullptr ? 0 : as_number(*voxels[k]) / kFullShade;
    }
  }
}

Vec3 ShadowGrid::brighter_way(Vec3 position) const {
  Recent recent;
  return brighter_way(position, recent);
}

Vec3 ShadowGrid::brighter_way(Vec3 position, Recent& recent) const {
  const Voxel voxel = voxel_at(position);

  // Look up the surrounding bricks once.
  BrickCell first;
  BrickCell last;
  for (int k = 0; k < 3; ++k) {
    first[k] = static_cast<std::int32_t>((voxel[k] - form_.reach) >> kBits);
    last[k] = static_cast<std::int32_t>((voxel[k] + form_.reach) >> kBits);
  }
  std::array<const Brick*, 8> bricks{};
  for (int k = 0; k < 8; ++k) {
    const BrickCell at{first[0] + (k & 1), first[1] + (k >> 1 & 1), first[2] + (k >> 2)};
    if (at[0] > last[0] || at[1] > last[1] || at[2] > last[2]) continue;
    bricks[k] = find(at, recent);
  }
  const auto shade_at = [&](std::int64_t x, std::int64_t y, std::int64_t z) -> std::uint64_t {
    const Brick* const brick =
        bricks[((x >> kBits) - first[0]) | ((y >> kBits) - first[1]) << 1 | ((z >> kBits) - first[2]) << 2];
    return brick == nullptr ? 0 : brick->shade[index_in_brick(x, y, z)];
  };

  // Subtract opposite voxels, so that equal shade on both sides cancels exactly.
  DVec3 sum(0);
  double total = 0;
  for (const auto& [offset, toward] : neighbours_) {
    const std::uint64_t there = shade_at(voxel[0] + offset[0], voxel[1] + offset[1], voxel[2] + offset[2]);
    const std::uint64_t opposite = shade_at(voxel[0] - offset[0], voxel[1] - offset[1], voxel[2] - offset[2]);
    sum += as_number(opposite - there) * toward;
    total += as_number(there) + as_number(opposite);
  }
  return total > 0 ? Vec3(sum / total) : Vec3(0);
}

std::size_t ShadowGrid::bytes() const { return brick_count() * kBrickBytes; }

}  // namespace meristem

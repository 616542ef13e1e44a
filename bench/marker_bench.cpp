// SPDX-License-Identifier: Apache-2.0
// Trees that grow toward free markers. Counters: shoots, buds or metamers a second (buds that searched, metamers that
// grew); `blind`, the share of buds that find no marker; bytes of the field per metamer. `to_plain` is the time of a
// hash map with an entry per voxel divided by the library's time, for an equal tree in one run.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/scene/crown/profile_crown.h"
#include "meristem/scene/marker/marker_field.h"

namespace {

using meristem::BudRoom;
using meristem::CrownPointer;
using meristem::MarkerField;
using meristem::MarkerParameters;
using meristem::RandomKey;
using meristem::SpaceSeeker;
using meristem::Vec3;

constexpr float kLength = 0.1F;       // of a metamer
constexpr std::uint32_t kWanted = 6;  // markers for which a bud grows
const MarkerParameters kForm{.spacing = 0.7 * kLength, .occupancy = 2 * kLength};

/// An egg of a given height, metres.
CrownPointer crown_of(std::int64_t height) {
  if (height == 0) return nullptr;
  const auto high = static_cast<float>(height);
  return std::make_shared<meristem::ProfileCrown>(
      meristem::ProfileCrown::Profile{{0, 0}, {0.3F * high, 0.3F * high}, {0.3F * high, 0.6F * high}, {0, high}});
}

class Field : public MarkerField {
 public:
  explicit Field(const CrownPointer& crown) : MarkerField(kForm, RandomKey(1)) { add_volume(crown, Vec3(0, -0.5F, 0)); }
};

/// The plain field: an entry per voxel, and an entry per claim.
class PlainField {
 public:
  explicit PlainField(CrownPointer crown) : crown_(std::move(crown)) {}
  void occupy(Vec3 position) {
    for_each_near(position, static_cast<float>(kForm.occupancy), [&](std::uint64_t voxel, Vec3) { ++shoots_[voxel]; });
  }
  void share_out(const std::vector<SpaceSeeker>& seekers, std::vector<BudRoom>& rooms, const meristem::Progress&) {
    struct Claim {
      float square = 1e9F;
      std::size_t seeker = 0;
      Vec3 unit{0};
    };
    std::unordered_map<std::uint64_t, Claim> claims;
    for (std::size_t k = 0; k < seekers.size(); ++k) {
      for_each_near(seekers[k].position, seekers[k].radius, [&](std::uint64_t voxel, Vec3 way) {
        const float square = glm::dot(way, way);
        if (glm::dot(way, seekers[k].direction) < seekers[k].cosine * std::sqrt(square)) return;
        if (shoots_.contains(voxel)) return;
        if (crown_ && !crown_->contains(seekers[k].position + way + Vec3(0, 0.5F, 0))) return;
        Claim& claim = claims[voxel];
        if (square < claim.square) claim = {square, k, way / std::sqrt(square)};
      });
    }
    rooms.assign(rooms.size(), {});
    for (const auto& [voxel, claim] : claims) {
      ++rooms[claim.seeker].count;
      rooms[claim.seeker].way += claim.unit;
    }
  }

 private:
  template <class Visit>
  void for_each_near(Vec3 position, float radius, Visit visit) {
    const auto side = static_cast<float>(kForm.spacing);
    std::array<std::int64_t, 3> low;
    std::array<std::int64_t, 3> high;
    for (int k = 0; k < 3; ++k) {
      low[k] = static_cast<std::int64_t>(std::floor((position[k] - radius) / side));
      high[k] = static_cast<std::int64_t>(std::floor((position[k] + radius) / side));
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t x = low[0]; x <= high[0]; ++x) {
          const auto part = [](std::int64_t at) { return static_cast<std::uint64_t>(at) & 0x1FFFFF; };
          const std::uint64_t voxel = part(x) | part(y) << 21 | part(z) << 42;
          std::uint64_t dice = voxel * 0x9E3779B97F4A7C15U;
          dice ^= dice >> 29;
          const auto jitter = [&](int shift) { return (static_cast<float>(dice >> shift & 255) + 0.5F) / 256; };
          const Vec3 marker(static_cast<float>(x) + jitter(32), static_cast<float>(y) + jitter(40),
                            static_cast<float>(z) + jitter(48));
          const Vec3 way = side * marker - position;
          if (glm::dot(way, way) <= radius * radius) visit(voxel, way);
        }
      }
    }
  }
  CrownPointer crown_;
  std::unordered_map<std::uint64_t, int> shoots_;
};

/// Each bud with enough room makes a metamer toward it. The metamer bears the terminal bud and a lateral bud.
template <class AnyField>
struct Tree {
  explicit Tree(const CrownPointer& crown) : field(crown) { buds.push_back({.radius = 4 * kLength}); }

  void grow(std::size_t metamers) {
    while (shoots.size() < metamers && grow_once(metamers)) {
    }
  }

  bool grow_once(std::size_t max) {
    std::vector<BudRoom> rooms(buds.size());
    field.share_out(buds, rooms, meristem::Progress());
    looks += buds.size();
    const std::size_t before = shoots.size();
    for (std::size_t k = 0; k < rooms.size() && shoots.size() < max; ++k) {
      if (rooms[k].count < kWanted) continue;
      SpaceSeeker& bud = buds[k];
      bud.direction = glm::normalize(0.6F * bud.direction + 0.4F * glm::normalize(rooms[k].way) + 1e-3F);
      bud.position += kLength * bud.direction;
      SpaceSeeker lateral = bud;
      const Vec3 aside = glm::cross(bud.direction, key.direction(shoots.size()));
      lateral.direction = glm::normalize(0.57F * bud.direction + 0.82F * glm::normalize(aside));
      buds.push_back(lateral);
      shoots.push_back(buds[k].position);
    }
    for (std::size_t k = before; k < shoots.size(); ++k) field.occupy(shoots[k]);
    ++rounds;
    return shoots.size() > before;
  }

  RandomKey key{2};
  AnyField field;
  std::vector<SpaceSeeker> buds;
  std::vector<Vec3> shoots;
  std::size_t looks = 0;
  int rounds = 0;
};

template <class AnyField>
double seconds_of_growing(const CrownPointer& crown, std::size_t metamers) {
  const auto begin = std::chrono::steady_clock::now();
  Tree<AnyField> tree(crown);
  tree.grow(metamers);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void rate(benchmark::State& state, const char* what, std::size_t count) {
  state.counters[what] = benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

/// Grows a tree from its first bud on one thread. `crown` in metres; 0: all of space.
void grow(benchmark::State& state) {
  const meristem::ThreadLimit limit(1);
  const CrownPointer crown = crown_of(state.range(1));
  const auto metamers = static_cast<std::size_t>(state.range(0));
  double bytes = 0;
  std::size_t count = 0;
  for (auto _ : state) {
    Tree<Field> tree(crown);
    tree.grow(metamers);
    count = tree.shoots.size();
    bytes = static_cast<double>(tree.field.bytes());
    state.counters["rounds"] = tree.rounds;
    state.counters["looks/metamer"] = static_cast<double>(tree.looks) / static_cast<double>(count);
  }
  rate(state, "metamers/s", count);
  state.counters["metamers"] = static_cast<double>(count);
  state.counters["bytes/metamer"] = bytes / static_cast<double>(count);
  if (metamers <= 20'000) {
    const double plain = seconds_of_growing<PlainField>(crown, metamers);
    state.counters["to_plain"] = plain / seconds_of_growing<Field>(crown, metamers);
  }
}
BENCHMARK(grow)
    ->ArgNames({"metamers", "crown"})
    ->ArgsProduct({meristem::bench::sized({1'000, 20'000}, {500}), {0, 8}})
    ->ArgsProduct({meristem::bench::sized({1'000'000}, {500}), {0, 20}})
    ->Unit(benchmark::kMillisecond);

/// Adds the shoots of a tree to an empty field.
void occupy_all(benchmark::State& state) {
  Tree<Field> tree(nullptr);
  tree.grow(meristem::bench::sized(20'000, 500));
  for (auto _ : state) {
    Field field(nullptr);
    for (const Vec3 shoot : tree.shoots) field.occupy(shoot);
    state.counters["bytes"] = static_cast<double>(field.bytes());
  }
  rate(state, "shoots/s", tree.shoots.size());
}
BENCHMARK(occupy_all)->Unit(benchmark::kMillisecond);

/// Removes shoots and adds them again.
void move(benchmark::State& state) {
  Tree<Field> tree(nullptr);
  tree.grow(meristem::bench::sized(20'000, 500));
  for (auto _ : state) {
    for (const Vec3 shoot : tree.shoots) {
      tree.field.vacate(shoot);
      tree.field.occupy(shoot);
    }
  }
  rate(state, "shoots/s", tree.shoots.size());
}
BENCHMARK(move)->Unit(benchmark::kMillisecond);

/// Runs a round of all buds of a young tree, and of an old tree that has filled a crown.
void share_out(benchmark::State& state) {
  const meristem::ThreadLimit limit(static_cast<int>(state.range(2)));
  Tree<Field> tree(crown_of(state.range(1)));
  tree.grow(static_cast<std::size_t>(state.range(0)));
  std::vector<BudRoom> rooms(tree.buds.size());
  for (auto _ : state) tree.field.share_out(tree.buds, rooms, meristem::Progress());
  rate(state, "buds/s", tree.buds.size());
  const auto blind = std::count_if(rooms.begin(), rooms.end(), [](const BudRoom& room) { return room.count == 0; });
  state.counters["blind"] = static_cast<double>(blind) / static_cast<double>(rooms.size());
}
BENCHMARK(share_out)
    ->ArgNames({"metamers", "crown", "threads"})
    ->ArgsProduct({meristem::bench::sized({1'000, 500'000}, {500}), {10}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }

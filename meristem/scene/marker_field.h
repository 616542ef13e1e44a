// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"
#include "meristem/scene/crown.h"
#include "meristem/scene/obstacles.h"
namespace meristem {
struct MarkerForm { double spacing = 0.07, occupancy = 0.2; bool operator==(const MarkerForm&) const = default; };
struct Seeker { Vec3 place{0}; Vec3 direction{kUp}; std::uint32_t volume = 0; float radius = 0, cosine = 0; };
struct Room { std::uint32_t count = 0; Vec3 way{0}; };
class MarkerField {
 public:
  MarkerField(const MarkerForm& form, RandomKey, const Obstacles*) : form_(form) {}
  std::uint32_t add_volume(CrownPointer, Vec3) { return 0; }
  void occupy(Vec3) {}
  void vacate(Vec3) {}
  void share_out(std::span<const Seeker>, std::span<Room>, const Progress&) {}
  std::size_t bytes() const { return 0; }
  const MarkerForm& form() const { return form_; }
 private:
  MarkerForm form_;
};
}

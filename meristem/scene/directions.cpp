// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/directions.h"

#include "meristem/base/fingerprint.h"

namespace meristem {

std::uint64_t Directions::key_at(Vec3 position) const {
  Fingerprint key;
  for (const Vec3 direction : {toward_light(position), down(position)})
    key.add(direction.x).add(direction.y).add(direction.z);
  return key.hash();
}

}  // namespace meristem

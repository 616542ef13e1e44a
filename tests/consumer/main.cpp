// SPDX-License-Identifier: Apache-2.0
// A header of each room, and something small grown with them, as a stranger's project would.
#include <cstdio>

#include "meristem/base/random.h"
#include "meristem/base/vec.h"
#include "meristem/measure/counts.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh_scene.h"

int main() {
  const meristem::RandomKey key(7);
  const double drawn = key.child("consumer").uniform(0);
  std::printf("%f\n", drawn);
  return drawn >= 0 && drawn < 1 ? 0 : 1;
}

// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/ray_scene.h"

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"

namespace meristem::ray_scene_test {

/// A level field of `side` by `side` squares of a metre, its corner at the origin.
MeshScene field(std::uint32_t side) {
  Mesh mesh;
  for (std::uint32_t z = 0; z <= side; ++z)
    for (std::uint32_t x = 0; x <= side; ++x)
      mesh.positions.emplace_back(static_cast<float>(x), 0, static_cast<float>(z));
  for (std::uint32_t z = 0; z < side; ++z) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t corner = z * (side + 1) + x;
      mesh.triangles.push_back({corner, corner + side + 1, corner + 1});
      mesh.triangles.push_back({corner + 1, corner + side + 1, corner + side + 2});
    }
  }
  MeshScene scene;
  scene.materials.resize(1);
  scene.meshes = {{"field", std::make_shared<const Mesh>(std::move(mesh)), 0, {Frame()}}};
  return scene;
}

// Whenever a build is cancelled, TBB looks at what built everything that is still there: once, that was a loop which
// was gone.
TEST(RayScene, MayOutliveTheLoopThatItWasBuiltIn) {
  const MeshScene scene = field(200);
  std::vector<std::unique_ptr<RayScene>> kept(8);
  parallel_for(kept.size(), 1, [&](std::size_t k, std::size_t) {
    Progress progress;
    kept[k] = std::make_unique<RayScene>(scene, progress);
  });
  for (int milliseconds = 0; milliseconds < 12; ++milliseconds) {
    Progress progress;
    const std::jthread cancels([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      progress.cancel();
    });
    try {
      const RayScene built(scene, progress);
    } catch (const Cancelled&) {
      continue;
    }
  }
  for (const std::unique_ptr<RayScene>& one : kept)
    EXPECT_TRUE(one->is_blocked({Vec3(100.3F, 1, 100.2F), Vec3(0, -1, 0)}));
}

}  // namespace meristem::ray_scene_test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/graph/component.h"
#include "meristem/graph/looks.h"
#include "meristem/graph/shared_meshes.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The data that the emitters of one batch share.
struct EmitterContext {
  const Prototype& prototype;  ///< prototype of the instances
  const Scene& scene;
  const Directions& directions;  ///< directions of the scene
  const SizeLimits& limits;
  SharedMeshes& meshes;
  Progress* progress = nullptr;          ///< for long work in one instance
  std::string multiplier;                ///< document path of the parameter that multiplies the children, for errors
  std::uint64_t together = 1;            ///< number of instances that are expanded together
  double time = 0;                       ///< seconds
  const Animation* animation = nullptr;  ///< null: the document has no animation
  std::optional<int> growth_step{};      ///< step at which all plants that grow by a model are shown; unset: the last
  RandomKey key = RandomKey();           ///< key of the component, for random numbers that its instances share
  bool wants_child_sites = true;
  bool wants_branch_sites = true;
  std::size_t site_names = 0;  ///< number of names of the graph's sites
  std::uint64_t site_names_hash = 0;
  std::uint64_t mesh_bytes = 0;             ///< bytes of other components' meshes
  std::atomic<std::uint64_t> instances{0};  ///< number so far, including sites for instances that are not expanded yet
  std::atomic<std::uint64_t> nodes{0};      ///< number so far, of all stems
  Tinting tinting{prototype};
};

}  // namespace meristem

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

/// What the emitters of one batch have in common.
struct EmitterContext {
  const Prototype& prototype;  ///< of the instances
  const Scene& scene;
  const Directions& directions;  ///< the scene's
  const Limits& limits;
  SharedMeshes& meshes;
  Progress* progress = nullptr;          ///< for what takes long in one instance
  std::string multiplier;                ///< document path of what multiplies the children, for errors
  std::uint64_t together = 1;            ///< instances that are expanded together
  double time = 0;                       ///< seconds
  const Animation* animation = nullptr;  ///< null: the document has none
  std::optional<int> growth_step{};      ///< step at which all plants that grow by a model are shown; unset: the last
  RandomKey key = RandomKey();           ///< of the component, for what its instances draw together
  bool wants_child_sites = true;
  bool wants_branch_sites = true;
  std::size_t site_names = 0;  ///< of the graph
  std::uint64_t site_names_hash = 0;
  std::uint64_t mesh_bytes = 0;             ///< of what other components have made
  std::atomic<std::uint64_t> instances{0};  ///< so far, with the sites that are offered to more
  std::atomic<std::uint64_t> nodes{0};      ///< so far, of all stems
  Tinting tinting{prototype};
};

}  // namespace meristem

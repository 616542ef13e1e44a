// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "meristem/base/kept_results.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/expansion_cache.h"
#include "meristem/graph/shared_meshes.h"
#include "meristem/plant/texture.h"

namespace meristem {

struct ExpansionCache::Kept {
  KeptResults<const BatchResult> batches;
  KeptResults<const Places> places;  // that links give
  KeptResults<GrownBatch> grown;
  KeptResults<SharedMeshes> meshes;                      // of components
  std::vector<std::shared_ptr<const Texture>> textures;  // so that they stay in use
  Reuse instances_reuse;
  Reuse grown_reuse;

  void begin_run();
  void end_run();
};

}  // namespace meristem

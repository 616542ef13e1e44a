// SPDX-License-Identifier: Apache-2.0
// Small pictures of a document with other values: what a value does, at one look.
#pragma once

#include <memory>
#include <string>

#include "grower.h"
#include "host.h"
#include "meristem/base/progress.h"
#include "meristem/document/grow.h"
#include "meristem/graph/table/read_store.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// What the pictures are made of.
struct StillSource {
  std::string text;
  std::string file;  ///< absolute
  std::string root;
  std::string models;
  double time = 0;                           ///< seconds, of the document
  std::shared_ptr<const GrownWish> grown{};  ///< of the same document, whose painted pictures serve where they fit
};

/// Keeps what the states of a document share. One thread at a time calls it.
class StillMaker {
 public:
  /// A list with an object for each state: {"picture": a PNG in base 64, without a background}, or {"faults"} of the
  /// state. All are seen by one camera. Meshes are coarse where there is much to see. Throws Cancelled.
  Value make(const StillSource& source, const StillsRequest& request, const Registry& registry, Progress& progress);

 private:
  struct State;
  State grow(const StillSource& source, const std::vector<Override>& values, const Registry& registry,
             Progress& progress);

  ReadStore store_;
  GrowthCache cache_;
  GrowthCache coarse_cache_;
};

}  // namespace meristem::studio

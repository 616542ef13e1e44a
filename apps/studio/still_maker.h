// SPDX-License-Identifier: Apache-2.0
// Small pictures of a document with other values, which show the effect of a value. States are grown and drawn in
// parallel. The results of a state are kept for the next pictures of any state.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "grower.h"
#include "host.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"
#include "request.h"
#include "small_textures.h"

namespace meristem::studio {

/// The source of the pictures.
struct StillSource {
  std::string text;
  std::string file;  ///< absolute path
  std::string root;
  std::string models;
  double time = 0;                            ///< seconds, of the document
  std::shared_ptr<const GrownPlant> grown{};  ///< grown plant of the same document; its painted pictures are reused
                                              ///< where they fit
};

/// Keeps results that the states of a document share, and the grown plant of each state, up to some hundred megabytes.
/// Only one thread at a time may call it.
class StillMaker {
 public:
  StillMaker();
  ~StillMaker();
  StillMaker(const StillMaker&) = delete;
  StillMaker& operator=(const StillMaker&) = delete;

  /// Returns a list with an object for each state: {"picture": a PNG in base 64, without a background}, or the
  /// {"faults"} of the state. All states have one camera. Meshes and textures are coarse if many details fall on few
  /// pixels. The pictures are equal on any number of threads, and do not depend on earlier calls. Throws Cancelled.
  Value make(const StillSource& source, const StillsRequest& request, const Registry& registry, Progress& progress);

  /// Returns the bytes of grown plants that are kept for the next pictures.
  std::uint64_t kept_bytes() const;

 private:
  struct State;
  struct Lane;
  std::vector<State> grow(const StillSource& source, const StillsRequest& request, const Registry& registry,
                          Progress& progress);

  std::vector<std::unique_ptr<Lane>> lanes_;
  SmallTextures textures_;
};

}  // namespace meristem::studio

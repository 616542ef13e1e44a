// SPDX-License-Identifier: Apache-2.0
// Small pictures of a document with other values: what a value does, at one look. States grow and are drawn side by
// side, and what a state has grown stays for the next pictures, of all states alike.
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

/// What the pictures are made of.
struct StillSource {
  std::string text;
  std::string file;  ///< absolute
  std::string root;
  std::string models;
  double time = 0;                           ///< seconds, of the document
  std::shared_ptr<const GrownWish> grown{};  ///< of the same document, whose painted pictures serve where they fit
};

/// Keeps what the states of a document share, and what each has grown, as far as that takes no more than some hundred
/// megabytes. One thread at a time calls it.
class StillMaker {
 public:
  StillMaker();
  ~StillMaker();
  StillMaker(const StillMaker&) = delete;
  StillMaker& operator=(const StillMaker&) = delete;

  /// A list with an object for each state: {"picture": a PNG in base 64, without a background}, or {"faults"} of the
  /// state. All are seen by one camera. Meshes and textures are coarse where there is much to see in few pixels. The
  /// pictures are equal on any number of threads, whatever was made before. Throws Cancelled.
  Value make(const StillSource& source, const StillsRequest& request, const Registry& registry, Progress& progress);

  /// Bytes of what has grown, that stay for the next pictures.
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

// SPDX-License-Identifier: Apache-2.0
// Streams text and records into a file. Blocks are made on all threads, a limited number at a time, and written in
// their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/atomic_file.h"
#include "meristem/base/frame.h"
#include "meristem/base/function_ref.h"
#include "meristem/base/progress.h"

namespace meristem {

/// Returns true for frames that mirror triangles, whose winding must then be swapped.
inline bool is_mirrored(const Frame& frame) {
  return glm::dot(glm::cross(frame.axes[0], frame.axes[1]), frame.axes[2]) < 0;
}

/// The elements of all frames are numbered consecutively. Calls `body(frame, first, last)` for each frame that has
/// elements in [begin, end), in order. `first` to `last` are numbers of elements within the frame.
template <class Body>
void for_each_run(std::size_t begin, std::size_t end, std::size_t per_frame, Body body) {
  while (begin < end) {
    const std::size_t first = begin % per_frame;
    const std::size_t last = std::min(per_frame, first + (end - begin));
    body(begin / per_frame, first, last);
    begin += last - first;
  }
}

class BlockWriter {
 public:
  static constexpr std::size_t kBlocks = 64;         ///< number of blocks in memory at a time
  static constexpr std::size_t kMaxElements = 4096;  ///< maximum number of elements of one block
  static constexpr std::size_t kBlockBytes = 400'000;

  /// Appends the bytes of elements `begin` to `end` to `out`. Called from any thread.
  using Fill = FunctionRef<void(std::size_t begin, std::size_t end, std::string& out)>;

  BlockWriter(AtomicFile& file, Progress& progress) : file_(file), progress_(progress) {}

  /// Writes `count` elements and counts them as progress. An element has at most `element_bytes`. Blocks are small
  /// enough that all blocks in memory stay below 26 MB.
  void write(std::size_t count, std::size_t element_bytes, Fill fill);

 private:
  AtomicFile& file_;
  Progress& progress_;
  std::vector<std::string> blocks_;  // kept, so that their memory is reused
};

/// Writes `per_frame` elements for each of `frames`. `fill(frame, first, last, out)` appends the bytes of the elements
/// from `first` to `last` of one frame.
template <class Fill>
void write_for_frames(BlockWriter& writer, std::size_t frames, std::size_t per_frame, std::size_t element_bytes,
                      Fill fill) {
  writer.write(frames * per_frame, element_bytes, [&](std::size_t begin, std::size_t end, std::string& out) {
    for_each_run(begin, end, per_frame,
                 [&](std::size_t frame, std::size_t first, std::size_t last) { fill(frame, first, last, out); });
  });
}

}  // namespace meristem

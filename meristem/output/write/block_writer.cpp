// SPDX-License-Identifier: Apache-2.0
// Formats blocks of elements on all threads and writes them in order, so that the bytes do not depend on the number of
// threads.
#include "meristem/output/write/block_writer.h"

#include "meristem/base/parallel.h"

namespace meristem {

void BlockWriter::write(std::size_t count, std::size_t element_bytes, Fill fill) {
  const std::size_t grain = std::clamp<std::size_t>(kBlockBytes / element_bytes, 1, kMaxElements);
  const std::size_t batch = grain * kBlocks;
  for (std::size_t start = 0; start < count; start += batch) {
    const std::size_t size = std::min(batch, count - start);
    const std::size_t blocks = (size + grain - 1) / grain;
    if (blocks_.size() < blocks) blocks_.resize(blocks);
    parallel_for(size, grain, [&](std::size_t begin, std::size_t end) {
      progress_.check();
      std::string& block = blocks_[begin / grain];
      block.clear();
      fill(start + begin, start + end, block);
    });
    for (std::size_t k = 0; k < blocks; ++k) file_.write(blocks_[k]);
    progress_.advance(size);
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/block_writer.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <numeric>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "tests/support/temporary_folder.h"

namespace meristem::block_writer_test {

std::string written(std::size_t count, std::size_t element_bytes, BlockWriter::Fill fill) {
  const TemporaryFolder folder;
  const std::string path = folder / "written";
  Progress progress;
  AtomicFile file(path);
  BlockWriter(file, progress).write(count, element_bytes, fill);
  file.commit();
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(BlockWriter, WritesEveryElementInOrderOnAnyNumberOfThreads) {
  constexpr std::size_t kCount = BlockWriter::kMaxElements * BlockWriter::kBlocks + 5000;  // two batches
  std::string expected;
  for (std::size_t i = 0; i < kCount; ++i) expected += std::to_string(i) + '\n';
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const std::string bytes = written(kCount, 8, [](std::size_t begin, std::size_t end, std::string& out) {
      for (; begin < end; ++begin) out += std::to_string(begin) + '\n';
    });
    EXPECT_TRUE(bytes == expected) << threads << " threads";
  }
}

TEST(BlockWriter, HoldsNoMoreThanItsBlocksHowLargeTheElementsMayBe) {
  for (const std::size_t element : {std::size_t{100}, std::size_t{30'000}, std::size_t{1'000'000}}) {
    const std::size_t bound = BlockWriter::kBlocks * std::max(element, BlockWriter::kBlockBytes);
    const std::size_t count = 3 * bound / element;
    Progress progress;
    AtomicFile file("/dev/null");
    std::atomic<std::size_t> max = 0;
    const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
      out.append((end - begin) * element, 'x');
      const std::size_t held = end * element - file.size();
      for (std::size_t known = max; known < held && !max.compare_exchange_weak(known, held);) continue;
    };
    BlockWriter(file, progress).write(count, element, fill);
    EXPECT_EQ(file.size(), count * element);
    EXPECT_LE(max, bound);
    EXPECT_GE(max, bound / 2);
  }
}

TEST(BlockWriter, RunsOfFramesCoverARangeOnce) {
  std::vector<std::size_t> elements;
  for_each_run(5, 23, 7, [&](std::size_t frame, std::size_t first, std::size_t last) {
    EXPECT_LT(first, last);
    EXPECT_LE(last, 7U);
    for (; first < last; ++first) elements.push_back(frame * 7 + first);
  });
  std::vector<std::size_t> expected(18);
  std::iota(expected.begin(), expected.end(), 5);
  EXPECT_EQ(elements, expected);
}

}  // namespace meristem::block_writer_test

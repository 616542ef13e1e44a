// SPDX-License-Identifier: Apache-2.0
// Common parts of scan writers: parallel formatting of points, and files whose head is written last.
#include "meristem/output/scan/scan_writer.h"

#include <algorithm>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kPointsPerText = 4096;

}  // namespace

void append_points(std::span<const ScanPoint> points, std::string& out,
                   FunctionRef<void(const ScanPoint& point, std::string& out)> append) {
  std::vector<std::string> texts((points.size() + kPointsPerText - 1) / kPointsPerText);
  parallel_for(points.size(), kPointsPerText, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) append(points[k], texts[begin / kPointsPerText]);
  });
  for (const std::string& text : texts) out += text;
}

HeadedFile::HeadedFile(const std::string& path, std::string head) : file_(path) { write(head); }

void HeadedFile::write(const std::string& bytes) {
  if (file_.is_stream()) {
    held_ += bytes;
  } else {
    file_.write(bytes);
  }
}

void HeadedFile::finish(const std::string& head) {
  if (file_.is_stream()) {
    std::copy(head.begin(), head.end(), held_.begin());
    file_.write(held_);
  } else {
    file_.overwrite(0, head);
  }
  file_.commit();
}

}  // namespace meristem

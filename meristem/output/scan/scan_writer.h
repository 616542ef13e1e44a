// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/atomic_file.h"
#include "meristem/base/function_ref.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/output/write/provenance.h"

namespace meristem {

/// The facts in the head of a scan file.
struct ScanHead {
  const Scanner* scanner = nullptr;
  Provenance provenance{};
};

/// Receives the points of a scan block by block.
class ScanWriter {
 public:
  virtual ~ScanWriter() = default;
  virtual void add(std::span<const ScanPoint> points) = 0;
  /// Writes the parts that are known only at the end, and puts the file in place.
  virtual void finish() = 0;
};

std::unique_ptr<ScanWriter> make_scan_ply(const std::string& path, ScanHead head);
std::unique_ptr<ScanWriter> make_scan_las(const std::string& path, ScanHead head);
std::unique_ptr<ScanWriter> make_scan_csv(const std::string& path, ScanHead head);

/// Appends the bytes of each point to a text. The bytes are made on all threads and joined in the order of the points.
void append_points(std::span<const ScanPoint> points, std::string& out,
                   FunctionRef<void(const ScanPoint& point, std::string& out)> append);

/// A file whose head is known only at its end. A stream cannot be overwritten, so its content is held and written at
/// the end.
class HeadedFile {
 public:
  /// `head` must have the length of the final head.
  HeadedFile(const std::string& path, std::string head);
  void write(const std::string& bytes);
  std::size_t size() const { return file_.is_stream() ? held_.size() : file_.size(); }
  void finish(const std::string& head);

 private:
  AtomicFile file_;
  std::string held_;  // held content of a stream
};

}  // namespace meristem

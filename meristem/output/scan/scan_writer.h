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

/// What the head of a file says.
struct ScanHead {
  const Scanner* scanner = nullptr;
  Provenance provenance{};
};

/// Takes the points of a scan as they come.
class ScanWriter {
 public:
  virtual ~ScanWriter() = default;
  virtual void add(std::span<const ScanPoint> points) = 0;
  /// Writes what is known only now, and puts the file in place.
  virtual void finish() = 0;
};

std::unique_ptr<ScanWriter> make_scan_ply(const std::string& path, ScanHead head);
std::unique_ptr<ScanWriter> make_scan_las(const std::string& path, ScanHead head);
std::unique_ptr<ScanWriter> make_scan_csv(const std::string& path, ScanHead head);

/// Appends the bytes of each point to a text, made on all threads and joined in the points' order.
void append_points(std::span<const ScanPoint> points, std::string& out,
                   FunctionRef<void(const ScanPoint& point, std::string& out)> append);

/// A file whose head is known when its end is. A stream, in which nothing can be written over, gets all at the end.
class HeadedFile {
 public:
  /// `head` has the length of the final one.
  HeadedFile(const std::string& path, std::string head);
  void write(const std::string& bytes);
  std::size_t size() const { return file_.is_stream() ? held_.size() : file_.size(); }
  void finish(const std::string& head);

 private:
  AtomicFile file_;
  std::string held_;  // of a stream
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Runs a scan once and passes each block of points to the writers of all files. The table of scan formats stands here.
#include "meristem/output/scan/scan_files.h"

#include <memory>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/output/scan/scan_writer.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

using MakeScanWriter = std::unique_ptr<ScanWriter> (*)(const std::string& path, ScanHead head);

constexpr ScanFormat kScanFormats[] = {
    {".ply", "points with their labels as binary PLY, for CloudCompare, Open3D and MeshLab"},
    {".las", "points with their labels as LAS 1.4, for CloudCompare, PDAL, lidR and LAStools"},
    {".csv", "points with their labels as a table, one row per point"},
};
constexpr MakeScanWriter kScanWriters[] = {make_scan_ply, make_scan_las, make_scan_csv};

std::vector<std::string> scan_endings() {
  std::vector<std::string> endings;
  for (const ScanFormat& format : kScanFormats) endings.emplace_back(format.ending);
  return endings;
}

}  // namespace

std::span<const ScanFormat> scan_formats() { return kScanFormats; }

const ScanFormat& scan_format_of(const std::string& path) {
  if (path == "-") return kScanFormats[0];
  const std::string name = lower_case(path.substr(path.find_last_of('/') + 1));
  for (const ScanFormat& format : kScanFormats) {
    if (name.ends_with(format.ending)) return format;
  }
  const std::size_t dot = name.find_last_of('.');
  throw InputError(
      Diagnostic{.message = dot == std::string::npos
                                ? fmt::format("'{}' has no ending that names a format", path)
                                : fmt::format("'{}' is not a format that scans are written to", name.substr(dot)),
                 .expected = fmt::format("a file that ends in {}", fmt::join(scan_endings(), ", ")),
                 .nearest = dot == std::string::npos ? "" : nearest_name(name.substr(dot), scan_endings())});
}

std::uint64_t write_scan(const Scanner& scanner, std::span<const std::string> paths, const Provenance& provenance,
                         Progress& progress) {
  std::vector<std::unique_ptr<ScanWriter>> writers;
  for (const std::string& path : paths) {
    const auto format = static_cast<std::size_t>(&scan_format_of(path) - kScanFormats);
    writers.push_back(kScanWriters[format](path, {&scanner, provenance}));
  }
  std::uint64_t count = 0;
  const auto take = [&](std::span<const ScanPoint> points) {
    count += points.size();
    for (const std::unique_ptr<ScanWriter>& writer : writers) writer->add(points);
  };
  scanner.run(take, progress);
  FileSet files;
  for (const std::unique_ptr<ScanWriter>& writer : writers) writer->finish();
  files.commit();
  return count;
}

}  // namespace meristem

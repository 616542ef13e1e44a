// SPDX-License-Identifier: Apache-2.0
// Scans as files. Each point has its position, what was measured, and what it is a point of.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "meristem/base/progress.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/output/write/provenance.h"

namespace meristem {

/// A kind of file that scans are written to.
struct ScanFormat {
  std::string_view ending;  ///< with its dot
  std::string_view doc;     ///< one line
};

/// All formats, the default first:
///
/// | ending | what it holds |
/// | --- | --- |
/// | `.ply` | binary little-endian PLY, y up: vertices with all columns, and an element `shoot` with the labels |
/// | `.las` | ASPRS LAS 1.4, point format 6, z up (x east, y north), extra bytes; labels in records of `meristem` |
/// | `.csv` | a row per point, y up, with components and labels as texts |
std::span<const ScanFormat> scan_formats();

/// The format of a path by its ending (capitals count as equal); "-" is standard output in the default format. Throws
/// InputError that names the known endings, and the nearest.
const ScanFormat& scan_format_of(const std::string& path);

/// Takes the scan once and writes all points to each of these files, as they come: memory stays below 300 MB, but for
/// "-" and pipes, which hold PLY and LAS until their number of points is known. Columns: `x`, `y`, `z`; `range`,
/// `true_range`, `intensity` (ScanPoint); `return` and `returns`; `station`; `pulse`; `kind` (SurfaceKind); `tree`,
/// `component`, `instance`, `shoot`, `order` (SurfaceLabel), none being -1, or in LAS 4294967295. Files appear whole or
/// not at all. Returns the number of points. Begins a stage of `progress`, which counts pulses. Throws MachineError
/// (path, disk), InputError for more points than a format counts or positions that LAS cannot hold, Cancelled.
std::uint64_t write_scan(const Scanner& scanner, std::span<const std::string> paths, const Provenance& provenance,
                         Progress& progress);

}  // namespace meristem

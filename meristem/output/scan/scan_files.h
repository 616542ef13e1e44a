// SPDX-License-Identifier: Apache-2.0
// Scans as files. Each point has its position, its measured values, and the label of its surface.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "meristem/base/progress.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/output/write/provenance.h"

namespace meristem {

/// A file format for scans.
struct ScanFormat {
  std::string_view ending;  ///< with its dot
  std::string_view doc;     ///< description in one line
};

/// Returns all formats, the default first:
///
/// | ending | content |
/// | --- | --- |
/// | `.ply` | binary little-endian PLY, y up: vertices with all columns, and an element `shoot` with the labels |
/// | `.las` | ASPRS LAS 1.4, point format 6, z up (x east, y north), extra bytes; labels in records of `meristem` |
/// | `.csv` | a row per point, y up, with components and labels as texts |
std::span<const ScanFormat> scan_formats();

/// Returns the format of a path by its ending (capital letters are equal to small ones). "-" is standard output in the
/// default format. Throws InputError with the known endings and the nearest one.
const ScanFormat& scan_format_of(const std::string& path);

/// Runs the scan once and writes all points to each of these files, block by block. Memory stays below 300 MB, except
/// for "-" and pipes, where PLY and LAS are held until the number of points is known.
///
/// Columns: `x`, `y`, `z`; `range`, `true_range`, `intensity` (ScanPoint); `return` and `returns`; `station`; `pulse`;
/// `kind` (SurfaceKind); `tree`, `component`, `instance`, `shoot`, `order` (SurfaceLabel). A missing object is -1, or
/// 4294967295 in LAS. Files appear whole or not at all. Returns the number of points. Begins a stage of `progress`,
/// which counts pulses. Throws MachineError (path, disk), Cancelled. Throws InputError for more points than a format
/// can count, or positions that LAS cannot store.
std::uint64_t write_scan(const Scanner& scanner, std::span<const std::string> paths, const Provenance& provenance,
                         Progress& progress);

}  // namespace meristem

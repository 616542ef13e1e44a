// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/reader.h"
#include "meristem/plant/file/node_table.h"
#include "meristem/plant/mtg/mtg.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The content of a skeleton file, in either form.
struct SkeletonFile {
  std::string path;
  std::optional<MtgTree> mtg;
  NodeTable table;  ///< used if the file is no MTG
};

/// The upward axis of a file.
enum class UpAxis { file, y, z };

/// The features of an MTG that contain coordinates and diameters.
struct MtgFeatures {
  std::string x = "XX";
  std::string y = "YY";
  std::string z = "ZZ";
  std::string diameter;  ///< empty: TopDia or TopDiameter
};

/// A plant that was measured or grown elsewhere, and the options for reading its file.
struct SkeletonSource {
  Asset<SkeletonFile> file;
  double unit = 1;                      ///< metres per unit of coordinates
  std::optional<double> diameter_unit;  ///< metres per unit of radii or diameters; unset: like `unit`
  UpAxis up = UpAxis::file;
  bool at_origin = true;
  std::optional<int> scale;
  MtgFeatures features;
};

const ParameterTable& skeleton_source_table();  ///< table of SkeletonSource

/// Returns the plant in metres, y up, with radius 0 if the file has none. Returns nothing if the file could not be read
/// or has errors. Errors are reported at `path`, the path of the source, with their lines.
std::optional<Skeleton> read_skeleton(const SkeletonSource& source, const DocumentPath& path, ParameterReader& reader);

/// Sets missing radii by the pipe model, limited by the radius of the bearing wood.
void fill_radii(Skeleton& skeleton, const PipeModel& model);

}  // namespace meristem

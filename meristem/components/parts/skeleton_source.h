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

/// What a file says of a plant's nodes, in either form.
struct SkeletonFile {
  std::string path;
  std::optional<MtgTree> mtg;
  NodeTable table;  ///< where it is no MTG
};

/// Which way is up in a file.
enum class UpAxis { file, y, z };

/// The features of an MTG with coordinates and diameters.
struct MtgFeatures {
  std::string x = "XX";
  std::string y = "YY";
  std::string z = "ZZ";
  std::string diameter;  ///< empty: TopDia or TopDiameter
};

/// A plant that was measured, or grown elsewhere, and how its file is to be read.
struct SkeletonSource {
  Asset<SkeletonFile> file;
  double unit = 1;                      ///< metres that a coordinate of 1 means
  std::optional<double> diameter_unit;  ///< metres that a radius or diameter of 1 means; unset: as `unit`
  UpAxis up = UpAxis::file;
  bool at_origin = true;
  std::optional<int> scale;
  MtgFeatures features;
};

const ParameterTable& skeleton_source_table();  ///< of SkeletonSource

/// The plant in metres, y up, with radius 0 where the file has none. Nothing where the file could not be read, or after
/// faults at `path`, the path of the source, which name the line.
std::optional<Skeleton> read_skeleton(const SkeletonSource& source, const DocumentPath& path, ParameterReader& reader);

/// Nodes without a radius get that of the pipe model, but none thicker than what bears them.
void fill_radii(Skeleton& skeleton, const PipeModel& model);

}  // namespace meristem

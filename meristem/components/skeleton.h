// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "meristem/graph/component.h"
#include "meristem/graph/table/asset.h"
#include "meristem/plant/file/node_table.h"
#include "meristem/plant/mtg/mtg.h"
#include "meristem/plant/plant.h"
#include "meristem/plant/skeleton.h"
#include "meristem/plant/trim.h"

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

/// What is done to a skeleton that was read, in this order.
struct SkeletonFinish {
  double decimate = 0;   ///< metres; 0 keeps all nodes
  bool relax = false;    ///< softens the angles of forks
  double subdivide = 0;  ///< metres; 0 keeps the nodes as they are
};

/// A plant that was measured, or grown elsewhere.
struct SkeletonFromFile : ComponentBase {
  Asset<SkeletonFile> file;
  double unit = 1;                      ///< metres that a coordinate of 1 means
  std::optional<double> diameter_unit;  ///< metres that a radius or diameter of 1 means; unset: as `unit`
  UpAxis up = UpAxis::file;
  bool at_origin = true;
  std::optional<int> scale;
  MtgFeatures features;
  double tip_radius = 0.002;
  double pipe_exponent = 2.4;
  SkeletonFinish finish;
  Surface surface;
  TrimMode trim = TrimMode::cut;               ///< what a body around its stems does to them
  std::shared_ptr<const Skeleton> skeleton{};  ///< what all of the above come to
};

ComponentType skeleton_component();

}  // namespace meristem

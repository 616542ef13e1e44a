// SPDX-License-Identifier: Apache-2.0
// The leaves that a grass component draws its own from: fitted once, when its document is read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/graph/asset.h"
#include "meristem/graph/parameter.h"
#include "meristem/shape/grass/fit_leaf.h"
#include "meristem/shape/grass/midrib_family.h"

namespace meristem {

/// A midrib at one age, as a document has it.
struct AgedPoints {
  double age = 0;
  std::vector<Vec2> points;
};

/// Where midribs and widths come from.
struct GrassSource {
  Asset<std::vector<MeasuredCurve>> midrib;
  std::vector<Vec2> midrib_points;  ///< in its stead: one curve
  std::vector<AgedPoints> midribs;  ///< or one at each of several ages
  Asset<std::vector<MeasuredCurve>> widths;
  Curve profile{{{0.0F, 0.7F}, {0.12F, 0.88F}, {0.35F, 1.0F}, {0.65F, 0.82F}, {0.85F, 0.47F}, {1.0F, 0.0F}}};
  double unit = 0.01;  ///< metres, of the files
  FitOptions fit;
};

/// A midrib with what is known of it.
struct StockedMidrib {
  std::optional<int> rank, leaf;
  GrassLeaf form;  ///< full grown: at age 1, or the last one of a family
  MidribFamily family;
  double length = 0;  ///< as measured, in the source's unit
};

struct StockedWidths {
  std::optional<int> rank, leaf;
  FittedWidths fitted;
};

/// All that a source has.
struct GrassStock {
  std::vector<StockedMidrib> midribs;
  std::vector<StockedWidths> widths;

  /// Of a rank, and of a leaf of it if one is asked for: indices, none if there is no such. What has no ranks suits
  /// all.
  std::vector<std::uint32_t> midribs_of(int rank, std::optional<int> leaf) const;
  /// The widths for a rank; those of the same leaf where there are such. Nothing if there is no such rank.
  std::optional<std::uint32_t> widths_of(int rank, std::optional<int> leaf) const;
  /// The ranks that there are, for messages: "1, 2, 3".
  std::string ranks() const;
};

/// Fits all of it. `is_loaded` false takes the built-in leaf instead, `is_fitted` false joins points by lines. Throws
/// InputError for ages that come twice.
GrassStock make_stock(const GrassSource& source, bool is_loaded, bool is_fitted);

const ParameterTable& grass_source_table();

}  // namespace meristem

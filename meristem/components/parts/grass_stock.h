// SPDX-License-Identifier: Apache-2.0
// The leaves that a grass component draws its own from: fitted once, when its document is read.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/fingerprint.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/shape/grass/fit_leaf.h"
#include "meristem/shape/grass/midrib_family.h"

namespace meristem {

/// A midrib at one age, as a document has it.
struct AgedPoints {
  double age = 0;
  std::vector<Vec2> points;
};

/// Sources of midribs and widths.
struct GrassSource {
  Asset<std::vector<MeasuredCurve>> midrib;
  std::vector<Vec2> midrib_points;  ///< instead of the file: one curve
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
  double length = 0;  ///< as measured, in the source's unit; 0 where the source is no file
};

struct StockedWidths {
  std::optional<int> rank, leaf;
  FittedWidths fitted;
};

/// Finds curves by rank and leaf. What has no ranks suits all ranks, and what has no leaves all leaves.
class StockIndex {
 public:
  template <class Stocked>
  explicit StockIndex(const std::vector<Stocked>& all) {
    for (std::uint32_t k = 0; k < all.size(); ++k) add(all[k].rank, all[k].leaf, k);
    sort();
  }
  /// The entries of a rank, and of one leaf of the rank if one is asked for; empty if there is none. Cost: logarithmic.
  std::span<const std::uint32_t> find(int rank, std::optional<int> leaf = {}) const;
  const std::vector<int>& ranks() const { return ranks_; }  ///< that there are, rising

 private:
  void add(std::optional<int> rank, std::optional<int> leaf, std::uint32_t index);
  void sort();

  bool has_ranks_ = false, has_leaves_ = false;
  std::vector<std::pair<int, int>> names_;  // rank and leaf, sorted
  std::vector<std::uint32_t> indices_;      // in that order
  std::vector<int> ranks_;
};

/// All that a source has.
struct GrassStock {
  explicit GrassStock(std::vector<StockedMidrib> all_midribs, std::vector<StockedWidths> all_widths)
      : midribs(std::move(all_midribs)), widths(std::move(all_widths)), midrib_index(midribs), width_index(widths) {}

  std::vector<StockedMidrib> midribs;
  std::vector<StockedWidths> widths;
  StockIndex midrib_index, width_index;
};

/// How a stock is made.
struct StockOptions {
  bool is_loaded = true;  ///< else the built-in leaf stands in for what the source has
  bool is_fitted = true;  ///< else points are joined by lines
  double full_age = 1;    ///< at which a leaf has its form, where midribs have no ages
};

/// All that make_stock depends on, points of files with it.
Fingerprint fingerprint_of(const GrassSource& source, const StockOptions& options);

/// Fits all of it. Throws InputError for midribs that stand alone at an age of 0 or less, and for faults of curves.
GrassStock make_stock(const GrassSource& source, const StockOptions& options);

/// The midribs of a source, those that documents hold as measured ones; the built-in leaf's where it has none.
std::vector<MeasuredCurve> measured_midribs(const GrassSource& source);

/// The points of a document's midrib as a measured one.
MeasuredCurve curve_of(const std::vector<Vec2>& points);

const ParameterTable& grass_source_table();

}  // namespace meristem

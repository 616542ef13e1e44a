// SPDX-License-Identifier: Apache-2.0
// The leaves that a grass component uses as models. They are fitted once, when the document is read.
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

/// A midrib at one age, as given in a document.
struct AgedPoints {
  double age = 0;
  std::vector<Vec2> points;
};

/// Sources of midribs and widths.
struct GrassSource {
  Asset<std::vector<MeasuredCurve>> midrib;
  std::vector<Vec2> midrib_points;  ///< one curve, instead of the file
  std::vector<AgedPoints> midribs;  ///< curves at several ages, instead of the file
  Asset<std::vector<MeasuredCurve>> widths;
  Curve profile{{{0.0F, 0.7F}, {0.12F, 0.88F}, {0.35F, 1.0F}, {0.65F, 0.82F}, {0.85F, 0.47F}, {1.0F, 0.0F}}};
  double unit = 0.01;  ///< metres per unit of the files
  FitOptions fit;
};

/// A fitted midrib with its metadata.
struct StockedMidrib {
  std::optional<int> rank, leaf;
  GrassLeaf form;  ///< full grown: at age 1, or at the last age of a family
  MidribFamily family;
  double length = 0;  ///< measured length in the source's unit; 0 without a file
};

struct StockedWidths {
  std::optional<int> rank, leaf;
  FittedWidths fitted;
};

/// Finds curves by rank and leaf. Curves without ranks match all ranks, and curves without leaves match all leaves.
class StockIndex {
 public:
  template <class Stocked>
  explicit StockIndex(const std::vector<Stocked>& all) {
    for (std::uint32_t k = 0; k < all.size(); ++k) add(all[k].rank, all[k].leaf, k);
    sort();
  }
  /// Returns the entries of a rank, or of one leaf of the rank. Empty if the rank or leaf does not exist. Cost:
  /// logarithmic.
  std::span<const std::uint32_t> find(int rank, std::optional<int> leaf = {}) const;
  const std::vector<int>& ranks() const { return ranks_; }  ///< existing ranks, in rising order

 private:
  void add(std::optional<int> rank, std::optional<int> leaf, std::uint32_t index);
  void sort();

  bool has_ranks_ = false, has_leaves_ = false;
  std::vector<std::pair<int, int>> names_;  // rank and leaf, sorted
  std::vector<std::uint32_t> indices_;      // in the order of names_
  std::vector<int> ranks_;
};

/// All curves of a source.
struct GrassStock {
  explicit GrassStock(std::vector<StockedMidrib> all_midribs, std::vector<StockedWidths> all_widths)
      : midribs(std::move(all_midribs)), widths(std::move(all_widths)), midrib_index(midribs), width_index(widths) {}

  std::vector<StockedMidrib> midribs;
  std::vector<StockedWidths> widths;
  StockIndex midrib_index, width_index;
};

/// Options of making a stock.
struct StockOptions {
  bool is_loaded = true;  ///< false: the built-in leaf replaces the source
  bool is_fitted = true;  ///< false: straight lines join the points
  double full_age = 1;    ///< age of a full-grown leaf, for midribs without ages
};

/// Returns a fingerprint of all inputs of make_stock(), including the points of files.
Fingerprint fingerprint_of(const GrassSource& source, const StockOptions& options);

/// Fits all curves. Throws InputError for a single midrib with an age of 0 or less, and for errors of curves.
GrassStock make_stock(const GrassSource& source, const StockOptions& options);

/// Returns the midribs of a source as measured curves, including midribs in documents. Returns the built-in leaf's if
/// the source has none.
std::vector<MeasuredCurve> measured_midribs(const GrassSource& source);

/// Returns the points of a document's midrib as a measured curve.
MeasuredCurve curve_of(const std::vector<Vec2>& points);

const ParameterTable& grass_source_table();

}  // namespace meristem

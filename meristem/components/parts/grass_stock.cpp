// SPDX-License-Identifier: Apache-2.0
// Fits the midribs and widths of a source, groups them by leaf and age, and indexes them by rank and leaf.
#include "meristem/components/parts/grass_stock.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/math.h"
#include "meristem/graph/table/curve_range.h"
#include "meristem/graph/table/table.h"

namespace meristem {

namespace {

/// Returns the built-in midrib: it leaves the stem at 20° and arches over.
std::vector<Vec2> arching_midrib() {
  std::vector<Vec2> points{{0, 0}};
  constexpr int kPieces = 12;
  for (int k = 0; k < kPieces; ++k) {
    const double place = (k + 0.5) / kPieces;
    const double angle = radians(20 + 85 * place * place);
    points.push_back(points.back() + Vec2(math::sin(angle), math::cos(angle)) / static_cast<float>(kPieces));
  }
  return points;
}

/// Returns a leaf with a single midrib: its form at the curve's age, or at `full_age`.
StockedMidrib stocked(const MeasuredCurve& curve, const FitOptions& options, double full_age) {
  const double age = curve.age.value_or(full_age);
  if (!(age > 0)) {
    throw InputError(Diagnostic{.message = fmt::format("the only midrib of a leaf has the age {}", age),
                                .expected = "an age above 0, or midribs at several ages",
                                .line = curve.lines.empty() ? 0 : curve.lines.front()});
  }
  FittedMidrib fitted = fit_midrib(curve, options);
  MidribFamily family(fitted.leaf, age);
  return {curve.rank, curve.lindex, std::move(fitted.leaf), std::move(family), fitted.length};
}

/// Returns a leaf with midribs at several ages.
StockedMidrib stocked(const std::vector<const MeasuredCurve*>& curves, const FitOptions& options) {
  std::vector<std::pair<double, GrassLeaf>> midribs;
  double length = 0;
  for (const MeasuredCurve* curve : curves) {
    FittedMidrib fitted = fit_midrib(*curve, options);
    midribs.emplace_back(*curve->age, std::move(fitted.leaf));
    length = fitted.length;
  }
  const MeasuredCurve& last = *curves.back();
  return {last.rank, last.lindex, midribs.back().second, MidribFamily(midribs), length};
}

/// Groups the midribs of each leaf by age.
std::vector<StockedMidrib> stock_midribs(const std::vector<MeasuredCurve>& curves, const FitOptions& options,
                                         double full_age) {
  std::vector<StockedMidrib> midribs;
  using Name = std::pair<std::optional<int>, std::optional<int>>;
  std::map<Name, std::vector<const MeasuredCurve*>> families;
  for (const MeasuredCurve& curve : curves) {
    if (!curve.age) {
      midribs.push_back(stocked(curve, options, full_age));
    } else {
      families[{curve.rank, curve.lindex}].push_back(&curve);
    }
  }
  for (auto& [name, family] : families) {
    std::ranges::stable_sort(family, {}, [](const MeasuredCurve* curve) { return *curve->age; });
    midribs.push_back(family.size() == 1 ? stocked(*family.front(), options, full_age) : stocked(family, options));
  }
  return midribs;
}

std::vector<MeasuredCurve> curves_of(const std::vector<AgedPoints>& midribs) {
  std::vector<MeasuredCurve> curves;
  for (const AgedPoints& midrib : midribs) {
    curves.push_back(curve_of(midrib.points));
    curves.back().age = midrib.age;
  }
  return curves;
}

FittedWidths widths_of_curve(const Curve& profile, int pieces) {
  FittedWidths fitted{.r = {}, .width = 1, .length = 1, .are_shares = true};
  double largest = 0;
  for (int k = 0; k <= pieces; ++k) {
    fitted.r.push_back(std::max(0.0, profile(static_cast<double>(k) / pieces)));
    largest = std::max(largest, fitted.r.back());
  }
  if (largest == 0) {
    // The whole width is between two sample points.
    const auto widest = std::ranges::max_element(profile.points(), {}, [](Vec2 point) { return point.y; });
    fitted.r[static_cast<std::size_t>(widest->x * static_cast<float>(pieces) + 0.5F)] = largest = 1;
  }
  for (double& share : fitted.r) share /= largest;
  return fitted;
}

const ParameterTable& fit_table() {
  static const ParameterTable table =
      Table<FitOptions>("a fit", "How closely fitted curves follow the measured points.")
          .number("smoothing", &FitOptions::smoothing, {.min = 0, .max = 1, .usual = {0, 0.02}, .fixed = true},
                  "Tolerance of fitted midribs: mean distance from the measured points, as a share of the length; "
                  "raised, smoother; 0 joins the points by lines.")
          .number("width_smoothing", &FitOptions::width_smoothing,
                  {.min = 0, .max = 1, .usual = {0, 0.1}, .fixed = true},
                  "Tolerance of fitted widths: mean distance from the measured ones, as a share of the largest; "
                  "raised, smoother.")
          .integer("pieces", &FitOptions::pieces, {.min = 4, .max = 1000, .fixed = true},
                   "Number of equal pieces of a fitted midrib; raised, it follows the curve more closely before it is "
                   "reduced.");
  return table;
}

const ParameterTable& aged_points_table() {
  static const ParameterTable table =
      Table<AgedPoints>("a midrib", "A midrib at an age.")
          .number("age", &AgedPoints::age, {.min = -1e4, .max = 1e4, .usual = {0, 1}, .fixed = true},
                  "Age at which the leaf has this midrib, in the unit of the leaf's own age.")
          .points("points", &AgedPoints::points, {.min = -1e4, .max = 1e4},
                  "Points [x, y] along the midrib from the collar: x away from the stem, y up the stem, of any size.")
          .required();
  return table;
}

std::vector<MeasuredCurve> read_midrib_file(const std::string& text, const std::string&, ParameterReader& reader,
                                            std::vector<Diagnostic>& warnings) {
  return read_midribs(text, reader.limits(), warnings);
}

std::vector<MeasuredCurve> read_width_file(const std::string& text, const std::string&, ParameterReader& reader,
                                           std::vector<Diagnostic>& warnings) {
  return read_widths(text, reader.limits(), warnings);
}

}  // namespace

std::vector<MeasuredCurve> measured_midribs(const GrassSource& source) {
  if (source.midrib) return *source.midrib;
  if (!source.midribs.empty()) return curves_of(source.midribs);
  return {curve_of(source.midrib_points.empty() ? arching_midrib() : source.midrib_points)};
}

MeasuredCurve curve_of(const std::vector<Vec2>& points) {
  MeasuredCurve curve;
  curve.points.assign(points.begin(), points.end());
  return curve;
}

void StockIndex::add(std::optional<int> rank, std::optional<int> leaf, std::uint32_t index) {
  has_ranks_ = has_ranks_ || rank;
  has_leaves_ = has_leaves_ || leaf;
  names_.emplace_back(rank.value_or(0), leaf.value_or(0));
  indices_.push_back(index);
  if (rank) ranks_.push_back(*rank);
}

void StockIndex::sort() {
  std::ranges::stable_sort(indices_, {}, [&](std::uint32_t index) { return names_[index]; });
  std::ranges::sort(names_);
  std::ranges::sort(ranks_);
  ranks_.erase(std::unique(ranks_.begin(), ranks_.end()), ranks_.end());
}

std::span<const std::uint32_t> StockIndex::find(int rank, std::optional<int> leaf) const {
  if (!has_ranks_) rank = 0;
  if (!has_leaves_) leaf.reset();
  const std::pair low(rank, leaf.value_or(std::numeric_limits<int>::min()));
  const std::pair high(rank, leaf.value_or(std::numeric_limits<int>::max()));
  const auto first = std::ranges::lower_bound(names_, low), last = std::ranges::upper_bound(names_, high);
  return std::span(indices_).subspan(static_cast<std::size_t>(first - names_.begin()),
                                     static_cast<std::size_t>(last - first));
}

Fingerprint fingerprint_of(const GrassSource& source, const StockOptions& options) {
  Fingerprint key;
  const auto add_curves = [&](const Asset<std::vector<MeasuredCurve>>& curves) {
    key.add(curves ? curves->size() : 0);
    if (!curves) return;
    for (const MeasuredCurve& curve : *curves) {
      key.add(curve.rank.has_value()).add(curve.rank.value_or(0));
      key.add(curve.lindex.has_value()).add(curve.lindex.value_or(0));
      key.add(curve.age.has_value()).add(curve.age.value_or(0));
      key.add_array(curve.points).add_array(curve.lines);
    }
  };
  add_curves(source.midrib);
  add_curves(source.widths);
  key.add_array(source.midrib_points).add(source.midribs.size());
  for (const AgedPoints& midrib : source.midribs) key.add(midrib.age).add_array(midrib.points);
  key.add_array(source.profile.points()).add(source.profile.kind()).add(source.unit);
  key.add(source.fit.smoothing).add(source.fit.width_smoothing).add(source.fit.pieces);
  return key.add(options.is_loaded).add(options.is_fitted).add(options.full_age);
}

GrassStock make_stock(const GrassSource& source, const StockOptions& how) {
  const GrassSource plain{.fit = source.fit};
  const GrassSource& used = how.is_loaded ? source : plain;
  FitOptions options = source.fit;
  if (!how.is_fitted) options.smoothing = options.width_smoothing = 0;
  std::vector<StockedWidths> widths;
  if (!used.widths) {
    widths.push_back({{}, {}, widths_of_curve(used.profile, options.pieces)});
  } else {
    for (const MeasuredCurve& curve : *used.widths) {
      widths.push_back({curve.rank, curve.lindex, fit_widths(curve, options)});
    }
  }
  std::vector<StockedMidrib> midribs = stock_midribs(measured_midribs(used), options, how.full_age);
  if (!used.midrib) {
    for (StockedMidrib& midrib : midribs) midrib.length = 0;
  }
  return GrassStock(std::move(midribs), std::move(widths));
}

const ParameterTable& grass_source_table() {
  static const ParameterTable table = with_curve_range(
      Table<GrassSource>("a grass leaf", "Sources of midribs and widths.")
          .text_file("midrib", &GrassSource::midrib, read_midrib_file,
                     "CSV file of digitised midribs with columns x (away from the stem) and y (up), and rank, lindex "
                     "and age if there are several.")
          .points("midrib_points", &GrassSource::midrib_points, {.min = -1e4, .max = 1e4},
                  "Points [x, y] along one midrib from the collar: x away from the stem, y up the stem, of any size.")
          .list("midribs", &GrassSource::midribs, aged_points_table,
                "Midribs of one leaf at several ages, in the order of their ages.")
          .text_file("widths", &GrassSource::widths, read_width_file,
                     "CSV file of widths with columns s (distance from the base, or share of the length) and r, and "
                     "rank (or rankclass) and lindex if there are several.")
          .curve("profile", &GrassSource::profile,
                 "Width of the blade from base (0) to tip (1), as a share of the largest width.")
          .number("unit", &GrassSource::unit,
                  {.unit = Unit::metre, .min = 1e-6, .max = 1000, .usual = {0.001, 1}, .fixed = true},
                  "Length of one unit of the measured files.")
          .object("fit", &GrassSource::fit, fit_table, "How closely fitted curves follow the measured points.")
          .never_with("midrib", {"midrib_points", "midribs"})
          .never_with("midribs", {"midrib_points"})
          .never_with("widths", {"profile"})
          .only_where({{"widths"}}, {"fit.width_smoothing"}),
      "profile", 0);
  return table;
}

}  // namespace meristem

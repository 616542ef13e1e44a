// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/grass_curves.h"

#include <algorithm>

#include "meristem/components/parts/grassleaf_table.h"

namespace meristem {

namespace {

using CurveName = GrassCurves::Name;

CurveName name_of(const MeasuredCurve& curve) { return {curve.rank, curve.lindex}; }

bool suits(const CurveName& curve, std::optional<int> rank, std::optional<int> leaf) {
  return (!rank || !curve.rank || *rank == *curve.rank) && (!leaf || !curve.leaf || *leaf == *curve.leaf);
}

/// Returns the curve of a leaf, the one with the largest age if there are several. Otherwise returns the first curve of
/// the rank, or else the first curve.
const MeasuredCurve* curve_for(const std::vector<MeasuredCurve>& curves, std::optional<int> rank,
                               std::optional<int> leaf) {
  const MeasuredCurve* found = nullptr;
  for (const MeasuredCurve& curve : curves) {
    if (!suits(name_of(curve), rank, leaf)) continue;
    const bool is_later =
        found != nullptr && name_of(*found) == name_of(curve) && curve.age && *curve.age > *found->age;
    if (found == nullptr || is_later) found = &curve;
  }
  if (found != nullptr || curves.empty()) return found;
  return leaf ? curve_for(curves, rank, {}) : &curves.front();
}

void add_midrib(const MeasuredCurve& measured, const FitOptions& fit, GrassCurves& curves) {
  const glm::dvec2 first = measured.points.front();
  for (const glm::dvec2 point : measured.points) curves.midrib_points.emplace_back(Vec2(point - first));
  const FittedMidrib fitted = fit_midrib(measured, fit);
  for (std::size_t k = 0; k < fitted.leaf.point_count(); ++k)
    curves.midrib.emplace_back(fitted.length * fitted.leaf.x[k], fitted.length * fitted.leaf.y[k]);
  curves.midrib_distance = fitted.distance;
}

FittedWidths add_widths(MeasuredCurve measured, const FitOptions& fit, GrassCurves& curves) {
  turn_to_base(measured);
  FittedWidths fitted = fit_widths(measured, fit);
  const double length = fitted.length > 0 ? fitted.length : 1;
  for (const glm::dvec2 point : measured.points)
    curves.width_points.emplace_back(point.x / length, point.y / fitted.width);
  const auto pieces = static_cast<double>(fitted.r.size() - 1);
  for (std::size_t k = 0; k < fitted.r.size(); ++k)
    curves.widths.emplace_back(static_cast<double>(k) / pieces, fitted.r[k]);
  return fitted;
}

}  // namespace

std::optional<GrassCurves> grass_curves(const Prototype& component, std::optional<int> rank, std::optional<int> leaf) {
  if (component.type->name != "grassleaf") return std::nullopt;
  const GrassSource& source = static_cast<const Grassleaf*>(component.parameters.get())->source;
  GrassCurves curves;
  curves.has_midrib_file = static_cast<bool>(source.midrib);
  curves.has_width_file = static_cast<bool>(source.widths);
  const std::vector<MeasuredCurve> midribs = measured_midribs(source);
  for (const MeasuredCurve& midrib : midribs) {
    if (std::ranges::count(curves.leaves, name_of(midrib)) == 0) curves.leaves.push_back(name_of(midrib));
  }
  const MeasuredCurve& midrib = *curve_for(midribs, rank, leaf);
  curves.leaf = name_of(midrib);
  add_midrib(midrib, source.fit, curves);
  double midrib_length = 0;
  for (std::size_t k = 1; k < curves.midrib.size(); ++k)
    midrib_length += glm::distance(curves.midrib[k - 1], curves.midrib[k]);
  if (curves.has_midrib_file) curves.length = source.unit * midrib_length;
  const MeasuredCurve* widths = source.widths ? curve_for(*source.widths, curves.leaf.rank, curves.leaf.leaf) : nullptr;
  if (widths == nullptr) {
    for (const Vec2 point : source.profile.points()) curves.width_points.push_back(point);
    for (int k = 0; k <= source.fit.pieces; ++k) {
      const float place = static_cast<float>(k) / static_cast<float>(source.fit.pieces);
      curves.widths.emplace_back(place, std::max(0.0F, static_cast<float>(source.profile(place))));
    }
    return curves;
  }
  const FittedWidths fitted = add_widths(*widths, source.fit, curves);
  if (!fitted.are_shares) curves.length = source.unit * fitted.length;
  if (!fitted.are_widths_shares()) curves.width = source.unit * fitted.width;
  return curves;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "meristem/measure/measures.h"

namespace meristem {
namespace {

template <class T>
MeasureValue shown(const std::optional<T>& value) {
  return value ? MeasureValue(*value) : MeasureValue();
}

template <class T>
MeasureValue shown(const std::vector<T>& values) {
  return values;
}

MeasureValue shown(std::uint64_t value) { return value; }
MeasureValue shown(double value) { return value; }

/// A member as it stands.
template <auto Member>
MeasureValue member(const Measures& measures) {
  return shown(measures.*Member);
}

/// An angle, in degrees.
template <std::optional<double> Measures::*Angle>
MeasureValue angle(const Measures& measures) {
  const std::optional<double>& radians = measures.*Angle;
  return radians ? MeasureValue(degrees(*radians)) : MeasureValue();
}

/// One figure of a distribution, nothing where it is one of no numbers.
template <Distribution Measures::*Samples, double Distribution::*Figure>
MeasureValue figure(const Measures& measures) {
  const Distribution& samples = measures.*Samples;
  return samples.count > 0 ? MeasureValue(samples.*Figure) : MeasureValue();
}

template <double Distribution::*Figure>
MeasureValue branching_angle(const Measures& measures) {
  const Distribution& angles = measures.branching_angle;
  return angles.count > 0 ? MeasureValue(degrees(angles.*Figure)) : MeasureValue();
}

template <Distribution Measures::*Samples>
MeasureValue count_of(const Measures& measures) {
  return shown(std::uint64_t{(measures.*Samples).count});
}

constexpr std::array kRows = {
    MeasureRow{"trees", "", "Roots of skeletons: each is a tree.", member<&Measures::trees>},
    MeasureRow{"nodes", "", "Points of the skeletons, roots included.", member<&Measures::nodes>},
    MeasureRow{"metamers", "", "Internodes: the segments between nodes, unless the growth model numbers its metamers.",
               member<&Measures::metamers>},
    MeasureRow{"tips", "", "Nodes without children.", member<&Measures::tips>},
    MeasureRow{"forks", "", "Nodes with more than one child.", member<&Measures::forks>},
    MeasureRow{"axes", "", "Stems and branches.", member<&Measures::axes>},
    MeasureRow{"order_histogram", "", "Axes of each branching order, from 0.", member<&Measures::axes_by_order>},
    MeasureRow{"length", "m", "Of all axes, laid end to end.", member<&Measures::length>},
    MeasureRow{"length_by_order", "m", "Of the axes of each branching order, from 0.",
               member<&Measures::length_by_order>},
    MeasureRow{"height", "m", "Of the highest node above the root.", member<&Measures::height>},
    MeasureRow{"crown_height", "m", "Of the highest node above the first fork; the crown is what lies past that fork.",
               member<&Measures::crown_height>},
    MeasureRow{"crown_width", "m", "Largest horizontal distance between nodes of the crown.",
               member<&Measures::crown_width>},
    MeasureRow{"crown_mean_width", "m", "The crown's horizontal extent, averaged over all directions.",
               member<&Measures::crown_mean_width>},
    MeasureRow{"crown_ground_area", "m²", "Of the convex outline of the crown's nodes, seen from above.",
               member<&Measures::crown_ground_area>},
    MeasureRow{"crown_hull_area", "m²", "Of the convex hull of the crown's nodes.", member<&Measures::crown_hull_area>},
    MeasureRow{"crown_hull_volume", "m³", "Within the convex hull of the crown's nodes.",
               member<&Measures::crown_hull_volume>},
    MeasureRow{"lit_share", "",
               "Share of the crown's hull that the sun lights, past obstacles: the mean over its positions.",
               member<&Measures::lit_share>},
    MeasureRow{"stem_diameter", "m", "Where the main axis is 1.3 m above the root.", member<&Measures::stem_diameter>},
    MeasureRow{"slenderness", "", "Height over stem diameter.", member<&Measures::slenderness>},
    MeasureRow{"inclination_azimuth", "°", "Of the sum of all segments as vectors, from north over east.",
               angle<&Measures::inclination_azimuth>},
    MeasureRow{"inclination_altitude", "°", "Of that sum over the horizon: 90 upright.",
               angle<&Measures::inclination_altitude>},
    MeasureRow{"centroid_azimuth", "°", "Of the mean of all nodes, seen from the root, from north over east.",
               angle<&Measures::centroid_azimuth>},
    MeasureRow{"centroid_radius", "m", "Horizontal distance of the mean of all nodes from the root.",
               member<&Measures::centroid_radius>},
    MeasureRow{"branching_angle_mean", "°",
               "Between a lateral's first segment and the mother's segment that ends at the fork; laterals on the root "
               "and segments without length do not count.",
               branching_angle<&Distribution::mean>},
    MeasureRow{"branching_angle_spread", "°", "Standard deviation of these angles.",
               branching_angle<&Distribution::spread>},
    MeasureRow{"branching_angle_low", "°", "5 % of these angles are smaller.", branching_angle<&Distribution::low>},
    MeasureRow{"branching_angle_median", "°", "Half of these angles are smaller.",
               branching_angle<&Distribution::median>},
    MeasureRow{"branching_angle_high", "°", "5 % of these angles are larger.", branching_angle<&Distribution::high>},
    MeasureRow{"branching_angle_count", "", "How many angles these are.", count_of<&Measures::branching_angle>},
    MeasureRow{"strahler_streams", "",
               "Runs of nodes of each Strahler number, from 1 (tips); where two or more of the largest number meet, it "
               "rises by one.",
               member<&Measures::strahler_streams>},
    MeasureRow{"bifurcation_ratios", "", "Streams of each Strahler number over those of the next.",
               member<&Measures::bifurcation_ratios>},
    MeasureRow{"bifurcation_ratio", "", "Geometric mean of all bifurcation ratios.",
               member<&Measures::bifurcation_ratio>},
    MeasureRow{"pipe_exponent", "",
               "Median over forks of the n with which the parent's radius to the power of n is the sum of its "
               "children's.",
               figure<&Measures::pipe_exponent, &Distribution::median>},
    MeasureRow{"pipe_exponent_low", "", "5 % of these exponents are smaller.",
               figure<&Measures::pipe_exponent, &Distribution::low>},
    MeasureRow{"pipe_exponent_high", "", "5 % of these exponents are larger.",
               figure<&Measures::pipe_exponent, &Distribution::high>},
    MeasureRow{"pipe_exponent_count", "", "How many forks have such an exponent.", count_of<&Measures::pipe_exponent>},
    MeasureRow{"pipe_exponent_none", "",
               "Forks that have none: a child is as thick as its parent, or the exponent would be above 100.",
               member<&Measures::pipe_unsolved>},
    MeasureRow{"area_ratio_median", "",
               "Over forks from 2 cm thickness (`--fork-diameter`): the children's cross-sections over the parent's; 1 "
               "keeps the area.",
               figure<&Measures::area_ratio, &Distribution::median>},
    MeasureRow{"area_ratio_low", "", "5 % of these ratios are smaller.",
               figure<&Measures::area_ratio, &Distribution::low>},
    MeasureRow{"area_ratio_high", "", "5 % of these ratios are larger.",
               figure<&Measures::area_ratio, &Distribution::high>},
    MeasureRow{"area_ratio_count", "", "How many forks these are.", count_of<&Measures::area_ratio>},
    MeasureRow{"leaf_count", "", "Organs with a two-sided material, as `leaf` makes them.",
               member<&Measures::leaf_count>, true},
    MeasureRow{"leaf_area", "m²", "Of all leaves, one side, their stalks' surface included.",
               member<&Measures::leaf_area>, true},
    MeasureRow{"leaf_area_index", "", "Leaf area over `crown_ground_area`.", member<&Measures::leaf_area_index>, true},
    MeasureRow{"leaf_exposure", "",
               "Share of the scene's light that comes to the leaves, past stems, organs and obstacles: the mean over "
               "their area (`--light`).",
               member<&Measures::leaf_exposure>, true},
    MeasureRow{"leaf_irradiance", "",
               "The same by how squarely it meets them: what matt leaves take up, against leaves that face all light "
               "unshaded (`--light`).",
               member<&Measures::leaf_irradiance>, true},
    MeasureRow{"thickened_below", "m",
               "Radius to which blended surfaces thicken what is thinner, as their cells could not hold it.",
               member<&Measures::thickened_below>, true},
    MeasureRow{"thickened_length", "", "Share of the length of blended stems that is thicker for it.",
               member<&Measures::thickened_length>, true},
    MeasureRow{"thickened_volume", "", "Volume that blended stems gain by it, over their own.",
               member<&Measures::thickened_volume>, true},
    MeasureRow{"triangles", "", "Of all surfaces, each instance counted.", member<&Measures::triangles>, true},
    MeasureRow{"instances", "", "Surfaces and organs as they stand in the scene.", member<&Measures::instances>, true},
    MeasureRow{"bytes", "B", "Of geometry in memory: each distinct mesh once, and a frame for each instance.",
               member<&Measures::bytes>, true},
};

constexpr bool is_of_trees(const MeasureRow& row) { return !row.only_whole; }

}  // namespace

std::span<const MeasureRow> measure_rows() { return kRows; }

std::span<const MeasureRow> tree_measure_rows() {
  static_assert(std::is_partitioned(kRows.begin(), kRows.end(), is_of_trees));
  static constexpr std::size_t kCount = std::count_if(kRows.begin(), kRows.end(), is_of_trees);
  return std::span(kRows).first(kCount);
}

}  // namespace meristem

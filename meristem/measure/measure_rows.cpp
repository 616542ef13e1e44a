// SPDX-License-Identifier: Apache-2.0
// The table of all measures as users see them: name, unit, sentence, and a function that reads the value. Angles are
// shown in degrees. Text, JSON, Python and the manual use this table.
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

/// Returns a member unchanged.
template <auto Member>
MeasureValue member(const Measures& measures) {
  return shown(measures.*Member);
}

/// Returns an angle in degrees.
template <std::optional<double> Measures::*Angle>
MeasureValue angle(const Measures& measures) {
  const std::optional<double>& radians = measures.*Angle;
  return radians ? MeasureValue(degrees(*radians)) : MeasureValue();
}

/// Returns one figure of a distribution, or no value if the distribution has no numbers.
template <SampleStatistics Measures::*Samples, double SampleStatistics::*Figure>
MeasureValue figure(const Measures& measures) {
  const SampleStatistics& samples = measures.*Samples;
  return samples.count > 0 ? MeasureValue(samples.*Figure) : MeasureValue();
}

template <double SampleStatistics::*Figure>
MeasureValue branching_angle(const Measures& measures) {
  const SampleStatistics& angles = measures.branching_angle;
  return angles.count > 0 ? MeasureValue(degrees(angles.*Figure)) : MeasureValue();
}

template <SampleStatistics Measures::*Samples>
MeasureValue count_of(const Measures& measures) {
  return shown(std::uint64_t{(measures.*Samples).count});
}

constexpr std::array kRows = {
    MeasureRow{"trees", "", "Number of trees: roots of skeletons.", member<&Measures::trees>},
    MeasureRow{"nodes", "", "Number of skeleton nodes, including roots.", member<&Measures::nodes>},
    MeasureRow{"metamers", "",
               "Number of metamers: the segments between nodes, unless the growth model numbers its metamers.",
               member<&Measures::metamers>},
    MeasureRow{"tips", "", "Number of tips: nodes without children.", member<&Measures::tips>},
    MeasureRow{"forks", "", "Number of forks: nodes with more than one child.", member<&Measures::forks>},
    MeasureRow{"axes", "", "Number of axes: stems and branches.", member<&Measures::axes>},
    MeasureRow{"order_histogram", "", "Number of axes of each branching order, from 0.",
               member<&Measures::axes_by_order>},
    MeasureRow{"length", "m", "Total length of all axes.", member<&Measures::length>},
    MeasureRow{"length_by_order", "m", "Total length of the axes of each branching order, from 0.",
               member<&Measures::length_by_order>},
    MeasureRow{"height", "m", "Height of the highest node above the root.", member<&Measures::height>},
    MeasureRow{"crown_height", "m",
               "Height of the highest node above the first fork; the crown is what lies past that fork.",
               member<&Measures::crown_height>},
    MeasureRow{"crown_width", "m", "Largest horizontal distance between nodes of the crown.",
               member<&Measures::crown_width>},
    MeasureRow{"crown_mean_width", "m", "Horizontal extent of the crown, averaged over all directions.",
               member<&Measures::crown_mean_width>},
    MeasureRow{"crown_ground_area", "m²",
               "Area of the crown's projection on the ground: the convex outline of its nodes, seen from above.",
               member<&Measures::crown_ground_area>},
    MeasureRow{"crown_hull_area", "m²", "Surface area of the convex hull of the crown's nodes.",
               member<&Measures::crown_hull_area>},
    MeasureRow{"crown_hull_volume", "m³", "Volume of the convex hull of the crown's nodes.",
               member<&Measures::crown_hull_volume>},
    MeasureRow{
        "lit_share", "",
        "Share of the crown's convex hull that the sun lights past obstacles, averaged over the sun's positions.",
        member<&Measures::lit_share>},
    MeasureRow{"stem_diameter", "m", "Diameter of the thickest stem at breast height, 1.3 m above the root.",
               member<&Measures::stem_diameter>},
    MeasureRow{"stem_equivalent_diameter", "m",
               "Diameter of one stem with the cross-section of all stems at breast height: the square root of the sum "
               "of their squared diameters.",
               member<&Measures::stem_equivalent_diameter>},
    MeasureRow{"stem_count", "",
               "Number of stems at breast height: the thickest stem, and all others at least a third as thick.",
               member<&Measures::stem_count>},
    MeasureRow{"basal_area", "m²", "Cross-section of all stems at breast height.", member<&Measures::basal_area>},
    MeasureRow{"base_diameter", "m", "Diameter of the stem at its base, also for plants lower than breast height.",
               member<&Measures::base_diameter>},
    MeasureRow{"slenderness", "", "Height divided by stem diameter.", member<&Measures::slenderness>},
    MeasureRow{"inclination_azimuth", "°", "Azimuth of the vector sum of all segments, from north (0) over east (90).",
               angle<&Measures::inclination_azimuth>},
    MeasureRow{"inclination_altitude", "°", "Angle above the horizon of the vector sum of all segments; 90 is upright.",
               angle<&Measures::inclination_altitude>},
    MeasureRow{"centroid_azimuth", "°",
               "Azimuth of the centroid of all nodes as seen from the root, from north (0) over east (90).",
               angle<&Measures::centroid_azimuth>},
    MeasureRow{"centroid_radius", "m", "Horizontal distance of the centroid of all nodes from the root.",
               member<&Measures::centroid_radius>},
    MeasureRow{"branching_angle_mean", "°",
               "Mean branching angle: between a lateral's first segment and its parent's segment that ends at the "
               "fork. Laterals on the root do not count.",
               branching_angle<&SampleStatistics::mean>},
    MeasureRow{"branching_angle_spread", "°", "Standard deviation of the branching angles.",
               branching_angle<&SampleStatistics::spread>},
    MeasureRow{"branching_angle_low", "°", "5th percentile of the branching angles.",
               branching_angle<&SampleStatistics::low>},
    MeasureRow{"branching_angle_median", "°", "Median of the branching angles.",
               branching_angle<&SampleStatistics::median>},
    MeasureRow{"branching_angle_high", "°", "95th percentile of the branching angles.",
               branching_angle<&SampleStatistics::high>},
    MeasureRow{"branching_angle_count", "",
               "Number of branching angles that were measured; segments without length have none.",
               count_of<&Measures::branching_angle>},
    MeasureRow{"strahler_streams", "",
               "Number of streams (runs of nodes) of each Strahler number, from 1 (tips); it rises by one where two of "
               "the largest meet.",
               member<&Measures::strahler_streams>},
    MeasureRow{"bifurcation_ratios", "",
               "Number of streams of each Strahler number, divided by the number of streams of the next.",
               member<&Measures::bifurcation_ratios>},
    MeasureRow{"bifurcation_ratio", "", "Geometric mean of all bifurcation ratios.",
               member<&Measures::bifurcation_ratio>},
    MeasureRow{"pipe_exponent", "",
               "Median pipe exponent: the n with which the radius below a fork to the power of n is the sum of those "
               "above it.",
               figure<&Measures::pipe_exponent, &SampleStatistics::median>},
    MeasureRow{"pipe_exponent_low", "", "5th percentile of the forks' pipe exponents.",
               figure<&Measures::pipe_exponent, &SampleStatistics::low>},
    MeasureRow{"pipe_exponent_high", "", "95th percentile of the forks' pipe exponents.",
               figure<&Measures::pipe_exponent, &SampleStatistics::high>},
    MeasureRow{"pipe_exponent_count", "", "Number of forks with a pipe exponent.", count_of<&Measures::pipe_exponent>},
    MeasureRow{
        "pipe_exponent_none", "",
        "Number of forks without a pipe exponent: a child is as thick as its parent, or the exponent exceeds 100.",
        member<&Measures::pipe_unsolved>},
    MeasureRow{"area_ratio_median", "",
               "Median over forks from 2 cm in diameter (`--fork-diameter`) of the children's cross-sections over the "
               "parent's; 1 keeps the area.",
               figure<&Measures::area_ratio, &SampleStatistics::median>},
    MeasureRow{"area_ratio_low", "", "5th percentile of the forks' area ratios.",
               figure<&Measures::area_ratio, &SampleStatistics::low>},
    MeasureRow{"area_ratio_high", "", "95th percentile of the forks' area ratios.",
               figure<&Measures::area_ratio, &SampleStatistics::high>},
    MeasureRow{"area_ratio_count", "", "Number of forks with an area ratio.", count_of<&Measures::area_ratio>},
    MeasureRow{"leaf_count", "", "Number of leaves: organs with a two-sided material, such as `leaf` makes.",
               member<&Measures::leaf_count>},
    MeasureRow{"leaf_area", "m²", "Area of all leaf blades, one side, without the holes of their textures.",
               member<&Measures::leaf_area>},
    MeasureRow{"petiole_area", "m²", "Surface of all petioles, the stalks of leaves.", member<&Measures::petiole_area>},
    MeasureRow{"leaf_area_index", "", "Leaf area over `crown_ground_area`.", member<&Measures::leaf_area_index>},
    MeasureRow{"leaf_exposure", "",
               "Share of the scene's light that reaches the leaves past stems, organs and obstacles, averaged over "
               "their area (`--light`).",
               member<&Measures::leaf_exposure>, false, true},
    MeasureRow{"leaf_irradiance", "",
               "Light that matt leaves take up, relative to leaves that face all light unshaded, averaged over their "
               "area (`--light`).",
               member<&Measures::leaf_irradiance>, false, true},
    MeasureRow{"thickened_below", "m",
               "Radius below which twigs of blended surfaces are thickened, since their cells could not hold them.",
               member<&Measures::thickened_below>, true},
    MeasureRow{"thickened_length", "", "Share of the length of blended stems that is thickened.",
               member<&Measures::thickened_length>, true},
    MeasureRow{"thickened_volume", "", "Volume that thickening adds to blended stems, divided by their own volume.",
               member<&Measures::thickened_volume>, true},
    MeasureRow{"triangles", "", "Number of triangles of all surfaces; each instance counts.",
               member<&Measures::triangles>, true, false, true},
    MeasureRow{"instances", "", "Number of surfaces and organs in the scene.", member<&Measures::instances>, true,
               false, true},
    MeasureRow{"bytes", "B", "Memory of the geometry: each distinct mesh once, and one frame per instance.",
               member<&Measures::bytes>, true, false, true},
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

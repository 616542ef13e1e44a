// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/measure/crown_light.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/organ_light.h"
#include "meristem/measure/samples.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/assembly/geometry_count.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The measures of one tree, or of a stand of several trees. In a stand, counts, lengths and areas are sums over all
/// trees. Height, widths and diameter come from the tallest tree. Angles, ratios and exponents cover the forks of
/// all trees. Units are metres and radians. An optional without a value is unknown or cannot be measured.
struct Measures {
  std::uint64_t trees = 0;                   ///< roots of skeletons
  std::uint64_t nodes = 0;                   ///< skeleton nodes, roots included
  std::uint64_t metamers = 0;                ///< metamers if they are numbered, else segments
  std::uint64_t tips = 0;                    ///< nodes without children
  std::uint64_t forks = 0;                   ///< nodes with more than one child
  std::uint64_t axes = 0;                    ///< stems and branches
  std::vector<std::uint64_t> axes_by_order;  ///< axes of each branching order, from 0
  std::vector<double> length_by_order;       ///< lengths of the axes of each branching order, from 0, metres
  double length = 0;                         ///< length of all axes, metres
  double height = 0;                         ///< height of the highest node above the root, metres
  double crown_height = 0;                   ///< height of the highest node above the first fork, metres
  double crown_width = 0;                    ///< largest horizontal distance between crown nodes, metres
  double crown_mean_width = 0;               ///< horizontal extent of the crown, averaged over all directions, metres
  double crown_ground_area = 0;              ///< ground below the convex hull of the crown, square metres
  double crown_hull_area = 0;                ///< surface of the crown's convex hull, square metres
  double crown_hull_volume = 0;              ///< volume of the crown's convex hull, cubic metres
  std::optional<double> lit_share;           ///< lit share of the hull; of several trees, share of the area of all
                                             ///< hulls
  std::optional<double> stem_diameter;       ///< diameter of the tallest tree's stem
  /// Diameter of a single stem that has the cross-section of all stems of the tallest tree at breast height.
  std::optional<double> stem_equivalent_diameter;
  std::uint64_t stem_count = 0;                 ///< number of stems at breast height, see kStemShare
  double basal_area = 0;                        ///< cross-section of stems at breast height, square metres
  std::optional<double> base_diameter;          ///< diameter at the root, metres
  std::optional<double> slenderness;            ///< height divided by stem diameter
  std::optional<double> inclination_azimuth;    ///< azimuth of the sum of all segments, radians from north over east
  std::optional<double> inclination_altitude;   ///< altitude of the sum of all segments, radians above the horizon
  std::optional<double> centroid_azimuth;       ///< azimuth from the root to the mean node, radians from north over
                                                ///< east
  double centroid_radius = 0;                   ///< horizontal distance from the root to the mean node, metres
  SampleStatistics branching_angle;             ///< radians between axes and their laterals
  std::vector<std::uint64_t> strahler_streams;  ///< number of Strahler streams of each order, from 1
  std::vector<double> bifurcation_ratios;       ///< streams of each order divided by streams of the next order
  std::optional<double> bifurcation_ratio;      ///< geometric mean of the ratios
  SampleStatistics pipe_exponent;               ///< exponent of the pipe model at each fork
  std::uint64_t pipe_unsolved = 0;              ///< forks for which no exponent exists
  SampleStatistics area_ratio;                  ///< cross-section above a fork divided by the cross-section below

  // Measures of plants, and of each tree if every leaf belongs to a known tree.
  std::optional<std::uint64_t> leaf_count;  ///< number of organs with a two-sided material
  std::optional<double> leaf_area;          ///< area of blades, one side, square metres
  std::optional<double> petiole_area;       ///< surface of petioles, square metres
  std::optional<double> leaf_area_index;    ///< leaf area divided by crown_ground_area
  std::optional<double> leaf_exposure;      ///< mean exposure of leaves, see LitOrgan::exposure; set only with
                                            ///< MeasureOptions::organ_light
  std::optional<double> leaf_irradiance;    ///< mean light per leaf area, see LitOrgan::irradiance; set only with
                                            ///< MeasureOptions::organ_light

  // Measures of whole plants.
  std::optional<double> thickened_below;   ///< diameter below which blended stems are thickened; this measure and the
                                           ///< next two exist only for blended stems
  std::optional<double> thickened_length;  ///< share of the length of blended stems that is thickened
  std::optional<double> thickened_volume;  ///< volume that thickening adds, as a share of the stems' volume without it
  std::optional<std::uint64_t> triangles;  ///< triangles of all instances
  std::optional<std::uint64_t> instances;  ///< instances: surfaces of stems, and organs
  std::optional<std::uint64_t> bytes;      ///< memory of the geometry, bytes

  /// Sets `triangles`, `instances` and `bytes`.
  void set_geometry(const GeometryCount& count);
};

/// The origin of a tree: its skeleton, and the component that has grown it.
struct TreeOrigin {
  std::size_t skeleton = 0;    ///< index of the tree's skeleton; in a plant, index of its stem
  Vec3 position{0};            ///< position of the tree's root, metres
  std::string component;       ///< id of the component that made its root; empty for skeletons without a plant
  std::uint32_t instance = 0;  ///< number of the instance within the component, from 0
  std::uint32_t row = kNoRow;  ///< row of the table that has placed the tree, from 0
};

/// A stand and its trees: each root of each skeleton is a tree.
struct StandMeasures {
  Measures whole;                    ///< measures of the stand as a whole
  std::vector<Measures> trees;       ///< measures of each tree
  std::vector<TreeOrigin> origins;   ///< origin of each tree
  std::vector<LitOrgan> organs;      ///< light on organs in the order of expanded(); empty unless options ask for the
                                     ///< list
  std::optional<LeafLayers> layers;  ///< unset unless options ask for them
};

/// Marks an organ that belongs to no tree, or to several.
inline constexpr std::uint32_t kNoTree = 0xffffffffU;

/// Returns the index of each organ's tree, in the numbering of measure_plant: the roots of the plant's stems in order.
/// Returns kNoTree for an organ that several trees share, and for trees whose leaves cannot be separated.
std::vector<std::uint32_t> trees_of_organs(const Plant& plant, const SizeLimits& limits, const Progress& progress);

/// Options: what else is measured, and how finely.
struct MeasureOptions {
  double fork_diameter = 0.02;            ///< metres; forks have an area ratio only if the parent is at least this
                                          ///< thick
  std::uint64_t crown_rays = kCrownRays;  ///< rays for the lit share of each tree, see crown_light.h
  bool organ_light = false;               ///< measures the light on every organ, which takes longer than all other
                                          ///< measures
  bool organ_list = false;                ///< with organ_light: also lists the light on each organ, 24 bytes each
  double layer_height = 0;                ///< height of the layers for leaf area by height, metres; 0 measures no
                                          ///< layers
};

/// Measures skeletons alone. If `scene` is null, light is not measured. Begins one stage of `progress`, which counts
/// nodes. The numbers are equal on any number of threads.
StandMeasures measure_skeletons(std::span<const Skeleton* const> skeletons, const Scene* scene,
                                const MeasureOptions& options, Progress& progress);

/// Measures a plant with its leaves and meshes. `scene` contains the light, which may differ from the light during
/// growth. Textures with holes must be painted before (has_holes, foliage.h). `meshes` must be the result of
/// make_mesh_scene or make_ray_meshes for this plant. They are counted for the measures of geometry. Placed plants are
/// measured in blocks (expand_in_blocks), so memory does not grow with the number of places. Begins stages of
/// `progress`. Throws InputError if `limits` are exceeded, and Cancelled.
StandMeasures measure_plant(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes, const Scene& scene,
                            const MeasureOptions& options, Progress& progress);

/// Measures a plant without meshes. Limits of triangles and geometry do not apply, and measures of geometry have no
/// value until Measures::set_geometry is called. Throws like the function above, and std::invalid_argument if options
/// request the light on organs.
StandMeasures measure_plant(const Plant& plant, const SizeLimits& limits, const Scene& scene,
                            const MeasureOptions& options, Progress& progress);

/// The value of a measure: no value, a count, a number in the unit of its row, or a list of counts or numbers.
using MeasureValue =
    std::variant<std::monostate, std::uint64_t, double, std::vector<std::uint64_t>, std::vector<double>>;

/// One measure as users see it.
struct MeasureRow {
  std::string_view name;                   ///< snake_case: the key in JSON
  std::string_view unit;                   ///< "m", "°", or empty for counts and ratios
  std::string_view doc;                    ///< one sentence
  MeasureValue (*value)(const Measures&);  ///< reads the measure
  bool only_whole = false;                 ///< unknown for single trees
  bool needs_light = false;                ///< needs the light on organs, which takes longer than all other measures
                                           ///< (MeasureOptions::organ_light)
  bool is_geometry = false;                ///< measures all meshes (Measures::set_geometry)
};

/// Returns all measures in the order in which they are shown. Text, JSON, Python and manual use this table.
std::span<const MeasureRow> measure_rows();

/// Returns the measures that are known of each tree, which are the first rows of the table.
std::span<const MeasureRow> tree_measure_rows();

}  // namespace meristem

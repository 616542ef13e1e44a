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
#include "meristem/shape/geometry_count.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// What is measured on one tree, or on a stand of several: counts, lengths and areas are then sums; height, widths and
/// diameter are the tallest tree's; angles, ratios and exponents are taken over all forks of all trees. Metres and
/// radians. An optional without a value is unknown or not there to be measured.
struct Measures {
  std::uint64_t trees = 0;                   ///< roots of skeletons
  std::uint64_t nodes = 0;                   ///< skeleton nodes, roots included
  std::uint64_t metamers = 0;                ///< metamers that are numbered, else segments
  std::uint64_t tips = 0;                    ///< nodes without children
  std::uint64_t forks = 0;                   ///< nodes with more than one child
  std::uint64_t axes = 0;                    ///< stems and branches
  std::vector<std::uint64_t> axes_by_order;  ///< axes of each branching order, from 0
  std::vector<double> length_by_order;       ///< metres, of the axes of each branching order, from 0
  double length = 0;                         ///< metres, of all axes
  double height = 0;                         ///< metres from the root to the highest node
  double crown_height = 0;                   ///< metres from the first fork to the highest node
  double crown_width = 0;                    ///< metres, largest horizontal distance between crown nodes
  double crown_mean_width = 0;               ///< metres, horizontal extent of the crown, averaged over all directions
  double crown_ground_area = 0;              ///< square metres of ground below the convex hull of the crown
  double crown_hull_area = 0;                ///< square metres of the crown's convex hull
  double crown_hull_volume = 0;              ///< cubic metres of the crown's convex hull
  std::optional<double> lit_share;           ///< lit share of the hull; for several trees, of all their hulls together
  std::optional<double> stem_diameter;       ///< diameter of the tallest tree's stem
  /// Diameter of one stem with the cross-section that all stems of the tallest tree have at breast height.
  std::optional<double> stem_equivalent_diameter;
  std::uint64_t stem_count = 0;                 ///< at breast height, see kStemShare
  double basal_area = 0;                        ///< square metres of cross-section at breast height
  std::optional<double> base_diameter;          ///< metres, at the root
  std::optional<double> slenderness;            ///< height divided by stem diameter
  std::optional<double> inclination_azimuth;    ///< radians from north over east, of the sum of all segments
  std::optional<double> inclination_altitude;   ///< radians above the horizon, of the sum of all segments
  std::optional<double> centroid_azimuth;       ///< radians from north over east, from the root to the mean node
  double centroid_radius = 0;                   ///< metres, horizontally from the root to the mean node
  Distribution branching_angle;                 ///< radians between axes and their laterals
  std::vector<std::uint64_t> strahler_streams;  ///< number of Strahler streams of each order, from 1
  std::vector<double> bifurcation_ratios;       ///< streams of each order divided by streams of the next order
  std::optional<double> bifurcation_ratio;      ///< geometric mean of the ratios
  Distribution pipe_exponent;                   ///< exponent of the pipe model at each fork
  std::uint64_t pipe_unsolved = 0;              ///< forks for which no exponent exists
  Distribution area_ratio;                      ///< cross-section above a fork divided by the one below

  // Measures of plants, and of a tree where its leaves are known to be its own.
  std::optional<std::uint64_t> leaf_count;  ///< organs with a two-sided material
  std::optional<double> leaf_area;          ///< square metres of blades, one side
  std::optional<double> petiole_area;       ///< square metres of petioles
  std::optional<double> leaf_area_index;    ///< leaf area divided by crown_ground_area
  std::optional<double> leaf_exposure;      ///< this and the next only where options ask for the light on organs
  std::optional<double> leaf_irradiance;    ///< mean light per leaf area, see LitOrgan::irradiance

  // Measures of whole plants.
  std::optional<double> thickened_below;   ///< this and the next two for blended stems alone
  std::optional<double> thickened_length;  ///< share of the length of blended stems that is thickened
  std::optional<double> thickened_volume;  ///< volume that thickening adds, as a share of the stems' own
  std::optional<std::uint64_t> triangles;  ///< triangles of all instances
  std::optional<std::uint64_t> instances;  ///< surfaces and organs
  std::optional<std::uint64_t> bytes;      ///< memory of the geometry

  /// Sets triangles, instances and bytes.
  void set_geometry(const GeometryCount& count);
};

/// What a tree is of.
struct TreeOrigin {
  std::size_t skeleton = 0;    ///< index of the tree's skeleton; in a plant, index of its stem
  Vec3 position{0};            ///< position of the tree's root, metres
  std::string component;       ///< id of what made its root; empty for skeletons that are of no plant
  std::uint32_t instance = 0;  ///< number among the component's instances, from 0
  std::uint32_t row = kNoRow;  ///< of the table that has placed it, from 0
};

/// A stand and its trees: each root of each skeleton is a tree.
struct StandMeasures {
  Measures whole;                    ///< measures of the stand as a whole
  std::vector<Measures> trees;       ///< measures of each tree
  std::vector<TreeOrigin> origins;   ///< origin of each tree
  std::vector<LitOrgan> organs;      ///< in the order of expanded(); empty unless options ask for the list
  std::optional<LeafLayers> layers;  ///< unset unless options ask for them
};

/// In place of the number of a tree.
inline constexpr std::uint32_t kNoTree = 0xffffffffU;

/// The number of each organ's tree among those that measure_plant measures, the roots of the plant's stems one after
/// another: kNoTree where several trees share the organ, or where their leaves cannot be told apart.
std::vector<std::uint32_t> trees_of_organs(const Plant& plant, const Limits& limits, const Progress& progress);

/// What is measured besides, and how finely.
struct MeasureOptions {
  double fork_diameter = 0.02;            ///< metres: area ratios count from forks at least that thick
  std::uint64_t crown_rays = kCrownRays;  ///< for the lit share of each tree, see crown_light.h
  bool organ_light = false;               ///< measures the light on every organ, which takes longer than all else
  bool organ_list = false;                ///< with organ_light: also lists the light on each organ, 24 bytes each
  double layer_height = 0;                ///< metres: height of the layers for leaf area by height; 0: none
};

/// Measures skeletons alone. Without a `scene` (null) no light is measured. Begins one stage of `progress`, which
/// counts nodes. The numbers are equal on any number of threads.
StandMeasures measure_skeletons(std::span<const Skeleton* const> skeletons, const Scene* scene,
                                const MeasureOptions& options, Progress& progress);

/// Measures a plant with its leaves and meshes. `scene` contains the light, which can be another one than during
/// growth. Textures with holes must be painted before (has_holes, foliage.h). `meshes` must be the result of
/// make_mesh_scene or make_ray_meshes for this plant; the measures of geometry are counted in them. Placed plants are
/// measured in blocks (expand_in_blocks), so memory does not grow with the number of places. Begins stages of
/// `progress`. Throws InputError if `limits` are exceeded, and Cancelled.
StandMeasures measure_plant(const Plant& plant, const Limits& limits, const MeshScene& meshes, const Scene& scene,
                            const MeasureOptions& options, Progress& progress);

/// Measures a plant without meshes. Limits of triangles and geometry do not apply, and measures of geometry have no
/// value until Measures::set_geometry is called. Throws as above, and std::invalid_argument if options request the
/// light on organs.
StandMeasures measure_plant(const Plant& plant, const Limits& limits, const Scene& scene, const MeasureOptions& options,
                            Progress& progress);

/// Nothing, a count, a number in the unit of its row, or a list of one of these.
using MeasureValue =
    std::variant<std::monostate, std::uint64_t, double, std::vector<std::uint64_t>, std::vector<double>>;

/// One measure as users see it.
struct MeasureRow {
  std::string_view name;                   ///< snake_case: the key in JSON
  std::string_view unit;                   ///< "m", "°", or empty for counts and ratios
  std::string_view doc;                    ///< one sentence
  MeasureValue (*value)(const Measures&);  ///< reads the measure
  bool only_whole = false;                 ///< not known of each tree
  bool needs_light = false;  ///< the light on organs, which takes longer than all else (MeasureOptions::organ_light)
  bool is_geometry = false;  ///< of all meshes (Measures::set_geometry)
};

/// All measures in the order in which they are shown: the one table behind text, JSON, Python and manual.
std::span<const MeasureRow> measure_rows();

/// The measures that are known of each tree: the first rows of all.
std::span<const MeasureRow> tree_measure_rows();

}  // namespace meristem

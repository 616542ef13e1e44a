// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/measures.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "tests/support/check_sentence.h"

namespace meristem::measures_test {

/// A random tree that rises from `root`.
Skeleton random_tree(std::uint64_t seed, Vec3 root, int nodes) {
  const RandomKey key(seed);
  Skeleton skeleton;
  skeleton.add_node(kNoNode, root, 0);
  for (int k = 1; k < nodes; ++k) {
    const auto parent = static_cast<NodeIndex>(key.child("parent").uniform(k) * k);
    const Vec3 step(key.child("x").uniform(k) - 0.5, key.child("y").uniform(k), key.child("z").uniform(k) - 0.5);
    skeleton.add_node(parent, skeleton.position[parent] + step, static_cast<float>(k));
  }
  assign_pipe_radii(skeleton, {});
  assign_axes(skeleton);
  return skeleton;
}

StandMeasures measure(const std::vector<Skeleton>& skeletons) {
  std::vector<const Skeleton*> pointers;
  for (const Skeleton& skeleton : skeletons) pointers.push_back(&skeleton);
  Progress progress;
  return measure_skeletons(pointers, nullptr, {}, progress);
}

/// Returns a slanted chain of segments.
Skeleton chain(Vec3 root, Vec3 step, int segments) {
  Skeleton skeleton;
  NodeIndex last = skeleton.add_node(kNoNode, root, 0);
  for (int k = 1; k <= segments; ++k) last = skeleton.add_node(last, root + step * static_cast<float>(k), 0);
  skeleton.radius.assign(skeleton.node_count(), 0.05F);
  return skeleton;
}

std::vector<MeasureValue> all_values(const Measures& measures) {
  std::vector<MeasureValue> values;
  for (const MeasureRow& row : measure_rows()) values.push_back(row.value(measures));
  return values;
}

TEST(Measures, InclinationAndCentroidOfASlantedStem) {
  // A chain to the east at 45°, whose root is not at the origin.
  const Measures east = measure({chain({5, 1, -3}, {1, 1, 0}, 4)}).whole;
  EXPECT_NEAR(degrees(*east.inclination_azimuth), 90, 1e-9);
  EXPECT_NEAR(degrees(*east.inclination_altitude), 45, 1e-9);
  EXPECT_NEAR(degrees(*east.centroid_azimuth), 90, 1e-9);
  EXPECT_NEAR(east.centroid_radius, 2, 1e-9);
  // South-west is 225°, -z is north.
  const Measures south_west = measure({chain({0, 0, 0}, {-1, 0, 1}, 3)}).whole;
  EXPECT_NEAR(degrees(*south_west.inclination_azimuth), 225, 1e-9);
  EXPECT_NEAR(degrees(*south_west.inclination_altitude), 0, 1e-9);
}

TEST(Measures, AnUprightStemHasNoAzimuth) {
  const Measures upright = measure({chain({0, 0, 0}, {0, 1, 0}, 3)}).whole;
  EXPECT_FALSE(upright.inclination_azimuth);
  EXPECT_FALSE(upright.centroid_azimuth);
  EXPECT_NEAR(degrees(*upright.inclination_altitude), 90, 1e-9);
  EXPECT_DOUBLE_EQ(upright.height, 3);
  EXPECT_NEAR(*upright.stem_diameter, 0.1, 1e-8);
  EXPECT_NEAR(*upright.slenderness, 30, 1e-5);
}

TEST(Measures, AStandSumsItsTreesAndIsAsHighAsTheTallest) {
  const Skeleton small = random_tree(1, {0, 0, 0}, 60);
  const Skeleton large = random_tree(2, {9, 1, 4}, 300);
  const StandMeasures stand = measure({small, large});
  ASSERT_EQ(stand.trees.size(), 2U);
  EXPECT_EQ(all_values(stand.trees[0]), all_values(measure({small}).whole));
  EXPECT_EQ(all_values(stand.trees[1]), all_values(measure({large}).whole));
  const Measures& a = stand.trees[0];
  const Measures& b = stand.trees[1];
  EXPECT_EQ(stand.whole.trees, 2U);
  EXPECT_EQ(stand.whole.nodes, 360U);
  EXPECT_EQ(stand.whole.axes, a.axes + b.axes);
  EXPECT_NEAR(stand.whole.length, a.length + b.length, 1e-9);
  EXPECT_NEAR(stand.whole.crown_hull_volume, a.crown_hull_volume + b.crown_hull_volume, 1e-9);
  EXPECT_EQ(stand.whole.height, std::max(a.height, b.height));
  EXPECT_EQ(stand.whole.crown_width, a.height > b.height ? a.crown_width : b.crown_width);
  EXPECT_EQ(stand.whole.branching_angle.count, a.branching_angle.count + b.branching_angle.count);
  EXPECT_EQ(stand.whole.strahler_streams[0], a.strahler_streams[0] + b.strahler_streams[0]);
}

TEST(Measures, StemsOfAStandAddUpAndTheTallestTellsTheDiameter) {
  const StandMeasures stand =
      measure({chain({0, 0, 0}, {0, 1, 0}, 3), chain({5, 2, 0}, {0, 1, 0}, 2), chain({9, 0, 0}, {0, 0.1F, 0}, 3)});
  EXPECT_EQ(stand.whole.stem_count, 2U);
  EXPECT_NEAR(stand.whole.basal_area, 2 * kPi / 4 * 0.01, 1e-8);
  EXPECT_NEAR(*stand.whole.stem_diameter, 0.1, 1e-8);
  EXPECT_NEAR(*stand.trees[1].stem_equivalent_diameter, 0.1, 1e-8);
  EXPECT_FALSE(stand.trees[2].stem_diameter);
  EXPECT_FALSE(stand.trees[2].stem_equivalent_diameter);
  EXPECT_NEAR(*stand.trees[2].base_diameter, 0.1, 1e-8);
  ASSERT_EQ(stand.origins.size(), 3U);
  EXPECT_EQ(stand.origins[1].skeleton, 1U);
  EXPECT_EQ(stand.origins[1].position, Vec3(5, 2, 0));
  EXPECT_TRUE(stand.origins[1].component.empty());
}

TEST(Measures, RootsOfOneSkeletonAreTrees) {
  const Skeleton left = random_tree(3, {0, 0, 0}, 50);
  const Skeleton right = random_tree(4, {3, 0, 0}, 70);
  // Puts both trees into one skeleton, the second after the first.
  Skeleton both = left;
  const AxisIndex axes = *std::max_element(left.axis.begin(), left.axis.end()) + 1;
  for (NodeIndex node = 0; node < right.node_count(); ++node) {
    const NodeIndex parent = right.is_root(node) ? kNoNode : right.parent[node] + 50;
    const NodeIndex added = both.add_node(parent, right.position[node], right.birth[node]);
    both.axis[added] = right.axis[node] + axes;
    both.order[added] = right.order[node];
    both.radius[added] = right.radius[node];
  }
  const StandMeasures apart = measure({left, right});
  const StandMeasures together = measure({both});
  ASSERT_EQ(together.trees.size(), 2U);
  EXPECT_EQ(all_values(together.whole), all_values(apart.whole));
  EXPECT_EQ(all_values(together.trees[1]), all_values(apart.trees[1]));
}

TEST(Measures, ATurnedTreeHasTheSameForm) {
  const Skeleton tree = random_tree(5, {0, 0, 0}, 400);
  Skeleton turned = tree;
  for (Vec3& position : turned.position) position = {-position.z, position.y, position.x};
  const Measures before = measure({tree}).whole;
  const Measures after = measure({turned}).whole;
  EXPECT_NEAR(after.crown_hull_volume, before.crown_hull_volume, 1e-6 * before.crown_hull_volume);
  EXPECT_NEAR(after.crown_mean_width, before.crown_mean_width, 1e-6);
  EXPECT_NEAR(after.branching_angle.mean, before.branching_angle.mean, 1e-9);
  EXPECT_EQ(after.strahler_streams, before.strahler_streams);
  // The turn from (x, z) to (-z, x) is a quarter turn from north to east: clockwise from above.
  const double turn = degrees(*after.inclination_azimuth - *before.inclination_azimuth);
  EXPECT_NEAR(turn < 0 ? turn + 360 : turn, 90, 1e-6);
}

TEST(Measures, TheSameNumbersOnAnyNumberOfThreads) {
  std::vector<Skeleton> stand;
  for (std::uint64_t seed = 0; seed < 20; ++seed) stand.push_back(random_tree(seed, {seed, 0, 0}, 100));
  const std::vector<MeasureValue> one = [&] {
    const ThreadLimit limit(1);
    return all_values(measure(stand).whole);
  }();
  for (const int threads : {2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(all_values(measure(stand).whole), one);
  }
}

TEST(Measures, PlantsAddTheirLeavesAndMeshes) {
  Plant plant;
  plant.materials.resize(2);
  plant.materials[1].two_sided = true;
  Stem stem;
  stem.parts[0].component = "tree";
  stem.parts[0].instance = 3;
  stem.skeleton = random_tree(6, {0, 0, 0}, 200);
  plant.stems = {stem};
  Mesh blade;
  blade.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  blade.triangles = {{0, 1, 2}};
  plant.prototypes = {{"leaf", 1, std::make_shared<const Mesh>(blade)}};
  plant.organs.resize(40);
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const StandMeasures stand = measure_plant(plant, {}, meshes, {}, {.layer_height = 0.4}, progress);
  const Measures& whole = stand.whole;
  EXPECT_EQ(stand.origins[0].component, "tree");
  EXPECT_EQ(stand.origins[0].instance, 3U);
  ASSERT_TRUE(stand.layers);
  EXPECT_EQ(stand.layers->area.size(), 3U);
  EXPECT_EQ(whole.petiole_area, 0.0);
  EXPECT_EQ(whole.leaf_count, 40U);
  EXPECT_DOUBLE_EQ(*whole.leaf_area, 20);
  EXPECT_DOUBLE_EQ(*whole.leaf_area_index, 20 / whole.crown_ground_area);
  EXPECT_EQ(whole.triangles, meshes.triangle_count());
  EXPECT_EQ(whole.instances, 41U);
  EXPECT_EQ(whole.bytes, meshes.meshes[0].mesh->bytes() + blade.bytes() + 41 * sizeof(Frame));
}

TEST(Measures, TheLitShareOfAStandIsThatOfAllItsHulls) {
  const Skeleton small = random_tree(1, {0, 0, 0}, 60);
  const Skeleton large = random_tree(2, {40, 0, 0}, 300);
  const std::vector<const Skeleton*> both{&small, &large};
  Scene scene;
  // Puts a roof over the small tree.
  scene.obstacles = Obstacles({{.mesh = box_mesh({-15, 90, -15}, {15, 91, 15})}});
  Progress progress;
  const StandMeasures stand = measure_skeletons(both, &scene, {}, progress);
  EXPECT_EQ(stand.trees[0].lit_share, 0);
  const Measures& lit = stand.trees[1];
  EXPECT_GT(*lit.lit_share, 0.2);
  const double lit_area = *lit.lit_share * lit.crown_hull_area;
  EXPECT_NEAR(*stand.whole.lit_share, lit_area / stand.whole.crown_hull_area, 1e-12);
}

TEST(Measures, LightIsUnknownWithoutASceneAndWithoutACrown) {
  EXPECT_FALSE(measure({random_tree(1, {0, 0, 0}, 60)}).whole.lit_share);
  const Skeleton stem = chain({0, 0, 0}, {0, 1, 0}, 3);
  const Skeleton* const pointer = &stem;
  const Scene scene;
  Progress progress;
  EXPECT_FALSE(measure_skeletons(std::span(&pointer, 1), &scene, {}, progress).whole.lit_share);
}

TEST(Measures, LightOnOrgansIsMeasuredIfAskedFor) {
  Plant plant;
  plant.materials.resize(1);
  plant.materials[0].two_sided = true;
  Mesh blade;
  blade.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}};
  blade.triangles = {{0, 1, 2}};
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>(blade)}};
  plant.organs.resize(2);
  plant.organs[1].frame.origin.y = 1;
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const StandMeasures without = measure_plant(plant, {}, meshes, {}, {}, progress);
  EXPECT_TRUE(without.organs.empty());
  EXPECT_FALSE(without.whole.leaf_exposure);
  for (const MeasureRow& row : measure_rows()) {
    if (!row.needs_light) continue;
    EXPECT_TRUE(std::holds_alternative<std::monostate>(row.value(without.whole))) << row.name;
  }
  const StandMeasures with = measure_plant(plant, {}, meshes, {}, {.organ_light = true, .organ_list = true}, progress);
  ASSERT_EQ(with.organs.size(), 2U);
  EXPECT_EQ(with.organs[1].exposure, 1);
  // The upper leaf shades the lower leaf.
  EXPECT_DOUBLE_EQ(*with.whole.leaf_exposure, 0.5);
  EXPECT_NEAR(*with.whole.leaf_irradiance, 0.5, 1e-6);
  const auto& all = measure_rows();
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const MeasureRow& row) { return row.needs_light; }), 2);
}

/// Returns two stems that fork. Each stem has the given number of leaves, each of half a square metre.
Plant leafy_trees(std::size_t first, std::size_t second) {
  Plant plant;
  plant.materials.resize(1);
  plant.materials[0].two_sided = true;
  Mesh blade;
  blade.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}};
  blade.triangles = {{0, 1, 2}};
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>(blade)}};
  plant.individuals = {{.component = "oak", .row = 7}, {.component = "oak", .number = 1, .row = 3}};
  for (const std::uint32_t tree : {0U, 1U}) {
    Stem& stem = plant.stems.emplace_back();
    stem.parts[0].component = "oak.stem";
    stem.skeleton = random_tree(tree + 1, {20.0F * static_cast<float>(tree), 0, 0}, 40);
    stem.individual_of_root = {tree};
    for (std::size_t k = 0; k < (tree == 0 ? first : second); ++k) {
      plant.organs.push_back({.frame = {.origin = {20 * tree, 3 + k, 0}}, .individual = tree});
    }
  }
  return plant;
}

StandMeasures measured(const Plant& plant, const MeasureOptions& options = {}) {
  Progress progress;
  return measure_plant(plant, {}, make_mesh_scene(plant, {}, progress), {}, options, progress);
}

TEST(Measures, EachTreeHasItsRowAndItsLeaves) {
  const StandMeasures stand = measured(leafy_trees(3, 1), {.organ_light = true});
  ASSERT_EQ(stand.trees.size(), 2U);
  EXPECT_EQ(stand.origins[0].row, 7U);
  EXPECT_EQ(stand.origins[1].row, 3U);
  EXPECT_EQ(stand.trees[0].leaf_count, 3U);
  EXPECT_EQ(stand.trees[1].leaf_count, 1U);
  EXPECT_DOUBLE_EQ(*stand.trees[0].leaf_area, 1.5);
  EXPECT_DOUBLE_EQ(*stand.trees[1].leaf_area, 0.5);
  EXPECT_DOUBLE_EQ(*stand.trees[1].leaf_area_index, 0.5 / stand.trees[1].crown_ground_area);
  EXPECT_DOUBLE_EQ(*stand.whole.leaf_area, 2);
  EXPECT_NEAR(*stand.whole.leaf_exposure, (3 * *stand.trees[0].leaf_exposure + *stand.trees[1].leaf_exposure) / 4,
              1e-12);
  EXPECT_EQ(trees_of_organs(leafy_trees(3, 1), {}, Progress()), (std::vector<std::uint32_t>{0, 0, 0, 1}));
}

/// Returns leafy trees that stand in several places, some of them within each other.
Plant placed_trees() {
  const auto variant_of = [](Plant plant) {
    auto variant = std::make_shared<PlantVariant>();
    variant->plant = std::make_shared<const Plant>(std::move(plant));
    return variant;
  };
  const auto at = [](float x, std::uint32_t row) {
    Planting::Place place;
    place.frame = {Mat3(1.5F), {x, 0, 2}};
    place.row = row;
    return place;
  };
  Plant group = leafy_trees(2, 1);
  group.plantings.push_back({"inner", variant_of(leafy_trees(1, 0)), {at(100, 3), at(200, 4)}});
  Plant plant = leafy_trees(3, 1);
  plant.plantings.push_back({"group", variant_of(std::move(group)), {at(1000, 5), at(2000, kNoRow)}});
  plant.plantings[0].places[1].instance = 1;
  return plant;
}

TEST(Measures, PlacedPlantsAreMeasuredAsTheirCopies) {
  const Plant plant = placed_trees();
  Progress progress;
  const Plant copies = expanded(plant, {}, progress);
  const MeasureOptions options{.organ_light = true, .organ_list = true, .layer_height = 0.5};
  Scene scene;
  scene.light.sky = {{kUp, 0.5}};
  const StandMeasures wanted =
      measure_plant(copies, {}, make_mesh_scene(copies, {}, progress), scene, options, progress);
  const StandMeasures stand = measure_plant(plant, {}, make_mesh_scene(plant, {}, progress), scene, options, progress);
  const auto skeleton_values = [](const Measures& measures) {
    std::vector<MeasureValue> values;
    for (const MeasureRow& row : measure_rows()) {
      if (!row.is_geometry) values.push_back(row.value(measures));
    }
    return values;
  };
  EXPECT_EQ(skeleton_values(stand.whole), skeleton_values(wanted.whole));
  ASSERT_EQ(stand.trees.size(), copies.stems.size());
  for (std::size_t k = 0; k < stand.trees.size(); ++k) {
    EXPECT_EQ(skeleton_values(stand.trees[k]), skeleton_values(wanted.trees[k]));
    EXPECT_EQ(stand.origins[k].skeleton, k);
    EXPECT_EQ(stand.origins[k].component, wanted.origins[k].component);
    EXPECT_EQ(stand.origins[k].instance, wanted.origins[k].instance);
    EXPECT_EQ(stand.origins[k].row, wanted.origins[k].row);
    EXPECT_EQ(stand.origins[k].position, wanted.origins[k].position);
  }
  ASSERT_EQ(stand.organs.size(), copies.organs.size());
  for (std::size_t k = 0; k < stand.organs.size(); ++k) EXPECT_EQ(stand.organs[k].area, wanted.organs[k].area);
  ASSERT_TRUE(stand.layers && wanted.layers);
  EXPECT_EQ(stand.layers->area, wanted.layers->area);
  EXPECT_EQ(trees_of_organs(plant, {}, progress), trees_of_organs(copies, {}, progress));
}

TEST(Measures, SkeletonsNeedNoRoomForMeshes) {
  const Plant plant = placed_trees();
  SizeLimits limits;
  limits.triangles = limits.mesh_bytes = 1;
  Progress progress;
  const StandMeasures stand = measure_plant(plant, limits, {}, {}, progress);
  EXPECT_EQ(stand.trees.size(), 14U);
  EXPECT_EQ(stand.whole.leaf_count, 14U);
  EXPECT_FALSE(stand.whole.triangles);
}

TEST(Measures, LeavesOfATreeAreUnknownWhereTreesShareThem) {
  Plant shared = leafy_trees(3, 1);
  shared.organs[0].individual = kNoIndividual;  // in a crown around both
  StandMeasures stand = measured(shared);
  EXPECT_EQ(stand.whole.leaf_count, 4U);
  for (const Measures& tree : stand.trees) EXPECT_FALSE(tree.leaf_count);
  Plant clump = leafy_trees(3, 1);
  clump.stems[1].individual_of_root = {0};  // two stems of one plant
  stand = measured(clump);
  for (const Measures& tree : stand.trees) EXPECT_FALSE(tree.leaf_area);
  EXPECT_EQ(stand.origins[1].row, 7U);
  EXPECT_EQ(trees_of_organs(clump, {}, Progress()), std::vector<std::uint32_t>(4, kNoTree));
}

TEST(Measures, AnEmptyPlantHasNothing) {
  Progress progress;
  const StandMeasures stand = measure_plant({}, {}, {}, {}, {}, progress);
  EXPECT_TRUE(stand.trees.empty());
  EXPECT_EQ(stand.whole.nodes, 0U);
  EXPECT_FALSE(stand.whole.leaf_area_index);
  EXPECT_FALSE(stand.whole.bifurcation_ratio);
}

TEST(MeasureRows, NamesAreDistinctAndSnakeCase) {
  std::set<std::string_view> names;
  for (const MeasureRow& row : measure_rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos) << row.name;
    EXPECT_TRUE(row.doc.ends_with('.')) << row.name;
  }
}

TEST(MeasureRows, EachIsExplainedByASentenceThatStandsAlone) {
  for (const MeasureRow& row : measure_rows()) EXPECT_EQ(sentence_error(row.doc), "") << row.name << ": " << row.doc;
}

TEST(MeasureRows, CountsAreWholeAndRatiosAreNotWhateverTheirValue) {
  Measures measures;
  measures.trees = 2;
  measures.axes_by_order = {1, 4};
  measures.bifurcation_ratios = {3, 4};
  measures.slenderness = 50;
  measures.leaf_count = 7;
  measures.pipe_exponent = {.count = 5, .mean = 2, .median = 2};
  const std::map<std::string_view, MeasureValue> expected = {
      {"trees", std::uint64_t{2}},
      {"order_histogram", std::vector<std::uint64_t>{1, 4}},
      {"bifurcation_ratios", std::vector<double>{3, 4}},
      {"slenderness", 50.0},
      {"leaf_count", std::uint64_t{7}},
      {"pipe_exponent", 2.0},
      {"pipe_exponent_count", std::uint64_t{5}},
      {"height", 0.0},
  };
  std::size_t seen = 0;
  for (const MeasureRow& row : measure_rows()) {
    const auto found = expected.find(row.name);
    if (found == expected.end()) continue;
    EXPECT_EQ(row.value(measures), found->second) << row.name;
    ++seen;
  }
  EXPECT_EQ(seen, expected.size());
}

TEST(MeasureRows, TreesHaveThoseThatAreNotOfTheWholeOnly) {
  const auto rows = measure_rows();
  const auto of_trees = tree_measure_rows();
  EXPECT_EQ(of_trees.data(), rows.data());
  ASSERT_LT(of_trees.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k].only_whole, k >= of_trees.size()) << rows[k].name;
}

TEST(MeasureRows, AnglesAreDegreesAndUnknownsAreNothing) {
  Measures measures;
  measures.inclination_altitude = kPi / 2;
  for (const MeasureRow& row : measure_rows()) {
    const MeasureValue value = row.value(measures);
    if (row.name == "inclination_altitude") {
      EXPECT_EQ(std::get<double>(value), 90);
    }
    if (row.name == "stem_diameter" || row.name == "pipe_exponent" || row.name == "leaf_count") {
      EXPECT_TRUE(std::holds_alternative<std::monostate>(value)) << row.name;
    }
  }
}

}  // namespace meristem::measures_test

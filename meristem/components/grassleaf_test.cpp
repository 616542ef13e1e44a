// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/grassleaf.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"
#include "tests/support/temporary_folder.h"

namespace meristem::grassleaf_test {

using Object = Value::Object;
using List = Value::List;

/// An upright midrib without smoothing, and a flat blade of constant width.
Object strip(Object more = {}) {
  Object leaf{{"length", 1.0},
              {"width", 0.1},
              {"midrib_points", List{Value(List{0, 0}), Value(List{0, 1}), Value(List{0, 2})}},
              {"profile", Object{{"curve", List{Value(List{0, 1}), Value(List{1, 1})}}}}};
  for (auto& member : more) {
    std::erase_if(leaf, [&](const Value::Member& known) { return known.first == member.first; });
    leaf.push_back(std::move(member));
  }
  return leaf;
}

Plant field_of(int plants, const Object& leaf, std::uint64_t seed = 1) {
  GraphBuilder builder(builtin_components());
  builder.seed(seed)
      .component("view", "camera")
      .component("field", "field", {{"rows", 1}, {"plants", plants}, {"spacing", 1.0}, {"turned", false}});
  builder.component("leaf", "grassleaf", leaf).link("view", "field").link("field", "leaf");
  return builder.grow();
}

double area_of(const Plant& plant, const Organ& organ) {
  const Mesh& mesh = *plant.prototypes[organ.prototype].mesh;
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](int k) { return DVec3(organ.frame.point(mesh.positions[triangle[k]])); };
    sum += 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  return sum;
}

/// Returns the end of the midrib: the vertex with v = 1 and u nearest to one half.
Vec3 tip_of(const Plant& plant, const Organ& organ) {
  const Mesh& mesh = *plant.prototypes[organ.prototype].mesh;
  std::size_t best = 0;
  const auto miss = [&](std::size_t k) { return std::abs(1 - mesh.uvs[k].y) + std::abs(0.5F - mesh.uvs[k].x); };
  for (std::size_t k = 1; k < mesh.vertex_count(); ++k) {
    if (miss(k) < miss(best)) best = k;
  }
  return organ.frame.point(mesh.positions[best]);
}

std::vector<Diagnostic> errors_of_leaf(const Object& leaf) {
  return errors_of([&] { field_of(1, leaf); });
}

TEST(Grassleaf, IsAsLongAndWideAsTheDocumentSays) {
  const Plant plant = field_of(1, strip());
  ASSERT_EQ(plant.organs.size(), 1U);
  EXPECT_NEAR(area_of(plant, plant.organs[0]), 0.1, 1e-6);
  EXPECT_NEAR(tip_of(plant, plant.organs[0]).y, 1, 1e-5);
}

TEST(Grassleaf, LeavesTheStemByItsInclination) {
  for (const double angle : {0.0, 30.0, 90.0, 135.0}) {
    const Plant plant = field_of(1, strip({{"inclination", angle}}));
    const Vec3 tip = tip_of(plant, plant.organs[0]);
    EXPECT_NEAR(tip.y, math::cos(radians(angle)), 1e-5);
    EXPECT_NEAR(-tip.z, math::sin(radians(angle)), 1e-5);
  }
}

TEST(Grassleaf, AFactorMultipliesTheInclination) {
  const auto angle_of = [](const Object& more) {
    const Plant plant = field_of(1, strip(more));
    const Vec3 tip = tip_of(plant, plant.organs[0]);
    return degrees(math::atan2(-tip.z, tip.y));
  };
  EXPECT_NEAR(angle_of({{"inclination", 40}, {"inclination_factor", 1.5}}), 60, 1e-3);
  const List leaning{Value(List{0, 0}), Value(List{1, 1}), Value(List{2, 2})};
  EXPECT_NEAR(angle_of({{"midrib_points", leaning}, {"inclination_factor", 0.5}}), 22.5, 1e-3);
}

TEST(Grassleaf, AnEvenStripKeepsItsAreaHoweverItIsTwisted) {
  const double area = area_of(field_of(1, strip()), field_of(1, strip()).organs[0]);
  const Plant twisted = field_of(1, strip({{"twist", 180}, {"polygons", 48}, {"exact", true}}));
  // The area of a helicoid is larger than the strip's area by about (twist * width)^2 / 24 here: 0.4 %.
  EXPECT_NEAR(area_of(twisted, twisted.organs[0]) / area, 1 + std::pow(kPi * 0.1, 2) / 24, 3e-3);
}

TEST(Grassleaf, ShowsTheShareOfItsLengthThatItsAgeIs) {
  for (const double age : {0.25, 0.5, 1.0}) {
    const Plant plant = field_of(1, strip({{"age", age}}));
    EXPECT_NEAR(area_of(plant, plant.organs[0]), 0.1 * age, 1e-6);
  }
}

TEST(Grassleaf, IsNotThereBeforeItsBirth) {
  EXPECT_TRUE(field_of(1, strip({{"age", 0}})).organs.empty());
  EXPECT_TRUE(field_of(1, strip({{"age", -3}})).organs.empty());
  EXPECT_EQ(field_of(5, strip({{"age", "min(i - 2, 1)"}})).organs.size(), 2U);
}

TEST(Grassleaf, MidribsByAgeAreInterpolatedInTheirDirections) {
  // Upright at age 2, horizontal at age 4.
  const List midribs{
      Value(Object{{"age", 2}, {"points", List{Value(List{0, 0}), Value(List{0, 1}), Value(List{0, 2})}}}),
      Value(Object{{"age", 4}, {"points", List{Value(List{0, 0}), Value(List{1, 0}), Value(List{2, 0})}}})};
  Object leaf = strip({{"midribs", midribs}, {"age", 3}, {"exact", true}});
  std::erase_if(leaf, [](const Value::Member& member) { return member.first == "midrib_points"; });
  const Plant plant = field_of(1, leaf);
  const Vec3 tip = tip_of(plant, plant.organs[0]);
  EXPECT_NEAR(tip.y, std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(-tip.z, std::sqrt(0.5), 1e-5);
}

TEST(Grassleaf, AgesBeyondItsMidribsAreAFault) {
  const auto errors = errors_of_leaf(strip({{"age", "1.5 + 0*i"}}));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.leaf.age");
  EXPECT_NE(errors[0].expected.find("at most 1"), std::string::npos);
}

TEST(Grassleaf, ManyLeavesShareFewShapes) {
  const Object varied = strip({{"age", "rand(0.1, 1)"}, {"length", "rand(0.2, 0.4)"}});
  const Plant plant = field_of(2000, varied);
  // 30 ages, and one octave of proportions.
  EXPECT_LE(plant.prototypes.size(), 30U * 9U);
  for (const Organ& organ : plant.organs) {
    EXPECT_GE(glm::length(organ.frame.heading()), 0.2F - 1e-6F);
    EXPECT_LE(glm::length(organ.frame.heading()), 0.4F + 1e-6F);
  }
}

TEST(Grassleaf, ExactLeavesAreAsTheyAreAsked) {
  const Plant plant = field_of(1, strip({{"age", 0.3456}, {"inclination", 12.3}, {"exact", true}}));
  EXPECT_NEAR(area_of(plant, plant.organs[0]), 0.03456, 1e-7);
  const Vec3 tip = tip_of(plant, plant.organs[0]);
  EXPECT_NEAR(math::atan2(-tip.z, tip.y), radians(12.3), 1e-5);
}

TEST(Grassleaf, ANumberThatIsTheSameForAllLeavesIsNotRounded) {
  // Returns the mean distance between the surfaces with and without the parameters.
  const auto moved_by = [](Object more, Object plain = {}) {
    more.emplace_back("polygons", 24);
    plain.emplace_back("polygons", 24);
    const Plant with = field_of(3, strip(std::move(more))), without = field_of(3, strip(std::move(plain)));
    EXPECT_EQ(with.prototypes.size(), 1U);
    float farthest = 0;
    for (const Vec3 point : with.prototypes[0].mesh->positions) {
      float nearest = 1e9F;
      for (const Vec3 other : without.prototypes[0].mesh->positions)
        nearest = std::min(nearest, glm::distance(point, other));
      farthest = std::max(farthest, nearest);
    }
    return farthest;
  };
  for (const char* const name : {"twist", "fold", "roll"}) EXPECT_GT(moved_by({{name, 2}}), 1e-5F) << name;
  EXPECT_GT(moved_by({{"waves", Object{{"number", 3}, {"depth", 0.02}}}}), 1e-5F);
  EXPECT_GT(moved_by({{"turns", List{Object{{"from", 0.5}, {"to", 0.5}, {"angle", 0.4}}}}}), 1e-4F);
  const Plant leaning = field_of(1, strip({{"inclination", 1.5}}));
  EXPECT_NEAR(-tip_of(leaning, leaning.organs[0]).z, std::sin(radians(1.5)), 1e-5);
  const Plant young = field_of(1, strip({{"age", 0.3456}}));
  EXPECT_NEAR(area_of(young, young.organs[0]), 0.03456, 1e-7);
}

TEST(Grassleaf, ANumberThatVariesIsStillRoundedSoThatLeavesShareMeshes) {
  EXPECT_LE(field_of(400, strip({{"twist", "rand(-10, 10)"}})).prototypes.size(), 5U);
  EXPECT_GT(field_of(400, strip({{"twist", "rand(-10, 10)"}, {"exact", true}})).prototypes.size(), 300U);
}

TEST(Grassleaf, WavesThatItsPolygonsCannotShowAreWarnedOf) {
  const auto warnings_of = [](const Object& leaf) {
    ParameterReader reader({}, SizeLimits());
    const ComponentType type = grassleaf_component();
    const std::shared_ptr<void> parameters = type.make_parameters();
    reader.read_varying(type.parameters, parameters.get(), leaf, DocumentPath());
    return reader.take_diagnostics();
  };
  const Object waves{{"number", 6}, {"depth", 0.5}};
  const auto warnings = warnings_of(strip({{"waves", waves}, {"polygons", 20}}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].severity, Severity::warning);
  EXPECT_EQ(warnings[0].message, "20 polygons are too few to show 6 waves, which are left out; 24 or more show them");
  EXPECT_TRUE(warnings_of(strip({{"waves", waves}, {"polygons", 24}})).empty());
  EXPECT_TRUE(warnings_of(strip({{"waves", waves}, {"polygons", 20}, {"stages", Object{{"reduce", false}}}})).empty());
}

TEST(Grassleaf, NumbersThatVaryDoNotSpoilItsTexture) {
  const Object veins{{"leaf", Object{{"veins", "parallel"}}}, {"pixels", 32}};
  const auto normals_of = [&](const Object& leaf) { return field_of(1, leaf).materials[0].texture->normals.rgba; };
  const Object plain = strip({{"length", 0.3}, {"width", 0.018}, {"texture", veins}});
  const Object varied = strip({{"length", "0.3 + 0*i"}, {"width", "0.018 + 0*i"}, {"texture", veins}});
  EXPECT_EQ(normals_of(varied), normals_of(plain));
}

TEST(Grassleaf, AFieldShowsTheSpreadThatIsAskedFor) {
  const Object lives{{"length", "1 + 0.1*gauss(0, 1)"}, {"width", "1 + 0.05*gauss(0, 1)"}, {"variants", 0}};
  const Plant plant = field_of(4000, strip({{"vary", lives}}));
  double sum = 0, squares = 0;
  std::vector<double> lengths;
  for (const Organ& organ : plant.organs) {
    const double length = tip_of(plant, organ).y;
    sum += length;
    squares += length * length;
  }
  const double mean = sum / 4000, deviation = std::sqrt(squares / 4000 - mean * mean);
  // Four standard errors of the mean and of the deviation.
  EXPECT_NEAR(mean, 1, 4 * 0.1 / std::sqrt(4000.0));
  EXPECT_NEAR(deviation, 0.1, 4 * 0.1 / std::sqrt(8000.0));
}

TEST(Grassleaf, LivesAreSharedByVariants) {
  const Object lives{{"bend", "1 + 0.3*gauss(0, 1)"}, {"variants", 7}};
  EXPECT_EQ(field_of(500, {{"vary", lives}}).prototypes.size(), 7U);
  EXPECT_EQ(field_of(500, {{"vary", lives}, {"stages", Object{{"vary", false}}}}).prototypes.size(), 1U);
}

TEST(Grassleaf, TheSameSeedGivesTheSameLeavesOnAnyNumberOfThreads) {
  const Object leaf{
      {"vary", Object{{"bend", "1 + 0.3*gauss(0, 1)"}}}, {"age", "rand(0.2, 1)"}, {"twist", "rand(-90, 90)"}};
  const auto hash = [&](int threads, std::uint64_t seed) {
    const ThreadLimit limit(threads);
    return hash_of(field_of(3000, leaf, seed));
  };
  const std::string one = hash(1, 5);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads, 5), one);
  EXPECT_NE(hash(1, 6), one);
}

TEST(Grassleaf, PolygonsAreAsManyAsAskedAndTheAreaStays) {
  const double area = area_of(field_of(1, {{"polygons", 48}}), field_of(1, {{"polygons", 48}}).organs[0]);
  for (const int polygons : {2, 4, 8, 16, 32}) {
    const Plant plant = field_of(1, {{"polygons", polygons}});
    EXPECT_EQ(plant.prototypes[0].mesh->triangle_count(), 4U * static_cast<unsigned>(polygons) - 2U);
    EXPECT_NEAR(area_of(plant, plant.organs[0]) / area, 1, 2e-3);
    check_mesh(*plant.prototypes[0].mesh);
  }
}

TEST(Grassleaf, AnErrorInPlaceOfPolygonsTakesThoseItNeeds) {
  const auto triangles = [](const Object& leaf) { return field_of(1, leaf).prototypes[0].mesh->triangle_count(); };
  EXPECT_EQ(triangles(strip({{"error", 1e-4}})), 4U);
  EXPECT_LT(triangles({{"error", 0.05}}), triangles({{"error", 0.002}}));
}

TEST(Grassleaf, StagesCanBePassedOver) {
  const Object wild{{"inclination", 80}, {"twist", 90}, {"age", 0.5}, {"polygons", 3}};
  const auto leaf = [&](const char* stage) {
    Object more = wild;
    more.emplace_back("stages", Object{{stage, false}});
    return field_of(1, strip(more));
  };
  const Plant all = field_of(1, strip(wild));
  EXPECT_NEAR(area_of(leaf("age"), leaf("age").organs[0]) / area_of(all, all.organs[0]), 2, 0.1);
  EXPECT_NEAR(tip_of(leaf("bend"), leaf("bend").organs[0]).y, 0.5, 1e-5);
  EXPECT_EQ(leaf("reduce").prototypes[0].mesh->triangle_count(), 4U * 48U);
  const Plant flat = leaf("blade");
  for (const Vec3 normal : flat.prototypes[0].mesh->normals) EXPECT_NEAR(normal.x, 0, 1e-6);
  const Plant built_in = leaf("load");
  EXPECT_GT(-tip_of(built_in, built_in.organs[0]).z, 0.2) << "the built-in leaf leads away";
  const auto kinked = [](bool is_fitted) {
    const List points{Value(List{0, 0}), Value(List{0, 1}), Value(List{1, 1})};
    const Plant plant = field_of(1, strip({{"midrib_points", points},
                                           {"fit", Object{{"smoothing", 0.05}}},
                                           {"polygons", 48},
                                           {"stages", Object{{"fit", is_fitted}}}}));
    return plant.prototypes[0].mesh->normals[3 * 12].y;  // at a point on the first leg, which is upright
  };
  EXPECT_NEAR(kinked(false), 0, 1e-3);
  EXPECT_GT(std::abs(kinked(true)), 0.02);
}

TEST(Grassleaf, WithoutTheStageOfAgeALeafIsFullGrown) {
  const Plant plant = field_of(1, strip({{"age", 0.2}, {"full_age", 0.5}, {"stages", Object{{"age", false}}}}));
  EXPECT_NEAR(area_of(plant, plant.organs[0]), 0.1, 1e-6);
}

TEST(Grassleaf, FullAgeIsTheAgeOfItsForm) {
  const auto height = [](double age) {
    const Plant plant = field_of(1, strip({{"age", age}, {"full_age", 20}}));
    return tip_of(plant, plant.organs[0]).y;
  };
  EXPECT_NEAR(height(20), 1, 1e-5);
  EXPECT_NEAR(height(5), 0.25, 1e-5);
}

TEST(Grassleaf, LivesFollowTheSeed) {
  const auto length_of = [](std::uint64_t seed) {
    const Object lives{{"length", "rand(0.5, 2)"}, {"variants", 1}};
    const Plant plant = field_of(1, strip({{"vary", lives}}), seed);
    return tip_of(plant, plant.organs[0]).y;
  };
  EXPECT_EQ(length_of(1), length_of(1));
  EXPECT_NE(length_of(1), length_of(2));
  const Object each{{"length", "rand(0.5, 2)"}, {"step", 0.05}};
  EXPECT_EQ(field_of(9, strip({{"vary", each}, {"exact", true}})).prototypes.size(), 9U);
}

TEST(Grassleaf, ItsUsualLengthIsThatOfAGrass) {
  const Plant plant = field_of(1, Object{});
  EXPECT_NEAR(glm::length(plant.organs[0].frame.heading()), 0.3, 1e-6);
}

TEST(Grassleaf, MorePolygonsThanTheFitHasPiecesAreMade) {
  EXPECT_EQ(field_of(1, {{"polygons", 100}}).prototypes[0].mesh->triangle_count(), 398U);
}

TEST(Grassleaf, AProfileOfOneNarrowPeakIsABladeAndNoneIsAFault) {
  const auto with_profile = [](const List& points) {
    return Object{{"profile", Object{{"curve", points}, {"kind", "linear"}}}};
  };
  const List peak{Value(List{0, 0}), Value(List{0.01, 1}), Value(List{0.02, 0}), Value(List{1, 0})};
  check_mesh(*field_of(1, with_profile(peak)).prototypes[0].mesh);
  const auto errors = errors_of_leaf(with_profile({Value(List{0, 0}), Value(List{1, 0})}));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.leaf.profile");
}

TEST(Grassleaf, FormulasThatGiveNoNumbersToReckonWithAreFaults) {
  const auto path_of = [](const Object& leaf) {
    const auto errors = errors_of_leaf(leaf);
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of({{"f", "1e300"}}), "components.leaf.f");
  EXPECT_EQ(path_of({{"vary", Object{{"length", "1/0"}}}}), "components.leaf.vary.length");
  const Object slow{{"age", 1}, {"step", 0.001}};
  EXPECT_EQ(path_of({{"full_age", 1000}, {"age", 1000}, {"vary", slow}}), "components.leaf.vary.step");
  const List midribs{
      Value(Object{{"age", 0}, {"points", List{Value(List{0, 0}), Value(List{0, 1}), Value(List{0, 2})}}}),
      Value(Object{{"age", 2}, {"points", List{Value(List{0, 0}), Value(List{0, 0}), Value(List{0, 2})}}})};
  EXPECT_EQ(path_of({{"midribs", midribs}}), "components.leaf.midribs[1].points");
}

TEST(Grassleaf, ItsSheathFitsTheStemWhateverTheScale) {
  GraphBuilder builder(builtin_components());
  const Object even{{"curve", List{Value(List{0, 1}), Value(List{1, 1})}}};
  builder.component("view", "camera")
      .component("stem", "tree", {{"length", 1}, {"radius", 0.05}, {"taper", even}, {"count", 3}})
      .component("leaf", "grassleaf", {{"sheath", Object{{"length", 0.1}}}});
  for (const double scale : {1.0, 0.5}) {
    GraphBuilder scaled = builder;
    const Object size{{"size", Object{{"curve", List{Value(List{0, scale}), Value(List{1, scale})}}}}};
    scaled.link("view", "stem").link("stem", "leaf", LinkKind::branch, size);
    const Plant plant = scaled.grow();
    const auto leaves = organs_of(plant, "leaf");
    // The heading is along the stem, although links give no angle, and the leaf is rotated about the stem.
    std::size_t sheaths = 0;
    for (const Organ& organ : leaves) {
      if (plant.materials[plant.prototypes[organ.prototype].material].name != "leaf_blades") continue;
      ++sheaths;
      EXPECT_NEAR(glm::length(organ.frame.axes[0]), 0.056, 1e-4);
      EXPECT_NEAR(std::hypot(organ.frame.origin.x, organ.frame.origin.z), 0, 1e-5);
      EXPECT_NEAR(glm::normalize(organ.frame.heading()).y, 1, 1e-5);
    }
    EXPECT_EQ(sheaths, 3U);
  }
}

TEST(Grassleaf, WindMovesTipsWhereItBlowsTo) {
  // Leaves that face eight directions, around the vertical.
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("star", "hydra", {{"number", 8}, {"angle", 0}})
      .component("leaf", "grassleaf", {{"length", 0.5}, {"width", 0.03}, {"forces", Object{{"wind", List{6, 0, 0}}}}});
  builder.link("view", "star").link("star", "leaf");
  const Plant blown = builder.grow();
  builder.component("leaf", "grassleaf", {{"length", 0.5}, {"width", 0.03}});
  const Plant still = builder.grow();
  ASSERT_EQ(blown.organs.size(), 8U);
  double shift = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    const float moved = tip_of(blown, blown.organs[k]).x - tip_of(still, still.organs[k]).x;
    EXPECT_GT(moved, -1e-3F);
    shift += moved;
  }
  EXPECT_GT(shift / 8, 0.03);
}

TEST(Grassleaf, ForcesThatAreNoneChangeNothing) {
  const Plant plain = field_of(1, {{"exact", true}});
  const Plant forced = field_of(1, {{"exact", true}, {"forces", Object{}}});
  const Vec3 a = tip_of(plain, plain.organs[0]), b = tip_of(forced, forced.organs[0]);
  EXPECT_LT(glm::distance(a, b), 1e-5F);
}

TEST(Grassleaf, HooksMoveTheSurfaceAsTheSourceWrites) {
  // S = (x + f, h, y + g): f away from the stem, h across, g up, in widths.
  const auto tip = [](const char* hook) {
    const Plant plant = field_of(1, strip({{hook, "0.5*s"}, {"exact", true}}));
    return tip_of(plant, plant.organs[0]) - Vec3(0, 1, 0);
  };
  EXPECT_LT(glm::distance(tip("f"), Vec3(0, 0, -0.05F)), 1e-5F);
  EXPECT_LT(glm::distance(tip("g"), Vec3(0, 0.05F, 0)), 1e-5F);
  EXPECT_LT(glm::distance(tip("h"), Vec3(0.05F, 0, 0)), 1e-5F);
}

TEST(Grassleaf, ASheathGoesAboutTheStemBelowItsBlade) {
  const Plant plant = field_of(1, strip({{"sheath", Object{{"length", 0.2}, {"radius", 0.02}}}}));
  ASSERT_EQ(plant.organs.size(), 2U);
  Box box;
  const Mesh& mesh = *plant.prototypes[plant.organs[0].prototype].mesh;
  for (const Vec3 point : mesh.positions) box.add(plant.organs[0].frame.point(point));
  EXPECT_NEAR(box.low.y, -0.2, 1e-6);
  EXPECT_NEAR(box.high.y, 0, 1e-6);
  EXPECT_NEAR(box.high.x, 0.02, 5e-4);
  // The blade begins at the rim of the sheath.
  EXPECT_NEAR(plant.organs[1].frame.origin.z, -0.02, 1e-6);
}

TEST(Grassleaf, StandsOnTheAxisOfAStem) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("stem", "tree",
                 {{"length", 1},
                  {"radius", 0.05},
                  {"taper", Object{{"curve", List{Value(List{0, 1}), Value(List{1, 1})}}}},
                  {"count", 4},
                  {"angle", 0}})
      .component("leaf", "grassleaf", strip());
  builder.link("view", "stem").link("stem", "leaf", LinkKind::branch);
  const Plant plant = builder.grow();
  ASSERT_EQ(organs_of(plant, "leaf").size(), 4U);
  for (const Organ& leaf : organs_of(plant, "leaf")) {
    // A blade without a sheath begins on the bark.
    EXPECT_NEAR(std::hypot(leaf.frame.origin.x, leaf.frame.origin.z), 0.05, 1e-5);
  }
}

TEST(Grassleaf, HangsOnAnyComponent) {
  for (const char* parent :
       {"simple", "hydra", "wreath", "phiball", "revolution", "horn", "field", "leaf", "needles"}) {
    GraphBuilder builder(builtin_components());
    Object parameters;
    if (std::string(parent) == "revolution")
      parameters = {{"silhouette", List{Value(List{0.1, 0}), Value(List{0, 0.1})}}};
    builder.component("view", "camera").component("parent", parent, parameters).component("leaf", "grassleaf");
    builder.link("view", "parent").link("parent", "leaf");
    EXPECT_FALSE(organs_of(builder.grow(), "leaf").empty()) << parent;
  }
}

/// A fixture that writes files to a temporary folder.
class GrassleafFiles : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string midribs() {
    return write("midribs.csv",
                 "rank,lindex,x,y\n1,1,0,0\n1,1,0,1\n1,1,0,2\n1,2,0,0\n1,2,0,2\n1,2,0,4\n2,1,0,0\n2,1,1,0\n2,1,3,0\n");
  }
  std::string widths() {
    return write("widths.csv", "rankclass;s;r\n1;0;0,5\n1;0,5;1\n1;1;0\n2;0;1\n2;0,5;1\n2;1;1\n");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(GrassleafFiles, LeavesOfARankAreDrawnFromAllMeasuredOnes) {
  const Object leaf{{"midrib", midribs()}, {"widths", widths()}, {"width", 0.001}, {"exact", true}};
  std::multiset<int> heights;
  const Plant plant = field_of(400, leaf);
  for (const Organ& organ : plant.organs) heights.insert(static_cast<int>(std::round(100 * tip_of(plant, organ).y)));
  // 2 and 4 centimetres as measured, with equal probability.
  EXPECT_EQ(heights.count(2) + heights.count(4), 400U);
  EXPECT_NEAR(static_cast<double>(heights.count(2)), 200, 40);
}

TEST_F(GrassleafFiles, WidthsAreSharesWhereTheirLargestIsAboutOneAndElseAsMeasured) {
  const auto width_of = [&](const char* rows) {
    const Object leaf{{"widths", write("w.csv", rows)}, {"length", 1}, {"unit", 1}, {"exact", true}};
    const Plant plant = field_of(1, leaf);
    Box box;
    for (const Vec3 point : plant.prototypes[0].mesh->positions) box.add(plant.organs[0].frame.point(point));
    return box.size().x;
  };
  // Shares of the length and of the width; both in metres; shares of the length with the width in metres.
  EXPECT_NEAR(width_of("s,r\n0,1\n0.5,1\n1,1\n"), 0.06, 1e-4);
  EXPECT_NEAR(width_of("s,r\n0,0.09\n0.4,0.09\n0.8,0.09\n"), 0.09, 1e-4);
  EXPECT_NEAR(width_of("s,r\n0,0.09\n0.5,0.09\n0.95,0.09\n"), 0.09, 1e-4);
}

TEST_F(GrassleafFiles, AnExpressionMayNameTheRank) {
  const Plant plant = field_of(2, {{"midrib", midribs()}, {"widths", widths()}, {"rank", "i + 1"}, {"leaf", 1}});
  EXPECT_NEAR(tip_of(plant, plant.organs[0]).y, 0.02, 1e-5);
  EXPECT_NEAR(-tip_of(plant, plant.organs[1]).z, 0.03, 1e-5);
}

TEST_F(GrassleafFiles, RanksThatAreNotThereAreAFault) {
  const auto errors = errors_of_leaf({{"midrib", midribs()}, {"rank", 7}});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.leaf.rank");
  EXPECT_EQ(errors[0].expected, "one of 1, 2");
}

TEST_F(GrassleafFiles, FaultsInFilesHaveTheirRowAndReason) {
  const auto text_of = [&](const char* row, const std::string& text) {
    std::string all;
    for (const Diagnostic& error : errors_of_leaf({{row, write("bad.csv", text)}})) all += error.text() + "\n";
    return all;
  };
  const auto has = [](const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
  };
  const std::string missing = text_of("midrib", "rank,X,y\n1,0,0\n");
  EXPECT_TRUE(has(missing, "components.leaf.midrib") && has(missing, "no column 'x'") && has(missing, "'X'"))
      << missing;
  // A repeated point that is not removed as an outlier.
  const std::string repeated = text_of("midrib", "x,y\n0,0\n1,1\n1,1\n");
  EXPECT_TRUE(has(repeated, "bad.csv:4") && has(repeated, "the one in the row before")) << repeated;
  const std::string negative = text_of("widths", "s,r\n0,1\n0.5,-1\n1,0\n");
  EXPECT_TRUE(has(negative, "bad.csv:3") && has(negative, "negative")) << negative;
  const std::string unsorted = text_of("widths", "s,r\n0,1\n0.7,1\n0.5,1\n1,0\n");
  EXPECT_TRUE(has(unsorted, "bad.csv:4") && has(unsorted, "not sorted")) << unsorted;
}

TEST(Grassleaf, FaultyParametersAreRejectedAtTheirPlaces) {
  const auto path_of = [](const Object& leaf) {
    const auto errors = errors_of_leaf(leaf);
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of({{"across", 3}}), "components.leaf.across");
  EXPECT_EQ(path_of({{"polygons", 0}}), "components.leaf.polygons");
  EXPECT_EQ(path_of({{"polygons", 4}, {"error", 0.1}}), "components.leaf.polygons");
  EXPECT_EQ(path_of({{"turns", List{Value(Object{{"from", 0.7}, {"to", 0.2}})}}}), "components.leaf.turns[0].to");
  EXPECT_EQ(path_of({{"f", "s + x"}}), "components.leaf.f");
  EXPECT_EQ(path_of({{"vary", Object{{"age", "1 + i"}}}}), "components.leaf.vary.age");
  EXPECT_EQ(path_of({{"midrib_points", List{Value(List{0, 0}), Value(List{1, 1})}}}), "components.leaf.midrib_points");
  EXPECT_EQ(path_of({{"stages", Object{{"bent", false}}}}), "components.leaf.stages.bent");
}

TEST(Grassleaf, WideningsChangeTheAreaAndVaryFromLeafToLeaf) {
  const auto widened = [](const Value& factor) {
    return field_of(
        6, strip({{"polygons", 200}, {"widenings", List{Value(Object{{"from", 0}, {"to", 1}, {"factor", factor}})}}}));
  };
  const Plant plain = field_of(1, strip({{"polygons", 200}}));
  const Plant wide = widened(2);
  EXPECT_EQ(wide.prototypes.size(), 1U);
  // A strip with r = 1: the mean of (4u(1-u))^2 is 8/15.
  EXPECT_NEAR(area_of(wide, wide.organs[0]) / area_of(plain, plain.organs[0]), 1 + 8.0 / 15, 0.01);
  EXPECT_EQ(widened("1 + 0.5*floor(i / 2)").prototypes.size(), 3U);
  const auto errors = errors_of_leaf({{"widenings", List{Value(Object{{"from", 0.7}, {"to", 0.7}, {"factor", 2}})}}});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.leaf.widenings[0].to");
}

TEST(Grassleaf, TurnsVaryFromLeafToLeafAndEqualOnesShareAMesh) {
  const auto turned = [](const Value& angle) {
    return field_of(6, strip({{"turns", List{Value(Object{{"from", 0.5}, {"to", 0.5}, {"angle", angle}})}}}));
  };
  const Plant rising = turned(List{0, 50});
  ASSERT_EQ(rising.organs.size(), 6U);
  EXPECT_EQ(rising.prototypes.size(), 6U);
  for (std::size_t k = 1; k < 6; ++k)
    EXPECT_LT(tip_of(rising, rising.organs[k]).y, tip_of(rising, rising.organs[k - 1]).y);
  EXPECT_EQ(turned("10 * floor(i / 2)").prototypes.size(), 3U);
  EXPECT_EQ(turned(30).prototypes.size(), 1U);
}

TEST(Grassleaf, ATurnThatVariesToEndBeforeItBeginsIsAKink) {
  const Object turn{{"from", 0.6}, {"to", "0.2 + 0 * i"}, {"angle", 40}};
  const Object kink{{"from", 0.6}, {"to", 0.6}, {"angle", 40}};
  const Plant varied = field_of(1, strip({{"turns", List{Value(turn)}}}));
  const Plant plain = field_of(1, strip({{"turns", List{Value(kink)}}}));
  EXPECT_EQ(tip_of(varied, varied.organs[0]), tip_of(plain, plain.organs[0]));
}

}  // namespace meristem::grassleaf_test

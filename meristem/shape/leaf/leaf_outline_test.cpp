// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/leaf/leaf_outline.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/shape/flat/cut_polygon.h"

namespace meristem::leaf_outline_test {

using Points = std::vector<glm::dvec2>;

/// A palmate leaf: the side lobes overhang, and the lowest extend behind the joint.
const std::vector<Vec2> kPalmate{{0.35F, -0.1F}, {0.3F, 0.12F}, {0.8F, 0.1F},  {0.65F, 0.25F}, {1, 0.55F},
                                 {0.7F, 0.5F},   {0.45F, 0.4F}, {0.4F, 0.75F}, {0.25F, 0.7F},  {0, 1}};

double area_of(const Points& corners) {
  double doubled = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

double widest(const Points& edge) {
  double width = 0;
  for (const glm::dvec2 point : edge) width = std::max(width, point.x);
  return width;
}

/// Counts the corners of the edge at which it turns inward.
long count_notches(const Points& edge) {
  long notches = 0;
  for (std::size_t i = 1; i + 1 < edge.size(); ++i) {
    const glm::dvec2 in = edge[i] - edge[i - 1], out = edge[i + 1] - edge[i];
    if (in.x * out.y - in.y * out.x < -1e-9) ++notches;
  }
  return notches;
}

TEST(LeafOutline, GoesFromTheJointToTheTip) {
  LeafBlade blade;
  blade.heart = 0.2;
  blade.teeth = 9;
  for (const Points& edge : {full_outline(blade).edge, mesh_outline(blade).edge}) {
    EXPECT_EQ(edge.front(), glm::dvec2(0, 0));
    EXPECT_EQ(edge.back(), glm::dvec2(0, 1));
  }
}

TEST(LeafOutline, APolygonOfSharpCornersIsTakenAsItIs) {
  LeafBlade blade;
  blade.polygon = kPalmate;
  blade.rows = 20;
  const LeafOutline outline = mesh_outline(blade);
  ASSERT_EQ(outline.edge.size(), kPalmate.size() + 1);
  for (std::size_t k = 0; k < kPalmate.size(); ++k) EXPECT_EQ(outline.edge[k + 1], glm::dvec2(kPalmate[k]));
  EXPECT_NEAR(outline.low, -0.1, 1e-6);
  EXPECT_EQ(outline.high, 1);
}

TEST(LeafOutline, RoundCornersKeepTheWidth) {
  LeafBlade blade;
  blade.polygon = kPalmate;
  blade.corners = LeafBlade::Corners::round;
  EXPECT_EQ(widest(full_outline(blade).edge), 1);
  EXPECT_GT(full_outline(blade).edge.size(), 2 * kPalmate.size());
}

TEST(LeafOutline, ThereAreAsManyTeethAsAskedFor) {
  LeafBlade blade;
  blade.outline = Curve({{0, 1}});
  blade.teeth = 12;
  blade.teeth_depth = 0.2;
  // One notch between each two teeth.
  EXPECT_EQ(count_notches(full_outline(blade).edge), 12 - 1);
}

TEST(LeafOutline, TeethCutIntoTheOutlineButNotIntoItsWidth) {
  LeafBlade entire;
  LeafBlade toothed = entire;
  toothed.teeth = 15;
  const Points before = full_outline(entire).edge, after = full_outline(toothed).edge;
  EXPECT_LT(area_of(after), area_of(before));
  EXPECT_GT(area_of(after), 0.9 * area_of(before));
  EXPECT_NEAR(widest(after), 1, 0.02);
}

TEST(LeafOutline, TeethLeanToTheTip) {
  // Returns the relative position of the second tooth between its notches.
  const auto place = [](double lean) {
    LeafBlade blade;
    blade.outline = Curve({{0, 1}});
    blade.teeth = 5;
    blade.teeth_depth = 0.05;
    blade.teeth_lean = lean;
    std::vector<double> along;
    for (const glm::dvec2 point : mesh_outline(blade).edge) {
      if (point.x > 0 && point.y > 0.1 && point.y < 0.9) along.push_back(point.y);
    }
    // The first tooth, then notch, tooth, notch.
    return (along.at(2) - along.at(1)) / (along.at(3) - along.at(1));
  };
  EXPECT_NEAR(place(0), 0.5, 1e-6);
  EXPECT_NEAR(place(1), 0.95, 1e-6);
}

TEST(LeafOutline, AHeartReachesBackBesideTheJoint) {
  LeafBlade blade;
  blade.outline = Curve({{0, 0.6F}, {0.3F, 1}, {1, 0}}, CurveKind::linear);
  EXPECT_EQ(full_outline(blade).low, 0);
  blade.heart = 0.2;
  const LeafOutline outline = full_outline(blade);
  EXPECT_NEAR(outline.low, -0.2, 0.01);
  EXPECT_EQ(outline.edge.front(), glm::dvec2(0, 0));
  EXPECT_EQ(outline.high, 1);
}

TEST(LeafOutline, AHeartReachesBackByItsShareFromANarrowBaseToo) {
  LeafBlade blade;
  for (const CurveKind kind : {CurveKind::linear, CurveKind::spline}) {
    blade.outline = Curve({{0, 0}, {0.15F, 0.6F}, {0.4F, 1}, {1, 0}}, kind);
    for (const double heart : {0.1, 0.3, 0.5}) {
      blade.heart = heart;
      EXPECT_NEAR(full_outline(blade).low, -heart, 0.03 * heart) << heart;
    }
  }
  // A lanceolate blade has almost no base that could be drawn back.
  blade.outline = Curve({{0, 0}, {0.9F, 0.001F}, {0.95F, 1}, {1, 0}}, CurveKind::linear);
  EXPECT_LE(full_outline(blade).low, 0);
}

TEST(LeafOutline, RowsRiseBetweenBothEnds) {
  LeafBlade blade;
  blade.polygon = kPalmate;
  blade.rows = 30;
  blade.waves = 7;
  const LeafOutline outline = mesh_outline(blade);
  EXPECT_GT(outline.rows.size(), 25U);
  EXPECT_GT(outline.rows.front(), outline.low);
  EXPECT_LT(outline.rows.back(), outline.high);
  EXPECT_EQ(std::adjacent_find(outline.rows.begin(), outline.rows.end(), std::greater_equal<>()), outline.rows.end());
}

TEST(LeafOutline, PolygonsThatTouchThemselvesOrTheMidribAreFound) {
  LeafBlade blade;
  blade.polygon = kPalmate;
  EXPECT_FALSE(polygon_crosses_itself(blade));
  blade.polygon = {{1, 0.2F}, {0, 0.5F}, {1, 0.8F}};
  EXPECT_TRUE(polygon_crosses_itself(blade));
  blade.polygon = {{1, 0.2F}, {0.2F, 0.8F}, {0.2F, 0.2F}, {1, 0.8F}};
  EXPECT_TRUE(polygon_crosses_itself(blade));
}

RC_GTEST_PROP(LeafOutline, NoOutlineCrossesItselfAndEveryHullHoldsItsOutline, ()) {
  const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  LeafBlade blade;
  if (*rc::gen::arbitrary<bool>()) {
    blade.polygon = kPalmate;
  } else {
    std::vector<Vec2> points{{0, static_cast<float>(share())}};
    for (int i = 1; i < 6; ++i) points.emplace_back(i / 6.0F, 0.05F + 0.95F * static_cast<float>(share()));
    points.emplace_back(1, static_cast<float>(share()));
    blade.outline = Curve(points, CurveKind::linear);
  }
  blade.corners = *rc::gen::element(LeafBlade::Corners::sharp, LeafBlade::Corners::round);
  blade.heart = 0.4 * share();
  blade.teeth = *rc::gen::inRange(0, 40);
  blade.teeth_depth = 0.5 * share();
  blade.teeth_lean = share();
  blade.rows = *rc::gen::inRange(2, 12);
  const Points edge = full_outline(blade).edge;
  RC_ASSERT(!crosses_itself(edge));
  blade.edge = LeafBlade::Edge::picture;
  const Points hull = mesh_outline(blade).edge;
  for (const glm::dvec2 point : edge) {
    for (std::size_t i = 0; i + 1 < hull.size(); ++i) {
      const glm::dvec2 along = glm::normalize(hull[i + 1] - hull[i]), away = point - hull[i];
      RC_ASSERT(along.x * away.y - along.y * away.x > -1e-9);
    }
  }
  for (const glm::dvec2 point : hull) RC_ASSERT(point.x <= std::max(1.0, widest(edge)) + 1e-9);
}

}  // namespace meristem::leaf_outline_test

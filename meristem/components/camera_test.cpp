// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/camera.h"

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::camera_test {

CameraView view_of(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera", parameters);
  return camera_view(builder.sound_graph());
}

TEST(CameraComponent, GivesItsViewInRadians) {
  const CameraView view = view_of({{"position", Value::List{1, 2, 3}},
                                   {"target", Value::List{0, 1, 0}},
                                   {"field_of_view", 60},
                                   {"background", "#ffffff"}});
  EXPECT_EQ(*view.position, Vec3(1, 2, 3));
  EXPECT_EQ(*view.target, Vec3(0, 1, 0));
  const CameraView by_angles = view_of({{"azimuth", 90}, {"altitude", -45}});
  EXPECT_DOUBLE_EQ(by_angles.azimuth, kPi / 2);
  EXPECT_DOUBLE_EQ(by_angles.altitude, -kPi / 4);
  EXPECT_DOUBLE_EQ(view.field_of_view, kPi / 3);
  EXPECT_EQ(*view.background, Vec3(1));
}

TEST(CameraComponent, LeavesToTheProgramWhatIsNotGiven) {
  const CameraView view = view_of({});
  EXPECT_FALSE(view.position.has_value());
  EXPECT_FALSE(view.target.has_value());
  EXPECT_FALSE(view.background.has_value());
  EXPECT_EQ(view.azimuth, CameraView{}.azimuth);
}

TEST(CameraComponent, RejectsWhatNoCameraCanSee) {
  EXPECT_EQ(errors_of([] { view_of({{"field_of_view", 180}}); }).at(0).path, "components.view.field_of_view");
  EXPECT_EQ(errors_of([] { view_of({{"altitude", 90}}); }).at(0).path, "components.view.altitude");
  EXPECT_EQ(errors_of([] { view_of({{"azimuth", "i"}}); }).at(0).path, "components.view.azimuth");
  EXPECT_EQ(errors_of([] { view_of({{"traget", Value::List{0, 0, 0}}}); }).at(0).nearest, "target");
}

TEST(CameraComponent, ItsFrameMovesTheWholePlant) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera", {{"frame", Value::Object{{"translate", Value::List{0, 5, 0}}}}});
  const Plant plant = builder.component("box", "simple").link("view", "box").grow();
  EXPECT_EQ(plant.organs.at(0).frame.origin.y, 5);
}

}  // namespace meristem::camera_test

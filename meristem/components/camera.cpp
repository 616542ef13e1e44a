// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/camera.h"

namespace meristem {

namespace {

/// The parameters of CameraView, at the top level of the component.
const ParameterTable& view_table() {
  static const ParameterTable table =
      Table<CameraView>("a camera", "The view of pictures and the root of the graph.")
          .vector("position", &CameraView::position, {.unit = Unit::metre, .min = -1e7, .max = 1e7, .usual = {-50, 50}},
                  "Position of the camera; by default, one from which the whole plant is seen.")
          .in_space(InSpace::position)
          .vector("target", &CameraView::target, {.unit = Unit::metre, .min = -1e7, .max = 1e7, .usual = {-50, 50}},
                  "Point that the camera looks at; by default, the middle of the plant.")
          .in_space(InSpace::position)
          .number(
              "azimuth", &CameraView::azimuth,
              {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 360}, .fixed = true},
              "Azimuth of the camera as seen from the target, from north (0) over east (90); 'position' replaces it.")
          .number("altitude", &CameraView::altitude, {.unit = Unit::degree, .min = -89, .max = 89, .fixed = true},
                  "Angle of the camera above the horizon as seen from the target; 'position' replaces it.")
          .number("field_of_view", &CameraView::field_of_view,
                  {.unit = Unit::degree, .min = 1, .max = 150, .usual = {10, 90}, .fixed = true},
                  "Vertical opening angle of the camera; raised, the view gets wider and its perspective stronger.")
          .number("roll", &CameraView::roll,
                  {.unit = Unit::degree, .min = -360, .max = 360, .usual = {-45, 45}, .fixed = true},
                  "Turn of the camera about its line of sight; raised, the picture turns clockwise.")
          .colour("background", &CameraView::background, "Colour behind the plant; by default, the sky.")
          .number("haze", &CameraView::haze,
                  {.unit = Unit::metre, .min = 1, .max = 1e6, .usual = {50, 5000}, .fixed = true},
                  "Distance over which haze hides two thirds of what is seen; raised, the air is clearer; by default, "
                  "there is no haze.")
          .number("clouds", &CameraView::clouds, {.min = 0, .max = 1, .fixed = true},
                  "Share of the sky that is covered by clouds in pictures.")
          .never_with("background", {"clouds"})
          .never_with("position", {"azimuth", "altitude"});
  return table;
}

}  // namespace

ComponentType camera_component() {
  return define_component<CameraParameters>({
      .traits = {.name = "camera",
                 .doc = "The view of pictures and the root of the graph.",
                 .has_geometry = false,
                 .is_camera = true,
                 .bears_plants = true},
      .parameters = Table<CameraParameters>("a camera", "The view of pictures and the root of the graph.")
                        .members(&CameraParameters::view, view_table()),
      .expand = [](const CameraParameters&, const Site&) {},
      .minimum_counts = [](const CameraParameters&, const KnownMembers&) { return MinimumCounts{.children = 1}; },
  });
}

const CameraView& camera_view(const Graph& graph) {
  return static_cast<const CameraParameters*>(graph.components[graph.structure.root].parameters.get())->view;
}

}  // namespace meristem

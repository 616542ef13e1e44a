// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/camera.h"

namespace meristem {

namespace {

/// The rows of View, at the top level of the component.
const ParameterTable& view_table() {
  static const ParameterTable table =
      Table<View>("a camera", "The view of pictures and the root of the graph.")
          .vector("position", &View::position, {.unit = Unit::metre, .min = -1e7, .max = 1e7},
                  "Where the camera stands; chosen so that the whole plant is seen if not given.")
          .vector("target", &View::target, {.unit = Unit::metre, .min = -1e7, .max = 1e7},
                  "What it looks at; the middle of the plant if not given.")
          .number("azimuth", &View::azimuth, {.unit = Unit::degree, .min = -360, .max = 360, .fixed = true},
                  "Where the camera stands as seen from the target, from north over east; without a position.")
          .number("altitude", &View::altitude, {.unit = Unit::degree, .min = -89, .max = 89, .fixed = true},
                  "How high it stands over the horizon as seen from the target; without a position.")
          .number("field_of_view", &View::field_of_view, {.unit = Unit::degree, .min = 1, .max = 150, .fixed = true},
                  "Vertical opening; raised, the picture gets wider and nearer.")
          .colour("background", &View::background, "Behind the plant; the sky if not given.")
          .never_with("position", {"azimuth", "altitude"});
  return table;
}

}  // namespace

ComponentType camera_component() {
  return define_component<CameraParameters>({
      .traits = {.name = "camera",
                 .doc = "The view of pictures and the root of the graph.",
                 .has_geometry = false,
                 .is_camera = true},
      .parameters = Table<CameraParameters>("a camera", "The view of pictures and the root of the graph.")
                        .members(&CameraParameters::view, view_table()),
      .expand = [](const CameraParameters&, const Site&, Emitter&) {},
  });
}

const View& camera_view(const Graph& graph) {
  return static_cast<const CameraParameters*>(graph.components[graph.structure.root].parameters.get())->view;
}

}  // namespace meristem

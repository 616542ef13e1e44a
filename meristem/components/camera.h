// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/graph.h"
#include "meristem/scene/view.h"

namespace meristem {

/// The root of every graph: the view, and the frame that contains the plants.
struct CameraParameters : ComponentBase {
  CameraView view;  ///< camera and frame of pictures
};

/// Returns the component type `camera`.
ComponentType camera_component();

/// Returns the view of a graph whose structure is valid.
const CameraView& camera_view(const Graph& graph);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/graph.h"
#include "meristem/scene/view.h"

namespace meristem {

/// The root of every graph: the view, and the frame in which the plants stand.
struct CameraParameters : ComponentBase {
  View view;  ///< camera and frame of pictures
};

/// The type of that name.
ComponentType camera_component();

/// The view of a graph whose structure is sound.
const View& camera_view(const Graph& graph);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include "meristem/scene/scene.h"

namespace meristem::python {

void bind_scene(py::module_& module) {
  py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene", "What surrounds plants and what they perceive.");
}

}  // namespace meristem::python

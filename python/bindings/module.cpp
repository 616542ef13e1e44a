// SPDX-License-Identifier: Apache-2.0
// The compiled half of the Python module: meristem._core.
#include <pybind11/pybind11.h>

#include "build_info.h"
#include "call.h"
#include "document.h"
#include "errors.h"
#include "grass.h"
#include "meristem/base/version.h"
#include "scene.h"

PYBIND11_MODULE(_core, module) {
  using namespace meristem::python;
  bind_errors();
  bind_progress(module);
  bind_skeleton(module);
  bind_mesh(module);
  bind_grass(module);
  bind_grass_forms(module);
  bind_grass_blade(module);
  bind_scene(module);
  bind_colonize(module);
  bind_trace(module);
  bind_plant(module);
  bind_shade(module);
  bind_scan(module);
  bind_document(module);
  bind_dataset(module);
  bind_session(module);
  bind_word(module);
  bind_component_types(module);
  module.attr("__version__") = std::string(meristem::version());
  module.attr("__commit__") = std::string(meristem::build_commit());
}

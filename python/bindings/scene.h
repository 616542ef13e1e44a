// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace meristem::python {

namespace py = pybind11;

void bind_scene(py::module_& module);

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
// The stages of a grass leaf.
#pragma once

#include <memory>
#include <vector>

#include <pybind11/pybind11.h>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem::python {

namespace py = pybind11;

using GrassLeafPointer = std::shared_ptr<GrassLeaf>;

/// Numbers of any count; the errors of numbers_of.
std::vector<double> all_numbers_of(const py::object& object, const char* name);

/// Degrees of radians.
std::vector<double> in_degrees(std::vector<double> angles);

/// Measured leaves, fits, and the leaf itself.
void bind_grass(py::module_& module);
/// What changes a leaf's form: age, turns, loads.
void bind_grass_forms(py::module_& module);
/// What makes it plain or gives it a surface: reduction, blades.
void bind_grass_blade(py::module_& module);

}  // namespace meristem::python

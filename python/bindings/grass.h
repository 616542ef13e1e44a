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

/// Returns any number of numbers. Throws like numbers_of.
std::vector<double> all_numbers_of(const py::object& object, const char* name);

/// Converts radians to degrees.
std::vector<double> in_degrees(std::vector<double> angles);

/// Measured leaves, fits, and the leaf itself.
void bind_grass(py::module_& module);
/// Stages that change a leaf's form: age, turns, loads.
void bind_grass_forms(py::module_& module);
/// Stages that simplify a leaf or make its surface: reduction, blades.
void bind_grass_blade(py::module_& module);

}  // namespace meristem::python

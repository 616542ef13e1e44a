// SPDX-License-Identifier: Apache-2.0
// Converts the library's errors to the Python classes of meristem/_errors.py.
#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "meristem/base/diagnostic.h"

namespace meristem::python {

namespace py = pybind11;

/// Returns a tuple of meristem.Diagnostic.
py::tuple to_python(const std::vector<Diagnostic>& diagnostics);

void bind_errors();

}  // namespace meristem::python

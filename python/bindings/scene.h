// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "meristem/base/diagnostic.h"
#include "meristem/scene/scene.h"

namespace meristem::python {

namespace py = pybind11;

/// Points from an array (n, 3), or one from (3,); the errors of points_of.
std::vector<Vec3> one_or_more_points(const py::object& object, const char* name);

/// What `read()` gives. Its faults lose file, line and column where they lie in a text that the caller never wrote.
template <class Read>
auto read_written_here(Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& diagnostic : diagnostics) {
      diagnostic.file.clear();
      diagnostic.line = diagnostic.column = 0;
    }
    throw InputError(std::move(diagnostics));
  }
}

/// What pickles carry of a scene: its light and its bodies, not the files and values that they came from.
py::tuple state_of(const Scene& scene);
Scene scene_from(const py::tuple& state);

void bind_scene(py::module_& module);
void bind_sun(py::module_& module);
void bind_colonize(py::module_& module);

}  // namespace meristem::python

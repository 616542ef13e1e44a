// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "meristem/base/diagnostic.h"
#include "meristem/scene/scene.h"

namespace meristem::python {

namespace py = pybind11;

/// Returns points from an array (n, 3), or one point from (3,). Throws like points_of.
std::vector<Vec3> one_or_more_points(const py::object& object, const char* name);

/// Returns the result of `read()`. Removes file, line and column from faults in a text that the caller never wrote.
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

/// The pickled state of a scene: its light and its bodies, without the files and values that they came from.
py::tuple state_of(const Scene& scene);
Scene scene_from(const py::tuple& state);

void bind_scene(py::module_& module);
void bind_sun(py::module_& module);
void bind_colonize(py::module_& module);

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "meristem/document/document.h"
#include "meristem/document/grow.h"

namespace meristem::python {

namespace py = pybind11;

/// A document and what it was read from, so that it can be read again with other values. It never changes, so calls
/// that run on other threads may use it.
struct DocumentInPython {
  std::string text;
  std::string file;
  std::vector<Override> overrides;
  std::optional<std::uint64_t> seed;
  Document document;

  /// Throws InputError.
  DocumentInPython(std::string given_text, std::string given_file, std::vector<Override> values,
                   std::optional<std::uint64_t> other_seed);
  /// What the text says, with overrides and seed.
  Value tree() const;
};

/// A document that has grown.
struct PlantInPython {
  std::shared_ptr<const DocumentInPython> origin;
  GrownDocument grown;
};

void bind_component_types(py::module_& module);
void bind_document(py::module_& module);
void bind_skeleton(py::module_& module);
void bind_mesh(py::module_& module);
void bind_plant(py::module_& module);

}  // namespace meristem::python

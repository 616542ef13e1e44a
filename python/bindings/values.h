// SPDX-License-Identifier: Apache-2.0
// Converts values of documents to and from Python's dicts, lists, numbers and texts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "meristem/document/document.h"
#include "meristem/graph/table/value.h"

namespace meristem::python {

namespace py = pybind11;

/// Whole numbers become int, others float.
py::object to_python(const Value& value);

/// Accepts mappings, lists, tuples, numpy's arrays and scalars, numbers, texts and None. Throws InputError with the
/// path for other types, for keys that are not texts, and for nesting beyond the limit of documents. Also throws
/// InputError for numbers that are not finite, and for whole numbers that a double cannot hold.
Value to_value(const py::handle& object);

/// Returns a path from text, bytes or an os.PathLike, in the system's encoding. Throws TypeError, and ValueError for a
/// NUL in the path.
std::string path_of(const py::object& path);

/// Returns the path of an output file. Refuses standard output.
std::string file_of(const py::object& path);

/// Returns a seed from a whole number. Throws TypeError for other types, and ValueError outside of 0 to 2^53.
std::uint64_t seed_of(const py::handle& seed);

/// Returns the overrides of a mapping from names to values, in its order.
std::vector<ValueOverride> to_overrides(const py::object& mapping);

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
// The values of documents to and from Python's dicts, lists, numbers and texts.
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

/// Takes mappings, lists, tuples, numpy's arrays and scalars, numbers, texts and None. Throws InputError with the path
/// for other types, keys that are no text, numbers that are not finite, whole ones that a double cannot hold, and
/// nesting beyond what documents may have.
Value to_value(const py::handle& object);

/// A path from text, bytes or an os.PathLike, as the system spells it. Throws TypeError, and ValueError for a NUL in
/// it.
std::string path_of(const py::object& path);

/// The path of a file that is written: standard output is refused.
std::string file_of(const py::object& path);

/// A seed from a whole number. Throws TypeError for others, and ValueError outside of 0 to 2^53.
std::uint64_t seed_of(const py::handle& seed);

/// What a mapping from names to values sets, in its order.
std::vector<Override> to_overrides(const py::object& mapping);

}  // namespace meristem::python

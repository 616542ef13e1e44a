// SPDX-License-Identifier: Apache-2.0
#include "arrays.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace meristem::python {

namespace {

/// Returns the argument as a numpy array. Refuses text, objects, complex numbers and times, and also fractions if whole
/// numbers are required.
py::array real_array(const py::object& object, const char* name, bool whole) {
  if (py::hasattr(object, "mask") && py::module_::import("numpy").attr("ma").attr("is_masked")(object).cast<bool>()) {
    throw py::value_error(fmt::format("{} has masked numbers; fill or leave out what is masked", name));
  }
  const py::array array = py::array::ensure(object);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(fmt::format("{} cannot be read as an array", name));
  }
  const char kind = array.dtype().kind();
  const bool is_whole = kind == 'i' || kind == 'u';
  // numpy makes an array of floats from an empty list.
  if (is_whole || (kind == 'f' && (!whole || array.size() == 0))) return array;
  throw py::type_error(fmt::format("{} must hold {} numbers, not {}", name, whole ? "whole" : "real",
                                   std::string(py::str(array.dtype()))));
}

void check_length(const py::array& array, const char* name, std::size_t rows) {
  if (array.ndim() == 1 && static_cast<std::size_t>(array.shape(0)) == rows) return;
  throw py::value_error(fmt::format("{} must have shape ({},), not {}", name, rows, shape_text(array)));
}

}  // namespace

std::string shape_text(const py::array& array) { return std::string(py::str(array.attr("shape"))); }

std::vector<Vec3> points_of(const py::object& object, const char* name) {
  const py::array given = real_array(object, name, false);
  if (given.size() == 0 && given.ndim() == 1) return {};
  if (given.ndim() != 2 || given.shape(1) != 3) {
    throw py::value_error(fmt::format("{} must have shape (n, 3), not {}", name, shape_text(given)));
  }
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>(given);
  const auto rows = array.unchecked<2>();
  std::vector<Vec3> points(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t row = 0; row < rows.shape(0); ++row) {
    for (py::ssize_t k = 0; k < 3; ++k) {
      const auto number = static_cast<float>(rows(row, k));
      if (!std::isfinite(number)) throw py::value_error(fmt::format("{}[{}, {}] is {}", name, row, k, number));
      points[row][static_cast<int>(k)] = number;
    }
  }
  return points;
}

std::vector<double> numbers_of(const py::object& object, const char* name, std::size_t rows) {
  const py::array given = real_array(object, name, false);
  check_length(given, name, rows);
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>(given);
  std::vector<double> numbers(array.data(), array.data() + array.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (!std::isfinite(numbers[k])) throw py::value_error(fmt::format("{}[{}] is {}", name, k, numbers[k]));
  }
  return numbers;
}

std::vector<std::int64_t> whole_numbers_of(const py::object& object, const char* name, std::size_t rows,
                                           std::int64_t low, std::int64_t high) {
  const py::array given = real_array(object, name, true);
  check_length(given, name, rows);
  // A number beyond 63 bits would wrap around. As a double it stays outside of every range.
  const auto doubles = py::array_t<double, py::array::c_style | py::array::forcecast>(given);
  const auto array = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(given);
  std::vector<std::int64_t> numbers(array.data(), array.data() + array.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const bool is_in_range = numbers[k] >= low && numbers[k] <= high && doubles.data()[k] <= 9.3e18 &&
                             std::signbit(doubles.data()[k]) == (numbers[k] < 0);
    if (!is_in_range) {
      throw py::value_error(fmt::format("{}[{}] is {:.0f}; expected {} to {}", name, k, doubles.data()[k], low, high));
    }
  }
  return numbers;
}

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
// Converts memory of the library to numpy arrays, and numpy arrays to the library's types.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/numpy.h>

#include "meristem/base/frame.h"
#include "meristem/base/vec.h"

namespace meristem::python {

namespace py = pybind11;

/// Returns an array over memory of `owner`. The array keeps `owner` alive. Strides in bytes.
template <class T>
py::array_t<T> array_over(const std::shared_ptr<const void>& owner, const T* data, std::vector<py::ssize_t> shape,
                          std::vector<py::ssize_t> strides) {
  const py::capsule keeper(new std::shared_ptr<const void>(owner),
                           [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
  return py::array_t<T>(std::move(shape), std::move(strides), data, keeper);
}

/// Returns a read-only view of data that `owner` keeps alive.
template <class T>
py::array_t<T> view(const std::shared_ptr<const void>& owner, const T* data, std::vector<py::ssize_t> shape,
                    std::vector<py::ssize_t> strides) {
  py::array_t<T> array = array_over(owner, data, std::move(shape), std::move(strides));
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Returns a view of a column: one number per row.
template <class T>
py::array_t<T> column_view(const std::shared_ptr<const void>& owner, const std::vector<T>& column) {
  return view(owner, column.data(), {static_cast<py::ssize_t>(column.size())}, {sizeof(T)});
}

/// Returns a view of a column of small vectors, each of `width` numbers of type T.
template <class T, class Row>
py::array_t<T> rows_view(const std::shared_ptr<const void>& owner, const std::vector<Row>& rows) {
  constexpr auto width = static_cast<py::ssize_t>(sizeof(Row) / sizeof(T));
  return view(owner, reinterpret_cast<const T*>(rows.data()), {static_cast<py::ssize_t>(rows.size()), width},
              {sizeof(Row), sizeof(T)});
}

/// Returns a view of frames with a distance of `stride` bytes: (n, 4, 3), the rows right, heading, upper and origin.
inline py::array_t<float> frames_view(const std::shared_ptr<const void>& owner, const Frame* first, std::size_t count,
                                      std::size_t stride) {
  static_assert(sizeof(Frame) == 12 * sizeof(float));
  return view(owner, reinterpret_cast<const float*>(first), {static_cast<py::ssize_t>(count), 4, 3},
              {static_cast<py::ssize_t>(stride), 3 * sizeof(float), sizeof(float)});
}

/// Returns an array that takes ownership of `values`.
template <class T>
py::array_t<T> array_of(std::vector<T> values) {
  const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
  return array_over(owner, owner->data(), {static_cast<py::ssize_t>(owner->size())}, {sizeof(T)});
}

/// Returns a text such as "(4, 3)".
std::string shape_text(const py::array& array);

/// Returns points from an array (n, 3) of real numbers. `name` is the argument's name. Throws TypeError for other
/// types, and ValueError for other shapes and for numbers that are not finite.
std::vector<Vec3> points_of(const py::object& object, const char* name);

/// Returns a column of `rows` real numbers. Throws like points_of, and ValueError for another length.
std::vector<double> numbers_of(const py::object& object, const char* name, std::size_t rows);

/// Returns a column of `rows` whole numbers from `low` to `high`. Throws like the overload above.
std::vector<std::int64_t> whole_numbers_of(const py::object& object, const char* name, std::size_t rows,
                                           std::int64_t low, std::int64_t high);

}  // namespace meristem::python

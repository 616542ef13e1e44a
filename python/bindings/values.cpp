// SPDX-License-Identifier: Apache-2.0
#include "values.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "meristem/base/limits.h"
#include "meristem/base/seed.h"

namespace meristem::python {

namespace {

constexpr std::size_t kReadBetweenSignals = 4096;     // values of Python between two checks for Ctrl-C
constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: up to here a double holds every whole number

/// A text that is not UTF-8 contains half a character.
std::optional<std::string> text_of(const py::handle& text) {
  Py_ssize_t size = 0;
  const char* const bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes != nullptr) return std::string(bytes, static_cast<std::size_t>(size));
  PyErr_Clear();
  return {};
}

std::string type_name(const py::handle& object) { return py::str(py::type::handle_of(object).attr("__name__")); }

[[noreturn]] void refuse(const DocumentPath& path, std::string message, std::string expected) {
  throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .path = path.text()});
}

std::string text_at(const py::handle& object, const DocumentPath& path) {
  std::optional<std::string> text = text_of(object);
  if (!text) refuse(path, "a text has half a character (a lone surrogate)", "text that is UTF-8");
  return *std::move(text);
}

class ValueReader {
 public:
  // Nesting is bounded, so recursion is safe, also for a list that contains itself.
  Value read(const py::handle& object, const DocumentPath& path, std::uint64_t depth) {
    if (++read_ % kReadBetweenSignals == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (depth > SizeLimits().nesting) {
      refuse(path, "lists and objects are nested too deeply", fmt::format("at most {} levels", SizeLimits().nesting));
    }
    if (object.is_none()) return {};
    if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
    if (py::isinstance<py::str>(object)) return text_at(object, path);
    if (PyMapping_Check(object.ptr()) != 0 && py::hasattr(object, "items")) return read_members(object, path, depth);
    if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) return read_items(object, path, depth);
    // numpy's arrays become lists of Python numbers, and numpy's scalars become Python numbers.
    if (py::hasattr(object, "tolist")) {
      const py::object list = object.attr("tolist")();
      if (!py::type::handle_of(list).is(py::type::handle_of(object))) return read(list, path, depth + 1);
    }
    return read_number(object, path);
  }

 private:
  Value read_members(const py::handle& object, const DocumentPath& path, std::uint64_t depth) {
    Value::Object members;
    for (const py::handle item : py::list(object.attr("items")())) {
      const auto pair = item.cast<py::tuple>();
      if (pair.size() != 2) refuse(path, "an item of a mapping is not a pair", "a key and a value");
      if (!py::isinstance<py::str>(pair[0])) {
        refuse(path, fmt::format("a key is of type {}", type_name(pair[0])), "texts as keys");
      }
      const std::string name = text_at(pair[0], path);
      members.emplace_back(name, read(pair[1], DocumentPath(path, name), depth + 1));
    }
    return members;
  }

  Value read_items(const py::handle& object, const DocumentPath& path, std::uint64_t depth) {
    Value::List list;
    std::size_t index = 0;
    for (const py::handle item : object) list.push_back(read(item, DocumentPath(path, index++), depth + 1));
    return list;
  }

  static Value read_number(const py::handle& object, const DocumentPath& path) {
    const bool is_whole = PyIndex_Check(object.ptr()) != 0;
    if (!is_whole && !py::isinstance<py::float_>(object) && !py::hasattr(object, "__float__")) {
      refuse(path, fmt::format("a value is of type {}", type_name(object)),
             "a dict, list, tuple, array, text, number, bool or None");
    }
    const double number = PyFloat_AsDouble(object.ptr());
    if (PyErr_Occurred() != nullptr) {
      if (PyErr_ExceptionMatches(PyExc_OverflowError) == 0) throw py::error_already_set();
      PyErr_Clear();
      refuse(path, "a number is too large", "one that a double holds");
    }
    if (!std::isfinite(number)) refuse(path, fmt::format("a number is {}", number), "a finite number");
    if (is_whole && (std::abs(number) > kLargestWhole || !py::float_(number).equal(object))) {
      refuse(path, fmt::format("the whole number {} is too large", std::string(py::str(object))),
             "one from -2^53 to 2^53");
    }
    return number;
  }

  std::size_t read_ = 0;
};

}  // namespace

py::object to_python(const Value& value) {
  if (const bool* boolean = value.boolean()) return py::bool_(*boolean);
  if (const double* number = value.number()) {
    if (std::floor(*number) == *number && std::abs(*number) <= kLargestWhole)
      return py::int_(static_cast<long long>(*number));
    return py::float_(*number);
  }
  if (const std::string* text = value.text()) return py::str(*text);
  if (const Value::List* list = value.list()) {
    py::list items;
    for (const Value& item : *list) items.append(to_python(item));
    return items;
  }
  if (const Value::Object* object = value.object()) {
    py::dict members;
    for (const auto& [name, member] : *object) members[py::str(name)] = to_python(member);
    return members;
  }
  return py::none();
}

Value to_value(const py::handle& object) { return ValueReader().read(object, DocumentPath(), 0); }

std::string path_of(const py::object& path) {
  const auto bytes = py::module_::import("os").attr("fsencode")(path).cast<std::string>();
  if (bytes.find('\0') != std::string::npos) throw py::value_error("a path holds the character NUL");
  return bytes;
}

std::string file_of(const py::object& path) {
  std::string file = path_of(path);
  if (file == "-") throw py::value_error("the path of a file is needed, not '-'");
  return file;
}

std::uint64_t seed_of(const py::handle& seed) {
  if (PyIndex_Check(seed.ptr()) == 0) throw py::type_error("seed must be a whole number");
  const auto number = seed_of_text(py::str(py::int_(py::reinterpret_borrow<py::object>(seed))).cast<std::string>());
  if (!number) throw py::value_error(fmt::format("seed must be {}", kSeedRange));
  return *number;
}

std::vector<ValueOverride> to_overrides(const py::object& mapping) {
  std::vector<ValueOverride> overrides;
  if (mapping.is_none()) return overrides;
  const Value values = to_value(mapping);
  if (values.object() == nullptr) throw py::type_error("set must be a dict such as {'leaf.length': 0.1}");
  for (const auto& [path, value] : *values.object()) overrides.push_back({path, value});
  return overrides;
}

}  // namespace meristem::python

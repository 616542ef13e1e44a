// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/base/visible_text.h"

namespace meristem::python {

namespace {

py::module_ errors_module() { return py::module_::import("meristem._errors"); }

/// Returns a file's name in Python's encoding: bytes that are not UTF-8 become surrogates.
py::str file_name(const std::string& name) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeFSDefaultAndSize(name.data(), static_cast<py::ssize_t>(name.size())));
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const InputError& error) {
    const py::object raised = errors_module().attr("InputError")(to_python(error.diagnostics()));
    PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
  } catch (const MachineError& error) {
    const py::object raised = errors_module().attr("MachineError")(visible_text(error.what()));
    PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
  } catch (const Cancelled& cancelled) {
    const py::object raised = errors_module().attr("Cancelled")(cancelled.what());
    PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
  }
}

}  // namespace

py::tuple to_python(const std::vector<Diagnostic>& diagnostics) {
  const py::object make = errors_module().attr("Diagnostic");
  py::list list;
  for (const Diagnostic& found : diagnostics) {
    const Diagnostic d = visible(found);
    list.append(make(d.severity == Severity::error ? "error" : "warning", d.message, d.expected, d.nearest, d.path,
                     file_name(d.file), d.line, d.column, d.text()));
  }
  return py::tuple(list);
}

void bind_errors() { py::register_exception_translator(&translate); }

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include "meristem/base/stoppable_mutex.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"

namespace meristem::python {

namespace py = pybind11;

/// Returns the component types that documents may name: the types of the library and of loaded plug-ins.
const Registry& component_types();

/// Returns the folder of shipped models, which is beside the package. Must be called with the GIL.
std::string models_folder();

/// Data that a document shares with the documents that set() makes from it: the textures of the last painted plant, the
/// results of read files, and the cache of the last growth.
struct SharedWork {
  std::mutex painting;
  GrowthCache textures;
  StoppableMutex reading;
  ReadStore files;
  std::mutex growing;
  GrowthCache growth;
};

/// The text of a document and everything else that reading needs.
struct WrittenDocument {
  std::string text;
  std::string file;
  std::vector<ValueOverride> overrides;
  std::optional<std::uint64_t> seed;
  std::string root;  ///< see ReadOptions
};

/// Component types and models that documents may name. Made with the interpreter's lock, used without it.
struct NamedByDocuments {
  const Registry& types = component_types();
  const std::string models = models_folder();
};

/// A document with its source, so that it can be read again with other values. It never changes, so calls on other
/// threads may use it.
struct DocumentInPython : WrittenDocument {
  Document document;
  std::shared_ptr<SharedWork> shared;  ///< shared with the documents that it was made from
  bool has_other_values = false;       ///< true if set() made it: the cache may hold most of its growth

  /// Reads the document. Must be called without the interpreter's lock: a thread that waits for another read must not
  /// block that read. Throws InputError. Throws Cancelled soon after `progress` was cancelled.
  DocumentInPython(WrittenDocument written, const NamedByDocuments& named, const Progress& progress,
                   std::shared_ptr<SharedWork> shared_work = std::make_shared<SharedWork>());
  /// Wraps a document that was read already.
  DocumentInPython(Document read, std::vector<ValueOverride> values, std::optional<std::uint64_t> other_seed,
                   std::string folder);
  /// Returns the values of the text, with overrides and seed.
  Value tree() const;
};

/// File name of a document that was made in Python.
inline constexpr const char* kFromPython = "<python>";

/// Throws InputError if files named by the document, read from `file`, would not be found from `target`.
void check_named_files(const Document& document, const std::string& file, const std::string& target);

/// Writes the text to a file, whole or not at all. Throws MachineError.
void write_file(const std::string& path, const std::string& text);

/// A grown document. Its meshes and their pictures are made on first use.
class PlantInPython {
 public:
  PlantInPython(std::shared_ptr<const DocumentInPython> from, GrownDocument grown)
      : origin(std::move(from)), grown_(std::move(grown)), has_meshes_(grown_.up_to >= GrownPart::meshes) {}

  const std::shared_ptr<const DocumentInPython> origin;

  /// Returns the plant with a copy of each placed plant. Throws InputError if the copies exceed a limit.
  const Plant& plant() const;
  /// Returns the plant without copies of placed plants.
  const Plant& unexpanded() const { return grown_.plant; }
  const std::vector<Diagnostic>& warnings() const { return grown_.warnings; }
  const GrowthTraces& traces() const { return grown_.traces; }
  /// Returns the growth, completed up to a part. Must be called on a thread without the interpreter's lock. Throws as
  /// complete_growth does.
  const GrownDocument& up_to(GrownPart part, Progress& progress);
  /// Returns the plant without copies of placed plants. Paints textures if they cut holes, because measures of leaves
  /// need the holes. Throws Cancelled.
  const Plant& with_holes(Progress& progress);
  /// Returns the meshes for rays alone (mesh_for_rays), or all meshes if they have been made. Throws like
  /// mesh_for_rays.
  std::shared_ptr<const MeshScene> ray_meshes(Progress& progress);
  /// Returns the meshes if they have been made, else null.
  const MeshScene* present_meshes() const { return has_meshes_ ? &grown_.meshes : nullptr; }

 private:
  /// Paints textures if they cut holes. The caller holds the mutex.
  void paint_holes(Progress& progress);

  GrownDocument grown_;
  bool has_painted_holes_ = false;
  std::shared_ptr<const MeshScene> ray_meshes_;  // null: not made, or all meshes are made
  mutable std::mutex mutex_;                     // guards the making of parts; finished parts never change
  std::atomic<bool> has_meshes_{false};
  mutable std::once_flag is_expanded_;
  mutable std::unique_ptr<const Plant> expanded_;  // null if no plants are placed
};

/// Makes T.__new__ raise TypeError for classes that only the library constructs. Otherwise Python could make an object
/// without content and read it.
template <class T>
void refuse_new(const char* where) {
  static const std::string message =
      fmt::format("{} cannot be made: {}", std::string(py::str(py::type::of<T>().attr("__name__"))), where);
  auto* const type = reinterpret_cast<PyTypeObject*>(py::type::of<T>().ptr());
  type->tp_new = [](PyTypeObject*, PyObject*, PyObject*) -> PyObject* {
    PyErr_SetString(PyExc_TypeError, message.c_str());
    return nullptr;
  };
}

/// Returns the trace of the growth of a plant, or None if no trace was recorded.
py::object trace_of(const std::shared_ptr<PlantInPython>& plant);

void bind_trace(py::module_& module);
void bind_component_types(py::module_& module);
void bind_dataset(py::module_& module);
void bind_document(py::module_& module);
void bind_skeleton(py::module_& module);
void bind_mesh(py::module_& module);
void bind_plant(py::module_& module);
void bind_scan(py::module_& module);
void bind_session(py::module_& module);
void bind_shade(py::module_& module);
void bind_word(py::module_& module);

}  // namespace meristem::python

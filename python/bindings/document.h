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

/// The component types that documents may name: those of the library and of the plug-ins that were loaded.
const Registry& component_types();

/// The folder of shipped models, which stands beside the package. To be called with the GIL.
std::string models_folder();

/// What a document and those that set() makes of it share: the textures of the last plant that has been painted, what
/// reading has made of files, and what the last growth of one of them has left.
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
  std::vector<Override> overrides;
  std::optional<std::uint64_t> seed;
  std::string root;  ///< as of ReadOptions
};

/// Component types and models that documents may name. Made with the interpreter's lock, used without it.
struct NamedByDocuments {
  const Registry& types = component_types();
  const std::string models = models_folder();
};

/// A document and what it was read from, so that it can be read again with other values. It never changes, so calls
/// that run on other threads may use it.
struct DocumentInPython : WrittenDocument {
  Document document;
  std::shared_ptr<SharedWork> shared;  ///< with the documents that it was made of
  bool has_other_values = false;       ///< than the one that set() made it of, so that growing it may find much done

  /// Reads the document. Without the interpreter's lock: a thread that waits for another read must not keep that read
  /// from the interpreter. Throws InputError; Cancelled soon after `progress` was asked to stop.
  DocumentInPython(WrittenDocument written, const NamedByDocuments& named, const Progress& progress,
                   std::shared_ptr<SharedWork> shared_work = std::make_shared<SharedWork>());
  /// A document that was read already.
  DocumentInPython(Document read, std::vector<Override> values, std::optional<std::uint64_t> other_seed,
                   std::string folder);
  /// What the text says, with overrides and seed.
  Value tree() const;
};

/// The file of a document that was made in Python.
inline constexpr const char* kFromPython = "<python>";

/// Throws InputError unless files that the document, read from `file`, names are found from `target` as well.
void check_named_files(const Document& document, const std::string& file, const std::string& target);

/// The text as a file, whole or not at all. Throws MachineError.
void write_file(const std::string& path, const std::string& text);

/// A document that has grown. Its meshes and the pictures on them are made when they are first asked for.
class PlantInPython {
 public:
  PlantInPython(std::shared_ptr<const DocumentInPython> from, GrownDocument grown)
      : origin(std::move(from)), grown_(std::move(grown)), has_meshes_(grown_.up_to >= GrownPart::meshes) {}

  const std::shared_ptr<const DocumentInPython> origin;

  /// With a copy of each placed plant. Throws InputError where they pass a limit.
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
  /// The meshes for rays alone (mesh_for_rays), or all meshes if they have been made. Throws as mesh_for_rays does.
  std::shared_ptr<const MeshScene> ray_meshes(Progress& progress);
  /// The meshes if they have been made, else null.
  const MeshScene* present_meshes() const { return has_meshes_ ? &grown_.meshes : nullptr; }

 private:
  /// Paints textures if they cut holes. The caller holds the mutex.
  void paint_holes(Progress& progress);

  GrownDocument grown_;
  bool has_painted_holes_ = false;
  std::shared_ptr<const MeshScene> ray_meshes_;  // null: not made, or all meshes are made
  mutable std::mutex mutex_;                     // guards what is being made; what there is does not change
  std::atomic<bool> has_meshes_{false};
  mutable std::once_flag is_expanded_;
  mutable std::unique_ptr<const Plant> expanded_;  // null where nothing is placed
};

/// Has T.__new__ raise TypeError, where only the library makes objects: one without content would be read all the same.
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

/// What was recorded of the growth of a plant; None where nothing was.
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

// SPDX-License-Identifier: Apache-2.0
// Data sets: the plan by content, as workers receive it, and the folder of the plants. _dataset.py decides where plants
// grow.
#include <chrono>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "call.h"
#include "document.h"
#include "errors.h"
#include "meristem/base/parallel.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/dataset_folder.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/manifest.h"
#include "meristem/dataset/plant_maker.h"
#include "meristem/dataset/plant_range.h"
#include "meristem/dataset/verify_dataset.h"
#include "meristem/document/json.h"
#include "values.h"

namespace meristem::python {

namespace {

namespace fs = std::filesystem;

/// A plan with its documents by content, and the makers of its plants, one per thread.
class PlanInPython {
 public:
  PlanInPython(const std::string& text, const std::string& file, std::vector<GivenDocument> documents,
               const std::string& scratch)
      : models_(models_folder()), scratch_(scratch) {
    const ThreadLimit alone(1);  // so that a process that is forked later misses no threads of the library
    plan = read_dataset_plan(text, file, component_types(), {.models = models_, .documents = std::move(documents)});
  }

  DatasetPlan plan;

  /// Returns the seconds, and the argument of put_range if this process cannot reach the folder.
  std::pair<double, std::optional<MadeRange>> make(PlantRange range, const std::string& folder, Progress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    std::unique_ptr<PlantMaker> maker = borrow();
    std::optional<MadeRange> apart;
    if (sees_dataset(plan, folder)) {
      make_range(*maker, plan, range, folder, progress);
    } else {
      apart = make_range_apart(*maker, plan, range, (fs::path(documents_->path()) / "plants").string(), progress);
    }
    give_back(std::move(maker));
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), std::move(apart)};
  }

 private:
  std::unique_ptr<PlantMaker> borrow() {
    const std::scoped_lock lock(mutex_);
    if (documents_ == nullptr) {
      auto folder = std::make_unique<ScratchFolder>(scratch_, "meristem-");
      unpack_documents(plan, documents_path(folder->path()));
      documents_ = std::move(folder);
    }
    if (makers_.empty()) {
      return std::make_unique<PlantMaker>(
          plan, component_types(), DocumentFolders{.documents = documents_path(documents_->path()), .models = models_});
    }
    std::unique_ptr<PlantMaker> maker = std::move(makers_.back());
    makers_.pop_back();
    return maker;
  }
  void give_back(std::unique_ptr<PlantMaker> maker) {
    const std::scoped_lock lock(mutex_);
    makers_.push_back(std::move(maker));
  }

  std::string models_;
  std::string scratch_;
  std::mutex mutex_;
  std::unique_ptr<ScratchFolder> documents_;
  std::vector<std::unique_ptr<PlantMaker>> makers_;
};

using PlanPointer = std::shared_ptr<PlanInPython>;

std::string scratch_folder() { return py::module_::import("tempfile").attr("gettempdir")().cast<std::string>(); }

PathValues path_values(const std::vector<ValueOverride>& overrides) {
  PathValues values;
  for (const ValueOverride& override : overrides) values.emplace_back(override.path, override.value);
  return values;
}

PlanPointer plan_of(const py::object& content, const std::string& file, const py::dict& documents) {
  const Value value = to_value(content);
  const std::string text = value.text() != nullptr ? *value.text() : write_json(value);
  std::vector<GivenDocument> given;
  for (const auto& [name, document] : documents) {
    const auto& one = *document.cast<std::shared_ptr<DocumentInPython>>();
    given.push_back({name.cast<std::string>(), one.text, one.file, path_values(one.overrides)});
  }
  return std::make_shared<PlanInPython>(text, file, std::move(given), scratch_folder());
}

py::dict values_of(const PathValues& values) {
  py::dict dict;
  for (const auto& [path, value] : values) dict[py::str(path)] = to_python(value);
  return dict;
}

py::tuple plan_state(const PlanPointer& plan) {
  py::list documents;
  for (const PlannedDocument& document : plan->plan.documents) {
    py::list files;
    for (const auto& [path, content] : document.bundle.files) files.append(py::make_tuple(path, py::bytes(content)));
    documents.append(py::make_tuple(document.name, document.bundle.document, files, values_of(document.set)));
  }
  return py::make_tuple(folder_plan_text(plan->plan), documents);
}

/// Returns paths and bytes.
std::vector<std::pair<std::string, std::string>> files_of(const py::handle& list) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const py::handle& file : list) {
    const auto pair = file.cast<py::tuple>();
    files.emplace_back(pair[0].cast<std::string>(), pair[1].cast<std::string>());
  }
  return files;
}

PlanPointer plan_from_state(const py::tuple& state) {
  if (state.size() != 2) throw py::value_error("the state of a DatasetPlan has two parts");
  const std::string scratch = scratch_folder();
  const ScratchFolder folder(scratch, "meristem-");  // until the documents are read
  std::vector<GivenDocument> given;
  for (const py::handle& one : state[1]) {
    const auto document = one.cast<py::tuple>();
    const DocumentBundle bundle{.document = document[1].cast<std::string>(), .files = files_of(document[2])};
    std::string text;
    for (const auto& [path, content] : bundle.files) {
      if (path == bundle.document) text = content;
    }
    const auto name = document[0].cast<std::string>();
    const fs::path own = fs::path(folder.path()) / name;
    unpack(bundle, own.string());
    given.push_back({name, text, (own / bundle.document).string(), path_values(to_overrides(document[3]))});
  }
  return std::make_shared<PlanInPython>(state[0].cast<std::string>(), "plan.json", std::move(given), scratch);
}

py::dict plant_of(const PlanPointer& plan, std::uint64_t number) {
  if (number >= plan->plan.count()) throw py::index_error(fmt::format("the plan has {} plants", plan->plan.count()));
  const PlannedPlant plant = plan->plan.plant(number);
  py::dict made;
  made["key"] = plant.key;
  made["document"] = plan->plan.documents[plant.document].name;
  made["seed"] = plant.seed;
  made["values"] = values_of(plant.values);
  return made;
}

py::object make_in(const PlanPointer& plan, const std::string& folder, std::uint64_t begin, std::uint64_t end,
                   const py::object& progress) {
  auto [seconds, apart] = run_call(progress, 1, [&](Progress& inner) {
    return plan->make({begin, end}, folder, inner);
  });
  if (!apart) return py::make_tuple(seconds, py::none());
  py::list files;
  for (const auto& [path, content] : apart->files) files.append(py::make_tuple(path, py::bytes(content)));
  return py::make_tuple(seconds, py::make_tuple(py::bytes(apart->rows), files));
}

/// The folder of a data set and its plan.
struct FolderInPython {
  FolderInPython(PlanPointer the_plan, const std::string& path, DatasetOpening opening, Progress& progress)
      : plan(std::move(the_plan)), folder(plan->plan, path, opening, progress) {}

  PlanPointer plan;
  DatasetFolder folder;
};

using FolderPointer = std::shared_ptr<FolderInPython>;

FolderPointer open_folder(const PlanPointer& plan, const py::object& path, const std::string& opening,
                          const py::object& progress) {
  DatasetOpening how = DatasetOpening::resume;
  if (opening == "repair") {
    how = DatasetOpening::repair;
  } else if (opening == "fresh") {
    how = DatasetOpening::fresh;
  } else if (opening != "resume") {
    throw py::value_error(fmt::format("opening is '{}'; expected resume, repair or fresh", opening));
  }
  const std::string folder = path_of(path);
  return run_call(progress, 1,
                  [&](Progress& inner) { return std::make_shared<FolderInPython>(plan, folder, how, inner); });
}

void add_range(const FolderPointer& folder, std::uint64_t begin, std::uint64_t end, double seconds,
               const py::object& apart) {
  const PlantRange range{begin, end};
  if (!apart.is_none()) {
    const auto pair = apart.cast<py::tuple>();
    const MadeRange made{.range = range, .rows = pair[0].cast<std::string>(), .files = files_of(pair[1])};
    const py::gil_scoped_release released;
    put_range(made, folder->plan->plan, folder->folder.path());
  }
  const py::gil_scoped_release released;
  folder->folder.add(range, seconds);
}

py::object next_range(const FolderPointer& folder, double seconds) {
  const auto range = folder->folder.next(seconds);
  return range ? py::object(py::make_tuple(range->begin, range->end)) : py::none();
}

/// Throws InputError if the number of rows differs from the number of plants of the data set in a folder.
void require_finished(const py::object& path, std::uint64_t rows) {
  const std::string folder = path_of(path);
  const std::optional<DatasetInfo> info = read_dataset_info(folder);
  if (!info) throw no_dataset(folder);
  if (info->plants == rows) return;
  throw InputError(
      Diagnostic{.message = fmt::format("the manifest has rows of {} of {} plants", rows, info->plants),
                 .expected = "a data set that is finished: meristem.dataset, or the command of that name, goes on",
                 .file = folder});
}

py::dict check_of(const py::object& path, const py::object& root, bool allow_old, int threads,
                  const py::object& progress) {
  const std::string folder = path_of(path);
  const DatasetCheckOptions options{.root = path_of(root), .allow_old = allow_old};
  // Both query Python, whose lock the call releases.
  const Registry& types = component_types();
  const std::string models = models_folder();
  const DatasetCheck check = run_call(
      progress, threads, [&](Progress& inner) { return verify_dataset(folder, types, models, inner, options); });
  py::dict made;
  made["plants"] = check.plants;
  made["rows"] = check.rows;
  made["failed"] = check.failed;
  made["files"] = check.files;
  made["bytes"] = check.bytes;
  made["faults"] = check.errors;
  made["warnings"] = check.warnings;
  return made;
}

}  // namespace

void bind_dataset(py::module_& module) {
  py::class_<PlanInPython, PlanPointer>(module, "DatasetPlan",
                                        R"(A plan of a data set with its documents, by content.

`content` is the dict of a plan's JSON, or the JSON text itself. `file` names the plan in messages, and documents are
searched in its folder. `documents`, Document objects by their names, replace the documents of the plan. Raises
InputError with all faults.

    plan = meristem.DatasetPlan({"meristem_dataset": 1, "name": "Tulips", "documents": ["tulip"], "seeds": 3,
                                 "files": [".glb"], "measures": ["height"]})
    assert len(plan) == 3 and plan.plant(2)["seed"] == 3)")
      .def(py::init(&plan_of), py::arg("content"), py::kw_only(), py::arg("file") = "<python>",
           py::arg("documents") = py::dict())
      .def("__len__", [](const PlanPointer& plan) { return plan->plan.count(); })
      .def("plant", &plant_of, py::arg("number"),
           "Returns the plan of the plant with a number: a dict of key, document, seed and values.")
      .def("make", &make_in, py::arg("folder"), py::arg("begin"), py::arg("end"), py::kw_only(),
           py::arg("progress") = py::none(),
           R"(Makes the plants from `begin` up to, but not including, `end`, on one thread. Returns (seconds, None).

If this process cannot reach the folder of the data set, returns (seconds, the argument of DatasetFolder.add()).)")
      .def_property_readonly(
          "hash", [](const PlanPointer& plan) { return plan->plan.hash; }, "What two plans are compared by.")
      .def_property_readonly(
          "name", [](const PlanPointer& plan) { return plan->plan.name; }, "Its name.")
      .def_property_readonly(
          "columns", [](const PlanPointer& plan) { return manifest_columns(plan->plan); },
          "The columns of its manifest.")
      .def_property_readonly(
          "warnings", [](const PlanPointer& plan) { return to_python(plan->plan.warnings); },
          "Warnings, a tuple of Diagnostic.")
      .def(py::pickle(&plan_state, &plan_from_state));

  py::class_<FolderInPython, FolderPointer>(module, "DatasetFolder",
                                            R"(The folder of an unfinished data set.

`opening` is 'resume', 'repair' (reads all files) or 'fresh'. Raises InputError if the folder holds something else, and
MachineError if the disk fails or another program works in the folder.)")
      .def(py::init(&open_folder), py::arg("plan"), py::arg("folder"), py::kw_only(), py::arg("opening") = "resume",
           py::arg("progress") = py::none())
      .def("next", &next_range, py::arg("seconds") = 0.5,
           "Returns the next missing plants as (begin, end), about the number that grows in `seconds`. None when all "
           "have been returned.")
      .def("add", &add_range, py::arg("begin"), py::arg("end"), py::arg("seconds"), py::arg("apart") = py::none(),
           "Reports finished plants and their seconds, and for plants made outside of the folder also their results.")
      .def(
          "finish",
          [](const FolderPointer& folder, const py::object& progress) {
            run_call(progress, 1, [&](Progress& inner) {
              folder->folder.finish(inner);
              return true;
            });
          },
          py::kw_only(), py::arg("progress") = py::none(), "Writes the data card when all plants are made.")
      .def(
          "add_file", [](const FolderPointer& folder, const std::string& name) { folder->folder.add_file(name); },
          py::arg("name"), "Adds the hash of a file of the folder to dataset.json, so that verify_dataset checks it.")
      .def("__len__", [](const FolderPointer& folder) { return folder->folder.total(); })
      .def_property_readonly(
          "path", [](const FolderPointer& folder) { return folder->folder.path(); }, "Where it lies.")
      .def_property_readonly(
          "done", [](const FolderPointer& folder) { return folder->folder.done(); }, "How many plants are there.")
      .def_property_readonly(
          "found", [](const FolderPointer& folder) { return folder->folder.found(); },
          "The number of plants that existed when the folder was opened.")
      .def_property_readonly(
          "failed", [](const FolderPointer& folder) { return folder->folder.failed(); },
          "The number of plants with an error and without files.")
      .def_property_readonly(
          "failures", [](const FolderPointer& folder) { return folder->folder.failures(); },
          "Key and error of failed plants: one line each, the first ten.")
      .def_property_readonly(
          "failed_text", [](const FolderPointer& folder) { return folder->folder.failed_text(); },
          "The numbers of written and failed plants, with the first error. Empty if no plant failed.")
      .def_property_readonly(
          "faults", [](const FolderPointer& folder) { return folder->folder.errors(); },
          "Faults of plants that are made again: one line each, the first hundred.");

  py::class_<ScratchFolder, std::shared_ptr<ScratchFolder>>(
      module, "ScratchFolder",
      R"(A new folder for temporary files, which is removed with this object.

The folder of a killed process is removed when another process makes a folder with this prefix in this parent folder.)")
      .def(py::init([](const py::object& parent, const std::string& prefix) {
             return std::make_shared<ScratchFolder>(path_of(parent), prefix);
           }),
           py::arg("parent"), py::arg("prefix"))
      .def_property_readonly(
          "path", [](const ScratchFolder& folder) { return folder.path(); }, "Where it lies.");
  module.def(
      "write_whole_file",
      [](const py::object& path, const std::string& text) { write_whole_file(path_of(path), text); }, py::arg("path"),
      py::arg("text"), "Writes a text file: whole, or not at all. Raises MachineError.");
  module.def(
      "unpack_files",
      [](const py::list& files, const py::object& folder) {
        unpack({.document = {}, .files = files_of(files)}, path_of(folder));
      },
      py::arg("files"), py::arg("folder"),
      "Writes the files of Document.bundle() below a folder, and creates the folder.");
  module.def("require_finished", &require_finished, py::arg("folder"), py::arg("rows"),
             "Raises InputError if the data set in a folder has another number of plants.");
  module.def(
      "verify_dataset", &check_of, py::arg("folder"), py::kw_only(), py::arg("root") = "", py::arg("allow_old") = false,
      py::arg("threads") = 0, py::arg("progress") = py::none(),
      R"(Compares all files of the data set in a folder with the manifest, and the manifest with its hashes and the plan.

Returns a dict of plants, rows, failed, files, bytes, faults and warnings. faults is a list of lines, empty if the data
set is unchanged. warnings lists parts that could not be checked. Tables of earlier versions of the program have no
hashes and cannot be checked: this is a fault, or with `allow_old` a warning. With a `root`, no file outside that folder is read,
wherever links in the folder lead. Raises InputError if the folder holds no data set, lies outside the root, or has a
link that leads out of the root.)");
}

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
#include "document.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "call.h"
#include "errors.h"
#include "meristem/base/atomic_file.h"
#include "meristem/document/bundle.h"
#include "meristem/document/grow_moving.h"
#include "meristem/document/json.h"
#include "meristem/document/models.h"
#include "meristem/document/plan.h"
#include "meristem/export/moving_file.h"
#include "meristem/export/output_files.h"
#include "meristem/measure/foliage.h"
#include "meristem/plant/plant_variant.h"
#include "values.h"

namespace meristem::python {

std::string models_folder() { return py::module_::import("meristem._models").attr("folder")().cast<std::string>(); }

namespace {

namespace fs = std::filesystem;
using DocumentPointer = std::shared_ptr<DocumentInPython>;

std::optional<std::uint64_t> optional_seed(const py::object& seed) {
  if (seed.is_none()) return {};
  return seed_of(seed);
}

/// Reads a document so that Ctrl-C stops it.
DocumentPointer read_written(WrittenDocument written,
                             std::shared_ptr<SharedWork> shared = std::make_shared<SharedWork>()) {
  const NamedByDocuments named;
  return run_call(py::none(), 0, [&](Progress& progress) {
    return std::make_shared<DocumentInPython>(std::move(written), named, progress, std::move(shared));
  });
}

DocumentPointer document_of(const py::object& content, const py::object& file, const py::object& set,
                            const py::object& seed, const py::object& root) {
  const Value value = to_value(content);
  const std::string* const text = value.text();
  const std::string named = path_of(file);
  return read_written({.text = text != nullptr ? *text : write_json(value),
                       .file = named.empty() ? kFromPython : named,
                       .overrides = to_overrides(set),
                       .seed = optional_seed(seed),
                       .root = path_of(root)});
}

DocumentPointer read(const py::object& path, const py::object& set, const py::object& seed, const py::object& root) {
  const DocumentFile found = find_document_within(path_of(path), models_folder(), path_of(root));
  return read_written({.text = read_text_file(found.file),
                       .file = found.file,
                       .overrides = to_overrides(set),
                       .seed = optional_seed(seed),
                       .root = found.root});
}

/// Adds overrides to a document. They replace earlier overrides of equal paths.
WrittenDocument with_overrides(WrittenDocument document, std::vector<ValueOverride> more) {
  for (ValueOverride& next : more) {
    std::erase_if(document.overrides, [&](const ValueOverride& old) { return old.path == next.path; });
    document.overrides.push_back(std::move(next));
  }
  return document;
}

DocumentPointer with_values(const DocumentPointer& document, const py::object& values, const py::object& seed) {
  std::vector<ValueOverride> more = to_overrides(values);
  const bool has_other_seed = std::ranges::any_of(more, [](const ValueOverride& one) { return one.path == "seed"; });
  WrittenDocument written = with_overrides(*document, std::move(more));
  if (has_other_seed) written.seed.reset();
  if (const auto other = optional_seed(seed)) written.seed = other;
  const DocumentPointer made = read_written(std::move(written), document->shared);
  made->has_other_values = !values.is_none();
  return made;
}

void save_document(const DocumentPointer& document, const py::object& path) {
  const std::string target = file_of(path);
  check_named_files(document->document, document->file, target);
  write_file(target, write_json(document->tree()));
}

py::tuple bundle_in_python(const DocumentPointer& document) {
  const DocumentBundle bundle = bundle_of(document->document, models_folder());
  py::list files;
  for (const auto& [path, content] : bundle.files) files.append(py::make_tuple(path, py::bytes(content)));
  return py::make_tuple(bundle.document, files);
}

py::list variables_of(const DocumentPointer& document) {
  const py::object make = py::module_::import("meristem._variable").attr("Variable");
  py::list list;
  for (const Variable& v : document->document.variables) {
    const py::object expression = v.expression.empty() ? py::object(py::none()) : py::str(v.expression);
    list.append(make(v.name, v.value, v.min, v.max, v.unit, v.doc, expression, v.is_private));
  }
  return list;
}

py::dict components_of(const DocumentPointer& document) {
  py::dict components;
  for (const Prototype& prototype : document->document.graph.components) {
    components[py::str(prototype.id)] = prototype.type->name;
  }
  return components;
}

/// Returns the document at a time.
DocumentPointer standing_at(const DocumentPointer& document, double time, const Progress& progress) {
  std::optional<Document> other;
  document_at(document->document, time, other, &progress);
  if (!other) return document;
  return std::make_shared<DocumentInPython>(*std::move(other), document->overrides, document->seed, document->root);
}

std::shared_ptr<PlantInPython> grow_plant(const DocumentPointer& document, double time, const std::optional<int>& step,
                                          bool trace, int threads, const py::object& progress) {
  if (!std::isfinite(time)) throw py::value_error("time must be a finite number of seconds");
  if (step && *step < 0) throw py::value_error("step must be 0 or more");
  GrowthView view{step, {}};
  if (trace) {
    view.request = TraceRequest::all();
  }
  return run_call(progress, threads, [&](Progress& inner) {
    GrowthOptions options{.time = time, .up_to = GrownPart::plant, .view = view};
    std::unique_lock<std::mutex> growing(document->shared->growing, std::defer_lock);
    if (document->has_other_values && growing.try_lock()) options.cache = &document->shared->growth;
    const DocumentPointer now = standing_at(document, time, inner);
    return std::make_shared<PlantInPython>(now, grow_document(now->document, inner, options));
  });
}

PlanRules plan_rules(const py::object& rules) {
  PlanRules asked;
  if (rules.is_none()) return asked;
  const Value value = to_value(rules);
  if (value.list() == nullptr) {
    throw InputError(Diagnostic{.message = fmt::format("rules cannot be {}", value.description()),
                                .expected = "a list of operations"});
  }
  asked.operations = *value.list();
  return asked;
}

std::shared_ptr<PlantInPython> plan_plant(const DocumentPointer& document, const py::object& rules, bool done,
                                          int threads, const py::object& progress) {
  const PlanRules asked = plan_rules(rules);
  const NamedByDocuments named;
  return run_call(progress, threads, [&](Progress& inner) {
    const auto read_with = [&](std::vector<ValueOverride> more) {
      return std::make_shared<DocumentInPython>(with_overrides(*document, std::move(more)), named, inner,
                                                document->shared);
    };
    const DocumentPointer planned = read_with(only_planned(document->document, asked));
    const DocumentPointer shown = done ? read_with(with_rules(document->document, asked)) : planned;
    GrowthOptions options{.up_to = GrownPart::plant, .view = {{}, {TracePart::outcome}, done}};
    std::unique_lock<std::mutex> growing(document->shared->growing, std::defer_lock);
    if (growing.try_lock()) options.cache = &document->shared->growth;
    return std::make_shared<PlantInPython>(shown, grow_document(planned->document, inner, options));
  });
}

void save_animated(const DocumentPointer& document, const py::object& path, int keys, int threads,
                   const py::object& progress) {
  if (keys < 2 || keys > static_cast<int>(kMaxKeys)) {
    throw py::value_error(fmt::format("keys must be from 2 to {}", kMaxKeys));
  }
  const std::string target = file_of(path);
  check_moving_file(target);
  check_output(target, input_files(document->document));
  run_call(progress, threads, [&](Progress& inner) {
    const MovingScene moving = grow_moving(document->document, inner, {.keys = static_cast<std::size_t>(keys)});
    write_moving_file(document->document, moving, target, inner);
    return true;
  });
}

std::string document_repr(const DocumentPointer& document) {
  return fmt::format("<meristem.Document '{}' of {} components, seed {}>", document->document.name,
                     document->document.graph.components.size(), document->document.graph.seed);
}

bool are_documents_equal(const DocumentPointer& document, const py::object& other) {
  if (!py::isinstance<DocumentInPython>(other)) return false;
  const auto second = other.cast<DocumentPointer>();
  const auto folder = [](const DocumentInPython& d) { return fs::path(d.file).parent_path(); };
  return document->document.graph.seed == second->document.graph.seed && folder(*document) == folder(*second) &&
         document->document.source.tree == second->document.source.tree;
}

py::tuple document_state(const DocumentPointer& document) {
  py::dict overrides;
  for (const ValueOverride& override : document->overrides)
    overrides[py::str(override.path)] = to_python(override.value);
  return py::make_tuple(document->text, document->file, overrides, document->seed, document->root);
}

DocumentPointer document_from_state(const py::tuple& state) {
  if (state.size() != 5) throw py::value_error("the state of a Document has five parts");
  return read_written({.text = state[0].cast<std::string>(),
                       .file = state[1].cast<std::string>(),
                       .overrides = to_overrides(state[2]),
                       .seed = optional_seed(state[3]),
                       .root = state[4].cast<std::string>()});
}

}  // namespace

DocumentInPython::DocumentInPython(WrittenDocument written, const NamedByDocuments& named, const Progress& progress,
                                   std::shared_ptr<SharedWork> shared_work)
    : WrittenDocument(std::move(written)), shared(std::move(shared_work)) {
  const auto reading = shared->reading.wait(&progress);
  shared->files.reload();
  document = read_document(text, file, named.types,
                           {.overrides = overrides,
                            .seed = seed,
                            .root = root,
                            .store = &shared->files,
                            .models = named.models,
                            .progress = &progress});
}

DocumentInPython::DocumentInPython(Document read, std::vector<ValueOverride> values,
                                   std::optional<std::uint64_t> other_seed, std::string folder)
    : WrittenDocument{.text = read.source.text,
                      .file = read.source.file,
                      .overrides = std::move(values),
                      .seed = other_seed,
                      .root = std::move(folder)},
      document(std::move(read)),
      shared(std::make_shared<SharedWork>()) {}

const Plant& PlantInPython::plant() const {
  if (!has_plantings(grown_.plant)) return grown_.plant;
  const auto expand = [this] {
    std::call_once(is_expanded_, [this] {
      const std::scoped_lock lock(mutex_);
      const SizeLimits& limits = origin->document.graph.limits;
      expanded_ = std::make_unique<const Plant>(expanded(grown_.plant, limits, Progress()));
    });
  };
  if (PyGILState_Check() == 0) {
    expand();
  } else {
    const py::gil_scoped_release released;
    expand();
  }
  return *expanded_;
}

const GrownDocument& PlantInPython::up_to(GrownPart part, Progress& progress) {
  const std::scoped_lock lock(mutex_);
  complete_growth(origin->document, grown_, progress, {.up_to = std::min(part, GrownPart::meshes)});
  has_meshes_ = grown_.up_to >= GrownPart::meshes;
  if (has_meshes_) ray_meshes_.reset();
  if (part <= grown_.up_to) return grown_;
  // The plants of a batch share their textures, but not their meshes.
  const std::scoped_lock painting(origin->shared->painting);
  complete_growth(origin->document, grown_, progress, {.up_to = part, .cache = &origin->shared->textures});
  return grown_;
}

void PlantInPython::paint_holes(Progress& progress) {
  if (has_painted_holes_ || grown_.up_to >= GrownPart::textures || !has_holes(grown_.plant)) return;
  const std::scoped_lock painting(origin->shared->painting);
  paint_plant(origin->document, grown_.plant, progress, &origin->shared->textures);
  has_painted_holes_ = true;
}

const Plant& PlantInPython::with_holes(Progress& progress) {
  const std::scoped_lock lock(mutex_);
  paint_holes(progress);
  return grown_.plant;
}

std::shared_ptr<const MeshScene> PlantInPython::ray_meshes(Progress& progress) {
  const std::scoped_lock lock(mutex_);
  // Holes let no ray through while materials have only sketches.
  if (has_meshes_ && (grown_.up_to >= GrownPart::textures || !has_holes(grown_.plant))) {
    return {std::shared_ptr<const MeshScene>(), &grown_.meshes};
  }
  paint_holes(progress);
  if (ray_meshes_ == nullptr) {
    ray_meshes_ = std::make_shared<const MeshScene>(mesh_for_rays(origin->document, grown_.plant, progress));
  }
  return ray_meshes_;
}

Value DocumentInPython::tree() const {
  Value tree = document.source.tree;
  if (!seed) return tree;
  const auto number = static_cast<double>(*seed);  // at most 2^53, so exact
  if (Value* member = tree.find("seed")) {
    *member = number;
  } else {
    tree.object()->emplace_back("seed", number);
  }
  return tree;
}

void check_named_files(const Document& document, const std::string& file, const std::string& target_path) {
  const fs::path target = target_path;
  const fs::path from = fs::absolute(fs::path(file).parent_path() / ".");
  const fs::path to = fs::absolute(target.parent_path() / ".");
  std::error_code ignored;
  for (const std::string& named : document.source.named_files) {
    if (fs::path(named).is_absolute() && file == kFromPython) continue;
    const fs::path relative = fs::absolute(named).lexically_normal().lexically_relative(from.lexically_normal());
    if (fs::equivalent(to / relative, named, ignored)) continue;
    throw InputError(
        Diagnostic{.message = fmt::format("'{}' would not find '{}' from there", target.string(), relative.string()),
                   .expected = fmt::format("a file in {}, or that file copied along", from.string())});
  }
}

void write_file(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

void bind_document(py::module_& module) {
  py::class_<DocumentInPython, DocumentPointer>(module, "Document",
                                                R"(A plant document. It never changes: set() returns another document.

`content` is the dict of a document's JSON, or the JSON text itself. It may contain numpy numbers, and tuples or arrays
as lists. Files that it names are searched in the folder of `file`, or in the current folder. `set` sets values by their
paths, as in set(). `seed` (0 to 2^53) replaces the document's seed. With a `root`, the document cannot read files
outside that folder. Ctrl-C stops the reading. Raises InputError with all faults.

    tulip = meristem.Document({
        "meristem": 1,
        "variables": {"tall": {"value": 0.3, "min": 0.1, "max": 1}},
        "components": {"stem": {"type": "tree", "length": "tall", "radius": 0.004}},
    })
    assert tulip.set({"tall": 0.5}).grow().measure()["height"] > tulip.grow().measure()["height"])")
      .def(py::init(&document_of), py::arg("content"), py::kw_only(), py::arg("file") = "", py::arg("set") = py::none(),
           py::arg("seed") = py::none(), py::arg("root") = "")
      .def("set", &with_values, py::arg("values") = py::none(), py::kw_only(), py::arg("seed") = py::none(),
           R"(Returns the document with other values, by their paths, and another seed.

{"age": 20} sets a variable, {"leaf.length": 0.1} a component's parameter, {"links[1].density": 90} or
{"scene.latitude": 50} a key. Changed files are read anew. Growing the new document makes only what has changed since
the last growth of a related document. Raises InputError.)")
      .def("grow", &grow_plant, py::arg("time") = 0.0, py::kw_only(), py::arg("step") = py::none(),
           py::arg("trace") = false, py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Grows the document at `time` (seconds). Returns a Plant, which is equal on any number of threads.

Meshes and textures are made when they are first needed. With a `step`, plants of growth models are as they were after
this step of growth. With `trace`, Plant.trace records all steps of the growth. This takes memory, and changes no plant.

`threads` bounds the threads (0: all cores). `progress` is a Progress, or a function of stage and fraction. Other Python
threads run meanwhile, and Ctrl-C stops the call. Raises InputError (limits), Cancelled.)")
      .def("plan", &plan_plant, py::arg("rules") = py::none(), py::kw_only(), py::arg("done") = false,
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Finds what the operations of the last iteration would do to the trees now. Returns the Plant before these
operations.

Plant.operations are the plan. The column `plan_cut` of its skeletons is the number of the operation that would cut each
metamer off. `rules` are further operations, such as [{"do": "cut", "shoots": "inward", "above": 0}]. They act at the
last iteration by default. With `done`, returns the Plant after the plan; both plants come from one growth. Other
arguments as in grow(). Raises InputError, also if no component has such trees, and Cancelled.)")
      .def("save_animated", &save_animated, py::arg("path"), py::kw_only(), py::arg("keys") = kUsualKeys,
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Writes the document's animation into a .glb file, which browsers and engines play.

The file holds the plant at `keys` times (2 to 1000), evenly from 0 to the animation's length, and moves evenly between
them. Raises InputError if the document has no animation, or if moving parts take too many bytes. Raises MachineError,
Cancelled.)")
      .def("bundle", &bundle_in_python,
           R"(Returns the document and all files that it names, by content, so that another machine can grow it.

Returns (name, files): the path of the document below a folder, and (path, bytes) of each file in this folder.)")
      .def("save", &save_document, py::arg("path"),
           "Writes the document as JSON with all values that were set. Raises InputError if the written document would "
           "not find a file that it names, and MachineError if the file cannot be written.")
      .def(
          "to_dict", [](const DocumentPointer& d) { return to_python(d->tree()); },
          "Returns the content as a new dict, which Document(dict) reads again. Changing the dict changes no document.")
      .def_property_readonly(
          "text", [](const DocumentPointer& d) { return write_json(d->tree()); },
          "The document as JSON, all values set.")
      .def_property_readonly(
          "name", [](const DocumentPointer& d) { return d->document.name; }, "Its name.")
      .def_property_readonly(
          "description", [](const DocumentPointer& d) { return d->document.description; }, "What it says of itself.")
      .def_property_readonly(
          "author", [](const DocumentPointer& d) { return d->document.author; }, "Who made it.")
      .def_property_readonly(
          "licence", [](const DocumentPointer& d) { return d->document.licence; }, "Under what it may be used.")
      .def_property_readonly(
          "file", [](const DocumentPointer& d) { return d->file; }, "The file it was read from, or '<python>'.")
      .def_property_readonly(
          "root", [](const DocumentPointer& d) { return d->root; },
          "The folder outside of which the document reads no files, or an empty text.")
      .def_property_readonly(
          "seed", [](const DocumentPointer& d) { return d->document.graph.seed; }, "What all randomness comes from.")
      .def_property_readonly(
          "variables", &variables_of,
          "The document's variables, a list of Variable. Variables that are not private are handles for users.")
      .def_property_readonly("components", &components_of, "The type of each component, by its id.")
      .def_property_readonly(
          "warnings", [](const DocumentPointer& d) { return to_python(d->document.warnings); },
          "Warnings, a tuple of Diagnostic.")
      .def_property_readonly(
          "scene", [](const DocumentPointer& d) { return std::shared_ptr<Scene>(d, &d->document.scene); },
          "What surrounds the plants: a Scene.")
      .def("__repr__", &document_repr)
      .def("__eq__", &are_documents_equal, py::arg("other"),
           "True if both documents have equal content and search files in the same folder.")
      .def("__hash__",
           [](const DocumentPointer& d) { return std::hash<std::string>()(write_json(d->document.source.tree)); })
      .def(py::pickle(&document_state, &document_from_state));

  module.def(
      "models", [] { return model_names(models_folder()); },
      "Returns the names of the shipped models, for read(), in alphabetical order.");
  module.def("read", &read, py::arg("path"), py::kw_only(), py::arg("set") = py::none(), py::arg("seed") = py::none(),
             py::arg("root") = "",
             R"(Reads the document in a file (str or path), or a shipped model by its name, such as 'oak'.

`set` and `seed` as in Document. With a `root`, neither the document nor a file that it names is read from outside that
folder, wherever links and dots lead. The error does not say whether such a file exists. Shipped models may be read.
Ctrl-C stops the reading. Raises InputError with all faults, each with line and column, and MachineError if the file
cannot be read.)");
}

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/session.h"

#include <cmath>
#include <map>
#include <mutex>

#include <pybind11/stl.h>

#include "call.h"
#include "document.h"
#include "errors.h"
#include "meristem/document/json.h"
#include "meristem/document/models.h"
#include "values.h"

namespace meristem::python {

namespace {

struct SessionInPython {
  SessionInPython(Session given, std::optional<std::uint64_t> other_seed, std::string folder)
      : session(std::move(given)), seed(other_seed), root(std::move(folder)) {}

  Session session;
  const std::optional<std::uint64_t> seed;
  const std::string root;  // see SessionOptions
  std::mutex mutex;        // one call at a time

  /// Throws instead of waiting, because waiting could block other threads forever: they need the interpreter's lock.
  std::unique_lock<std::mutex> lock() {
    std::unique_lock<std::mutex> lock(mutex, std::try_to_lock);
    if (!lock) throw std::runtime_error("another thread is using the session");
    return lock;
  }
};
using SessionPointer = std::shared_ptr<SessionInPython>;

std::optional<std::uint64_t> optional_seed(const py::object& seed) {
  if (seed.is_none()) return {};
  return seed_of(seed);
}

/// Runs a call that reads the text. Ctrl-C stops the call, which then has no effect.
template <class Call>
auto run_reading(const SessionPointer& self, Call call) {
  const auto lock = self->lock();
  return run_call(py::none(), 0, [&](const Progress& progress) { return call(self->session, &progress); });
}

bool read_text(const SessionPointer& self) {
  return run_reading(self, [](Session& session, const Progress* progress) {
    session.read(progress);
    return true;
  });
}

SessionPointer make_session(std::string text, std::string file, const py::object& set, const py::object& seed,
                            const py::object& root) {
  SessionOptions options{.overrides = to_overrides(set),
                         .seed = optional_seed(seed),
                         .root = path_of(root),
                         .models = models_folder(),
                         .reads_at_once = false};
  Session session(std::move(text), std::move(file), component_types(), options);
  auto made = std::make_shared<SessionInPython>(std::move(session), options.seed, options.root);
  read_text(made);
  return made;
}

/// Returns a session of the document's text, with edits for the values that were set.
SessionPointer session_of_document(const DocumentInPython& document, const py::object& root) {
  const std::string own = path_of(root);
  SessionOptions options{.root = own.empty() ? document.root : own, .models = models_folder(), .reads_at_once = false};
  auto made = std::make_shared<SessionInPython>(Session(document.text, document.file, component_types(), options),
                                                std::nullopt, options.root);
  std::vector<SessionEdit> edits;
  for (const ValueOverride& set : document.overrides) edits.emplace_back(SetValue{set.path, set.value});
  if (document.seed) edits.emplace_back(SetValue{"seed", static_cast<double>(*document.seed)});
  if (edits.empty()) {
    read_text(made);
  } else {
    run_reading(made, [&](Session& session, const Progress* progress) { return session.edit(edits, progress); });
  }
  return made;
}

SessionPointer session_of(const py::object& content, const py::object& file, const py::object& set,
                          const py::object& seed, const py::object& root) {
  if (py::isinstance<DocumentInPython>(content)) {
    if (!set.is_none() || !seed.is_none() || !path_of(file).empty()) {
      throw py::type_error("a Document has its own file, values and seed; give others with its set()");
    }
    return session_of_document(content.cast<const DocumentInPython&>(), root);
  }
  const Value value = to_value(content);
  const std::string* const text = value.text();
  const std::string named = path_of(file);
  return make_session(text != nullptr ? *text : write_json(value), named.empty() ? kFromPython : named, set, seed,
                      root);
}

SessionPointer open(const py::object& path, const py::object& set, const py::object& seed, const py::object& root) {
  const DocumentFile found = find_document_within(path_of(path), models_folder(), path_of(root));
  return make_session(read_text_file(found.file), found.file, set, seed, py::str(found.root));
}

py::list to_python(const TextPatch& patch) {
  py::list splices;
  for (const TextSplice& splice : patch) {
    splices.append(py::make_tuple(splice.offset, splice.length, py::str(splice.replacement)));
  }
  return splices;
}

/// Returns the Change, or None if there was no step.
py::object to_python(const std::optional<Change>& change) {
  if (!change) return py::none();
  return py::module_::import("meristem._change").attr("Change")(to_python(change->patch), to_python(change->inverse));
}

py::object edit(const SessionPointer& self, const std::vector<SessionEdit>& edits) {
  return to_python(run_reading(
      self, [&](Session& session, const Progress* progress) { return std::optional(session.edit(edits, progress)); }));
}

py::object edit_values(const SessionPointer& self, const py::object& values) {
  std::vector<SessionEdit> edits;
  for (ValueOverride& given : to_overrides(values)) edits.emplace_back(SetValue{given.path, std::move(given.value)});
  return edit(self, edits);
}

py::object edit_text(const SessionPointer& self,
                     const std::vector<std::tuple<std::size_t, std::size_t, std::string>>& splices) {
  TextPatch patch;
  for (const auto& [offset, length, replacement] : splices) patch.push_back({offset, length, replacement});
  return to_python(run_reading(self, [&](Session& session, const Progress* progress) {
    return std::optional(session.edit_text(patch, progress));
  }));
}

py::object undo(const SessionPointer& self) {
  return to_python(
      run_reading(self, [](Session& session, const Progress* progress) { return session.undo(progress); }));
}

py::object redo(const SessionPointer& self) {
  return to_python(
      run_reading(self, [](Session& session, const Progress* progress) { return session.redo(progress); }));
}

void preview(const SessionPointer& self, const py::object& values) {
  std::vector<ValueOverride> overrides = to_overrides(values);
  run_reading(self, [&](Session& session, const Progress* progress) {
    session.set_overrides(std::move(overrides), progress);
    return true;
  });
}

void reload(const SessionPointer& self) {
  run_reading(self, [](Session& session, const Progress* progress) {
    session.reload(progress);
    return true;
  });
}

std::string part_of_session(const SessionPointer& self, const std::vector<std::string>& components) {
  return run_reading(self, [&](const Session& session, const Progress* progress) {
    return plant_part(session.text(), components, progress);
  });
}

py::dict notes_of_session(const SessionPointer& self) {
  const auto found = run_reading(
      self, [](const Session& session, const Progress* progress) { return component_notes(session.text(), progress); });
  py::dict notes;
  for (const auto& [name, note] : found) notes[py::str(name)] = note;
  return notes;
}

std::optional<std::size_t> optional_index(const py::object& index) {
  if (index.is_none()) return {};
  return index.cast<std::size_t>();
}

std::shared_ptr<DocumentInPython> document_of(const SessionPointer& self) {
  const auto lock = self->lock();
  if (self->session.document() == nullptr) return nullptr;
  return std::make_shared<DocumentInPython>(*self->session.document(), self->session.overrides(), self->seed,
                                            self->root);
}

std::shared_ptr<PlantInPython> grow_session(const SessionPointer& self, double time, int threads,
                                            const py::object& progress) {
  if (!std::isfinite(time)) throw py::value_error("time must be a finite number of seconds");
  const std::shared_ptr<DocumentInPython> document = document_of(self);
  const auto lock = self->lock();
  return run_call(progress, threads, [&](Progress& inner) {
    GrownDocument grown = self->session.grow(inner, {.time = time});
    return std::make_shared<PlantInPython>(document, std::move(grown));
  });
}

void save_session(const SessionPointer& self, const py::object& path) {
  const std::string target = file_of(path);
  const auto lock = self->lock();
  if (!self->session.is_good()) throw InputError(self->session.errors());
  check_named_files(*self->session.document(), self->session.file(), target);
  write_file(target, self->session.text());
}

/// Returns the names "leaf[0]", "leaf[1]", ... of the batches at these indices.
py::list names_of(const SceneKeys& keys, const std::vector<std::size_t>& places) {
  py::list names;
  for (const std::size_t k : places)
    names.append(fmt::format("{}[{}]", keys.batches[k].component, keys.batches[k].number));
  return names;
}

py::dict difference_of(const SessionPointer& self) {
  const auto lock = self->lock();
  const Session& session = self->session;
  py::dict found;
  found["added"] = names_of(session.keys(), session.difference().batches.added);
  found["changed"] = names_of(session.keys(), session.difference().batches.changed);
  found["removed"] = names_of(session.keys_before(), session.difference().batches.removed);
  return found;
}

std::string session_repr(const SessionPointer& self) {
  const auto lock = self->lock();
  const std::size_t errors = self->session.is_good() ? 0 : self->session.errors().size();
  return fmt::format("<meristem.Session of '{}', {} steps to undo, {} faults>", self->session.file(),
                     self->session.undo_count(), errors);
}

constexpr const char* kChange =
    "Returns the Change, which undo() takes back. Raises InputError if a path does not exist.";

void bind_edits(py::class_<SessionInPython, SessionPointer>& session) {
  static const std::string set = std::string("Has the path say the value. ") + kChange;
  static const std::string unset = std::string("Removes a member if it exists, so that its default holds. ") + kChange;
  static const std::string remove =
      std::string("Removes an existing member; a component is removed with all links from and to it. ") + kChange;
  session
      .def("edit", &edit_values, py::arg("values"),
           R"(Sets values by their paths as one step, as in set(): {"age": 20, "leaf.length": 0.1}.

Only the necessary parts of the text change: comments, layout and line endings stay. Missing members are added. Returns
the Change. Raises InputError if a path does not exist, without any change.)")
      .def(
          "set",
          [](const SessionPointer& s, const std::string& path, const py::object& value) {
            return edit(s, {SetValue{path, to_value(value)}});
          },
          py::arg("path"), py::arg("value"), set.c_str())
      .def(
          "unset", [](const SessionPointer& s, const std::string& path) { return edit(s, {UnsetValue{path}}); },
          py::arg("path"), unset.c_str())
      .def(
          "insert",
          [](const SessionPointer& s, const std::string& path, const py::object& value, const py::object& index) {
            return edit(s, {InsertValue{path, to_value(value), optional_index(index)}});
          },
          py::arg("path"), py::arg("value"), py::arg("index") = py::none(),
          R"(Inserts an element before the element of the path, "links[0]", or behind the last one, "links[]"; or adds a
member.

A member's name must be unused. The member becomes the last one, or number `index`. Returns the Change. Raises
InputError.)")
      .def(
          "remove", [](const SessionPointer& s, const std::string& path) { return edit(s, {RemoveValue{path}}); },
          py::arg("path"), remove.c_str())
      .def(
          "rename",
          [](const SessionPointer& s, const std::string& path, const std::string& name) {
            return edit(s, {RenameValue{path, name}});
          },
          py::arg("path"), py::arg("name"),
          R"(Renames a member. Components and variables are renamed everywhere in the document.

This includes links, expressions, and grammars in the document. Random numbers of a component depend on its name.
Returns the Change. Raises InputError if the name is in use or would have another meaning.)")
      .def(
          "move",
          [](const SessionPointer& s, const std::string& path, std::size_t index) {
            return edit(s, {MoveValue{path, index}});
          },
          py::arg("path"), py::arg("index"),
          "Moves a member or element within its object or list, so that it is number `index`. Returns the Change. "
          "Raises InputError.")
      .def(
          "note",
          [](const SessionPointer& s, const std::string& path, const std::string& note) {
            return edit(s, {SetNote{path, note}});
          },
          py::arg("path"), py::arg("note"),
          "Writes the comment on a member; an empty note removes the comment. Returns the Change. Raises InputError.")
      .def(
          "paste",
          [](const SessionPointer& s, const std::string& part, const std::map<std::string, std::string>& names,
             const py::object& index, const py::object& link_index) {
            return edit(s, {InsertPart{.text = part,
                                       .names = {names.begin(), names.end()},
                                       .index = optional_index(index),
                                       .link_index = optional_index(link_index)}});
          },
          py::arg("part"), py::kw_only(), py::arg("names") = py::dict(), py::arg("index") = py::none(),
          py::arg("link_index") = py::none(),
          R"(Inserts a part of a document, from part(): its components with their notes, its links and variables.

`names` renames components, for example if a name is in use. The first component becomes number `index` of all, and the
first link number `link_index`; by default, they come last. Links from the document to the part are further edits.
Returns the Change. Raises InputError.)")
      .def("edit_text", &edit_text, py::arg("patch"),
           "Applies a patch, such as Change.patch, to the text, like typing. Returns the Change. Raises ValueError if "
           "it does not fit.");
}

}  // namespace

void bind_session(py::module_& module) {
  py::class_<SessionInPython, SessionPointer> session(module, "Session",
                                                      R"(A document that is being edited.

Edits change only the necessary parts of the text, and can be undone. A faulty text is kept with its faults; document
and growth then belong to the last text without faults. Growing makes only what has changed. `content`, `file`, `set`
and `seed` are as in Document. If `content` is a Document, the session has its original text, with edits for the values
of set(). With a `root`, no file outside this folder is read. Ctrl-C stops every call that reads the text, without any
change. Only one thread may call a session at a time; calls of other threads raise RuntimeError.

    session = meristem.Session.open("tulip")
    session.set("description", "A tulip by the gate.")
    plant = session.grow()
    session.undo()
    assert session.undo_count == 0 and session.is_good)");
  session.def(py::init(&session_of), py::arg("content"), py::kw_only(), py::arg("file") = "",
              py::arg("set") = py::none(), py::arg("seed") = py::none(), py::arg("root") = "");
  bind_edits(session);
  session
      .def_static("open", &open, py::arg("path"), py::kw_only(), py::arg("set") = py::none(),
                  py::arg("seed") = py::none(), py::arg("root") = "",
                  "Opens a session of the document in a file, or of a shipped model by its name. Raises MachineError "
                  "if the file cannot be read.")
      .def("undo", &undo, "Undoes the last step. Returns the Change, or None if there is no step.")
      .def("redo", &redo, "Redoes the step that was undone last. Returns the Change, or None if there is no such step.")
      .def("preview", &preview, py::arg("values") = py::none(),
           "Overrides values of the text until the next call, for example during a drag. The text does not change.")
      .def("reload", &reload, "Reads changed files again, and the document with them.")
      .def("part", &part_of_session, py::arg("components"),
           "Returns a part of the document as a text: these components as they are written, the links among them, and "
           "the variables that they name. Raises InputError for unknown components.")
      .def("save", &save_session, py::arg("path"),
           "Writes the text as it is. Raises InputError if the text has faults or would not find a file that it names, "
           "and MachineError if the file cannot be written.")
      .def("grow", &grow_session, py::arg("time") = 0.0, py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Grows the document of the last text without faults. Returns a Plant, as Document.grow does.

Only changes since the last growth are made anew; `difference` lists them. Raises InputError (limits; also if the text
never was without faults), Cancelled.)")
      .def_property_readonly(
          "text",
          [](const SessionPointer& s) {
            const auto lock = s->lock();
            return s->session.text();
          },
          "The document's text as it is now.")
      .def_property_readonly(
          "file", [](const SessionPointer& s) { return s->session.file(); }, "Its name, or '<python>'.")
      .def_property_readonly("notes", &notes_of_session,
                             "The comments on the components, by component name: a dict of str.")
      .def_property_readonly("document", &document_of,
                             "The Document of the last text without faults; None if the text never was without faults.")
      .def_property_readonly(
          "faults",
          [](const SessionPointer& s) {
            const auto lock = s->lock();
            return to_python(s->session.errors());
          },
          "The faults of the text, or its warnings if it has no faults: a tuple of Diagnostic.")
      .def_property_readonly(
          "is_good",
          [](const SessionPointer& s) {
            const auto lock = s->lock();
            return s->session.is_good();
          },
          "True if the text has no faults, so that `document` belongs to this text.")
      .def_property_readonly(
          "undo_count",
          [](const SessionPointer& s) {
            const auto lock = s->lock();
            return s->session.undo_count();
          },
          "Steps that undo() can take back.")
      .def_property_readonly(
          "redo_count",
          [](const SessionPointer& s) {
            const auto lock = s->lock();
            return s->session.redo_count();
          },
          "Steps that redo() can make again.")
      .def_property_readonly("difference", &difference_of,
                             R"(The differences between the meshes of the last growth and of the growth before it.

A dict of lists of names, 'added', 'changed' and 'removed': "leaf[0]" is the first of the component leaf in
Plant.meshes.)")
      .def("__repr__", &session_repr);
}

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
// Reads a document's tree into a Document. The order follows the dependencies: limits, keys of the animation,
// variables, scene, components, links, and last the structure of the graph. All faults are collected, and a faulty part
// does not stop the others.
#include "meristem/document/document.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "meristem/base/free_later.h"
#include "meristem/base/name_table.h"
#include "meristem/base/reading_stop.h"
#include "meristem/base/stoppable_mutex.h"
#include "meristem/document/animation_keys.h"
#include "meristem/document/instance_variables.h"
#include "meristem/document/json.h"
#include "meristem/document/locate.h"
#include "meristem/document/override.h"
#include "meristem/document/silent_keys.h"
#include "meristem/document/sources.h"
#include "meristem/document/tables.h"
#include "meristem/document/variables.h"
#include "meristem/graph/add_camera.h"
#include "meristem/graph/link_reader.h"
#include "meristem/graph/single_recursions.h"
#include "meristem/graph/table/fingerprint.h"

namespace meristem {

namespace {

/// Returns the lower value of each limit.
SizeLimits within(const SizeLimits& own, const SizeLimits& outer) {
  SizeLimits both = own;
  for (std::uint64_t SizeLimits::*const limit :
       {&SizeLimits::points, &SizeLimits::nodes, &SizeLimits::modules, &SizeLimits::instances, &SizeLimits::triangles,
        &SizeLimits::mesh_bytes, &SizeLimits::file_bytes, &SizeLimits::picture_pixels, &SizeLimits::texture_pixels}) {
    both.*limit = std::min(own.*limit, outer.*limit);
  }
  return both;
}

/// Fills a Document from the tree of its text and collects all faults.
class DocumentReader {
 public:
  /// `root` is the tree of the text, with the overrides.
  DocumentReader(const Value& root, const Registry& registry, const ReadOptions& options, const std::string& file)
      : root_(&root),
        registry_(registry),
        options_(options),
        access_{.folder = std::filesystem::path(file).parent_path().string(),
                .root = options.root,
                .store = options.store,
                .sources = &sources_},
        sources_(registry, options) {}

  /// Returns the faults and warnings.
  std::vector<Diagnostic> run(Document& document) {
    if (root_->object() == nullptr) {
      return {{.message = fmt::format("the document is {}", root_->description()),
               .expected = "an object with \"meristem\": 1"}};
    }
    if (const Value* format = root_->find("meristem");
        format != nullptr && format->number() != nullptr && *format->number() > kDocumentFormat) {
      return {{.message = fmt::format("the document's format {} is newer than this program", *format->number()),
               .expected = fmt::format("at most {}", kDocumentFormat),
               .path = "meristem"}};
    }

    // Limits and variables come first: everything else may use them.
    read_limits(document.graph.limits);
    if (options_.within) document.graph.limits = within(document.graph.limits, *options_.within);
    sources_.set_limits(document.graph.limits);
    std::vector<KeyedParameter> keyed = put_keys_of_variables(document.graph.limits);
    const Value* given_variables = root_->find("variables");
    if (are_too_many_variables(given_variables)) return with_too_many_variables(document.graph.limits);
    const VariableValues solved = solve_variables(given_variables, document.graph.limits);

    ParameterReader reader(solved.constants, document.graph.limits, access_);
    reader.stop_with(options_.progress);
    reader.expressions().note_expressions(options_.expression_paths);
    read_animation(reader, document.graph);
    if (own_) {
      for (KeyedParameter& parameter : put_other_keys(*own_, registry_, options_.time, reader)) {
        keyed.push_back(std::move(parameter));
      }
    }
    reader.numbers().expect_keys(paths_of_keys(keyed));
    document.variables = read_variables(given_variables, solved, reader);
    document.source.variable_notes = note_variables(document.variables, solved, document.source.overridden);
    read_head(reader, document);
    read_components(reader, document.graph);
    LinkReader links(document.graph, reader);
    if (const Value* given = root_->find("links")) links.read(*given, DocumentPath(top_, "links"));
    links.link_placed(DocumentPath(top_, "components"));
    warn_of_variables(*root_, document.variables, reader);
    for (const NamedFile& file : reader.files().named()) {
      document.source.named_files.push_back(file.path);
      if (file.is_beside) document.source.files_beside.push_back(file.path);
    }
    take_from(reader);
    if (options_.seed) document.graph.seed = *options_.seed;

    // The structure is analysed once all components and links are read without faults.
    if (!has_errors(diagnostics_)) {
      const std::vector<bool> has_recursion = with_recursion();
      add_camera(document.graph, registry_.camera(), has_recursion);
      analyse_structure(document.graph, has_recursion, diagnostics_, options_.progress);
      if (!has_errors(diagnostics_)) check_given_names(*root_, document.graph, diagnostics_, options_.progress);
      if (!has_errors(diagnostics_)) check_silent_keys(*root_, document.graph, diagnostics_);
      if (!has_errors(diagnostics_) && !keyed.empty()) check_key_clocks(keyed, document.graph, diagnostics_);
    }
    keep_first(document.graph.limits.diagnostics);
    return std::move(diagnostics_);
  }

  const std::vector<ParameterReader::Meaningless>& meaningless() const { return meaningless_; }
  /// Returns true if the document's content depends on its time.
  bool depends_on_time() const { return depends_on_time_; }

  static bool has_errors(const std::vector<Diagnostic>& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
  }

 private:
  std::vector<KeyedParameter> put_keys_of_variables(const SizeLimits& limits) {
    const Value* animation = root_->find("animation");
    if (animation == nullptr || animation->find("keys") == nullptr) return {};
    root_ = &own_.emplace(*root_);
    ParameterReader reader({}, limits);
    reader.stop_with(options_.progress);
    std::vector<KeyedParameter> keyed = put_variable_keys(*own_, options_.time, reader);
    take_from(reader);
    return keyed;
  }

  /// Reports the fault of too many variables. Does not read the rest: values that use the variables would be faulty as
  /// well.
  std::vector<Diagnostic> with_too_many_variables(const SizeLimits& limits) {
    ParameterReader reader({}, limits);
    read_variables(root_->find("variables"), {}, reader);
    take_from(reader);
    keep_first(limits.diagnostics);
    return std::move(diagnostics_);
  }

  /// Returns the document paths of the numbers that keys replace.
  std::vector<std::string> paths_of_keys(const std::vector<KeyedParameter>& keyed) {
    std::vector<std::string> paths;
    for (const KeyedParameter& parameter : keyed) {
      if (parameter.clock == KeyClock::document) depends_on_time_ = true;
      if (parameter.clock != KeyClock::instance) continue;
      paths.push_back(parameter.path);
      for (const char* const element : {"[0]", "[1]", "[2]"}) paths.push_back(parameter.path + element);
    }
    return paths;
  }

  void read_animation(ParameterReader& reader, Graph& graph) const {
    const Value* given = root_->find("animation");
    if (given == nullptr) return;
    Animation animation;
    reader.read(animation_table(), &animation, *given, DocumentPath(top_, "animation"));
    graph.animation = animation;
  }

  void take_from(ParameterReader& reader) {
    std::vector<Diagnostic> found = reader.take_diagnostics();
    const auto errors =
        std::count_if(found.begin(), found.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
    meaningless_.insert(meaningless_.end(), reader.meaningless().begin(), reader.meaningless().end());
    hidden_ += reader.error_count() - static_cast<std::size_t>(errors);
    diagnostics_.insert(diagnostics_.end(), std::make_move_iterator(found.begin()),
                        std::make_move_iterator(found.end()));
  }

  /// Keeps at most a given number of diagnostics, errors before warnings, and counts the errors that are left out.
  void keep_first(std::size_t limit) {
    if (diagnostics_.size() > limit) {
      const auto warnings = std::stable_partition(diagnostics_.begin(), diagnostics_.end(),
                                                  [](const Diagnostic& d) { return d.severity == Severity::error; });
      const auto errors = static_cast<std::size_t>(warnings - diagnostics_.begin());
      if (errors > limit) hidden_ += errors - limit;
      diagnostics_.resize(limit);
    }
    if (hidden_ > 0) diagnostics_.push_back({.message = fmt::format("and {} more faults", hidden_)});
  }

  void read_limits(SizeLimits& limits) {
    const Value* given = root_->find("limits");
    if (given == nullptr) return;
    ParameterReader reader({}, SizeLimits{});
    reader.read(limits_table(), &limits, *given, DocumentPath(top_, "limits"));
    take_from(reader);
  }

  void read_head(ParameterReader& reader, Document& document) {
    DocumentHead head;
    reader.read(head_table(), &head, *root_, top_);
    document.name = std::move(head.name);
    document.description = std::move(head.description);
    document.author = std::move(head.author);
    document.licence = std::move(head.licence);
    document.graph.seed = head.seed;
    document.output = std::move(head.output);
    document.scene.ground_colour = head.scene.ground.colour;
    for (auto& [name, support] : head.scene.supports) document.scene.supports[name] = std::move(support.line);
    if (reader.error_count() > 0) return;
    const Value* scene = root_->find("scene");
    document.scene.fingerprint =
        fingerprint_of(scene != nullptr ? *scene : Value(), reader.expressions().constant_table(),
                       reader.files().named(), reader.limits().file_bytes);
    light_scene(head.scene.light, DocumentPath(top_, "scene"), reader, document.scene);
    if (head.scene.obstacles.empty()) return;
    const Value* obstacles = scene->find("obstacles");
    const auto said = fingerprint_of(*obstacles, reader.expressions().constant_table(), reader.files().named(),
                                     reader.limits().file_bytes);
    const auto build = [&] { return build_obstacles(head.scene.obstacles); };
    document.scene.obstacles = said ? *reader.files().kept<Obstacles>(Fingerprint().add(*said), build) : build();
  }

  void read_components(ParameterReader& reader, Graph& graph) {
    const DocumentPath path(top_, "components");
    const Value* given = root_->find("components");
    if (given == nullptr || given->object() == nullptr || given->object()->empty()) {
      const bool is_missing = given == nullptr || given->object() != nullptr;
      return reader.add_error(
          given == nullptr ? top_ : path,
          is_missing ? "the document has no components" : fmt::format("the components are {}", given->description()),
          R"(an object such as "components": {"tree": {"type": "colonize", ...}})");
    }
    graph.components.reserve(given->object()->size() + 1);  // and a camera
    for (const auto& member : *given->object()) {
      reader.check_stop();
      graph.components.emplace_back().id = member.first;
    }
    // Components that give names are read before all components that may use the names.
    const auto read_all = [&](bool gives) {
      for (std::size_t c = 0; c < graph.components.size(); ++c) {
        reader.check_stop();
        const auto& [id, value] = (*given->object())[c];
        if (gives_names(value) != gives) continue;
        const DocumentPath own(path, id);
        const ComponentType* type = type_of(reader, id, value, own);
        if (type == nullptr) continue;
        read_component(reader, graph.components[c], *type, value, own);
        if (gives) take_names(reader, graph, graph.components[c], own);
      }
    };
    read_all(true);
    reader.expressions().add_instance_names(graph.site_names);
    read_instance_variables(root_->find("variables"), graph, reader);
    read_all(false);
  }

  /// Returns true for each component that has a "recursion". The document may compute it by variables, down to 1.
  std::vector<bool> with_recursion() const {
    std::vector<bool> given;
    for (const auto& [id, value] : *root_->find("components")->object()) {
      given.push_back(value.find("recursion") != nullptr);
    }
    return given;
  }

  /// Returns true if a component of the document has a type that gives names to its descendants.
  bool gives_names(const Value& component) const {
    const Value* name = component.find("type");
    const ComponentType* type = name == nullptr || name->text() == nullptr ? nullptr : registry_.find(*name->text());
    return type != nullptr && type->gives;
  }

  /// Adds the names that a component gives to the graph. A name that several components give is added once.
  void take_names(ParameterReader& reader, Graph& graph, Prototype& prototype, const DocumentPath& path) {
    if (reader.error_count() > 0) return;
    GivenNames given = prototype.type->gives(prototype.parameters.get());
    for (const std::string& name : given.names) {
      if (reader.expressions().constant_table().names().contains(name)) {
        reader.add_error(path, fmt::format("'{}' is a column here and a variable of the document", name),
                         "another name for one of them");
      }
      if (!columns_.contains(name)) {
        columns_.add(name);
        graph.site_names.push_back(name);
      }
      prototype.given_slots.push_back(static_cast<std::uint32_t>(*columns_.find(name)));
    }
    for (auto& [name, reason] : given.refused) reader.expressions().refuse_instance_name(name, std::move(reason));
  }

  /// Returns the type of a component, or null after a fault. A faulty component stays in the graph without a type, so
  /// that links to it cause no further fault.
  const ComponentType* type_of(ParameterReader& reader, const std::string& id, const Value& value,
                               const DocumentPath& path) const {
    const auto fits = [](char c) {
      return c == '_' || ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
    };
    if (id.empty() || !std::all_of(id.begin(), id.end(), fits)) {
      reader.add_name_error(path, fmt::format("'{}' cannot name a component", id), "letters, digits and _", "");
    }
    const Value* type = value.find("type");
    if (type == nullptr || type->text() == nullptr) {
      reader.add_error(path,
                       value.object() == nullptr ? fmt::format("a component cannot be {}", value.description())
                                                 : fmt::format("'{}' has no type", id),
                       fmt::format("a \"type\": one of {}", fmt::join(registry_.names(), ", ")));
      return nullptr;
    }
    const ComponentType* found = registry_.find(*type->text());
    if (found == nullptr) {
      const std::vector<std::string> names = registry_.names();
      const std::string nearest = reader.nearest(*type->text(), names);
      reader.add_error(DocumentPath(path, "type"), fmt::format("'{}' is not a type of component", *type->text()),
                       nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", ")) : "", nearest);
    }
    return found;
  }

  void read_component(ParameterReader& reader, Prototype& prototype, const ComponentType& type, const Value& value,
                      const DocumentPath& path) {
    prototype.type = &type;
    prototype.parameters = prototype.type->make_parameters();
    const std::size_t errors_before = reader.error_count();
    const std::size_t files_before = reader.files().named().size();
    const Value whole = with_shown(reader, prototype, value, path);
    if (reader.error_count() != errors_before) return;
    prototype.varyings = reader.read_varying(prototype.type->parameters, prototype.parameters.get(), whole, path);
    if (reader.error_count() != errors_before) return;
    check_shown(reader, prototype, value, path);
    set_fingerprints(prototype, whole, reader.expressions().constant_table(),
                     std::span(reader.files().named()).subspan(files_before), reader.limits());
  }

  /// Reports rows of a component that have no effect because the component shows the remains of another one's growth.
  static void check_shown(ParameterReader& reader, const Prototype& prototype, const Value& value,
                          const DocumentPath& path) {
    const auto& watches = prototype.type->watches_growth;
    if (prototype.shown.empty() || !watches || !watches(prototype.parameters.get())) return;
    for (const std::string& row : prototype.type->shows.before_growth) {
      if (value.find(row) == nullptr) continue;
      reader.add_meaning_error(DocumentPath(path, row),
                               fmt::format("'{}' has no meaning beside the growth of '{}'", row, prototype.shown),
                               "no such key");
    }
  }

  /// Returns a component's value, completed with the rows that it copies from the component that it shows.
  Value with_shown(ParameterReader& reader, Prototype& prototype, const Value& value, const DocumentPath& path) {
    const ShownComponent& shows = prototype.type->shows;
    const Value* of = shows.type.empty() ? nullptr : value.find("of");
    if (of == nullptr || of->text() == nullptr) return value;
    const Typed& typed = components_of_type(shows.type);
    const auto position = typed.ids.find(*of->text());
    const Value* shown = position ? typed.values[*position] : nullptr;
    if (shown == nullptr) {
      const std::string nearest = reader.nearest(*of->text(), typed.ids.names());
      reader.add_error(DocumentPath(path, "of"), fmt::format("there is no {} '{}'", shows.type, *of->text()),
                       nearest.empty() ? fmt::format("the id of a component of type {}", shows.type) : "", nearest);
      return value;
    }
    prototype.shown = *of->text();
    Value whole = value;
    for (const auto& [own, there] : shows.rows) {
      const Value* taken = value.find(own) == nullptr ? find_member(*shown, there) : nullptr;
      if (taken != nullptr) whole.object()->emplace_back(own, *taken);
    }
    return whole;
  }

  /// The components of one type, with their values in the document.
  struct Typed {
    NameTable ids;
    std::vector<const Value*> values;
  };
  const Typed& components_of_type(const std::string& type) {
    const auto [found, is_new] = typed_.try_emplace(type);
    if (!is_new) return found->second;
    for (const auto& [id, value] : *root_->find("components")->object()) {
      const Value* own = value.find("type");
      if (own == nullptr || own->text() == nullptr || *own->text() != type) continue;
      found->second.ids.add(id);
      found->second.values.push_back(&value);
    }
    return found->second;
  }

  /// Returns the value at a path of names with dots between them. Returns null if the path does not exist.
  static const Value* find_member(const Value& value, std::string_view names) {
    const Value* found = &value;
    while (found != nullptr && !names.empty()) {
      const std::size_t end = std::min(names.find('.'), names.size());
      found = found->find(names.substr(0, end));
      names.remove_prefix(std::min(end + 1, names.size()));
    }
    return found;
  }

  const Value* root_;
  std::optional<Value> own_;  // a copy of the root that contains the keys of the animation
  NameTable columns_;         // names of columns that components give to their descendants
  std::map<std::string, Typed> typed_;
  const Registry& registry_;
  const ReadOptions& options_;
  const FileAccess access_;
  DocumentSources sources_;
  const DocumentPath top_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<ParameterReader::Meaningless> meaningless_;
  std::size_t hidden_ = 0;  // number of faults that are only counted
  bool depends_on_time_ = false;
};

}  // namespace

void DocumentOrigin::place(std::vector<Diagnostic>& diagnostics, const Progress* progress) const {
  tell_variables(tree, variable_notes, diagnostics);
  locate_diagnostics(text, diagnostics, progress);
  for (Diagnostic& diagnostic : diagnostics) {
    diagnostic.file = file;
    for (std::size_t k = 0; k < overridden.size(); ++k) {
      const std::string_view rest =
          std::string_view(diagnostic.path).substr(std::min(diagnostic.path.size(), overridden[k].size()));
      if (!diagnostic.path.starts_with(overridden[k]) || !(rest.empty() || rest[0] == '.' || rest[0] == '[')) continue;
      diagnostic.file = override_names[k];
      diagnostic.line = diagnostic.column = 0;
    }
  }
}

namespace {

/// A store of read files that all reads of one document at other times share.
struct SharedReads {
  StoppableMutex mutex;  // one read at a time
  ReadStore store;
};

/// Returns a function that reads a document at other times. It reads each file once.
std::function<Document(double, const Progress*)> reading_again(const Document& document, const Registry& registry,
                                                               const ReadOptions& options) {
  ReadOptions again = options;
  again.expression_paths = nullptr;
  auto shared = std::make_shared<SharedReads>();
  return [text = document.source.text, file = document.source.file, &registry, again, shared](
             double time, const Progress* progress) {
    const auto lock = shared->mutex.wait(progress);
    ReadOptions now = again;
    now.time = time;
    now.store = &shared->store;
    now.progress = progress;
    return read_document(text, file, registry, now);
  };
}

/// Reads a document into `document`, which is incomplete if this throws.
void read_into(Document& document, std::string text, const std::string& file, const Registry& registry,
               const ReadOptions& options) {
  document.source = {.file = file, .text = std::move(text)};
  bool depends_on_time = false;
  std::vector<Diagnostic> diagnostics;
  const bool is_outermost = options.chain == nullptr;  // documents that others name are part of the outermost read
  if (options.store != nullptr && is_outermost) options.store->begin_read();
  const DocumentChain outermost{.file = real_file(file), .name = file};
  ReadOptions reading = options;
  if (is_outermost) reading.chain = &outermost;
  try {
    Value& root = document.source.tree;
    SizeLimits of_text;
    of_text.document_bytes = options.document_bytes;
    root = parse_json(document.source.text, of_text, options.progress);
    if (root.object() != nullptr) apply_overrides(root, options.overrides, document.source, diagnostics, &registry);
    for (bool again = diagnostics.empty(); again;) {
      DocumentReader reader(root, registry, reading, file);
      diagnostics = reader.run(document);
      depends_on_time = reader.depends_on_time();
      // Overrides take precedence: values of the document that have no effect beside them are removed, and the document
      // is read again.
      again = give_way(root, reader.meaningless(), document.source.overridden);
      if (again) document = Document{.source = std::move(document.source)};
    }
  } catch (const InputError& error) {
    diagnostics = error.diagnostics();
  }
  document.source.place(diagnostics, options.progress);
  if (DocumentReader::has_errors(diagnostics)) throw InputError(std::move(diagnostics));
  document.warnings = std::move(diagnostics);
  if (options.store != nullptr && is_outermost) options.store->end_read();
  document.time = options.time;
  if (depends_on_time && is_outermost) document.at_time = reading_again(document, registry, options);
}

}  // namespace

Document read_document(std::string text, const std::string& file, const Registry& registry,
                       const ReadOptions& options) {
  const ReadingStop stop(options.progress);  // of the files that the document names
  Document document;
  try {
    read_into(document, std::move(text), file, registry, options);
  } catch (const Cancelled&) {
    document.scene = Scene();  // may hold trees of rays, which must not be freed while the program ends
    free_later(std::move(document));
    throw;
  }
  return document;
}

const Document& document_at(const Document& document, double time, std::optional<Document>& other,
                            const Progress* progress) {
  if (!document.at_time || time == document.time) return document;
  return other.emplace(document.at_time(time, progress));
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/document.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/document/json.h"
#include "meristem/document/locate.h"
#include "meristem/document/override.h"
#include "meristem/document/silent_keys.h"
#include "meristem/document/tables.h"
#include "meristem/document/variables.h"
#include "meristem/graph/table/fingerprint.h"

namespace meristem {

namespace {

const std::vector<std::string> kLinkKinds = {"child", "branch", "leaf", "crown"};

/// Fills a Document from the tree of its text; the reader collects what is wrong.
class DocumentReader {
 public:
  DocumentReader(const Value& root, const Registry& registry, std::string folder)
      : root_(root), registry_(registry), folder_(std::move(folder)) {}

  /// Returns the faults and warnings.
  std::vector<Diagnostic> run(Document& document, std::optional<std::uint64_t> seed) {
    if (root_.object() == nullptr) {
      return {{.message = fmt::format("the document is {}", root_.description()),
               .expected = "an object with \"meristem\": 1"}};
    }
    if (const Value* format = root_.find("meristem");
        format != nullptr && format->number() != nullptr && *format->number() > kDocumentFormat) {
      return {{.message = fmt::format("this program is too old for the document's format {}", *format->number()),
               .expected = fmt::format("at most {}", kDocumentFormat),
               .path = "meristem"}};
    }

    // Limits and variables come first: everything else may use them.
    read_limits(document.graph.limits);
    const Value* given_variables = root_.find("variables");
    const VariableValues solved = solve_variables(given_variables, document.graph.limits);

    ParameterReader reader(solved.constants, document.graph.limits, folder_);
    document.variables = read_variables(given_variables, solved, reader);
    document.source.variable_notes = note_variables(document.variables, solved, document.source.overridden);
    read_head(reader, document);
    read_components(reader, document.graph);
    read_links(reader, document.graph);
    link_placed(reader, document.graph);
    warn_of_variables(root_, document.variables, reader);
    document.source.named_files = reader.files();
    take_from(reader);
    if (seed) document.graph.seed = *seed;

    // The links mean something only once all are read.
    if (!has_errors(diagnostics_)) {
      add_camera(document.graph);
      document.structure = analyse_structure(document.graph, diagnostics_);
      if (!has_errors(diagnostics_)) check_silent_keys(root_, document.graph, document.structure, diagnostics_);
    }
    keep_first(document.graph.limits.diagnostics);
    return std::move(diagnostics_);
  }

  static bool has_errors(const std::vector<Diagnostic>& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
  }

 private:
  void take_from(ParameterReader& reader) {
    std::vector<Diagnostic> found = reader.take_diagnostics();
    const auto errors =
        std::count_if(found.begin(), found.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
    hidden_ += reader.fault_count() - static_cast<std::size_t>(errors);
    diagnostics_.insert(diagnostics_.end(), std::make_move_iterator(found.begin()),
                        std::make_move_iterator(found.end()));
  }

  /// Leaves so many diagnostics, errors before warnings, and counts the errors that are left out.
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

  void read_limits(Limits& limits) {
    const Value* given = root_.find("limits");
    if (given == nullptr) return;
    ParameterReader reader({}, Limits{});
    reader.read(limits_table(), &limits, *given, Place(top_, "limits"));
    take_from(reader);
  }

  void read_head(ParameterReader& reader, Document& document) {
    DocumentHead head;
    reader.read(head_table(), &head, root_, top_);
    document.name = std::move(head.name);
    document.description = std::move(head.description);
    document.author = std::move(head.author);
    document.licence = std::move(head.licence);
    document.graph.seed = head.seed;
    document.output = std::move(head.output);
    document.scene.ground_colour = head.scene.ground.colour;
    if (reader.fault_count() > 0) return;
    const Value* scene = root_.find("scene");
    document.scene.fingerprint = fingerprint_of(scene != nullptr ? *scene : Value(), reader.constants(), reader.files(),
                                                reader.limits().file_bytes);
    light_scene(head.scene.light, Place(top_, "scene"), reader, document.scene);
    document.scene.obstacles = build_obstacles(head.scene.obstacles);
  }

  void read_components(ParameterReader& reader, Graph& graph) {
    const Place place(top_, "components");
    const Value* given = root_.find("components");
    if (given == nullptr || given->object() == nullptr || given->object()->empty()) {
      const bool is_missing = given == nullptr || given->object() != nullptr;
      return reader.fault(
          given == nullptr ? top_ : place,
          is_missing ? "the document has no components" : fmt::format("the components are {}", given->description()),
          R"(an object such as "components": {"tree": {"type": "colonize", ...}})");
    }
    for (const auto& [id, value] : *given->object()) read_component(reader, graph, id, value, Place(place, id));
  }

  void read_component(ParameterReader& reader, Graph& graph, const std::string& id, const Value& value,
                      const Place& place) {
    const auto fits = [](char c) {
      return c == '_' || ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
    };
    if (id.empty() || !std::all_of(id.begin(), id.end(), fits)) {
      reader.fault_name(place, fmt::format("'{}' cannot name a component", id), "letters, digits and _", "");
    }
    // Faulty components stay in the graph without a type, so that links to them are no further fault.
    component_by_id_.emplace(id, static_cast<ComponentIndex>(graph.components.size()));
    ids_.push_back(id);
    Prototype& prototype = graph.components.emplace_back();
    prototype.id = id;
    const Value* type = value.find("type");
    if (type == nullptr || type->text() == nullptr) {
      return reader.fault(place,
                          value.object() == nullptr ? fmt::format("a component cannot be {}", value.description())
                                                    : fmt::format("'{}' has no type", id),
                          fmt::format("a \"type\": one of {}", fmt::join(registry_.names(), ", ")));
    }
    prototype.type = registry_.find(*type->text());
    if (prototype.type == nullptr) {
      const std::vector<std::string> names = registry_.names();
      const std::string nearest = reader.nearest(*type->text(), names);
      return reader.fault(Place(place, "type"), fmt::format("'{}' is not a type of component", *type->text()),
                          nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", ")) : "", nearest);
    }
    prototype.parameters = prototype.type->make_parameters();
    const std::size_t faults_before = reader.fault_count();
    const std::size_t files_before = reader.files().size();
    prototype.varyings =
        reader.read_varying(prototype.type->parameters, prototype.parameters.get(), prototype.type->size, value, place);
    if (reader.fault_count() != faults_before) return;
    set_fingerprints(prototype, value, reader.constants(), std::span(reader.files()).subspan(files_before),
                     reader.limits());
  }

  void read_links(ParameterReader& reader, Graph& graph) {
    const Value* given = root_.find("links");
    if (given == nullptr) return;
    const Place place(top_, "links");
    if (given->list() == nullptr) {
      return reader.fault(place, fmt::format("the links are {}", given->description()),
                          R"(a list such as [["view", "tree"]])");
    }
    for (std::size_t k = 0; k < given->list()->size(); ++k)
      read_link(reader, graph, (*given->list())[k], Place(place, k));
  }

  void read_link(ParameterReader& reader, Graph& graph, const Value& value, const Place& place) {
    Link link;
    if (const Value::List* pair = value.list()) {
      if (pair->size() != 2) {
        return reader.fault(place, fmt::format("a link is {}", value.description()), R"(a pair ["from", "to"])");
      }
      link.from = read_end(reader, (*pair)[0], Place(place, std::size_t{0}));
      link.to = read_end(reader, (*pair)[1], Place(place, std::size_t{1}));
    } else if (value.object() == nullptr) {
      return reader.fault(place, fmt::format("a link cannot be {}", value.description()),
                          R"(["from", "to"] or {"from": ..., "to": ..., "kind": ...})");
    } else {
      link.from = read_named_end(reader, value, "from", place);
      link.to = read_named_end(reader, value, "to", place);
      const bool kind_is_known = read_kind(reader, value, place, link.kind);
      if (link.kind == LinkKind::crown) {
        reader.read(crown_placement_table(), &link.in_crown, value, place);
        check_crown(reader, graph, place, link);
      } else {
        reader.read(placement_table(), &link.placement, value, place);
        link.given = given_placement(value);
        if (kind_is_known) check_placement(reader, graph, value, place, link);
      }
    }
    link.fingerprint = fingerprint_of(value, reader.constants(), {}, 0);
    if (link.from != kNoIndex && link.to != kNoIndex) graph.links.push_back(std::move(link));
  }

  /// False after a fault.
  static bool read_kind(ParameterReader& reader, const Value& value, const Place& place, LinkKind& kind) {
    const Value* given = value.find("kind");
    if (given == nullptr) return true;
    Parameter row;
    row.name = "kind";
    row.kind = ParameterKind::choice;
    row.choices = kLinkKinds;
    const auto chosen = reader.choice(row, *given, Place(place, "kind"));
    if (chosen) kind = static_cast<LinkKind>(*chosen);
    return chosen.has_value();
  }

  ComponentIndex read_named_end(ParameterReader& reader, const Value& link, const char* name, const Place& place) {
    const Value* end = link.find(name);
    if (end != nullptr) return read_end(reader, *end, Place(place, name));
    reader.fault(place, fmt::format("the link has no '{}'", name), "the id of a component");
    return kNoIndex;
  }

  ComponentIndex read_end(ParameterReader& reader, const Value& value, const Place& place) {
    if (value.text() == nullptr) {
      reader.fault(place, fmt::format("the end of a link cannot be {}", value.description()), "the id of a component");
      return kNoIndex;
    }
    const auto found = component_by_id_.find(*value.text());
    if (found != component_by_id_.end()) return found->second;
    const std::string nearest = reader.nearest(*value.text(), ids_);
    reader.fault(place, fmt::format("there is no component '{}'", *value.text()),
                 nearest.empty() ? "the id of a component" : "", nearest);
    return kNoIndex;
  }

  /// Links to what components place themselves by its id.
  void link_placed(ParameterReader& reader, Graph& graph) const {
    for (ComponentIndex from = 0; from < graph.components.size(); ++from) {
      const Prototype& prototype = graph.components[from];
      if (prototype.type == nullptr || !prototype.type->placed) continue;
      const std::vector<PlacedComponent> placed = prototype.type->placed(prototype.parameters.get());
      for (std::uint32_t k = 0; k < placed.size(); ++k) {
        const std::string& id = placed[k].id;
        const auto found = component_by_id_.find(id);
        if (found != component_by_id_.end()) {
          graph.links.push_back({.from = from, .to = found->second, .name = k, .fingerprint = 0});
          continue;
        }
        if (!placed[k].is_needed) continue;
        const Place components(top_, "components");
        const std::string nearest = reader.nearest(id, ids_);
        reader.fault(Place(components, prototype.id),
                     fmt::format("'{}' places '{}', and there is no such component", prototype.id, id),
                     nearest.empty() ? fmt::format("a component '{}'{}", id, placed[k].hint) : "", nearest);
      }
    }
  }

  /// Crown links need a crown body.
  static void check_crown(ParameterReader& reader, const Graph& graph, const Place& place, const Link& link) {
    if (link.from == kNoIndex || graph.components[link.from].type == nullptr) return;
    const Prototype& from = graph.components[link.from];
    if (from.type->surface && from.type->surface(from.parameters.get()).crown) return;
    reader.fault(Place(place, "kind"),
                 from.type->surface ? fmt::format("the surface of '{}' has no crown", from.id)
                                    : fmt::format("'{}' makes no stems that could have a crown", from.id),
                 R"("crown": {...} in the surface of a component with stems)");
  }

  /// Placement keys need a branch link from something that has stems.
  static void check_placement(ParameterReader& reader, const Graph& graph, const Value& value, const Place& place,
                              const Link& link) {
    if (link.from == kNoIndex || graph.components[link.from].type == nullptr) return;
    const Prototype& from = graph.components[link.from];
    if (link.kind == LinkKind::branch && from.type->makes_stems) return;
    for (const auto& [name, member] : *value.object()) {
      if (placement_table().find(name) == nullptr) continue;
      reader.fault_name(
          Place(place, name),
          link.kind != LinkKind::branch
              ? fmt::format("'{}' belongs to branch links", name)
              : fmt::format("'{}' has no meaning here, since '{}' makes no stems", name, from.id),
          link.kind != LinkKind::branch ? "\"kind\": \"branch\", or no such key" : "a link from a component with stems",
          "");
    }
  }

  /// A document without a camera gets one that links to all components without a parent, and to one of each circle of
  /// components that nothing else leads into: the first that recurses, else the first.
  void add_camera(Graph& graph) const {
    for (const Prototype& prototype : graph.components) {
      if (prototype.type->is_camera) return;
    }
    const std::size_t count = graph.components.size();
    std::vector<std::vector<ComponentIndex>> children(count);
    std::vector<bool> has_parent(count);
    for (const Link& link : graph.links) {
      children[link.from].push_back(link.to);
      has_parent[link.to] = true;
    }
    std::string id = "camera";
    while (component_by_id_.contains(id)) id += '_';
    graph.components.push_back(
        {.id = id, .type = &registry_.camera(), .parameters = registry_.camera().make_parameters(), .fingerprint = 0});

    std::vector<bool> is_reached(count);
    const auto link_to = [&](ComponentIndex component) {
      graph.links.push_back({.from = static_cast<ComponentIndex>(count), .to = component, .fingerprint = 0});
      is_reached[component] = true;
      std::vector<ComponentIndex> ahead{component};
      while (!ahead.empty()) {
        const ComponentIndex next = ahead.back();
        ahead.pop_back();
        for (const ComponentIndex child : children[next]) {
          if (!is_reached[child]) ahead.push_back(child);
          is_reached[child] = true;
        }
      }
    };
    for (ComponentIndex c = 0; c < count; ++c) {
      if (!has_parent[c]) link_to(c);
    }
    for (ComponentIndex c = 0; c < count; ++c) {
      if (!is_reached[c] && graph.components[c].base().recursion > 1) link_to(c);
    }
    for (ComponentIndex c = 0; c < count; ++c) {
      if (!is_reached[c]) link_to(c);
    }
  }

  const Value& root_;
  const Registry& registry_;
  const std::string folder_;  // of the document
  const Place top_;
  std::unordered_map<std::string, ComponentIndex> component_by_id_;
  std::vector<std::string> ids_;
  std::vector<Diagnostic> diagnostics_;
  std::size_t hidden_ = 0;  // faults that are only counted
};

}  // namespace

void Source::place(std::vector<Diagnostic>& diagnostics) const {
  tell_variables(tree, variable_notes, diagnostics);
  locate_diagnostics(text, diagnostics);
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

Document read_document(std::string text, const std::string& file, const Registry& registry,
                       const std::vector<Override>& overrides, std::optional<std::uint64_t> seed) {
  Document document;
  document.source = {.file = file, .text = std::move(text)};
  std::vector<Diagnostic> diagnostics;
  const std::string folder = std::filesystem::path(file).parent_path().string();
  try {
    Value& root = document.source.tree;
    root = parse_json(document.source.text);
    if (root.object() != nullptr) apply_overrides(root, overrides, document.source, diagnostics);
    if (diagnostics.empty()) diagnostics = DocumentReader(root, registry, folder).run(document, seed);
  } catch (const InputError& error) {
    diagnostics = error.diagnostics();
  }
  document.source.place(diagnostics);
  if (DocumentReader::has_errors(diagnostics)) throw InputError(std::move(diagnostics));
  document.warnings = std::move(diagnostics);
  return document;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Marks the components that have or use a value, then follows what depends on a component: its links, components that
// show it, and plants of the same stand.
#include "meristem/export/graph/affected.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/name_table.h"
#include "meristem/document/mentions.h"

namespace meristem {

namespace {

using Names = std::unordered_set<std::string>;

class Affected {
 public:
  explicit Affected(const Document& document)
      : document_(document), graph_(document.graph), effects_(graph_.components.size(), GraphEffect::none) {
    for (const Prototype& prototype : graph_.components) ids_.add(prototype.id);
  }

  std::vector<GraphEffect> of(std::string_view path) {
    const std::string whole(path);
    if (path.starts_with("components.")) path.remove_prefix(std::string_view("components.").size());
    if (path.starts_with("variables.")) {
      path.remove_prefix(std::string_view("variables.").size());
      path = path.substr(0, path.find('.'));
    }
    const std::size_t end = std::min(path.find_first_of(".["), path.size());
    const std::string first(path.substr(0, end));
    const std::string_view rest = path.substr(std::min(end + 1, path.size()));
    if (first == "links") {
      start_at_link(whole, rest);
    } else if (const auto id = ids_.find(first); id && (!rest.empty() || find_variable(first) == nullptr)) {
      start_at_parameter(whole, static_cast<ComponentIndex>(*id), rest);
    } else if (rest.empty() && find_variable(first) != nullptr) {
      start_at_variable(first);
    } else {
      fail(whole, first);
    }
    follow();
    return std::move(effects_);
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& name) const {
    std::vector<std::string> names = ids_.names();
    for (const Variable& variable : document_.variables) names.push_back(variable.name);
    throw InputError(Diagnostic{.message = fmt::format("the document has no value '{}'", path),
                                .expected = "a variable (age), a parameter (leaf.length) or a key (links[1].density)",
                                .nearest = nearest_name(name, names)});
  }

  const Variable* find_variable(std::string_view name) const {
    const auto found = std::ranges::find(document_.variables, name, &Variable::name);
    return found == document_.variables.end() ? nullptr : &*found;
  }

  void start(ComponentIndex component, bool is_look) {
    effects_[component] = GraphEffect::own;
    if (!is_look) open_.push_back(component);
  }

  void start_at_parameter(const std::string& path, ComponentIndex component, std::string_view rest) {
    const std::string row(rest.substr(0, rest.find_first_of(".[")));
    const ComponentType& type = *graph_.components[component].type;
    if (!row.empty() && type.parameters.find(row) == nullptr) {
      throw InputError(Diagnostic{.message = fmt::format("'{}' is not a parameter of {}", row, type.parameters.name),
                                  .nearest = nearest_name(row, type.parameters.names()),
                                  .path = path});
    }
    start(component, is_look(row));
  }

  static bool is_look(std::string_view row) { return std::ranges::find(look_names(), row) != look_names().end(); }

  void start_at_link(const std::string& path, std::string_view rest) {
    std::size_t link = 0;
    const std::string number(rest.substr(0, rest.find(']')));
    const bool is_number = !number.empty() && number.size() < 9 &&
                           std::ranges::all_of(number, [](char c) { return '0' <= c && c <= '9'; });
    if (is_number) link = std::stoul(number);
    const Value* links = document_.source.tree.find("links");
    if (!is_number || links == nullptr || links->list() == nullptr || link >= links->list()->size()) {
      fail(path, path);
    }
    start(graph_.links[link].to, false);
  }

  /// Starts at each component and link that mentions the variable, or a variable that depends on it. If the scene
  /// mentions it, all components inherit the effect.
  void start_at_variable(const std::string& name) {
    const Value& root = document_.source.tree;
    const Names names = dependents_of(name, *root.find("variables")->object());
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      const Value* written = written_of(c);
      if (written == nullptr || !mentions(*written, names)) continue;
      const bool are_looks = std::ranges::all_of(*written->object(), [&](const Value::Member& member) {
        return is_look(member.first) || !mentions(member.second, names);
      });
      start(c, are_looks);
    }
    const Value* scene = root.find("scene");
    const bool is_of_scene = scene != nullptr && mentions(*scene, names);
    for (ComponentIndex c = 0; is_of_scene && c < graph_.components.size(); ++c) {
      if (c != graph_.structure.root) inherit(c);
    }
    const Value* links = root.find("links");
    if (links == nullptr || links->list() == nullptr) return;
    for (std::size_t k = 0; k < links->list()->size(); ++k) {
      if (mentions((*links->list())[k], names)) start(graph_.links[k].to, false);
    }
  }

  /// Returns what the document writes about a component: null for the hidden camera. The document's components have
  /// the order of the graph.
  const Value* written_of(ComponentIndex component) const {
    const Value::Object& written = *document_.source.tree.find("components")->object();
    return component < written.size() ? &written[component].second : nullptr;
  }

  /// Returns the variable and all variables that depend on it.
  static Names dependents_of(const std::string& name, const Value::Object& variables) {
    std::unordered_map<std::string, std::vector<std::string>> users;
    for (const auto& [user, value] : variables) {
      for_each_mention(value, [&, &user = user](std::string_view used) { users[std::string(used)].push_back(user); });
    }
    Names names{name};
    std::vector<std::string> open{name};
    while (!open.empty()) {
      const std::vector<std::string> next = users[open.back()];
      open.pop_back();
      for (const std::string& user : next) {
        if (names.insert(user).second) open.push_back(user);
      }
    }
    return names;
  }

  static bool mentions(const Value& value, const Names& names) {
    bool found = false;
    for_each_mention(value, [&](std::string_view name) { found = found || names.contains(std::string(name)); });
    return found;
  }

  void follow() {
    std::unordered_map<std::string_view, std::vector<ComponentIndex>> shown_by;
    std::vector<ComponentIndex> competitors;
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      if (!graph_.components[c].shown.empty()) shown_by[graph_.components[c].shown].push_back(c);
      if (competes(c)) competitors.push_back(c);
    }
    while (!open_.empty()) {
      const ComponentIndex from = open_.back();
      open_.pop_back();
      for (const LinkIndex link : graph_.structure.outgoing[from]) inherit(graph_.links[link].to);
      for (const ComponentIndex shows : shown_by[graph_.components[from].id]) inherit(shows);
      if (!competes(from)) continue;
      for (const ComponentIndex other : std::exchange(competitors, {})) inherit(other);
    }
  }

  /// Returns true if a component grows in a stand with others, where plants take light and room from each other.
  bool competes(ComponentIndex component) const {
    const Prototype& prototype = graph_.components[component];
    if (!prototype.type->grow) return false;
    return !prototype.type->grows_alone || !prototype.type->grows_alone(prototype.parameters.get());
  }

  void inherit(ComponentIndex component) {
    if (!was_inherited_.insert(component).second) return;
    if (effects_[component] == GraphEffect::none) effects_[component] = GraphEffect::inherited;
    open_.push_back(component);
  }

  const Document& document_;
  const Graph& graph_;
  NameTable ids_;
  std::vector<GraphEffect> effects_;
  std::unordered_set<ComponentIndex> was_inherited_;
  std::vector<ComponentIndex> open_;
};

}  // namespace

std::vector<GraphEffect> affected_by(const Document& document, std::string_view path) {
  return Affected(document).of(path);
}

}  // namespace meristem

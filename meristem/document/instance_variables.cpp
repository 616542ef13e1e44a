// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/instance_variables.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/document/mentions.h"
#include "meristem/document/tables.h"
#include "meristem/document/variables.h"
#include "meristem/graph/table/fingerprint.h"

namespace meristem {

namespace {

/// A variable on its way into the graph.
struct Draft {
  std::string name;
  ComponentIndex owner = kNoIndex;
  const Value* said = nullptr;
  Varying value;
  std::vector<std::size_t> uses;  // other drafts
};

class InstanceVariableReader {
 public:
  InstanceVariableReader(const Value::Object& given, Graph& graph, ParameterReader& reader)
      : given_(given), graph_(graph), reader_(reader) {}

  void run() {
    for (const auto& [name, said] : given_) {
      if (!is_per_instance(said)) continue;
      if (is_identifier(name) && !has_meaning(name)) {
        drafts_.push_back({.name = name, .said = &said, .value = {}});
      } else {
        reader_.fault_name(DocumentPath(path_, name),
                           fmt::format("'{}' already has a meaning in expressions, or is no name", name),
                           "another name", "");
      }
    }
    if (drafts_.empty()) return;
    first_slot_ = graph_.site_names.size();
    std::vector<std::string> names;
    for (const Draft& draft : drafts_) {
      if (std::ranges::find(graph_.site_names, draft.name) != graph_.site_names.end()) {
        reader_.fault_name(DocumentPath(path_, draft.name),
                           fmt::format("'{}' is already a column of places", draft.name), "another name", "");
      }
      names.push_back(draft.name);
    }
    graph_.site_names.insert(graph_.site_names.end(), names.begin(), names.end());
    reader_.add_instance_names(names);
    const std::size_t faults_before = reader_.fault_count();
    for (Draft& draft : drafts_) read(draft);
    if (reader_.fault_count() == faults_before) add_in_order();
  }

 private:
  void read(Draft& draft) {
    const DocumentPath own(path_, draft.name);
    // Its value is an expression over the owner's sites; the rest is that of any variable.
    Value::Object rest = *draft.said->object();
    for (Value::Member& member : rest) {
      if (member.first == "value") member.second = Value(0.0);
    }
    Variable variable;
    reader_.read(variable_table(), &variable, Value(std::move(rest)), own);
    find_owner(draft, variable.per, DocumentPath(own, "per"));
    const Value* value = draft.said->find("value");
    if (value == nullptr) return;
    draft.value.path = own.text() + ".value";
    draft.value.name_hash = hash64(draft.name);
    draft.value.min = draft.said->find("min") != nullptr ? variable.min : -std::numeric_limits<double>::infinity();
    draft.value.max = draft.said->find("max") != nullptr ? variable.max : std::numeric_limits<double>::infinity();
    if (value->number() != nullptr) {
      draft.value.first = draft.value.last = *value->number();
      return;
    }
    draft.value.expression = reader_.expression(*value, DocumentPath(own, "value"), reader_.instance_names());
    draft.value.names = reader_.instance_names().size();
    if (!draft.value.expression) return;
    const std::size_t first = site_variables().size() + first_slot_;
    for (std::size_t k = 0; k < drafts_.size(); ++k) {
      if (draft.value.expression->uses(first + k)) draft.uses.push_back(k);
    }
  }

  void find_owner(Draft& draft, const std::string& id, const DocumentPath& path) {
    std::vector<std::string> ids;
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      ids.push_back(graph_.components[c].id);
      if (ids.back() == id) draft.owner = c;
    }
    if (draft.owner != kNoIndex) return;
    const std::string nearest = reader_.nearest(id, ids);
    reader_.fault(path, fmt::format("there is no component '{}'", id), nearest.empty() ? "the id of a component" : "",
                  nearest);
  }

  /// Each after those that it uses. Those that are left when none can go next need each other.
  void add_in_order() {
    std::vector<bool> is_added(drafts_.size());
    for (std::size_t added = 0; added < drafts_.size();) {
      const std::size_t before = added;
      for (std::size_t k = 0; k < drafts_.size(); ++k) {
        const auto is_ready = [&](std::size_t used) { return is_added[used]; };
        if (is_added[k] || !std::ranges::all_of(drafts_[k].uses, is_ready)) continue;
        is_added[k] = true;
        ++added;
        add(k);
      }
      if (added == before) return tell_circle(is_added);
    }
  }

  void add(std::size_t k) {
    const Draft& draft = drafts_[k];
    InstanceVariable& variable = graph_.instance_variables.emplace_back();
    variable.name = draft.name;
    variable.owner = draft.owner;
    variable.value = draft.value;
    variable.slot = static_cast<std::uint32_t>(first_slot_ + k);
    variable.fingerprint = fingerprint_of(*draft.said, reader_.constants(), {}, 0).value_or(0);
  }

  void tell_circle(const std::vector<bool>& is_added) {
    // Follow uses from one that is left until one comes again.
    std::size_t at = static_cast<std::size_t>(std::ranges::find(is_added, false) - is_added.begin());
    std::vector<std::size_t> way;
    while (std::ranges::find(way, at) == way.end()) {
      way.push_back(at);
      at = *std::ranges::find_if(drafts_[at].uses, [&](std::size_t used) { return !is_added[used]; });
    }
    way.erase(way.begin(), std::ranges::find(way, at));
    std::string text;
    for (const std::size_t k : way) text += drafts_[k].name + " -> ";
    reader_.fault(DocumentPath(DocumentPath(path_, drafts_[at].name), "value"),
                  fmt::format("the variables {}{} depend on each other in a circle", text, drafts_[at].name),
                  "an expression without this circle");
  }

  const Value::Object& given_;
  Graph& graph_;
  ParameterReader& reader_;
  const DocumentPath top_;
  const DocumentPath path_{top_, "variables"};
  std::vector<Draft> drafts_;
  std::size_t first_slot_ = 0;
};

/// Whether a text of the value other than those of a name, a file or a choice mentions the name. Where it does so in
/// vain, such as in the name of a column to choose by, the component still knows what it says.
bool mentions_in_expression(const Value& said, std::string_view name) {
  const Value::Object* members = said.object();
  if (members == nullptr) return false;
  constexpr std::array kTexts{"type", "file", "table", "choose", "names", "grammar", "of"};
  return std::ranges::any_of(*members, [&](const Value::Member& member) {
    const bool is_text = std::ranges::find(kTexts, member.first) != kTexts.end();
    return !is_text && mentions(member.second, name);
  });
}

/// Which components stand somewhere without any of the givers above them.
std::vector<bool> reached_without(const Graph& graph, const std::vector<bool>& gives) {
  std::vector<bool> reached(graph.components.size());
  std::vector<ComponentIndex> ahead;
  const auto meet = [&](ComponentIndex component) {
    if (reached[component]) return;
    reached[component] = true;
    ahead.push_back(component);
  };
  meet(graph.structure.root);
  while (!ahead.empty()) {
    const ComponentIndex next = ahead.back();
    ahead.pop_back();
    if (gives[next]) continue;
    for (const LinkIndex link : graph.structure.outgoing[next]) meet(graph.links[link].to);
  }
  return reached;
}

}  // namespace

bool is_per_instance(const Value& variable) { return variable.object() != nullptr && variable.find("per") != nullptr; }

void read_instance_variables(const Value* given, Graph& graph, ParameterReader& reader) {
  if (given == nullptr || given->object() == nullptr) return;
  InstanceVariableReader(*given->object(), graph, reader).run();
}

void check_given_names(const Value& root, const Graph& graph, std::vector<Diagnostic>& diagnostics) {
  for (std::size_t slot = 0; slot < graph.site_names.size(); ++slot) {
    const std::string& name = graph.site_names[slot];
    // The owner of a variable sees it itself; who gives columns gives them to children only.
    std::vector<bool> gives(graph.components.size());
    std::vector<bool> sees(graph.components.size());
    std::string who;
    for (ComponentIndex c = 0; c < graph.components.size(); ++c) {
      const std::vector<std::uint32_t>& slots = graph.components[c].given_slots;
      gives[c] = std::ranges::find(slots, slot) != slots.end();
    }
    for (const InstanceVariable& variable : graph.instance_variables) {
      if (variable.slot == slot) gives[variable.owner] = sees[variable.owner] = true;
    }
    for (ComponentIndex c = 0; c < graph.components.size(); ++c) {
      if (gives[c]) who += fmt::format("{}'{}'", who.empty() ? "" : " or ", graph.components[c].id);
    }
    const std::vector<bool> reached = reached_without(graph, gives);
    const Value* components = root.find("components");
    for (ComponentIndex c = 0; c < graph.components.size(); ++c) {
      const Prototype& prototype = graph.components[c];
      const Value* said = components == nullptr ? nullptr : components->find(prototype.id);
      if (said == nullptr || !reached[c] || sees[c] || !mentions_in_expression(*said, name)) continue;
      diagnostics.push_back({.message = fmt::format("'{}' uses '{}', which only components that stand on {} have",
                                                    prototype.id, name, who),
                             .expected = fmt::format("links that lead to '{}' through {} alone", prototype.id, who),
                             .path = "components." + prototype.id});
    }
    for (const InstanceVariable& variable : graph.instance_variables) {
      if (!variable.value.expression || !variable.value.expression->uses(site_variables().size() + slot)) continue;
      if (!reached[variable.owner] || sees[variable.owner]) continue;
      diagnostics.push_back({.message = fmt::format("'{}' uses '{}', which only components that stand on {} have",
                                                    variable.name, name, who),
                             .expected = fmt::format("a component of that kind as the \"per\" of '{}'", variable.name),
                             .path = variable.value.path});
    }
  }
}

}  // namespace meristem

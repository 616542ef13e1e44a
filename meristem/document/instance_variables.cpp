// SPDX-License-Identifier: Apache-2.0
// Reads variables that each instance of a component draws, and checks who uses them. Variables are ordered so that each
// follows the variables that it uses. A name may be used below its giver only; dominators of the graph answer this for
// a single giver, and a walk for several givers.
#include "meristem/document/instance_variables.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/base/name_index.h"
#include "meristem/base/name_table.h"
#include "meristem/document/mentions.h"
#include "meristem/document/tables.h"
#include "meristem/document/variables.h"
#include "meristem/graph/dominators.h"
#include "meristem/graph/table/fingerprint.h"

namespace meristem {

namespace {

/// A variable that is not yet in the graph.
struct Draft {
  std::string name;
  ComponentIndex owner = kNoIndex;
  const Value* said = nullptr;
  Varying value;
  std::vector<std::size_t> uses;  // indices of other drafts
};

/// Returns the id of a component.
struct IdAt {
  const Graph& graph;
  std::string_view operator()(std::size_t component) const { return graph.components[component].id; }
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
        reader_.add_name_error(DocumentPath(path_, name),
                               fmt::format("'{}' already has a meaning in expressions, or is no name", name),
                               "another name", "");
      }
    }
    if (drafts_.empty()) return;
    first_slot_ = graph_.site_names.size();
    ids_ = NameIndex(graph_.components.size());
    for (std::size_t c = 0; c < graph_.components.size(); ++c) ids_.enter(graph_.components[c].id, c, IdAt{graph_});
    const NameTable columns(graph_.site_names);
    std::vector<std::string> names;
    for (const Draft& draft : drafts_) {
      if (columns.contains(draft.name)) {
        reader_.add_name_error(DocumentPath(path_, draft.name),
                               fmt::format("'{}' is already a column of places", draft.name), "another name", "");
      }
      names.push_back(draft.name);
    }
    graph_.site_names.insert(graph_.site_names.end(), names.begin(), names.end());
    reader_.expressions().add_instance_names(names);
    const std::size_t errors_before = reader_.error_count();
    for (Draft& draft : drafts_) read(draft);
    if (reader_.error_count() == errors_before) add_in_order();
  }

 private:
  void read(Draft& draft) {
    const DocumentPath own(path_, draft.name);
    // The value is an expression over the owner's sites. The other members are read as for any variable.
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
    draft.value.expression =
        reader_.expressions().read(*value, DocumentPath(own, "value"), reader_.expressions().instance_names());
    draft.value.names = reader_.expressions().instance_names().size();
    if (!draft.value.expression) return;
    const std::size_t first = site_variables().size() + first_slot_;
    for (std::size_t k = 0; k < drafts_.size(); ++k) {
      if (draft.value.expression->uses(first + k)) draft.uses.push_back(k);
    }
  }

  void find_owner(Draft& draft, const std::string& id, const DocumentPath& path) {
    if (const auto owner = ids_.find(id, IdAt{graph_})) {
      draft.owner = static_cast<ComponentIndex>(*owner);
      return;
    }
    if (id_list_.empty()) {
      for (const Prototype& prototype : graph_.components) id_list_.push_back(prototype.id);
    }
    const std::string nearest = reader_.nearest(id, id_list_);
    reader_.add_error(path, fmt::format("there is no component '{}'", id),
                      nearest.empty() ? "the id of a component" : "", nearest);
  }

  /// Adds each variable after the variables that it uses. Works in rounds: each round adds, in the document's order,
  /// all variables whose used variables have been added. Variables that are left over depend on each other.
  void add_in_order() {
    const std::size_t count = drafts_.size();
    std::vector<std::vector<std::size_t>> users(count);
    std::vector<std::size_t> missing(count);  // number of used variables that have not been added
    for (std::size_t k = 0; k < count; ++k) {
      missing[k] = drafts_[k].uses.size();
      for (const std::size_t used : drafts_[k].uses) users[used].push_back(k);
    }
    std::vector<std::size_t> round(count);
    std::vector<std::size_t> ready;
    for (std::size_t k = 0; k < count; ++k) {
      if (missing[k] == 0) ready.push_back(k);
    }
    for (std::size_t next = 0; next < ready.size(); ++next) {
      const std::size_t used = ready[next];
      for (const std::size_t k : users[used]) {
        round[k] = std::max(round[k], round[used] + (used > k ? 1 : 0));
        if (--missing[k] == 0) ready.push_back(k);
      }
    }
    std::ranges::sort(ready, {}, [&](std::size_t k) { return std::pair(round[k], k); });
    std::vector<bool> is_added(count);
    for (const std::size_t k : ready) {
      is_added[k] = true;
      add(k);
    }
    if (ready.size() < count) tell_circle(is_added);
  }

  void add(std::size_t k) {
    const Draft& draft = drafts_[k];
    InstanceVariable& variable = graph_.instance_variables.emplace_back();
    variable.name = draft.name;
    variable.owner = draft.owner;
    variable.value = draft.value;
    variable.slot = static_cast<std::uint32_t>(first_slot_ + k);
    variable.fingerprint = fingerprint_of(*draft.said, reader_.expressions().constant_table(), {}, 0).value_or(0);
  }

  void tell_circle(const std::vector<bool>& is_added) {
    // Follows uses from a variable that is left, until a variable is met again.
    std::size_t at = static_cast<std::size_t>(std::ranges::find(is_added, false) - is_added.begin());
    std::vector<std::size_t> way;
    std::vector<bool> is_met(drafts_.size());
    while (!is_met[at]) {
      is_met[at] = true;
      way.push_back(at);
      at = *std::ranges::find_if(drafts_[at].uses, [&](std::size_t used) { return !is_added[used]; });
    }
    way.erase(way.begin(), std::ranges::find(way, at));
    std::string text;
    for (const std::size_t k : way) text += drafts_[k].name + " -> ";
    reader_.add_error(DocumentPath(DocumentPath(path_, drafts_[at].name), "value"),
                      fmt::format("the variables {}{} depend on each other in a circle", text, drafts_[at].name),
                      "an expression without this circle");
  }

  const Value::Object& given_;
  Graph& graph_;
  ParameterReader& reader_;
  const DocumentPath top_;
  const DocumentPath path_{top_, "variables"};
  NameIndex ids_;                     // ids of components
  std::vector<std::string> id_list_;  // filled for the first message
  std::vector<Draft> drafts_;
  std::size_t first_slot_ = 0;
};

/// Returns true if a member of a component is a name, a file or a choice, and so no expression.
bool is_plain_text(std::string_view member) {
  constexpr std::array kTexts{"type", "file", "table", "choose", "names", "grammar", "of"};
  return std::ranges::find(kTexts, member) != kTexts.end();
}

/// Returns for each component true if it stands somewhere without any of the givers above it.
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

/// Checks every name that a component or a variable mentions. Each mention is checked once.
class GivenNamesCheck {
 public:
  GivenNamesCheck(const Graph& graph, std::vector<Diagnostic>& diagnostics, const Progress* progress)
      : graph_(graph),
        diagnostics_(diagnostics),
        progress_(progress),
        names_(graph.site_names),
        givers_(graph.site_names.size()),
        owners_(graph.site_names.size(), kNoIndex) {
    for (ComponentIndex c = 0; c < graph.components.size(); ++c) {
      for (const std::uint32_t slot : graph.components[c].given_slots) {
        if (givers_[slot].empty() || givers_[slot].back() != c) givers_[slot].push_back(c);
      }
    }
    // The owner of a variable may use it itself. A component that gives columns gives them only to its descendants.
    for (const InstanceVariable& variable : graph.instance_variables) {
      std::vector<ComponentIndex>& givers = givers_[variable.slot];
      const auto place = std::ranges::lower_bound(givers, variable.owner);
      if (place == givers.end() || *place != variable.owner) givers.insert(place, variable.owner);
      owners_[variable.slot] = variable.owner;
    }
  }

  void run(const Value& root) {
    find_mentions(root);
    std::ranges::sort(mentions_);
    for (const Mention& mention : mentions_) {
      if (progress_ != nullptr) progress_->check();
      if (owners_[mention.slot] != mention.component && is_reached(mention)) tell(mention);
    }
  }

 private:
  static constexpr std::size_t kByComponent = 0;

  /// A component that uses a name. `variable` - 1 is the index of the component's variable that uses it.
  struct Mention {
    std::uint32_t slot = 0;
    std::size_t variable = kByComponent;
    ComponentIndex component = 0;
    auto operator<=>(const Mention&) const = default;
  };

  void find_mentions(const Value& root) {
    std::vector<ComponentIndex> last(names_.size(), kNoIndex);  // the last component that mentioned each name
    const Value* components = root.find("components");
    const std::size_t count =
        components == nullptr || components->object() == nullptr ? 0 : components->object()->size();
    // The graph's components begin with the components of the document, in their order. Components that the reader has
    // added follow.
    for (std::size_t k = 0; k < count; ++k) {
      if (progress_ != nullptr) progress_->check();
      const auto component = static_cast<ComponentIndex>(k);
      const Value::Object* members = (*components->object())[k].second.object();
      if (members == nullptr) continue;
      for (const auto& [name, member] : *members) {
        if (is_plain_text(name)) continue;
        for_each_mention(member, [&](std::string_view mentioned) {
          const auto slot = names_.find(mentioned);
          if (!slot || last[*slot] == component) return;
          last[*slot] = component;
          mentions_.push_back({static_cast<std::uint32_t>(*slot), kByComponent, component});
        });
      }
    }
    for (std::size_t v = 0; v < graph_.instance_variables.size(); ++v) {
      const InstanceVariable& variable = graph_.instance_variables[v];
      if (!variable.value.expression) continue;
      std::vector<std::uint32_t> slots;
      for_each_name(variable.value.expression->text(), [&](std::string_view mentioned) {
        const auto slot = names_.find(mentioned);
        if (slot && variable.value.expression->uses(site_variables().size() + *slot)) {
          slots.push_back(static_cast<std::uint32_t>(*slot));
        }
      });
      std::ranges::sort(slots);
      slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
      for (const std::uint32_t slot : slots) mentions_.push_back({slot, v + 1, variable.owner});
    }
  }

  /// Returns true if the component stands somewhere without any giver of the name above it.
  bool is_reached(const Mention& mention) {
    const std::vector<ComponentIndex>& givers = givers_[mention.slot];
    if (!dominators_) {
      std::vector<std::vector<ComponentIndex>> children(graph_.components.size());
      for (const Link& link : graph_.links) children[link.from].push_back(link.to);
      dominators_.emplace(children, graph_.structure.root, progress_);
    }
    const auto is_above = [&](ComponentIndex giver) {
      return dominators_->is_strictly_dominated(mention.component, giver);
    };
    if (givers.size() == 1) return !is_above(givers[0]);
    // A name with several givers needs a walk. Names with equal givers share one walk.
    if (walked_slot_ != mention.slot && (!walked_ || *walked_ != givers)) {
      std::vector<bool> gives(graph_.components.size());
      for (const ComponentIndex giver : givers) gives[giver] = true;
      reached_ = reached_without(graph_, gives);
      walked_ = givers;
    }
    walked_slot_ = mention.slot;
    return reached_[mention.component];
  }

  void tell(const Mention& mention) {
    // Faults beyond the limit are only counted.
    if (++told_ > graph_.limits.diagnostics) {
      diagnostics_.emplace_back();
      return;
    }
    std::string who;
    for (const ComponentIndex giver : givers_[mention.slot]) {
      who += fmt::format("{}'{}'", who.empty() ? "" : " or ", graph_.components[giver].id);
    }
    const bool is_variable = mention.variable != kByComponent;
    const InstanceVariable* variable = is_variable ? &graph_.instance_variables[mention.variable - 1] : nullptr;
    const std::string& user = is_variable ? variable->name : graph_.components[mention.component].id;
    diagnostics_.push_back({.message = fmt::format("'{}' uses '{}', which only components that stand on {} have", user,
                                                   graph_.site_names[mention.slot], who),
                            .expected = is_variable
                                            ? fmt::format("a component of that kind as the \"per\" of '{}'", user)
                                            : fmt::format("links that lead to '{}' through {} alone", user, who),
                            .path = is_variable ? variable->value.path : "components." + user});
  }

  const Graph& graph_;
  std::vector<Diagnostic>& diagnostics_;
  const Progress* progress_;
  const NameTable names_;                            // names of the values of sites
  std::vector<std::vector<ComponentIndex>> givers_;  // by name: indices of its givers, rising
  std::vector<ComponentIndex> owners_;               // by name: owner of the variable
  std::vector<Mention> mentions_;
  std::optional<Dominators> dominators_;
  std::optional<std::uint32_t> walked_slot_;           // slot of the previous mention
  std::optional<std::vector<ComponentIndex>> walked_;  // givers of the last walk
  std::vector<bool> reached_;                          // result of the last walk
  std::size_t told_ = 0;
};

}  // namespace

bool is_per_instance(const Value& variable) { return variable.object() != nullptr && variable.find("per") != nullptr; }

void read_instance_variables(const Value* given, Graph& graph, ParameterReader& reader) {
  if (given == nullptr || given->object() == nullptr) return;
  InstanceVariableReader(*given->object(), graph, reader).run();
}

void check_given_names(const Value& root, const Graph& graph, std::vector<Diagnostic>& diagnostics,
                       const Progress* progress) {
  if (!graph.site_names.empty()) GivenNamesCheck(graph, diagnostics, progress).run(root);
}

}  // namespace meristem

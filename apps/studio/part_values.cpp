// SPDX-License-Identifier: Apache-2.0
#include "part_values.h"

#include <algorithm>
#include <set>

#include "meristem/document/edit/session.h"

namespace meristem::studio {

namespace {

Value link_value(const std::string& from, const std::string& to) { return Value::Object{{"from", from}, {"to", to}}; }

std::string text_of(const Value* value) {
  return value != nullptr && value->text() != nullptr ? *value->text() : std::string();
}

}  // namespace

Value implied_links_value(const Graph& graph) {
  Value::List links;
  for (const Link& link : graph.links) {
    if (link.is<PlacedLink>())
      links.push_back(link_value(graph.components[link.from].id, graph.components[link.to].id));
  }
  return links;
}

Value notes_value(const std::string& text, const Progress* progress) {
  Value::Object notes;
  for (auto& [id, note] : component_notes(text, progress)) notes.emplace_back(id, std::move(note));
  return notes;
}

std::vector<std::string> placeable_components(const Value& tree, const Registry& registry) {
  std::vector<std::string> ids;
  const Value* components = tree.find("components");
  if (components == nullptr || components->object() == nullptr) return ids;
  for (const auto& [id, component] : *components->object()) {
    const ComponentType* type = registry.find(text_of(component.find("type")));
    if (type == nullptr || !type->is_camera) ids.push_back(id);
  }
  return ids;
}

Value part_roots_value(const Value& tree, const std::vector<std::string>& components) {
  const std::set<std::string> all(components.begin(), components.end());
  std::set<std::string> held;
  const Value* links = tree.find("links");
  if (links != nullptr && links->list() != nullptr) {
    for (const Value& link : *links->list()) {
      const Value::List* ends = link.list();
      const bool is_pair = ends != nullptr && ends->size() == 2;
      const std::string from = text_of(is_pair ? &(*ends)[0] : link.find("from"));
      const std::string to = text_of(is_pair ? &(*ends)[1] : link.find("to"));
      if (from != to && all.contains(from)) held.insert(to);
    }
  }
  Value::List roots;
  for (const std::string& id : components) {
    if (!held.contains(id)) roots.push_back(id);
  }
  if (roots.empty() && !components.empty()) roots.push_back(components[0]);
  return roots;
}

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/silent_keys.h"

#include <algorithm>

#include <fmt/format.h>

namespace meristem {

namespace {

void report(std::vector<Diagnostic>& diagnostics, std::string path, std::string message, std::string expected) {
  diagnostics.push_back({.message = std::move(message),
                         .expected = std::move(expected),
                         .nearest = {},
                         .path = std::move(path),
                         .file = {},
                         .text_offset = kAtName});
}

void check_recursions(const Value& components, const Graph& graph, std::vector<Diagnostic>& diagnostics) {
  for (ComponentIndex component = 0; component < graph.components.size(); ++component) {
    const std::string& id = graph.components[component].id;
    const Value* given = components.find(id);
    if (given == nullptr || given->find("recursion") == nullptr) continue;
    const auto is_its = [&](const Structure::Recursion& recursion) { return recursion.head == component; };
    if (std::ranges::any_of(graph.structure.recursions, is_its)) continue;
    report(diagnostics, fmt::format("components.{}.recursion", id),
           fmt::format("'recursion' has no meaning here: no link leads back to '{}'", id),
           fmt::format("a link from '{}', or from what hangs on it, to '{}', or no such key", id, id));
  }
}

/// Where children head along the stem unless the link gives an angle, nothing else turns them away from it.
void check_angles(const Value& links, std::vector<Diagnostic>& diagnostics, const Graph& graph) {
  const auto leads_away = [&](const Value& link) {
    const Value* to = link.find("to");
    const auto is_it = [&](const Prototype& prototype) { return to != nullptr && *to == Value(prototype.id); };
    const auto found = std::ranges::find_if(graph.components, is_it);
    return found != graph.components.end() && found->type->stance == BranchStance::along_axis;
  };
  for (std::size_t k = 0; k < links.list()->size(); ++k) {
    const Value& link = (*links.list())[k];
    if (link.find("angle") != nullptr || !leads_away(link)) continue;
    for (const char* const name : {"angle_tip", "angle_spread"}) {
      if (link.find(name) == nullptr) continue;
      report(diagnostics, fmt::format("links[{}].{}", k, name),
             fmt::format("'{}' has no meaning without 'angle', as '{}' heads along its stem", name,
                         *link.find("to")->text()),
             "'angle' beside it, or no such key");
    }
  }
}

}  // namespace

void check_silent_keys(const Value& root, const Graph& graph, std::vector<Diagnostic>& diagnostics) {
  if (const Value* components = root.find("components")) check_recursions(*components, graph, diagnostics);
  if (const Value* links = root.find("links")) check_angles(*links, diagnostics, graph);
}

}  // namespace meristem

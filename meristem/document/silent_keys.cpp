// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/silent_keys.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "meristem/base/name_table.h"
#include "meristem/base/reading_stop.h"

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

void check_recursions(const Value& components, const Graph& graph, std::vector<Diagnostic>& diagnostics,
                      StopCounter& stop) {
  // The graph's components begin with the components of the document, in their order. Components that the reader has
  // added follow.
  if (components.object() == nullptr) return;
  for (std::size_t k = 0; k < components.object()->size(); ++k) {
    stop.step();
    const auto component = static_cast<ComponentIndex>(k);
    const auto& [id, given] = (*components.object())[k];
    if (given.find("recursion") == nullptr) continue;
    const auto is_its = [component](const LinkStructure::Recursion& recursion) { return recursion.head == component; };
    if (std::ranges::any_of(graph.structure.recursions, is_its)) continue;
    report(diagnostics, fmt::format("components.{}.recursion", id),
           fmt::format("'recursion' has no meaning here: no link leads back to '{}'", id),
           fmt::format("a link from '{}', or from what hangs on it, to '{}', or no such key", id, id));
  }
}

/// Reports angles that have no effect: children that head along the stem turn away from it only if the link gives an
/// angle.
void check_angles(const Value& links, std::vector<Diagnostic>& diagnostics, const Graph& graph, StopCounter& stop) {
  NameTable ids;
  for (const Prototype& prototype : graph.components) {
    stop.step();
    ids.add(prototype.id);
  }
  const auto leads_away = [&](const Value& link) {
    const Value* to = link.find("to");
    const auto found = to == nullptr || to->text() == nullptr ? std::nullopt : ids.find(*to->text());
    return found && graph.components[*found].type->stance == BranchStance::along_axis;
  };
  for (std::size_t k = 0; k < links.list()->size(); ++k) {
    stop.step();
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
  StopCounter stop;
  if (const Value* components = root.find("components")) check_recursions(*components, graph, diagnostics, stop);
  if (const Value* links = root.find("links")) check_angles(*links, diagnostics, graph, stop);
}

}  // namespace meristem

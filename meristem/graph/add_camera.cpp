// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/add_camera.h"

#include <algorithm>
#include <string>
#include <vector>

#include "meristem/base/reading_stop.h"
#include "meristem/graph/flat_lists.h"

namespace meristem {

namespace {

/// Links the camera to all roots of the graph. Marks the components that can be reached from each new link.
class Roots {
 public:
  Roots(Graph& graph, const std::vector<bool>& has_recursion, ComponentIndex camera)
      : graph_(graph), has_recursion_(has_recursion), camera_(camera), has_parent_(camera), is_reached_(camera) {
    outgoing_ = make_flat_lists(camera, graph.links.size(), [&](std::size_t k) { return graph.links[k].from; });
    for (const Link& link : graph.links) {
      stop_.step();
      has_parent_[link.to] = true;
    }
  }

  void run() {
    const auto roots = std::ranges::count(has_parent_, false);
    graph_.links.reserve(graph_.links.size() + static_cast<std::size_t>(roots));  // moves nothing after a LinkReader
    for (ComponentIndex c = 0; c < camera_; ++c) {
      if (!has_parent_[c]) link_to(c);
    }
    for (ComponentIndex c = 0; c < camera_; ++c) {
      if (!is_reached_[c] && graph_.components[c].base().recursion > 1) link_to(c);
    }
    for (ComponentIndex c = 0; c < camera_ && c < has_recursion_.size(); ++c) {
      if (!is_reached_[c] && has_recursion_[c]) link_to(c);
    }
    for (ComponentIndex c = 0; c < camera_; ++c) {
      if (!is_reached_[c]) link_to(c);
    }
  }

 private:
  void link_to(ComponentIndex component) {
    stop_.step();
    graph_.links.push_back({.from = camera_, .to = component, .kind = ChildLink{}, .fingerprint = 0});
    is_reached_[component] = true;
    std::vector<ComponentIndex> ahead{component};
    while (!ahead.empty()) {
      const ComponentIndex next = ahead.back();
      ahead.pop_back();
      stop_.step();
      for (const LinkIndex link : outgoing_.of(next)) {
        const ComponentIndex child = graph_.links[link].to;
        if (!is_reached_[child]) ahead.push_back(child);
        is_reached_[child] = true;
      }
    }
  }

  StopCounter stop_;
  Graph& graph_;
  const std::vector<bool>& has_recursion_;
  ComponentIndex camera_;  // the last component
  FlatLists outgoing_;     // links of the document by component
  std::vector<bool> has_parent_;
  std::vector<bool> is_reached_;
};

}  // namespace

void add_camera(Graph& graph, const ComponentType& camera, const std::vector<bool>& has_recursion) {
  const auto is_camera = [](const Prototype& prototype) { return prototype.type->is_camera; };
  if (std::ranges::any_of(graph.components, is_camera)) return;
  std::string id = "camera";
  while (std::ranges::find(graph.components, id, &Prototype::id) != graph.components.end()) id += '_';
  graph.components.push_back({.id = std::move(id),
                              .type = &camera,
                              .parameters = camera.make_parameters(),
                              .fingerprint = 0,
                              .depends_on_time = false});
  Roots(graph, has_recursion, static_cast<ComponentIndex>(graph.components.size() - 1)).run();
}

}  // namespace meristem

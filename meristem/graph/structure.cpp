// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "meristem/graph/graph.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxRecursions = 64;

std::string link_path(LinkIndex link) { return fmt::format("links[{}]", link); }

class Analysis {
 public:
  Analysis(const Graph& graph, std::vector<Diagnostic>& diagnostics) : graph_(graph), diagnostics_(diagnostics) {
    structure_.outgoing.resize(graph.components.size());
    structure_.recursion_of_link.assign(graph.links.size(), kNoIndex);
    structure_.recursion_of.assign(graph.components.size(), kNoIndex);
  }

  Structure run() {
    const std::size_t errors_before = diagnostics_.size();
    for (LinkIndex k = 0; k < graph_.links.size(); ++k) structure_.outgoing[graph_.links[k].from].push_back(k);
    find_root();
    if (diagnostics_.size() == errors_before) find_recursions();
    if (diagnostics_.size() == errors_before) order_recursions();
    return std::move(structure_);
  }

 private:
  const std::string& id(ComponentIndex component) const { return graph_.components[component].id; }

  void error(std::string path, std::string message, std::string expected) {
    diagnostics_.push_back({.message = std::move(message),
                            .expected = std::move(expected),
                            .nearest = {},
                            .path = std::move(path),
                            .file = {}});
  }

  void find_root() {
    structure_.root = kNoIndex;
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      if (!graph_.components[c].type->is_camera) continue;
      if (structure_.root != kNoIndex) {
        error("components." + id(c), fmt::format("'{}' is a second camera beside '{}'", id(c), id(structure_.root)),
              "one camera a document");
      } else {
        structure_.root = c;
      }
    }
    for (LinkIndex k = 0; k < graph_.links.size(); ++k) {
      const Link& link = graph_.links[k];
      if (graph_.components[link.to].type->is_camera) {
        error(link_path(k), fmt::format("the link leads to the camera '{}'", id(link.to)),
              "the camera is the root of all links");
      }
    }
  }

  /// Walks the graph depth-first without recursing; a link to a component on the present path closes a recursion.
  void find_recursions() {
    enum class State : std::uint8_t { unseen, on_path, done };
    struct Visit {
      ComponentIndex component;
      std::size_t next = 0;  // outgoing link to follow next
    };
    std::vector<State> state(graph_.components.size(), State::unseen);
    std::vector<Visit> path{{structure_.root}};
    state[structure_.root] = State::on_path;
    while (!path.empty()) {
      Visit& top = path.back();
      if (top.next == structure_.outgoing[top.component].size()) {
        state[top.component] = State::done;
        path.pop_back();
        continue;
      }
      const LinkIndex link = structure_.outgoing[top.component][top.next++];
      const ComponentIndex to = graph_.links[link].to;
      if (state[to] == State::unseen) {
        state[to] = State::on_path;
        path.push_back({to});
      } else if (state[to] == State::on_path) {
        close_recursion(link, path.begin(), path.end());
      }
    }
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      if (state[c] == State::unseen) {
        error("components." + id(c), fmt::format("nothing that hangs on the camera links to '{}'", id(c)),
              fmt::format("a link such as [\"{}\", \"{}\"]", id(structure_.root), id(c)));
      }
    }
  }

  template <class Iterator>
  void close_recursion(LinkIndex link, Iterator path_begin, Iterator path_end) {
    const ComponentIndex head = graph_.links[link].to;
    const auto head_at = std::find_if(path_begin, path_end, [&](const auto& v) { return v.component == head; });
    Structure::Recursion recursion{.head = head};
    for (auto visit = head_at; visit != path_end; ++visit) recursion.members.push_back(visit->component);
    if (graph_.components[head].base().recursion == 0) {
      error(link_path(link), fmt::format("the links {} go round without end", cycle_text(recursion)),
            fmt::format("a \"recursion\" of at least 1 in '{}', or no link back", id(head)));
    }
    structure_.recursion_of_link[link] = static_cast<std::uint32_t>(structure_.recursions.size());
    structure_.recursions.push_back(std::move(recursion));
  }

  std::string cycle_text(const Structure::Recursion& recursion) const {
    std::string text;
    for (const ComponentIndex member : recursion.members) text += id(member) + " > ";
    return text + id(recursion.head);
  }

  /// Two recursions may lie apart or within one another, but not cross. Levels count from the outermost.
  void order_recursions() {
    std::vector<Structure::Recursion>& recursions = structure_.recursions;
    if (recursions.size() > kMaxRecursions) {
      return error("links", fmt::format("{} links lead back to an ancestor", recursions.size()),
                   fmt::format("at most {} recursions", kMaxRecursions));
    }
    const auto contains = [](const Structure::Recursion& outer, ComponentIndex c) {
      return std::find(outer.members.begin(), outer.members.end(), c) != outer.members.end();
    };
    for (std::size_t a = 0; a < recursions.size(); ++a) {
      for (std::size_t b = 0; b < recursions.size(); ++b) {
        if (a == b) continue;
        const bool b_head_in_a = contains(recursions[a], recursions[b].head);
        const bool b_tail_in_a = contains(recursions[a], recursions[b].members.back());
        const bool same_head = recursions[a].head == recursions[b].head;
        // b begins inside a (below its head) and ends outside of it.
        if (b_head_in_a && !same_head && !b_tail_in_a && contains(recursions[b], recursions[a].members.back())) {
          error("links",
                fmt::format("the recursions {} and {} cross", cycle_text(recursions[a]), cycle_text(recursions[b])),
                "recursions that lie apart or one within the other");
        }
        if (b_head_in_a && b_tail_in_a && !same_head) ++recursions[b].level;
      }
    }
    for (std::uint32_t r = 0; r < recursions.size(); ++r) {
      if (recursions[r].level >= kMaxRecursionLevels) {
        error("components." + id(recursions[r].head),
              fmt::format("'{}' recurses within {} other recursions", id(recursions[r].head), recursions[r].level),
              fmt::format("at most {} within one another", kMaxRecursionLevels));
      }
      for (const ComponentIndex member : recursions[r].members) {
        std::uint32_t& innermost = structure_.recursion_of[member];
        if (innermost == kNoIndex || recursions[innermost].level < recursions[r].level) innermost = r;
      }
    }
  }

  const Graph& graph_;
  std::vector<Diagnostic>& diagnostics_;
  Structure structure_;
};

}  // namespace

Structure analyse_structure(const Graph& graph, std::vector<Diagnostic>& diagnostics) {
  return Analysis(graph, diagnostics).run();
}

}  // namespace meristem

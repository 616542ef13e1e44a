// SPDX-License-Identifier: Apache-2.0
// Analyses the links of a graph. A depth-first walk from the camera finds links that close a cycle; each must be a
// recursion, and recursions may be nested but must not cross. A backward search from its last member finds the
// components of a recursion.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "meristem/base/free_later.h"
#include "meristem/graph/flat_lists.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/single_recursions.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxRecursions = 64;
constexpr std::size_t kShownMembers = 8;  // members of a cycle that messages list
constexpr std::size_t kStepsBetweenChecks = 4096;

class Analysis {
 public:
  Analysis(const Graph& graph, const std::vector<bool>& may_be_single, std::vector<Diagnostic>& diagnostics,
           const Progress* progress)
      : graph_(graph), may_be_single_(may_be_single), diagnostics_(diagnostics), progress_(progress) {
    structure_.outgoing.resize(graph.components.size());
    structure_.recursion_of_link.assign(graph.links.size(), kNoIndex);
    structure_.recursion_of.assign(graph.components.size(), kNoIndex);
    spans_.resize(graph.components.size());
  }

  /// Returns what has been found so far.
  LinkStructure take() { return std::move(structure_); }

  LinkStructure run() {
    const std::size_t errors_before = diagnostics_.size();
    for (LinkIndex k = 0; k < graph_.links.size(); ++k) {
      check(k);
      structure_.outgoing[graph_.links[k].from].push_back(k);
    }
    find_root();
    if (diagnostics_.size() == errors_before) find_recursions();
    if (diagnostics_.size() == errors_before) order_recursions();
    return take();
  }

 private:
  void check(std::size_t step) const {
    if (progress_ != nullptr && step % kStepsBetweenChecks == 0) progress_->check();
  }

  const std::string& id(ComponentIndex component) const { return graph_.components[component].id; }

  void add_error(std::string path, std::string message, std::string expected) {
    if (++errors_ > graph_.limits.diagnostics) return;
    diagnostics_.push_back({.message = std::move(message),
                            .expected = std::move(expected),
                            .nearest = {},
                            .path = std::move(path),
                            .file = {}});
  }

  void find_root() {
    structure_.root = kNoIndex;
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      check(c);
      if (!graph_.components[c].type->is_camera) continue;
      if (structure_.root != kNoIndex) {
        add_error("components." + id(c), fmt::format("'{}' is a second camera beside '{}'", id(c), id(structure_.root)),
                  "one camera per document");
      } else {
        structure_.root = c;
      }
    }
    if (structure_.root == kNoIndex)
      add_error("components", "the graph has no camera", "one camera, the root of all links");
    for (LinkIndex k = 0; k < graph_.links.size(); ++k) {
      check(k);
      const Link& link = graph_.links[k];
      if (graph_.components[link.to].type->is_camera) {
        add_error(link_path(graph_, k), fmt::format("the link leads to the camera '{}'", id(link.to)),
                  "the camera is the root of all links");
      }
    }
  }

  /// Walks the graph depth-first without recursing. A link to a component on the present path closes a recursion.
  void find_recursions() {
    enum class State : std::uint8_t { unseen, on_path, done };
    struct Visit {
      ComponentIndex component;
      std::size_t next = 0;  // outgoing link to follow next
    };
    std::vector<State> state(graph_.components.size(), State::unseen);
    std::vector<Visit> path;
    std::uint32_t seen = 0;
    std::size_t links_back = 0;
    const auto enter = [&](ComponentIndex component) {
      state[component] = State::on_path;
      spans_[component].first = seen++;
      path.push_back({component});
    };
    enter(structure_.root);
    for (std::size_t step = 0; !path.empty(); ++step) {
      check(step);
      Visit& top = path.back();
      if (top.next == structure_.outgoing[top.component].size()) {
        state[top.component] = State::done;
        spans_[top.component].end = seen;
        path.pop_back();
        continue;
      }
      const LinkIndex link = structure_.outgoing[top.component][top.next++];
      const ComponentIndex to = graph_.links[link].to;
      if (state[to] == State::unseen) {
        enter(to);
      } else if (state[to] == State::on_path && ++links_back <= kMaxRecursions) {
        close_recursion(link, path.begin(), path.end());
      }
    }
    if (links_back > kMaxRecursions) {
      add_error("links", fmt::format("{} links lead back to an ancestor", links_back),
                fmt::format("at most {} recursions", kMaxRecursions));
    }
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      check(c);
      if (state[c] == State::unseen) {
        add_error("components." + id(c), fmt::format("'{}' cannot be reached from the camera by links", id(c)),
                  fmt::format("a link such as [\"{}\", \"{}\"]", id(structure_.root), id(c)));
      }
    }
  }

  template <class Iterator>
  void close_recursion(LinkIndex link, Iterator path_begin, Iterator path_end) {
    const ComponentIndex head = graph_.links[link].to;
    const auto head_at = std::find_if(path_begin, path_end, [&](const auto& v) { return v.component == head; });
    LinkStructure::Recursion recursion{.head = head};
    for (auto visit = head_at; visit != path_end; ++visit) recursion.members.push_back(visit->component);
    const bool may_be_single = head < may_be_single_.size() && may_be_single_[head];
    if (graph_.components[head].base().recursion < 2 && !may_be_single) {
      add_error(link_path(graph_, link), fmt::format("the links {} form an endless circle", cycle_text(recursion)),
                fmt::format("a \"recursion\" of at least 2 in '{}', or no link back", id(head)));
    }
    structure_.recursion_of_link[link] = static_cast<std::uint32_t>(structure_.recursions.size());
    structure_.recursions.push_back(std::move(recursion));
  }

  std::string cycle_text(const LinkStructure::Recursion& recursion) const {
    std::string text;
    for (std::size_t k = 0; k < recursion.members.size(); ++k) {
      if (k == kShownMembers) return text + "... > " + id(recursion.members.back()) + " > " + id(recursion.head);
      text += id(recursion.members[k]) + " > ";
    }
    return text + id(recursion.head);
  }

  /// Checks that recursions lie apart or within one another, and numbers their levels from the outermost.
  void order_recursions() {
    std::vector<LinkStructure::Recursion>& recursions = structure_.recursions;
    std::vector<std::vector<bool>> members;
    for (const LinkStructure::Recursion& recursion : recursions) members.push_back(members_of(recursion));
    for (std::size_t a = 0; a < recursions.size(); ++a) {
      for (std::size_t b = 0; b < recursions.size(); ++b) {
        if (cross(recursions[a], members[a], recursions[b], members[b])) {
          add_error("links",
                    fmt::format("the recursions {} and {} cross", cycle_text(recursions[a]), cycle_text(recursions[b])),
                    "recursions that lie apart or one within the other");
        }
      }
    }
    std::vector<std::vector<bool>> bodies;
    if (!recursions.empty()) {
      incoming_ = make_flat_lists(graph_.components.size(), graph_.links.size(),
                                  [&](std::size_t k) { return graph_.links[k].to; });
    }
    for (const LinkStructure::Recursion& recursion : recursions) bodies.push_back(body(recursion));
    for (LinkStructure::Recursion& inner : recursions) {
      std::set<ComponentIndex> outer_heads;
      for (std::size_t a = 0; a < recursions.size(); ++a) {
        const ComponentIndex head = recursions[a].head;
        if (bodies[a][inner.head] && spans_[head].first < spans_[inner.head].first) outer_heads.insert(head);
      }
      inner.level = outer_heads.size();
      if (inner.level >= kMaxRecursionLevels) {
        add_error("components." + id(inner.head),
                  fmt::format("'{}' recurses within {} other recursions", id(inner.head), inner.level),
                  fmt::format("at most {} within one another", kMaxRecursionLevels));
      }
    }
    for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
      check(c);
      std::uint32_t& innermost = structure_.recursion_of[c];
      for (std::uint32_t r = 0; r < recursions.size(); ++r) {
        if (bodies[r][c] && (innermost == kNoIndex || recursions[innermost].level < recursions[r].level)) innermost = r;
      }
    }
  }

  /// Returns true if b begins on a's way below its head, follows that way for a while, and ends beyond it.
  static bool cross(const LinkStructure::Recursion& a, const std::vector<bool>& in_a, const LinkStructure::Recursion& b,
                    const std::vector<bool>& in_b) {
    const ComponentIndex a_tail = a.members.back();
    return b.head != a.head && b.head != a_tail && in_a[b.head] && in_b[a_tail] && !in_a[b.members.back()];
  }

  std::vector<bool> members_of(const LinkStructure::Recursion& recursion) const {
    std::vector<bool> inside(graph_.components.size());
    for (const ComponentIndex member : recursion.members) inside[member] = true;
    return inside;
  }

  /// Returns all components below the head from which the recursion's last member can be reached without passing the
  /// head.
  std::vector<bool> body(const LinkStructure::Recursion& recursion) const {
    const Span below = spans_[recursion.head];
    std::vector<bool> inside(graph_.components.size());
    std::vector<ComponentIndex> open{recursion.members.back()};
    inside[recursion.head] = inside[open.back()] = true;
    for (std::size_t step = 0; !open.empty(); ++step) {
      check(step);
      const ComponentIndex component = open.back();
      open.pop_back();
      if (component == recursion.head) continue;
      for (const LinkIndex link : incoming_.of(component)) {
        const ComponentIndex from = graph_.links[link].from;
        if (inside[from] || spans_[from].first < below.first || spans_[from].first >= below.end) continue;
        inside[from] = true;
        open.push_back(from);
      }
    }
    return inside;
  }

  /// The times, counted in steps of the walk, at which the walk entered a component and left the last component below
  /// it.
  struct Span {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };

  const Graph& graph_;
  const std::vector<bool>& may_be_single_;
  std::vector<Diagnostic>& diagnostics_;
  const Progress* progress_;
  LinkStructure structure_;
  FlatLists incoming_;       // links by component; only if there are recursions
  std::vector<Span> spans_;  // by component
  std::size_t errors_ = 0;
};

}  // namespace

std::string link_path(const Graph& graph, LinkIndex link) {
  const bool is_made = graph.links[link].is<PlacedLink>();
  return is_made ? "components." + graph.components[graph.links[link].from].id : fmt::format("links[{}]", link);
}

void analyse_structure(Graph& graph, std::vector<Diagnostic>& diagnostics, const Progress* progress) {
  analyse_structure(graph, {}, diagnostics, progress);
}

void analyse_structure(Graph& graph, const std::vector<bool>& may_be_single, std::vector<Diagnostic>& diagnostics,
                       const Progress* progress) {
  Analysis analysis(graph, may_be_single, diagnostics, progress);
  try {
    graph.structure = analysis.run();
  } catch (const Cancelled&) {
    free_later(analysis.take());
    throw;
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Numbers the nodes in depth-first order, computes semidominators from the last node to the first, and reads the
// immediate dominators from them. Paths to the best ancestor are compressed. Nothing recurses.
//
// Based on: T. Lengauer, R. E. Tarjan: A fast algorithm for finding dominators in a flowgraph (1979), the version
// without balanced linking.
#include "meristem/graph/dominators.h"

#include <algorithm>

namespace meristem {

namespace {

constexpr std::uint32_t kNoDominator = static_cast<std::uint32_t>(-1);
constexpr std::size_t kNodesBetweenChecks = 4096;

/// All arrays are indexed by depth-first number.
class Search {
 public:
  using Node = Dominators::Node;

  Search(const std::vector<std::vector<Node>>& successors, Node root, const Progress* progress)
      : successors_(successors), progress_(progress), number_(successors.size(), kNoDominator) {
    walk(root);
    find_predecessors();
  }

  const std::vector<Node>& nodes() const { return node_; }

  /// Returns the immediate dominator of each node except the root. Nodes are depth-first numbers.
  std::vector<std::uint32_t> run() {
    const auto count = static_cast<std::uint32_t>(node_.size());
    semi_.resize(count);
    best_.resize(count);
    ancestor_.assign(count, kNoDominator);
    dominator_.assign(count, 0);
    for (std::uint32_t k = 0; k < count; ++k) semi_[k] = best_[k] = k;
    std::vector<std::uint32_t> first_in_bucket(count, kNoDominator);
    std::vector<std::uint32_t> next_in_bucket(count, kNoDominator);
    for (std::uint32_t w = count; w-- > 1;) {
      check(w);
      for (std::uint32_t e = first_edge_[w]; e < first_edge_[w + 1]; ++e) {
        semi_[w] = std::min(semi_[w], semi_[best_ancestor(predecessors_[e])]);
      }
      next_in_bucket[w] = first_in_bucket[semi_[w]];
      first_in_bucket[semi_[w]] = w;
      ancestor_[w] = parent_[w];
      for (std::uint32_t v = first_in_bucket[parent_[w]]; v != kNoDominator; v = next_in_bucket[v]) {
        const std::uint32_t best = best_ancestor(v);
        dominator_[v] = semi_[best] < semi_[v] ? best : parent_[w];
      }
      first_in_bucket[parent_[w]] = kNoDominator;
    }
    for (std::uint32_t w = 1; w < count; ++w) {
      if (dominator_[w] != semi_[w]) dominator_[w] = dominator_[dominator_[w]];
    }
    return std::move(dominator_);
  }

 private:
  void check(std::size_t step) const {
    if (progress_ != nullptr && step % kNodesBetweenChecks == 0) progress_->check();
  }

  void walk(Node root) {
    struct Visit {
      std::uint32_t number;
      std::size_t next;
    };
    std::vector<Visit> path;
    const auto enter = [&](Node node, std::uint32_t parent) {
      number_[node] = static_cast<std::uint32_t>(node_.size());
      path.push_back({number_[node], 0});
      node_.push_back(node);
      parent_.push_back(parent);
      check(node_.size());
    };
    enter(root, 0);
    while (!path.empty()) {
      Visit& top = path.back();
      const std::vector<Node>& next = successors_[node_[top.number]];
      if (top.next == next.size()) {
        path.pop_back();
        continue;
      }
      const Node to = next[top.next++];
      if (number_[to] == kNoDominator) enter(to, top.number);
    }
  }

  void find_predecessors() {
    const std::size_t count = node_.size();
    first_edge_.assign(count + 1, 0);
    for (const Node node : node_) {
      for (const Node to : successors_[node]) ++first_edge_[number_[to] + 1];
    }
    for (std::size_t k = 0; k < count; ++k) first_edge_[k + 1] += first_edge_[k];
    predecessors_.resize(first_edge_.back());
    std::vector<std::uint32_t> place(first_edge_.begin(), first_edge_.end() - 1);
    for (std::uint32_t from = 0; from < count; ++from) {
      check(from);
      for (const Node to : successors_[node_[from]]) predecessors_[place[number_[to]]++] = from;
    }
  }

  /// Returns the node with the lowest semidominator on the way from v to the root of its tree of linked nodes. The root
  /// of that tree is left out.
  std::uint32_t best_ancestor(std::uint32_t v) {
    if (ancestor_[v] == kNoDominator) return v;
    way_.clear();
    for (std::uint32_t at = v; ancestor_[ancestor_[at]] != kNoDominator; at = ancestor_[at]) way_.push_back(at);
    while (!way_.empty()) {
      const std::uint32_t at = way_.back();
      way_.pop_back();
      const std::uint32_t above = ancestor_[at];
      if (semi_[best_[above]] < semi_[best_[at]]) best_[at] = best_[above];
      ancestor_[at] = ancestor_[above];
    }
    return best_[v];
  }

  const std::vector<std::vector<Node>>& successors_;
  const Progress* progress_;
  std::vector<std::uint32_t> number_;  // by node
  std::vector<Node> node_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> first_edge_, predecessors_;  // the predecessors of node k begin at first_edge_[k]
  std::vector<std::uint32_t> semi_, best_, ancestor_, dominator_;
  std::vector<std::uint32_t> way_;
};

}  // namespace

Dominators::Dominators(const std::vector<std::vector<Node>>& successors, Node root, const Progress* progress)
    : spans_(successors.size()) {
  Search search(successors, root, progress);
  const std::vector<std::uint32_t> dominator = search.run();
  const std::vector<Node>& nodes = search.nodes();
  const std::size_t count = nodes.size();
  // A dominator has a lower depth-first number than the nodes below it, so plain loops find sizes and places.
  std::vector<std::uint32_t> size(count, 1);
  for (std::size_t k = count; k-- > 1;) size[dominator[k]] += size[k];
  std::vector<std::uint32_t> begin(count, 1);
  std::vector<std::uint32_t> next(count, 2);  // where the next subtree below a node begins
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) {
      begin[k] = next[dominator[k]];
      next[dominator[k]] += size[k];
      next[k] = begin[k] + 1;
    }
    spans_[nodes[k]] = {begin[k], begin[k] + size[k]};
  }
}

}  // namespace meristem

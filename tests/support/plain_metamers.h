// SPDX-License-Identifier: Apache-2.0
// Metamers as a tree of pointers: a simple reference implementation.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/grow/metamer/metamers.h"

namespace meristem {

/// Metamers are identified by their births, which are unique. The seed's birth is 0.
class PlainMetamers {
 public:
  PlainMetamers() { by_birth_[0] = &seed_; }

  void grow(int from, bool is_lateral, int birth) {
    Node* const parent = by_birth_.at(from);
    Side& side = is_lateral ? parent->lateral : parent->terminal;
    side = {std::make_unique<Node>(), Bud::State::grown};
    Node& made = *side.node;
    made.parent = parent;
    made.birth = birth;
    made.number = is_lateral ? 1 : parent->number + 1;
    made.order = parent->order + (is_lateral ? 1 : 0);
    made.shoot = is_lateral ? fmt::format("{}.{}", parent->shoot, parent->number) : parent->shoot;
    by_birth_[birth] = &made;
  }

  /// Removes metamers with everything that they bear. `births` must be in rising order, so that a bearing metamer comes
  /// first.
  void remove(const std::vector<int>& births, Bud::State after) {
    for (const int birth : births) {
      const auto found = by_birth_.find(birth);
      if (found == by_birth_.end()) continue;
      Node& parent = *found->second->parent;
      parent.lost += tips(*found->second);
      Side& side = parent.lateral.node.get() == found->second ? parent.lateral : parent.terminal;
      forget(*side.node);
      side = {nullptr, after};
    }
  }

  /// Succeeds if both are the same valid tree with equal names. The failure names the birth.
  testing::AssertionResult is_like(const Metamers& metamers) const {
    if (metamers.count() != by_birth_.size()) {
      return testing::AssertionFailure() << metamers.count() << " metamers for " << by_birth_.size();
    }
    std::vector<MetamerIndex> first(metamers.axes.size(), kNoNode);
    std::vector<MetamerIndex> last(metamers.axes.size(), kNoNode);
    for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
      const Node& node = *by_birth_.at(metamers.birth[metamer]);
      const std::string error = error_of(metamers, metamer, node);
      if (!error.empty()) return testing::AssertionFailure() << "born at " << node.birth << " " << error;
      const AxisIndex axis = metamers.axis[metamer];
      if (first[axis] == kNoNode) first[axis] = metamer;
      last[axis] = metamer;
    }
    for (AxisIndex axis = 0; axis < metamers.axes.size(); ++axis) {
      if (metamers.axes[axis].first != first[axis] || metamers.axes[axis].last != last[axis]) {
        return testing::AssertionFailure() << "axis " << axis << " has other ends";
      }
      if (axis > 0 && first[axis] < first[axis - 1]) return testing::AssertionFailure() << "axes are out of order";
    }
    return testing::AssertionSuccess();
  }

 private:
  struct Node;
  struct Side {
    std::unique_ptr<Node> node;
    Bud::State state = Bud::State::open;
  };
  struct Node {
    Node* parent = nullptr;
    Side terminal;
    Side lateral;
    int birth = 0;
    std::uint32_t number = 0;
    int order = 0;
    std::string shoot = "main";
    double lost = 0;
  };
  static double tips(const Node& node) {
    double sum = 0;
    for (const Side* side : {&node.terminal, &node.lateral}) sum += side->node ? tips(*side->node) : 0;
    return sum == 0 ? std::max(node.lost, 1.0) : sum + node.lost;
  }

  void forget(const Node& node) {
    by_birth_.erase(node.birth);
    for (const Side* side : {&node.terminal, &node.lateral}) {
      if (side->node) forget(*side->node);
    }
  }

  static std::string error_of(const Metamers& metamers, MetamerIndex metamer, const Node& node) {
    const MetamerIndex parent = metamers.parent[metamer];
    if (metamer == 0 ? parent != kNoNode : parent >= metamer) return "comes before its parent";
    if (metamer != 0 && metamers.birth[parent] != node.parent->birth) return "has another parent";
    const auto is_same = [&](Bud bud, const Side& side) {
      return bud.state() == side.state && (!bud.is_grown() || metamers.birth[bud.metamer()] == side.node->birth);
    };
    if (!is_same(metamers.terminal[metamer], node.terminal)) return "has another terminal bud";
    if (!is_same(metamers.lateral[metamer], node.lateral)) return "has another lateral bud";
    if (metamers.number[metamer] != node.number) return "has another number";
    if (metamers.order[metamer] != node.order) return "has another order";
    if (metamers.lost_tips[metamer] != node.lost) return "has lost other tips";
    if (metamers.name_of(metamers.axis[metamer]) != node.shoot) return "is on another shoot";
    if (metamers.find_shoot(node.shoot) != metamers.axis[metamer]) return "is not found by its shoot's name";
    if (metamers.find(metamers.axis[metamer], node.number) != metamer) return "is not found by its number";
    return {};
  }

  Node seed_{.parent = nullptr, .terminal = {}, .lateral = {nullptr, Bud::State::dead}};
  std::map<int, Node*> by_birth_;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Draws p-graphs and i-trees as SVG. A spanning tree of the graph places each component under its deepest parent,
// place_tree finds the positions, and links are lines between boxes.
#include "meristem/export/graph/graph_drawing.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "meristem/export/graph/tree_layout.h"

namespace meristem {

namespace {

constexpr double kLetter = 6.9;       // width of a letter of the names, pixels
constexpr double kSmallLetter = 4.6;  // width of a letter below the line, pixels
constexpr double kPadding = 18;       // space on both sides of a name in its box, together, pixels
constexpr double kMinWidth = 34;
constexpr double kHeight = 26;
constexpr double kHeightWithType = 38;
constexpr double kGap = 16;    // space between boxes, pixels
constexpr double kLevel = 34;  // space between levels, pixels
constexpr double kSheetMargin = 10;

struct DrawnNode {
  std::string name;
  std::string below;  // text below the line, in smaller letters than the name
  std::string type;
  std::uint32_t parent = kNoParent;
  bool is_end = false;  // true for the first component of a recursion, drawn again
  GraphEffect effect = GraphEffect::none;
};

struct DrawnLine {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  const Link* link = nullptr;
  bool is_doubled = false;
};

struct Drawing {
  std::vector<DrawnNode> nodes;  // parents before children
  std::vector<DrawnLine> lines;
};

std::string escaped(const std::string& text) {
  std::string made;
  for (const char c : text) {
    if (c == '<') {
      made += "&lt;";
    } else if (c == '&') {
      made += "&amp;";
    } else {
      made += c;
    }
  }
  return made;
}

double width_of(const DrawnNode& node) {
  const double name =
      kLetter * static_cast<double>(node.name.size()) + kSmallLetter * static_cast<double>(node.below.size());
  return std::max({kMinWidth, name + kPadding, 0.86 * kLetter * static_cast<double>(node.type.size()) + kPadding});
}

/// Returns the style of a link as attributes of its line.
std::string style_of(const Link* link) {
  if (link == nullptr) return "stroke-width=\"1.2\"";
  if (link->is<BranchLink>()) return "stroke-width=\"3.6\"";
  if (link->is<LeafLink>()) return "stroke-width=\"1.4\" stroke-dasharray=\"6 4\"";
  if (link->is<CrownLink>()) return "stroke-width=\"2.4\" stroke-dasharray=\"0.1 5\"";
  if (link->is<PlacedLink>()) return "stroke-width=\"1.2\" stroke-dasharray=\"2 2\"";
  return "stroke-width=\"1.2\"";
}

/// Returns the style of a doubled line: a broad line, and a white line over it.
std::string doubled_style(const Link* link, bool is_inner) {
  const bool is_thick = link != nullptr && link->is<BranchLink>();
  if (is_inner) return fmt::format("stroke=\"#fff\" stroke-width=\"{}\"", is_thick ? 2.6 : 2.4);
  const bool is_dashed = link != nullptr && link->is<LeafLink>();
  return fmt::format("stroke-width=\"{}\"{}", is_thick ? 8.6 : 4.8, is_dashed ? " stroke-dasharray=\"6 4\"" : "");
}

std::string line_text(const std::string& way, const DrawnLine& line) {
  if (!line.is_doubled) return fmt::format("<path d=\"{}\" {}/>\n", way, style_of(line.link));
  return fmt::format("<path d=\"{}\" stroke-linecap=\"butt\" {}/>\n<path d=\"{}\" stroke-linecap=\"butt\" {}/>\n", way,
                     doubled_style(line.link, false), way, doubled_style(line.link, true));
}

/// Returns the colour of a box as an attribute.
std::string fill_of(GraphEffect effect) {
  switch (effect) {
    case GraphEffect::own:
      return " fill=\"#f2b84b\"";
    case GraphEffect::inherited:
      return " fill=\"#fbe9c6\"";
    case GraphEffect::none:
      break;
  }
  return "";
}

std::string node_text(const DrawnNode& node, double x, double y, double width, double height) {
  std::string made =
      fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\" rx=\"6\"{}{}/>\n", x - width / 2,
                  y - height / 2, width, height, node.is_end ? " stroke-dasharray=\"3 3\"" : "", fill_of(node.effect));
  const double name_y = node.type.empty() ? y + 4.5 : y - 2;
  const std::string below =
      node.below.empty() ? "" : fmt::format("<tspan dy=\"3.5\" font-size=\"8.5\">{}</tspan>", escaped(node.below));
  made += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}{}</text>\n", x, name_y, escaped(node.name), below);
  if (!node.type.empty()) {
    made += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10.5\" fill=\"#666\">{}</text>\n", x, y + 11,
                        escaped(node.type));
  }
  return made;
}

std::string svg_of(const Drawing& drawing, const std::string& title) {
  std::vector<std::uint32_t> parents;
  double width = kMinWidth;
  bool has_types = false;
  for (const DrawnNode& node : drawing.nodes) {
    parents.push_back(node.parent);
    width = std::max(width, width_of(node));
    has_types = has_types || !node.type.empty();
  }
  const TreePlaces places = place_tree(parents);
  const double height = has_types ? kHeightWithType : kHeight;
  const auto x_of = [&](std::uint32_t node) { return kSheetMargin + width / 2 + places.across[node] * (width + kGap); };
  const auto y_of = [&](std::uint32_t node) {
    return kSheetMargin + height / 2 + places.level[node] * (height + kLevel);
  };
  const double sheet_width = 2 * kSheetMargin + width + places.breadth * (width + kGap);
  const double sheet_height =
      2 * kSheetMargin + height + std::max(1U, places.levels) * (height + kLevel) - (height + kLevel);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12.5\" text-anchor=\"middle\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      sheet_width, sheet_height, escaped(title));
  svg += "<g fill=\"none\" stroke=\"#222\" stroke-linecap=\"round\">\n";
  for (const DrawnLine& line : drawing.lines) {
    svg += line_text(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x_of(line.from), y_of(line.from) + height / 2,
                                 x_of(line.to), y_of(line.to) - height / 2),
                     line);
  }
  svg += "</g>\n<g fill=\"#fff\" stroke=\"#222\" stroke-width=\"1\">\n";
  std::string texts;
  for (std::uint32_t k = 0; k < drawing.nodes.size(); ++k) {
    const std::string node = node_text(drawing.nodes[k], x_of(k), y_of(k), width, height);
    const std::size_t end = node.find('\n') + 1;
    svg += node.substr(0, end);
    texts += node.substr(end);
  }
  return svg + "</g>\n<g fill=\"#111\">\n" + texts + "</g>\n</svg>\n";
}

/// Returns the length of each component's longest path from the root, without links back.
std::vector<std::uint32_t> levels_of(const Graph& graph) {
  const LinkStructure& structure = graph.structure;
  std::vector<std::uint32_t> waits(graph.components.size(), 0), level(graph.components.size(), 0);
  const auto leads_on = [&](LinkIndex link) { return structure.recursion_of_link[link] == kNoIndex; };
  for (LinkIndex k = 0; k < graph.links.size(); ++k) waits[graph.links[k].to] += leads_on(k) ? 1 : 0;
  std::vector<ComponentIndex> open{structure.root};
  while (!open.empty()) {
    const ComponentIndex from = open.back();
    open.pop_back();
    for (const LinkIndex link : structure.outgoing[from]) {
      if (!leads_on(link)) continue;
      const ComponentIndex to = graph.links[link].to;
      level[to] = std::max(level[to], level[from] + 1);
      if (--waits[to] == 0) open.push_back(to);
    }
  }
  return level;
}

/// Returns true if the link is on the path of a recursion.
bool is_within_recursion(const Graph& graph, const Link& link) {
  return std::ranges::any_of(graph.structure.recursions, [&](const LinkStructure::Recursion& recursion) {
    const auto at = std::ranges::find(recursion.members, link.from);
    return at != recursion.members.end() && at + 1 != recursion.members.end() && *(at + 1) == link.to;
  });
}

/// The tree of a graph: each component stands under the first of its deepest parents.
class GraphTree {
 public:
  GraphTree(const Graph& graph, const DrawingOptions& options)
      : graph_(graph), options_(options), level_(levels_of(graph)), node_of_(graph.components.size(), kNoParent) {}

  Drawing run() {
    std::vector<Next> open{{.component = graph_.structure.root}};
    while (!open.empty()) {
      const Next next = open.back();
      open.pop_back();
      const auto own = static_cast<std::uint32_t>(drawing_.nodes.size());
      add(next, own);
      if (next.ends == kNoIndex) follow(next.component, own, open);
    }
    add_lines();
    return std::move(drawing_);
  }

 private:
  /// A node that must still be drawn.
  struct Next {
    ComponentIndex component = 0;
    std::uint32_t parent = kNoParent;
    LinkIndex ends = kNoIndex;  ///< the link back that ends at this node
  };

  void add(const Next& next, std::uint32_t own) {
    const Prototype& prototype = graph_.components[next.component];
    const bool is_end = next.ends != kNoIndex;
    if (is_end) {
      ends_.emplace_back(own, next.ends);
    } else {
      node_of_[next.component] = own;
    }
    drawing_.nodes.push_back(
        {.name = prototype.id,
         .below = {},
         .type = options_.shows_types ? prototype.type->name : std::string(),
         .parent = next.parent,
         .is_end = is_end,
         .effect = options_.effects.empty() ? GraphEffect::none : options_.effects[next.component]});
  }

  /// Children wait in the order of the links, the first on top.
  void follow(ComponentIndex component, std::uint32_t own, std::vector<Next>& open) {
    std::vector<Next> children;
    for (const LinkIndex link : graph_.structure.outgoing[component]) {
      const ComponentIndex to = graph_.links[link].to;
      if (graph_.structure.recursion_of_link[link] != kNoIndex) {
        children.push_back({to, own, link});
      } else if (level_[to] == level_[component] + 1 && !is_taken(to)) {
        taken_.push_back(to);
        children.push_back({to, own, kNoIndex});
      }
    }
    open.insert(open.end(), children.rbegin(), children.rend());
  }

  bool is_taken(ComponentIndex component) const { return std::ranges::find(taken_, component) != taken_.end(); }

  void add_lines() {
    for (LinkIndex k = 0; k < graph_.links.size(); ++k) {
      const Link& link = graph_.links[k];
      if (graph_.structure.recursion_of_link[k] != kNoIndex) continue;
      drawing_.lines.push_back({node_of_[link.from], node_of_[link.to], &link, is_within_recursion(graph_, link)});
    }
    for (const auto& [node, link] : ends_) {
      drawing_.lines.push_back({drawing_.nodes[node].parent, node, &graph_.links[link], true});
    }
  }

  const Graph& graph_;
  const DrawingOptions& options_;
  std::vector<std::uint32_t> level_;                       // for each component
  std::vector<std::uint32_t> node_of_;                     // for each component
  std::vector<ComponentIndex> taken_;                      // components that have a parent in the tree
  std::vector<std::pair<std::uint32_t, LinkIndex>> ends_;  // ends of recursions: node and link
  Drawing drawing_;
};

std::string joined_numbers(const std::vector<std::uint32_t>& numbers) {
  const bool are_short = std::ranges::all_of(numbers, [](std::uint32_t number) { return number < 10; });
  std::string made;
  for (const std::uint32_t number : numbers) made += fmt::format("{}{}", made.empty() || are_short ? "" : ",", number);
  return made;
}

}  // namespace

std::string draw_graph(const Graph& graph, const DrawingOptions& options) {
  return svg_of(GraphTree(graph, options).run(), "p-graph");
}

std::string draw_instance_tree(const Graph& graph, const InstanceTree& tree) {
  const LinkStructure& structure = graph.structure;
  Drawing drawing;
  // The tree is ordered level by level. Siblings are drawn in the order of their links, which is the order of their
  // numbers.
  std::vector<std::vector<std::uint32_t>> numbers(tree.instances.size());
  std::vector<std::uint32_t> depth(tree.instances.size(), 0);
  for (std::uint32_t k = 0; k < tree.instances.size(); ++k) {
    const InstanceTree::Instance& instance = tree.instances[k];
    const bool is_root = instance.parent == kNoIndex;
    const bool goes_back = !is_root && structure.recursion_of_link[instance.link] != kNoIndex;
    const bool is_recursive = structure.recursion_of[instance.component] != kNoIndex;
    if (!is_root) {
      numbers[k] = numbers[instance.parent];
      depth[k] = goes_back ? depth[instance.parent] + 1 : is_recursive ? depth[instance.parent] : 0;
      const bool parent_has_depth = structure.recursion_of[tree.instances[instance.parent].component] != kNoIndex;
      if (parent_has_depth && is_recursive) numbers[k].pop_back();
    }
    if (instance.n > 1) numbers[k].push_back(instance.i + 1);
    if (is_recursive) numbers[k].push_back(depth[k] + 1);
    drawing.nodes.push_back({.name = graph.components[instance.component].id,
                             .below = joined_numbers(numbers[k]),
                             .type = {},
                             .parent = is_root ? kNoParent : instance.parent});
    if (!is_root) drawing.lines.push_back({instance.parent, k, &graph.links[instance.link], false});
  }
  return svg_of(drawing, "i-tree");
}

}  // namespace meristem

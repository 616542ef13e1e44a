// SPDX-License-Identifier: Apache-2.0
// The p-graph of a document: component prototypes joined by links. Expanding it (expand.h) gives a tree of instances.
//
// Based on: B. Lintermann, O. Deussen: Interactive modelling of plants (1999) and the report on rule-based objects in
// xfrog; recursions are links back to an ancestor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/graph/animation.h"
#include "meristem/graph/component.h"
#include "meristem/graph/link.h"

namespace meristem {

/// What a graph's links mean together.
struct Structure {
  /// Links that lead back to an ancestor, and the components on the way.
  struct Recursion {
    ComponentIndex head = 0;              ///< the ancestor that links from below lead back to
    std::vector<ComponentIndex> members;  ///< the way from the head down on which it was found; the last links back
    std::size_t level = 0;                ///< 0 for the outermost; recursions with one head have one level
  };
  ComponentIndex root = 0;                       ///< the camera
  std::vector<std::vector<LinkIndex>> outgoing;  ///< by component, in the document's order
  std::vector<std::uint32_t> recursion_of_link;  ///< by link: the recursion that a link back closes, or kNoIndex
  std::vector<std::uint32_t> recursion_of;       ///< by component: the innermost recursion it lies in, or kNoIndex
  std::vector<Recursion> recursions;             ///< recursions, in the order in which they were found
};

/// A variable that is drawn once for each instance of a component and used by all that stands on the instance.
struct InstanceVariable {
  std::string name;                 ///< name in expressions
  ComponentIndex owner = kNoIndex;  ///< component whose instances draw it
  Varying value;                    ///< over the owner's sites
  std::uint32_t slot = 0;           ///< index into Graph::site_names
  std::uint64_t fingerprint = 0;    ///< hash of its text in the document
};

/// Components and links of a document, ready to be expanded.
struct Graph {
  std::vector<Prototype> components;    ///< links refer to components by index
  std::vector<Link> links;              ///< in the document's order
  std::vector<std::string> site_names;  ///< what sites are given by name: columns of tables, and variables of instances
  std::vector<InstanceVariable> instance_variables;  ///< each after those that it uses
  Structure structure;                               ///< structure of the links as analyse_structure last found them
  std::optional<Animation> animation;                ///< unset: nothing but expressions of t changes with time
  std::uint64_t seed = 0;                            ///< root of all random numbers
  Limits limits;                                     ///< limits of the document
};

/// What messages call a link: "links[2]", or the component that made it where the document has no such link.
std::string link_path(const Graph& graph, LinkIndex link);

/// Sets the graph's structure: finds root and recursions, or reports all that is wrong with the links: no or two roots,
/// components without a parent, links to the camera, cycles without a recursion, crossing recursions (both named).
/// Two recursions cross where one begins inside the other and ends outside, having part of the way in common; one that
/// begins inside and goes its own way lies within the other. Reports at most `graph.limits.diagnostics` faults. The
/// structure is meaningful only if no error was added. Takes time by the number of components and links. Throws
/// Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
void analyse_structure(Graph& graph, std::vector<Diagnostic>& diagnostics, const Progress* progress = nullptr);

}  // namespace meristem

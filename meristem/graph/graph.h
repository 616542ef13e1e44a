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

/// The structure of a graph's links.
struct LinkStructure {
  /// Links that lead back to an ancestor, and the components on the way.
  struct Recursion {
    ComponentIndex head = 0;              ///< the ancestor that links from below lead back to
    std::vector<ComponentIndex> members;  ///< the path from the head down on which the recursion was found; the last
                                          ///< member links back
    std::size_t level = 0;                ///< 0 for the outermost; recursions with one head have one level
  };
  ComponentIndex root = 0;                       ///< index of the camera
  std::vector<std::vector<LinkIndex>> outgoing;  ///< by component, in the document's order
  std::vector<std::uint32_t> recursion_of_link;  ///< by link: the recursion that a link back closes, or kNoIndex
  std::vector<std::uint32_t> recursion_of;       ///< by component: the innermost recursion it lies in, or kNoIndex
  std::vector<Recursion> recursions;             ///< recursions, in the order in which they were found
};

/// A variable that is drawn once for each instance of a component. All descendants of the instance may use the value.
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
  std::vector<std::string> site_names;  ///< names of the values that sites get: columns of tables and variables of
                                        ///< instances
  std::vector<InstanceVariable> instance_variables;  ///< each variable follows the variables that it uses
  LinkStructure structure;                           ///< structure of the links as analyse_structure last found them
  std::optional<Animation> animation;                ///< unset: only expressions of t change with time
  std::uint64_t seed = 0;                            ///< root of all random numbers
  SizeLimits limits;                                 ///< limits of the document
};

/// Returns the name of a link in messages: "links[2]", or the component that made the link if it is not in the
/// document.
std::string link_path(const Graph& graph, LinkIndex link);

/// Finds the root and the recursions of a graph and sets its structure. Reports all errors of its links: no root or two
/// roots, components without a parent, links to the camera, cycles without a recursion, and crossing recursions (with
/// both names). Two recursions cross if one begins inside the other, shares part of its path, and ends outside. A
/// recursion that begins inside and takes its own path lies within the other.
///
/// Reports at most `graph.limits.diagnostics` faults. The structure is meaningful only if no error was added. Takes
/// time in proportion to the number of components and links. Throws Cancelled soon after `progress` was asked to stop.
/// Null: it cannot be stopped.
void analyse_structure(Graph& graph, std::vector<Diagnostic>& diagnostics, const Progress* progress = nullptr);

}  // namespace meristem

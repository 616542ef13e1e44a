// SPDX-License-Identifier: Apache-2.0
// The links of a graph. A link sets the instances of one component on another component.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "meristem/graph/crown_placement.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/table/parameter.h"

namespace meristem {

using ComponentIndex = std::uint32_t;                   ///< index into Graph::components
using LinkIndex = std::uint32_t;                        ///< index into Graph::links
inline constexpr std::uint32_t kNoIndex = 0xffffffffU;  ///< marks a missing component, link or recursion

/// The child stands where the parent's geometry ends.
struct ChildLink {};

/// The child is multiplied along the parent's stems or ribs. On other parents it acts as a child link.
struct BranchLink {
  BranchPlacement placement;  ///< where the children stand
  GivenRows given;            ///< the rows of the placement that the document gives
};

/// In a recursion the child appears only at its end. On a grown skeleton it appears at the tips.
struct LeafLink {};

/// The child is multiplied in the crown body of the parent's stems.
struct CrownLink {
  CrownPlacement placement;  ///< where the children stand
};

/// The parent itself places the child. No document has such a link; the graph makes it.
struct PlacedLink {
  std::uint32_t name = 0;  ///< index of the id in the list of what the parent places
};

/// A link from a component to another, which stands on it.
struct Link {
  ComponentIndex from = 0;                                                    ///< component that bears the child
  ComponentIndex to = 0;                                                      ///< component that is the child
  std::variant<ChildLink, BranchLink, LeafLink, CrownLink, PlacedLink> kind;  ///< kind of link, with its placement
  std::optional<std::uint64_t> fingerprint{};  ///< hash of everything that the document says about the link

  /// Returns true for a link of this kind.
  template <class Kind>
  bool is() const {
    return std::holds_alternative<Kind>(kind);
  }
  /// Returns the link as this kind, or null for a link of another kind.
  template <class Kind>
  const Kind* as() const {
    return std::get_if<Kind>(&kind);
  }
};

/// The kinds of links that documents can name.
enum class LinkKind { child, branch, leaf, crown };

/// The keys that every link of a document has. Links with a placement have further keys, in the tables of their
/// placements.
struct LinkHead {
  std::string from;                 ///< id of the component that bears the child
  std::string to;                   ///< id of the child
  LinkKind kind = LinkKind::child;  ///< kind of link
};

const ParameterTable& link_table();  ///< the rows of LinkHead

}  // namespace meristem

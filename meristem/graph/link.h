// SPDX-License-Identifier: Apache-2.0
// The links of a graph: which component stands on which, and where its instances stand.
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

/// The child is multiplied along the parent's stems or ribs; elsewhere it acts as a child link.
struct BranchLink {
  Placement placement;  ///< where the children stand
  GivenRows given;      ///< which rows of it the document gives
};

/// In a recursion the child appears only where it ends; on a grown skeleton at the tips.
struct LeafLink {};

/// The child is multiplied in the crown body of the parent's stems.
struct CrownLink {
  CrownPlacement placement;  ///< where the children stand
};

/// The parent itself places the child. No document has such a link; the graph makes it.
struct PlacedLink {
  std::uint32_t name = 0;  ///< which of the ids that the parent places
};

/// A link from a component to another, which stands on it.
struct Link {
  ComponentIndex from = 0;                                                    ///< component that bears the child
  ComponentIndex to = 0;                                                      ///< component that is the child
  std::variant<ChildLink, BranchLink, LeafLink, CrownLink, PlacedLink> kind;  ///< kind of link, with its placement
  std::optional<std::uint64_t> fingerprint{};  ///< hash of all that the document says of it

  /// Returns true for a link of this kind.
  template <class Kind>
  bool is() const {
    return std::holds_alternative<Kind>(kind);
  }
  /// Null for a link of another kind.
  template <class Kind>
  const Kind* as() const {
    return std::get_if<Kind>(&kind);
  }
};

/// The kinds that documents name.
enum class LinkKind { child, branch, leaf, crown };

/// The keys that every link of a document has. Links that place their children say more, in the tables of their
/// placements.
struct LinkHead {
  std::string from;                 ///< id of the component that bears the child
  std::string to;                   ///< id of the child
  LinkKind kind = LinkKind::child;  ///< kind of link
};

const ParameterTable& link_table();  ///< the rows of LinkHead

}  // namespace meristem

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

using ComponentIndex = std::uint32_t;
using LinkIndex = std::uint32_t;
inline constexpr std::uint32_t kNoIndex = 0xffffffffU;

/// The child stands where the parent's geometry ends.
struct ChildLink {};

/// The child is multiplied along the parent's stems or ribs; elsewhere it acts as a child link.
struct BranchLink {
  Placement placement;
  GivenRows given;  ///< which rows of it the document gives
};

/// In a recursion the child appears only where it ends; on a grown skeleton at the tips.
struct LeafLink {};

/// The child is multiplied in the crown body of the parent's stems.
struct CrownLink {
  CrownPlacement placement;
};

/// The parent itself places the child. No document has such a link; the graph makes it.
struct PlacedLink {
  std::uint32_t name = 0;  ///< which of the ids that the parent places
};

struct Link {
  ComponentIndex from = 0;
  ComponentIndex to = 0;
  std::variant<ChildLink, BranchLink, LeafLink, CrownLink, PlacedLink> kind;
  std::optional<std::uint64_t> fingerprint{};  ///< hash of all that the document says of it

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

/// What a document says of every link. Links that place their children say more, in the tables of their placements.
struct LinkHead {
  std::string from;
  std::string to;
  LinkKind kind = LinkKind::child;
};

const ParameterTable& link_table();  ///< the rows of LinkHead

}  // namespace meristem

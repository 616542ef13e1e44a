// SPDX-License-Identifier: Apache-2.0
// An edit of a text that consists of several patches, each for the text that the patches before it have made.
#pragma once

#include <optional>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"

namespace meristem {

/// A tree that patches change one after another. The text is not parsed again for each patch.
class TreeEdit {
 public:
  /// Changes `tree` itself, which must outlive this object and is used up by the edit. Throws Cancelled soon after
  /// `progress` was asked to stop. Null: it cannot be stopped.
  explicit TreeEdit(LocatedTree* tree, const Progress* progress = nullptr) : tree_(tree), progress_(progress) {}
  /// Leaves `tree` unchanged, and copies it if it is needed after a patch.
  explicit TreeEdit(const LocatedTree& tree, const Progress* progress = nullptr)
      : original_(&tree), progress_(progress) {}
  TreeEdit(const TreeEdit&) = delete;
  TreeEdit& operator=(const TreeEdit&) = delete;

  /// Returns the tree after all patches so far. Invalidates located values of the tree before the last take().
  const LocatedTree& tree();
  /// Adds the next patch, for the text of tree().
  void take(TextPatch next);
  /// Returns all patches so far as one patch for the first text.
  TextPatch patch() const { return joiner_.joined(); }

 private:
  const LocatedTree* original_ = nullptr;
  std::optional<LocatedTree> copy_;
  LocatedTree* tree_ = nullptr;  // null until the original is copied
  const Progress* progress_;
  std::vector<TextPatch> waiting_;  // until the tree is needed
  PatchJoiner joiner_;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Applies patches to the tree only when the next step looks at it, so that the last patch costs nothing.
#include "meristem/document/edit/tree_edit.h"

#include <utility>

namespace meristem {

const LocatedTree& TreeEdit::tree() {
  if (waiting_.empty()) return tree_ != nullptr ? *tree_ : *original_;
  if (tree_ == nullptr) {
    copy_ = *original_;
    tree_ = &*copy_;
  }
  for (const TextPatch& patch : std::exchange(waiting_, {})) tree_->apply(patch, progress_);
  return *tree_;
}

void TreeEdit::take(TextPatch next) {
  if (progress_ != nullptr) progress_->check();
  if (next.empty()) return;
  waiting_.push_back(next);
  joiner_.add(std::move(next));
}

}  // namespace meristem

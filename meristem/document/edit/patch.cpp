// SPDX-License-Identifier: Apache-2.0
// Joins and inverts patches. A patched text is described as a sequence of kept and new pieces, so two patches are
// joined without the text itself.
#include "meristem/document/edit/patch.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace meristem {

namespace {

/// A piece of a patched text: kept from the text before, or new.
struct Piece {
  std::size_t begin = 0;  // position of a kept piece in the text before
  std::size_t length = 0;
  std::string_view added;  // text of a new piece
  bool is_added = false;
};

constexpr std::size_t kEndless = std::numeric_limits<std::size_t>::max() / 2;

/// Returns the pieces after a patch. The last piece has no end, so the length of the text is not needed.
std::vector<Piece> pieces_after(const TextPatch& patch) {
  std::vector<Piece> pieces;
  std::size_t at = 0;
  for (const TextSplice& splice : patch) {
    if (splice.offset > at) pieces.push_back({.begin = at, .length = splice.offset - at});
    if (!splice.replacement.empty()) {
      pieces.push_back(
          {.begin = 0, .length = splice.replacement.size(), .added = splice.replacement, .is_added = true});
    }
    at = splice.offset + splice.length;
  }
  pieces.push_back({.begin = at, .length = kEndless});
  return pieces;
}

/// Reads pieces in order.
class PieceReader {
 public:
  explicit PieceReader(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  /// Returns the next `length` bytes as pieces.
  std::vector<Piece> take(std::size_t length) {
    std::vector<Piece> taken;
    while (length > 0 && next_ < pieces_.size()) {
      Piece& piece = pieces_[next_];
      const std::size_t part = std::min(length, piece.length);
      taken.push_back(piece);
      taken.back().length = part;
      if (piece.is_added) {
        taken.back().added = piece.added.substr(0, part);
        piece.added.remove_prefix(part);
      }
      piece.begin += part;
      piece.length -= part;
      length -= part;
      if (piece.length == 0) ++next_;
    }
    return taken;
  }

 private:
  std::vector<Piece> pieces_;
  std::size_t next_ = 0;
};

/// Returns the patch that makes these pieces of a text.
TextPatch patch_of(const std::vector<Piece>& pieces) {
  TextPatch patch;
  std::size_t at = 0;  // position in the text before
  TextSplice open;
  for (const Piece& piece : pieces) {
    if (piece.is_added) {
      open.replacement += piece.added;
      continue;
    }
    open.offset = at;
    open.length = piece.begin - at;
    if (open.length > 0 || !open.replacement.empty()) patch.push_back(std::move(open));
    open = {};
    at = piece.begin + piece.length;
  }
  return patch;
}

}  // namespace

bool is_sound(const TextPatch& patch, std::size_t text_size) {
  std::size_t end = 0;
  for (const TextSplice& splice : patch) {
    if (splice.offset < end || splice.offset > text_size || splice.length > text_size - splice.offset) return false;
    end = splice.offset + splice.length;
  }
  return true;
}

std::string apply_patch(std::string_view text, const TextPatch& patch) {
  if (!is_sound(patch, text.size())) throw std::invalid_argument("the patch does not fit the text");
  std::string made;
  std::size_t at = 0;
  for (const TextSplice& splice : patch) {
    made += text.substr(at, splice.offset - at);
    made += splice.replacement;
    at = splice.offset + splice.length;
  }
  made += text.substr(at);
  return made;
}

TextPatch inverse_patch(std::string_view text, const TextPatch& patch) {
  if (!is_sound(patch, text.size())) throw std::invalid_argument("the patch does not fit the text");
  TextPatch inverse;
  std::size_t added = 0;    // bytes so far
  std::size_t removed = 0;  // bytes so far
  for (const TextSplice& splice : patch) {
    inverse.push_back({.offset = splice.offset + added - removed,
                       .length = splice.replacement.size(),
                       .replacement = std::string(text.substr(splice.offset, splice.length))});
    added += splice.replacement.size();
    removed += splice.length;
  }
  return inverse;
}

TextPatch joined_patches(const TextPatch& first, const TextPatch& second) {
  if (first.empty() || second.empty()) return first.empty() ? second : first;
  PieceReader between(pieces_after(first));
  std::vector<Piece> made;
  std::size_t at = 0;  // position in the text between the patches
  for (const TextSplice& splice : second) {
    for (const Piece& piece : between.take(splice.offset - at)) made.push_back(piece);
    between.take(splice.length);
    made.push_back({.begin = 0, .length = splice.replacement.size(), .added = splice.replacement, .is_added = true});
    at = splice.offset + splice.length;
  }
  for (const Piece& piece : between.take(kEndless)) made.push_back(piece);
  return patch_of(made);
}

void PatchJoiner::add(TextPatch patch) {
  if (patch.empty()) return;
  runs_.push_back({std::move(patch), 1});
  while (runs_.size() > 1 && runs_[runs_.size() - 2].count <= runs_.back().count) {
    Run last = std::move(runs_.back());
    runs_.pop_back();
    runs_.back().patch = joined_patches(runs_.back().patch, last.patch);
    runs_.back().count += last.count;
  }
}

TextPatch PatchJoiner::joined() const {
  TextPatch joined;
  for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) joined = joined_patches(run->patch, joined);
  return joined;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Keeps text, document and growth together. Edits become patches with inverses, which are kept for undo and redo. A
// failed edit changes nothing, and a text with faults keeps the last good document.
#include "meristem/document/edit/session.h"

#include <algorithm>
#include <utility>

#include "meristem/document/edit/edits.h"
#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/note.h"
#include "meristem/document/edit/plant_part.h"
#include "meristem/document/edit/tree_edit.h"

namespace meristem {

std::string plant_part(const std::string& text, const std::vector<std::string>& components, const Progress* progress) {
  return part_text(LocatedTree(text, progress), components, progress);
}

std::vector<std::pair<std::string, std::string>> component_notes(const std::string& text, const Progress* progress) {
  try {
    return notes_on_members(LocatedTree(text, progress), "components", progress);
  } catch (const InputError&) {
    return {};
  }
}

Session::Session(std::string text, std::string file, const Registry& registry, SessionOptions options)
    : text_(std::move(text)), file_(std::move(file)), registry_(&registry), options_(std::move(options)) {
  if (options_.reads_at_once) read();
}

ReadOptions Session::reading(const Progress* progress) {
  return {.overrides = options_.overrides,
          .seed = options_.seed,
          .root = options_.root,
          .store = &store_,
          .models = options_.models,
          .progress = progress};
}

void Session::read(const Progress* progress) {
  if (!is_read_) read_anew(progress);
}

void Session::read_anew(const Progress* progress) {
  try {
    document_ = std::make_shared<const Document>(read_document(text_, file_, *registry_, reading(progress)));
    errors_ = document_->warnings;
    is_good_ = true;
  } catch (const InputError& error) {
    errors_ = error.diagnostics();
    is_good_ = false;
  }
  is_read_ = true;
}

Change Session::take_over(TextPatch patch, const Progress* progress) {
  Change change{.patch = std::move(patch), .inverse = {}};
  change.inverse = inverse_patch(text_, change.patch);
  std::string before = std::exchange(text_, apply_patch(text_, change.patch));
  try {
    read_anew(progress);
  } catch (...) {
    text_ = std::move(before);
    throw;
  }
  return change;
}

Change Session::edit(const std::vector<SessionEdit>& edits, const Progress* progress) {
  TextPatch patch;
  try {
    LocatedTree tree(text_, progress);
    TreeEdit all(&tree, progress);
    const EditContext context{file_, *registry_, document(), reading(progress)};
    for (const SessionEdit& edit : edits) make_edit(edit, all, context);
    patch = all.patch();
  } catch (const InputError& error) {
    std::vector<Diagnostic> errors = error.diagnostics();
    for (Diagnostic& diagnostic : errors) diagnostic.file = file_;
    throw InputError(std::move(errors));
  }
  return edit_text(patch, progress);
}

/// Keeps a step for undo().
void Session::note(const Change& change) {
  undone_.clear();
  done_.push_back(change);
  if (done_.size() > options_.max_undone) done_.erase(done_.begin());
}

Change Session::edit_text(const TextPatch& patch, const Progress* progress) {
  if (patch.empty()) return {};
  Change change = take_over(patch, progress);
  note(change);
  return change;
}

Change Session::change_text(const TextPatch& patch) {
  if (patch.empty()) return {};
  Change change{.patch = patch, .inverse = inverse_patch(text_, patch)};
  text_ = apply_patch(text_, patch);
  errors_.clear();
  is_good_ = false;
  is_read_ = false;
  note(change);
  return change;
}

Change Session::step_back(std::vector<Change>& from, std::vector<Change>& to, const Progress* progress) {
  Change change = take_over(from.back().inverse, progress);
  from.pop_back();
  to.push_back(change);
  return change;
}

std::optional<Change> Session::undo(const Progress* progress) {
  if (done_.empty()) return std::nullopt;
  return step_back(done_, undone_, progress);
}

std::optional<Change> Session::redo(const Progress* progress) {
  if (undone_.empty()) return std::nullopt;
  return step_back(undone_, done_, progress);
}

void Session::set_overrides(std::vector<ValueOverride> overrides, const Progress* progress) {
  std::swap(options_.overrides, overrides);
  try {
    read_anew(progress);
  } catch (...) {
    options_.overrides = std::move(overrides);
    throw;
  }
}

void Session::reload(const Progress* progress) {
  store_.reload();
  is_read_ = false;
  read_anew(progress);
}

const GrownDocument& Session::grow(Progress& progress, GrowthOptions options) {
  if (!document_) throw InputError(errors_);
  options.cache = &cache_;
  GrownDocument grown = grow_document(*document_, progress, options);
  keys_before_ = std::exchange(keys_, key_maker_.keys_of(grown.meshes));
  difference_ = meristem::difference(keys_before_, keys_);
  grown_ = std::move(grown);
  return *grown_;
}

}  // namespace meristem

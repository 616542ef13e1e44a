// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/session.h"

#include <algorithm>
#include <utility>

#include "meristem/document/edit/edits.h"
#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/note.h"
#include "meristem/document/edit/plant_part.h"

namespace meristem {

std::string plant_part(const std::string& text, const std::vector<std::string>& components) {
  return part_text(LocatedTree(text), components);
}

std::vector<std::pair<std::string, std::string>> component_notes(const std::string& text) {
  try {
    return notes_on_members(LocatedTree(text), "components");
  } catch (const InputError&) {
    return {};
  }
}

Session::Session(std::string text, std::string file, const Registry& registry, SessionOptions options)
    : text_(std::move(text)), file_(std::move(file)), registry_(&registry), options_(std::move(options)) {
  read();
}

ReadOptions Session::reading() {
  return {.overrides = options_.overrides,
          .seed = options_.seed,
          .root = options_.root,
          .store = &store_,
          .models = options_.models};
}

void Session::read() {
  try {
    document_ = read_document(text_, file_, *registry_, reading());
    faults_ = document_->warnings;
    is_good_ = true;
  } catch (const InputError& error) {
    faults_ = error.diagnostics();
    is_good_ = false;
  }
}

Change Session::take_over(Patch patch) {
  Change change{.patch = std::move(patch), .inverse = {}};
  change.inverse = inverse_patch(text_, change.patch);
  text_ = apply_patch(text_, change.patch);
  read();
  return change;
}

Change Session::edit(const std::vector<Edit>& edits) {
  Patch patch;
  std::string text = text_;
  try {
    for (const Edit& edit : edits) {
      const Patch next = patch_of(edit, LocatedTree(text), {file_, *registry_, document(), reading()});
      text = apply_patch(text, next);
      patch = joined_patches(patch, next);
    }
  } catch (const InputError& error) {
    std::vector<Diagnostic> faults = error.diagnostics();
    for (Diagnostic& fault : faults) fault.file = file_;
    throw InputError(std::move(faults));
  }
  return edit_text(patch);
}

Change Session::edit_text(const Patch& patch) {
  if (patch.empty()) return {};
  Change change = take_over(patch);
  undone_.clear();
  done_.push_back(change);
  if (done_.size() > options_.most_undone) done_.erase(done_.begin());
  return change;
}

Change Session::step_back(std::vector<Change>& from, std::vector<Change>& to) {
  Change change = take_over(std::move(from.back().inverse));
  from.pop_back();
  to.push_back(change);
  return change;
}

std::optional<Change> Session::undo() {
  if (done_.empty()) return std::nullopt;
  return step_back(done_, undone_);
}

std::optional<Change> Session::redo() {
  if (undone_.empty()) return std::nullopt;
  return step_back(undone_, done_);
}

void Session::set_overrides(std::vector<Override> overrides) {
  options_.overrides = std::move(overrides);
  read();
}

void Session::reload() {
  store_.reload();
  read();
}

const GrownDocument& Session::grow(Progress& progress, GrowthOptions options) {
  if (!document_) throw InputError(faults_);
  options.cache = &cache_;
  GrownDocument grown = grow_document(*document_, progress, options);
  keys_before_ = std::exchange(keys_, key_maker_.keys_of(grown.meshes));
  difference_ = meristem::difference(keys_before_, keys_);
  grown_ = std::move(grown);
  return *grown_;
}

}  // namespace meristem

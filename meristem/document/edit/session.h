// SPDX-License-Identifier: Apache-2.0
// A document that is being edited. Editors change documents only through this interface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/document/edit/patch.h"
#include "meristem/document/grow.h"
#include "meristem/shape/scene/scene_keys.h"

namespace meristem {

// The kinds of edits. Paths have the form of overrides and of messages: "age" (a variable), "leaf.length" (of a
// component), "components.leaf.length", "links[1].density". "links[]" is the position after the last element. All edits
// throw an InputError for paths that do not exist.

/// Sets the value at the path. Missing members along the path are added; elements of lists must exist.
struct SetValue {
  std::string path;  ///< path of the value
  Value value;       ///< the new value
};
/// Removes a member if it exists, so that its default holds.
struct UnsetValue {
  std::string path;  ///< path of the member
};
/// Inserts an element before the element at the path, or a new member at `index` or last. A missing list is added with
/// its first element.
struct InsertValue {
  std::string path;                    ///< position of the new value
  Value value;                         ///< the new value
  std::optional<std::size_t> index{};  ///< index among the members; unset: last
};
/// Removes an existing member or element. A component is removed together with all links from and to it.
struct RemoveValue {
  std::string path;  ///< path of the member or element
};
/// Renames a member. Components and variables are also renamed in the document's links, expressions and grammars.
/// Random numbers depend on a component's name, so a renamed component grows differently.
struct RenameValue {
  std::string path;  ///< path of the member
  std::string name;  ///< the new name
};
/// Moves a member or element within its object or list to `index`, with its note.
struct MoveValue {
  std::string path;       ///< path of the member or element
  std::size_t index = 0;  ///< index after the move, from 0
};
/// Sets the comment on a member. A new comment stands on its own lines directly above the member; an existing comment
/// after the member in its last line is replaced there. An empty note removes the comment.
struct SetNote {
  std::string path;  ///< path of the member
  std::string note;  ///< text of the comment, without comment signs
};
/// Inserts a part of a document in the form of plant_part(): its components with their notes, its links, and its
/// variables that the document lacks. A variable whose value differs in the document gets a free name.
struct InsertPart {
  std::string text;                                          ///< text of the part, in the form of plant_part()
  std::vector<std::pair<std::string, std::string>> names{};  ///< other names of components, which must be free
  std::optional<std::size_t> index{};                        ///< index of its first component among the components;
                                                             ///< unset: last
  std::optional<std::size_t> link_index{};                   ///< index of its first link among the links; unset: last
};
using SessionEdit = std::variant<SetValue, UnsetValue, InsertValue, RemoveValue, RenameValue, MoveValue, SetNote,
                                 InsertPart>;  ///< any kind of edit

/// Returns a part of a document, which is a document too: these components, the links among them and the variables that
/// they use, all as they are written. Throws an InputError if the text is not JSON or has no such component. Throws
/// Cancelled soon after `progress` was asked to stop. Null: it cannot be stopped.
std::string plant_part(const std::string& text, const std::vector<std::string>& components,
                       const Progress* progress = nullptr);

/// Returns the comments on a document's components, by component id, in the form of SetNote. Returns an empty list if
/// the text is not JSON. Throws Cancelled soon after `progress` was asked to stop. Null: it cannot be stopped.
std::vector<std::pair<std::string, std::string>> component_notes(const std::string& text,
                                                                 const Progress* progress = nullptr);

/// A change of the text, and the inverse change.
struct Change {
  TextPatch patch;    ///< turns the text before into the text after
  TextPatch inverse;  ///< turns the text after into the text before
};

/// Options of a session for reading its text.
struct SessionOptions {
  std::vector<ValueOverride> overrides{};  ///< as of read_document
  std::optional<std::uint64_t> seed{};     ///< as of read_document
  std::string root{};                      ///< as of read_document
  std::string models{};                    ///< as of read_document
  std::size_t max_undone = 1000;           ///< number of edits that can be undone; older ones are forgotten
  /// False: the constructor does not read the text. Until read(), the text counts as one with faults.
  bool reads_at_once = true;
};

/// Text, document and grown plant, kept together. An edit changes only those bytes of the text that it must change. If
/// the new text has faults, the session keeps it; document and growth stay as of the last text without faults. Reading
/// and growing make only what an edit has changed. Files are read again only by reload(). Only one call at a time is
/// allowed. Calls that read the text throw Cancelled within 50 ms after their `progress` was asked to stop, and then
/// have changed nothing. Null: they cannot be stopped.
class Session {
 public:
  /// `file` is the name of the text in messages; paths in the text start from the folder of `file`. `registry` must
  /// outlive the session. Never throws for faults of the text: see faults().
  Session(std::string text, std::string file, const Registry& registry, SessionOptions options = {});

  const std::string& text() const { return text_; }  ///< the present text, also if it has faults
  const std::string& file() const { return file_; }  ///< name of the text in messages
  /// Returns the errors of the present text, or the document's warnings if there are no errors.
  const std::vector<Diagnostic>& errors() const { return errors_; }
  /// Returns true if the present text has no errors. document() is then the document of this text.
  bool is_good() const { return is_good_; }
  /// Returns true if the present text has been read. False only after change_text(), or without
  /// SessionOptions::reads_at_once.
  bool is_read() const { return is_read_; }
  /// Returns the document of the last text without errors, or null if there was none yet.
  const Document* document() const { return document_.get(); }
  /// Returns the document that document() returns. It does not change when the session reads another text.
  std::shared_ptr<const Document> shared_document() const { return document_; }

  /// Makes the edits, one after another, as one step. Throws an InputError if one of them is impossible or if the text
  /// is not JSON; nothing is changed then.
  Change edit(const std::vector<SessionEdit>& edits, const Progress* progress = nullptr);
  Change edit(std::string path, Value value) { return edit({SetValue{std::move(path), std::move(value)}}); }
  /// Applies a patch to the text, as when a user types. Throws std::invalid_argument if the patch does not fit.
  Change edit_text(const TextPatch& patch, const Progress* progress = nullptr);
  /// Applies a patch like edit_text(), but does not read the new text. Until read(), the text counts as one with
  /// faults.
  Change change_text(const TextPatch& patch);
  /// Reads the present text if it is not read yet. If this is stopped, the text stays unread.
  void read(const Progress* progress = nullptr);
  /// Undoes the last step. Returns nothing if there is no step to undo.
  std::optional<Change> undo(const Progress* progress = nullptr);
  /// Makes the last undone step again. Returns nothing if there is no such step.
  std::optional<Change> redo(const Progress* progress = nullptr);
  std::size_t undo_count() const { return done_.size(); }    ///< number of steps that undo() can take back
  std::size_t redo_count() const { return undone_.size(); }  ///< number of steps that redo() can make again

  /// Returns the values that replace values of the text.
  const std::vector<ValueOverride>& overrides() const { return options_.overrides; }
  /// Sets values that replace values of the text until the next call, for example during the drag of a slider. The text
  /// does not change.
  void set_overrides(std::vector<ValueOverride> overrides, const Progress* progress = nullptr);
  /// Reads files that have changed on the disk, and the document that names them.
  void reload(const Progress* progress = nullptr);

  /// Grows the document with the session's own cache, so that only changed parts are made again. Throws an InputError
  /// (limits; also if there was never a document) and Cancelled; grown() is then unchanged.
  const GrownDocument& grow(Progress& progress, GrowthOptions options = {});
  /// Returns the last growth, or null if there was none yet.
  const GrownDocument* grown() const { return grown_ ? &*grown_ : nullptr; }
  /// Returns the keys of the parts of the last growth.
  const SceneKeys& keys() const { return keys_; }
  const SceneKeys& keys_before() const { return keys_before_; }  ///< the keys of the growth before
  /// Returns the differences between the last growth and the growth before.
  const SceneDifference& difference() const { return difference_; }
  const GrowthCache& cache() const { return cache_; }  ///< results of the last growth, for the next one
  /// Returns counts of the work of reading; see ReadStore::Counts.
  const ReadStore::Counts& read_counts() const { return store_.counts(); }

 private:
  ReadOptions reading(const Progress* progress);
  void read_anew(const Progress* progress);
  Change take_over(TextPatch patch, const Progress* progress);
  Change step_back(std::vector<Change>& from, std::vector<Change>& to, const Progress* progress);
  void note(const Change& change);

  std::string text_;
  std::string file_;
  const Registry* registry_;
  SessionOptions options_;
  ReadStore store_;
  std::vector<Diagnostic> errors_;
  bool is_good_ = false;
  bool is_read_ = false;
  std::shared_ptr<const Document> document_;
  std::vector<Change> done_;
  std::vector<Change> undone_;
  GrowthCache cache_;
  std::optional<GrownDocument> grown_;
  SceneKeyMaker key_maker_;
  SceneKeys keys_;
  SceneKeys keys_before_;
  SceneDifference difference_;
};

}  // namespace meristem

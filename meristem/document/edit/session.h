// SPDX-License-Identifier: Apache-2.0
// A document that is being edited: the one interface through which editors change it.
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
#include "meristem/shape/scene_keys.h"

namespace meristem {

// Kinds of edits. Paths are those of overrides and of messages: "age" (a variable), "leaf.length" (of a component),
// "components.leaf.length", "links[1].density"; "links[]" is behind the last element. All throw an InputError for paths
// that do not exist.

/// Sets the value at the path. Missing members along the path are added; elements of lists must exist.
struct SetValue {
  std::string path;  ///< path of the value
  Value value;       ///< the new value
};
/// Removes a member if it exists, so that its default holds.
struct UnsetValue {
  std::string path;  ///< path of the member
};
/// Inserts an element before that of the path, or a new member, as the last or at `index`. A list that is not there yet
/// is made for its first element.
struct InsertValue {
  std::string path;                    ///< where the new value goes
  Value value;                         ///< the new value
  std::optional<std::size_t> index{};  ///< index among the members; unset: last
};
/// Removes a member or element that exists; a component together with all links from and to it.
struct RemoveValue {
  std::string path;  ///< path of the member or element
};
/// Renames a member; components and variables also in the document's links, expressions and grammars. The random
/// numbers of a component follow its name, so a renamed component grows differently.
struct RenameValue {
  std::string path;  ///< path of the member
  std::string name;  ///< the new name
};
/// Moves a member or element within its object or list to `index`, with its note.
struct MoveValue {
  std::string path;       ///< path of the member or element
  std::size_t index = 0;  ///< index after the move, from 0
};
/// Sets the comment on a member: on lines of its own directly above it, or behind it in its last line if a comment
/// stands there. An empty note removes the comment.
struct SetNote {
  std::string path;  ///< path of the member
  std::string note;  ///< text of the comment, without comment signs
};
/// Puts in a part of a document, a text as plant_part() gives it: its components with their notes, its links, and those
/// of its variables that the document lacks. A variable whose value differs in the document gets a free name.
struct InsertPart {
  std::string text;                                          ///< the part, as plant_part() gives it
  std::vector<std::pair<std::string, std::string>> names{};  ///< other names of components, which must be free
  std::optional<std::size_t> index{};                        ///< of the first among the components; not given: last
  std::optional<std::size_t> link_index{};                   ///< of its first link among the links; not given: last
};
using Edit = std::variant<SetValue, UnsetValue, InsertValue, RemoveValue, RenameValue, MoveValue, SetNote,
                          InsertPart>;  ///< any kind of edit

/// A part of a document: a text that is a document too, with these components, the links among them and the variables
/// that they name, all as they are written. Throws an InputError where the text is not JSON or has no such component;
/// Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
std::string plant_part(const std::string& text, const std::vector<std::string>& components,
                       const Progress* progress = nullptr);

/// The comments on a document's components, by their names, as SetNote sets them; none where the text is not JSON.
/// Throws Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
std::vector<std::pair<std::string, std::string>> component_notes(const std::string& text,
                                                                 const Progress* progress = nullptr);

/// A change of the text, and the inverse change.
struct Change {
  Patch patch;    ///< turns the text before into the text after
  Patch inverse;  ///< turns the text after into the text before
};

/// How a session reads its text.
struct SessionOptions {
  std::vector<Override> overrides{};    ///< as of read_document
  std::optional<std::uint64_t> seed{};  ///< as of read_document
  std::string root{};                   ///< as of read_document
  std::string models{};                 ///< as of read_document
  std::size_t most_undone = 1000;       ///< edits that can be taken back; the oldest are forgotten
  /// False: the constructor does not read the text, which then counts as one with faults until read().
  bool reads_at_once = true;
};

/// Text, document and grown plant, kept together. An edit changes only those bytes of the text that it must change. If
/// the new text has faults, the session keeps the text with its faults, while document and growth stay those of the
/// last text without faults. Reading and growing make anew only what an edit has changed; files are read again by
/// reload() alone. One call at a time. Calls that read the text throw Cancelled within 50 ms after their `progress` was
/// asked to stop, and then have changed nothing; null: they cannot be stopped.
class Session {
 public:
  /// `file` is the name of the text in messages; paths in the text start from the folder of `file`. `registry` must
  /// outlive the session. Never throws for faults of the text: see faults().
  Session(std::string text, std::string file, const Registry& registry, SessionOptions options = {});

  const std::string& text() const { return text_; }  ///< the present text, also if it has faults
  const std::string& file() const { return file_; }  ///< name of the text in messages
  /// Errors of the present text, or if there are none the document's warnings.
  const std::vector<Diagnostic>& faults() const { return faults_; }
  /// Whether the present text has no errors, so that document() is the document of this text.
  bool is_good() const { return is_good_; }
  /// Whether the present text has been read. False only after change_text(), or without SessionOptions::reads_at_once.
  bool is_read() const { return is_read_; }
  /// The document of the last text without errors; null if there was none yet.
  const Document* document() const { return document_.get(); }
  /// The same document, which stays as it is when the session reads another text.
  std::shared_ptr<const Document> shared_document() const { return document_; }

  /// Makes the edits, one after another, as one step. Throws an InputError if one of them cannot be made or the text is
  /// not JSON; then nothing has changed.
  Change edit(const std::vector<Edit>& edits, const Progress* progress = nullptr);
  Change edit(std::string path, Value value) { return edit({SetValue{std::move(path), std::move(value)}}); }
  /// Applies a patch to the text, as when a user types. Throws std::invalid_argument if the patch does not fit.
  Change edit_text(const Patch& patch, const Progress* progress = nullptr);
  /// Applies a patch like edit_text(), but does not read the new text: until read() it counts as one with faults.
  Change change_text(const Patch& patch);
  /// Reads the present text unless that has been done. If it is stopped, the text stays and is not read.
  void read(const Progress* progress = nullptr);
  /// Takes the last step back, or makes it again; nullopt if there is no such step.
  std::optional<Change> undo(const Progress* progress = nullptr);
  /// Makes the step again that undo() has taken back.
  std::optional<Change> redo(const Progress* progress = nullptr);
  std::size_t undo_count() const { return done_.size(); }    ///< number of steps that undo() can take back
  std::size_t redo_count() const { return undone_.size(); }  ///< number of steps that redo() can make again

  /// Returns the values that replace values of the text.
  const std::vector<Override>& overrides() const { return options_.overrides; }
  /// Values that replace those of the text until the next call, as during the drag of a slider; the text stays.
  void set_overrides(std::vector<Override> overrides, const Progress* progress = nullptr);
  /// Reads the files that have changed on the disk since they were read, and the document with them.
  void reload(const Progress* progress = nullptr);

  /// Grows the document with the session's own cache: what has changed since the last growth is made anew. Throws an
  /// InputError (limits; also where there was never a document), Cancelled; then grown() stays.
  const GrownDocument& grow(Progress& progress, GrowthOptions options = {});
  /// The last growth; null if there was none yet.
  const GrownDocument* grown() const { return grown_ ? &*grown_ : nullptr; }
  /// Keys of what has grown, and how it differs from the growth before.
  const SceneKeys& keys() const { return keys_; }
  const SceneKeys& keys_before() const { return keys_before_; }  ///< the keys of the growth before
  const SceneDifference& difference() const {
    return difference_;
  }                                                    ///< how the last growth differs from the growth before
  const GrowthCache& cache() const { return cache_; }  ///< results of the last growth, for the next one
  /// What reading has done; see ReadStore::Counts.
  const ReadStore::Counts& read_counts() const { return store_.counts(); }

 private:
  ReadOptions reading(const Progress* progress);
  void read_anew(const Progress* progress);
  Change take_over(Patch patch, const Progress* progress);
  Change step_back(std::vector<Change>& from, std::vector<Change>& to, const Progress* progress);
  void note(const Change& change);

  std::string text_;
  std::string file_;
  const Registry* registry_;
  SessionOptions options_;
  ReadStore store_;
  std::vector<Diagnostic> faults_;
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

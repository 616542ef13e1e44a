// SPDX-License-Identifier: Apache-2.0
// The plant document: what a person writes and saves, read into a graph, a scene and settings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/read_store.h"
#include "meristem/graph/table/value.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The newest format that this program reads.
inline constexpr int kDocumentFormat = 1;

/// A value that every expression can use by name: one of the few handles that a user should see, or a private one.
struct Variable {
  std::string name;         ///< an identifier
  double value = 0;         ///< value of the name in expressions
  double min = 0;           ///< least and greatest sensible value, for sliders; nothing is refused beyond them
  double max = 1;           ///< greatest sensible value
  std::string unit;         ///< unit for people, such as "m"; may be empty
  std::string doc;          ///< one sentence for people; may be empty
  std::string expression;   ///< the expression that gave the value, or empty: "2 + 0.1*age"
  std::string per;          ///< id of the component whose instances each draw a value, or empty
  bool is_private = false;  ///< no handle, but a name for what several expressions share; it can be set all the same
};

/// A note on a variable, for messages on wrong values that depend on it.
struct VariableNote {
  std::string variable;           ///< name of the variable
  std::string text;               ///< "age is 1000, beyond 8 to 160", or empty
  std::vector<std::size_t> uses;  ///< notes of the variables that it is worked out from
};

/// Defaults for programs that make pictures and files.
struct OutputParameters {
  std::vector<int> size{1200, 1200};  ///< width and height, pixels
  int samples = 64;                   ///< paths per pixel
  int lod = 0;                        ///< coarser levels of detail that files with meshes are written in as well
  int cards = 0;                      ///< upright crossed cards of a last level; 0: none is written
};

/// One `--set PATH=VALUE`: a variable's name ("age"), a component's parameter ("stem.length"), or a key
/// ("links[1].density", "scene.latitude", "seed"). A variable is preferred to a key of its name.
struct Override {
  std::string path;  ///< such as "age" or "stem.length"
  Value value;       ///< replaces the value in the text
  std::string name;  ///< what messages call it, in place of a file; empty: "set PATH"
};

/// Where a document came from, for messages and for editors that patch the text.
struct Source {
  std::string file;                          ///< the document's name in messages
  std::string text;                          ///< text of the document
  Value tree;                                ///< what the text says, with the values that overrides have set
  std::vector<std::string> named_files;      ///< paths of the files that were read with it
  std::vector<std::string> files_beside;     ///< those of them that a copy elsewhere needs beside it, by NamedFile
  std::vector<std::string> overridden;       ///< document paths that an override has set
  std::vector<std::string> override_names;   ///< what messages call each override
  std::vector<std::string> sets;             ///< the overrides as they were given, the last of each path: "age=20"
  std::vector<VariableNote> variable_notes;  ///< notes of the variables that values depend on

  /// Gives diagnostics with a path their file, line and column: in the text, or the override that brought the value.
  /// Errors tell of the variables behind the value that were set or lie beyond their ranges.
  /// Throws Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
  void place(std::vector<Diagnostic>& diagnostics, const Progress* progress = nullptr) const;
};

/// A document that was read without faults: what grows, in which scene, and the defaults for output.
struct Document {
  std::string name;                  ///< name for people
  std::string description;           ///< one sentence for people; may be empty
  std::string author;                ///< may be empty
  std::string licence;               ///< may be empty
  std::vector<Variable> variables;   ///< in the order of the text
  Graph graph;                       ///< components and links
  Scene scene;                       ///< light, obstacles, camera and supports
  OutputParameters output;           ///< defaults for pictures and files
  Source source;                     ///< text and files that the document was read from
  std::vector<Diagnostic> warnings;  ///< what is odd but not wrong
  double time = 0;                   ///< seconds: what is one value for the document has the value of its keys then
  /// Returns the document at another time. Throws what read_document throws, Cancelled soon after `progress` was asked
  /// to stop. Empty if no key of the document changes it over time. Many threads may call it at once.
  std::function<Document(double time, const Progress* progress)> at_time;
};

/// A document as it stands at a time: itself, or one that is read anew into `other`. Throws Cancelled soon after
/// `progress` was asked to stop; null: it cannot be stopped.
const Document& document_at(const Document& document, double time, std::optional<Document>& other,
                            const Progress* progress = nullptr);

/// Splits "PATH=VALUE"; the value is JSON where it reads as such, else text. Throws InputError for texts without
/// '=' or a path before it; whether that is well formed, read_document checks.
Override parse_override(std::string_view text);

/// Documents that name each other, from the last one back.
struct DocumentChain {
  std::string file;                       ///< where it really lies
  std::string name;                       ///< as it was named
  const DocumentChain* before = nullptr;  ///< the document that names this one; null: a user opened it
};

/// How a document is read.
struct ReadOptions {
  std::vector<Override> overrides{};    ///< values that replace those of the text
  std::optional<std::uint64_t> seed{};  ///< in place of the document's
  double time = 0;                      ///< seconds: what is one value for the document gets what its keys give then
  /// Files outside this folder are not read, wherever links and dots lead, and messages do not reveal what is there.
  /// Empty: any file may be read.
  std::string root{};
  /// Results of earlier reads of files are found here and kept for later reads; null: every file is read.
  ReadStore* store = nullptr;
  /// Folder of the shipped models, which documents may name; empty: there are none.
  std::string models{};
  /// The documents that contain this one, each within the one before; null for a document that a user opens.
  const DocumentChain* chain = nullptr;
  /// Limits that hold besides the document's own: those of the document that places it.
  std::optional<Limits> within{};
  /// Takes the document paths of all expressions, as far as they were read; may be null.
  std::vector<std::string>* expression_paths = nullptr;
  /// Reading stops within 50 ms after this was asked to stop; null: it cannot be stopped.
  const Progress* progress = nullptr;
  /// Largest size of the text in bytes. A larger value lets larger documents be read, in the same time per byte.
  std::uint64_t document_bytes = Limits{}.document_bytes;
};

/// Reads a document's text. `file` is the name of the document in messages; paths in the document start from the
/// folder of `file`. Throws one InputError with all faults (up to the limit), each with line, column and document
/// path. Throws Cancelled if it was asked to stop. Takes time by the size of the text.
Document read_document(std::string text, const std::string& file, const Registry& registry,
                       const ReadOptions& options = {});

/// Reads a whole file, or standard input for "-". Throws MachineError if it cannot be read, InputError if it is larger
/// than `document_bytes`.
std::string read_text_file(const std::string& path, std::uint64_t document_bytes = Limits{}.document_bytes);

}  // namespace meristem

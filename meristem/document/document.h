// SPDX-License-Identifier: Apache-2.0
// A plant document: the text that a user writes, read into a graph, a scene and settings.
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

/// A value that every expression can use by name. It is a handle for users, unless it is private.
struct Variable {
  std::string name;         ///< an identifier
  double value = 0;         ///< value of the name in expressions
  double min = 0;           ///< least sensible value, for sliders; smaller values are allowed
  double max = 1;           ///< greatest sensible value, for sliders; larger values are allowed
  std::string unit;         ///< unit for people, such as "m"; may be empty
  std::string doc;          ///< one sentence for people; may be empty
  std::string expression;   ///< expression that gave the value, for example "2 + 0.1*age"; may be empty
  std::string per;          ///< id of the component whose instances each draw a value, or empty
  bool is_private = false;  ///< true: a name that several expressions share, and no handle; it can still be set
};

/// A note on a variable, for messages on wrong values that depend on it.
struct VariableNote {
  std::string variable;           ///< name of the variable
  std::string text;               ///< "age is 1000, beyond 8 to 160", or empty
  std::vector<std::size_t> uses;  ///< notes of the variables that its expression uses
};

/// Defaults for programs that make pictures and files.
struct OutputParameters {
  std::vector<int> size{1200, 1200};  ///< width and height, pixels
  int samples = 64;                   ///< paths per pixel
  int lod = 0;                        ///< number of coarser levels of detail that files with meshes also contain
  int cards = 0;                      ///< number of upright crossed cards of a last level; 0: no such level
};

/// One `--set PATH=VALUE`. The path is a variable's name ("age"), a component's parameter ("stem.length"), or a key
/// ("links[1].density", "scene.latitude", "seed"). A variable takes precedence over a key of its name.
struct ValueOverride {
  std::string path;  ///< such as "age" or "stem.length"
  Value value;       ///< replaces the value in the text; null removes it
  std::string name;  ///< source of the value in messages, instead of a file; empty: "set PATH"
};

/// The source of a document, for messages and for editors that change the text.
struct DocumentOrigin {
  std::string file;                          ///< the document's name in messages
  std::string text;                          ///< text of the document
  Value tree;                                ///< tree of the text, with the values of the overrides
  std::vector<std::string> named_files;      ///< paths of the files that were read with it
  std::vector<std::string> files_beside;     ///< the named files that a copy of the document needs beside it
                                             ///< (NamedFile)
  std::vector<std::string> overridden;       ///< document paths that overrides have set
  std::vector<std::string> override_names;   ///< name of each override in messages
  std::vector<std::string> sets;             ///< the overrides as given, for example "age=20"; only the last one of
                                             ///< each path
  std::vector<VariableNote> variable_notes;  ///< notes of the variables that values depend on

  /// Sets the file of all diagnostics to the document, and the line and column of those without a line. If an override
  /// gave the value, the file is the name of the override, and line and column are 0. Errors mention the variables
  /// behind the value that were set or lie beyond their ranges. Throws Cancelled soon after `progress` was asked to
  /// stop. Null: it cannot be stopped.
  void place(std::vector<Diagnostic>& diagnostics, const Progress* progress = nullptr) const;
};

/// A document that was read without faults: graph, scene and defaults for output.
struct Document {
  std::string name;                  ///< name for people
  std::string description;           ///< one sentence for people; may be empty
  std::string author;                ///< may be empty
  std::string licence;               ///< may be empty
  std::vector<Variable> variables;   ///< in the order of the text
  Graph graph;                       ///< components and links
  Scene scene;                       ///< light, obstacles, camera and supports
  OutputParameters output;           ///< defaults for pictures and files
  DocumentOrigin source;             ///< text and files that the document was read from
  std::vector<Diagnostic> warnings;  ///< unusual but valid things in the document
  double time = 0;                   ///< time of the document, seconds; its keys are evaluated at this time
  /// Returns the document at another time. Throws what read_document throws, and Cancelled soon after `progress` was
  /// asked to stop. Null if no key of the document changes it over time. Many threads may call it at once.
  std::function<Document(double time, const Progress* progress)> at_time;
};

/// Returns a document at a time: the document itself, or another one that is read into `other`. Throws Cancelled soon
/// after `progress` was asked to stop. Null: it cannot be stopped.
const Document& document_at(const Document& document, double time, std::optional<Document>& other,
                            const Progress* progress = nullptr);

/// Splits "PATH=VALUE". The value is read as JSON if possible, else as text. The value `null` removes the key. Throws
/// InputError for texts without '=' or without a path before it. read_document checks the path itself.
ValueOverride parse_override(std::string_view text);

/// A chain of documents that name each other, from the last one backwards.
struct DocumentChain {
  std::string file;                       ///< path without links and dots
  std::string name;                       ///< name as the user or the document before gave it
  const DocumentChain* before = nullptr;  ///< the document that names this one; null: a user opened it
};

/// Options for reading a document.
struct ReadOptions {
  std::vector<ValueOverride> overrides{};  ///< values that replace values of the text
  std::optional<std::uint64_t> seed{};     ///< seed that replaces the document's
  double time = 0;                         ///< seconds; keys of the document are evaluated at this time
  /// Folder that limits reading: files outside are not read, even through links and dots, and messages do not disclose
  /// whether they exist. Empty: any file may be read.
  std::string root{};
  /// Keeps the results of reading files for later reads. Null: every file is read again.
  ReadStore* store = nullptr;
  /// Folder of the shipped models, which documents may name. Empty: no models.
  std::string models{};
  /// The documents that contain this one, from the innermost outwards. Null for a document that a user opens.
  const DocumentChain* chain = nullptr;
  /// Limits of the document that places this one. They apply in addition to the document's own.
  std::optional<SizeLimits> within{};
  /// Receives the document paths of all expressions that were read. May be null.
  std::vector<std::string>* expression_paths = nullptr;
  /// Reading stops within 50 ms after this was asked to stop. Null: it cannot be stopped.
  const Progress* progress = nullptr;
  /// Maximum size of the text, bytes. A larger value allows larger documents; the time per byte stays the same.
  std::uint64_t document_bytes = SizeLimits{}.document_bytes;
};

/// Reads a document's text. `file` is the name of the document in messages; relative paths in the document start at the
/// folder of `file`. Throws one InputError with all faults (up to the limit), each with line, column and document path.
/// Throws Cancelled if it was asked to stop. `registry` must outlive the document. Takes time in proportion to the size
/// of the text.
Document read_document(std::string text, const std::string& file, const Registry& registry,
                       const ReadOptions& options = {});

/// Reads a whole file, or standard input for "-". Throws MachineError if it cannot be read, InputError if it is larger
/// than `document_bytes`.
std::string read_text_file(const std::string& path, std::uint64_t document_bytes = SizeLimits{}.document_bytes);

}  // namespace meristem

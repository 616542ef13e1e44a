// SPDX-License-Identifier: Apache-2.0
// Exports of a document: files to download, and the command line that writes equal files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "grower.h"
#include "host.h"
#include "meristem/document/document.h"
#include "meristem/output/picture/still.h"
#include "request.h"

namespace meristem::studio {

/// The source of an export: a document, and its grown plant if there is one.
struct ExportSource {
  std::shared_ptr<const Document> document;  ///< document at the requested time and with the requested seed
  std::string text;                          ///< present text
  std::string name;                          ///< name for files, without ending
  std::shared_ptr<const GrownPlant> grown;   ///< grown plant of the same document and time; null: the document is grown
                                             ///< again
};

/// Returns a name for files that is made from any text.
std::string file_name_of(const std::string& text);

/// Returns all endings that can be exported, for the page's list.
Value formats_value();

/// Throws a Refusal for options that do not fit the format.
void check_export(const ExportOptions& options);

/// Returns true if the options request pictures of several times: a film, or numbered pictures.
bool has_frames(const ExportOptions& options);

/// Returns the size, quality and camera of pictures.
StillOptions still_of(const ExportOptions& options, const Document& document);
CameraView view_of(const ExportOptions& options, const Document& document);

/// Keeps the files of a draft and returns the member "file" of the answer. That is the single file, or an archive of
/// all files, with `first` at the head of its list. Throws MachineError, Cancelled.
Value made_file(Downloads& downloads, const Downloads::Draft& draft, const std::string& first, const std::string& name,
                const Progress& progress);

/// Writes a file and keeps it in the downloads. If the format needs several files, writes an archive. Returns the
/// member "file" of the answer. A cancelled export leaves no files. Throws InputError, MachineError, Cancelled.
Value export_file(const ExportSource& source, const ExportOptions& options, Downloads& downloads, Progress& progress);

/// Returns the command line that exports the document in `file` with these options.
std::string export_command(const std::string& program, const std::string& file, const ExportOptions& options,
                           const std::string& name);

}  // namespace meristem::studio

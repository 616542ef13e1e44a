// SPDX-License-Identifier: Apache-2.0
// What a studio writes of a document: files to download, and the command line that writes the same.
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

/// What is exported: a document, and what has grown of it already.
struct ExportSource {
  std::shared_ptr<const Document> document;  ///< at the time and with the seed that were asked for
  std::string text;                          ///< as it stands
  std::string name;                          ///< for files, without ending
  std::shared_ptr<const GrownWish> grown;    ///< of the same document and time; null: it grows anew
};

/// A name that files may have, out of any text.
std::string file_name_of(const std::string& text);

/// All endings that can be exported, as the page lists them.
Value formats_value();

/// Throws a Refusal for options that do not fit.
void check_export(const ExportOptions& options);

/// Whether pictures of several times are asked for: a film, or numbered pictures.
bool has_frames(const ExportOptions& options);

/// How large and fine pictures are, and from where they are seen.
StillOptions still_of(const ExportOptions& options, const Document& document);
View view_of(const ExportOptions& options, const Document& document);

/// Keeps what was written to a draft, and gives the "file" of the answer: the one file, or an archive of all that there
/// are, of which `first` is listed first. Throws MachineError, Cancelled.
Value made_file(Downloads& downloads, const Downloads::Draft& draft, const std::string& first, const std::string& name,
                const Progress& progress);

/// Writes a file that the downloads keep, an archive where the format takes several, and gives the "file" of the
/// answer. What was cancelled leaves nothing. Throws InputError, MachineError, Cancelled.
Value export_file(const ExportSource& source, const ExportOptions& options, Downloads& downloads, Progress& progress);

/// The line for a terminal that does the same with the document in `file`.
std::string export_command(const std::string& program, const std::string& file, const ExportOptions& options,
                           const std::string& name);

}  // namespace meristem::studio

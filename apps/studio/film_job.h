// SPDX-License-Identifier: Apache-2.0
// Pictures of a document over time: a film, or numbered pictures.
#pragma once

#include "export_job.h"
#include "job_news.h"

namespace meristem::studio {

/// Draws the frames that the options ask for, by default those of the whole animation, and gives the "file" of the
/// answer: the film, or an archive of the pictures. A camera that the options do not say stands where it shows all of
/// the last plant; one with keys moves. Throws a Refusal where the document has no animation and the options no times,
/// InputError, MachineError, Cancelled.
Value export_frames(const ExportSource& source, const ExportOptions& options, Downloads& downloads, JobNews& news);

}  // namespace meristem::studio

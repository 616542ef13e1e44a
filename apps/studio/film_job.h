// SPDX-License-Identifier: Apache-2.0
// Pictures of a document over time: a film, or numbered pictures.
#pragma once

#include "export_job.h"
#include "job_messages.h"

namespace meristem::studio {

/// Draws the requested frames, by default the frames of the whole animation. Returns the member "file" of the answer:
/// the film, or an archive of the pictures. Without a camera in the options, the camera shows the whole plant of the
/// last frame; a camera with keys moves. Throws a Refusal if neither the document has an animation nor the options have
/// times. Throws InputError, MachineError, Cancelled.
Value export_frames(const ExportSource& source, const ExportOptions& options, Downloads& downloads,
                    JobMessages& messages);

}  // namespace meristem::studio

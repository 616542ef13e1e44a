// SPDX-License-Identifier: Apache-2.0
// Several files as one, so that a browser fetches them in one piece.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem::studio {

/// Writes a zip archive of these files under their own names, without compressing them: meshes and pictures would gain
/// little for the time. The same files give the same bytes. Throws MachineError (also where a file or the archive has
/// 4 GB or more, which this form of archives cannot hold), Cancelled.
void write_zip(const std::vector<std::string>& files, const std::string& path, const Progress& progress);

}  // namespace meristem::studio

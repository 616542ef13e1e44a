// SPDX-License-Identifier: Apache-2.0
// Joins several files into one, so that a browser fetches them together.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem::studio {

/// Writes a zip archive of these files under their own names. Files are not compressed: meshes and pictures would gain
/// little for the time. Equal files give equal bytes. Throws MachineError (also if a file or the archive has 4 GB or
/// more, which this archive format cannot hold), Cancelled.
void write_zip(const std::vector<std::string>& files, const std::string& path, const Progress& progress);

}  // namespace meristem::studio

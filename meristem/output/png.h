// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/image.h"

namespace meristem {

/// Writes a PNG to `path` ("-" for standard output); same picture, same bytes. Throws MachineError.
void write_png(const Image& image, const std::string& path);

}  // namespace meristem

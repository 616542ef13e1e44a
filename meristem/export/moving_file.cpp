// SPDX-License-Identifier: Apache-2.0
// Writes an animation as binary glTF, the only format that can store one, and refuses all other endings.
#include "meristem/export/moving_file.h"

#include <fmt/format.h>

#include "meristem/export/formats.h"
#include "meristem/output/gltf/gltf.h"

namespace meristem {

void check_moving_file(const std::string& path) {
  if (path != "-" && format_of(path).can_animate) return;
  throw InputError(Diagnostic{.message = fmt::format("'{}' cannot hold an animation", path),
                              .expected = "a file that ends in .glb"});
}

void write_moving_file(const Document& document, const MovingScene& moving, const std::string& path, Progress& progress,
                       EncodedPictures* pictures) {
  check_moving_file(path);
  write_moving_glb(moving, path, {.provenance = provenance_of(document), .pictures = pictures}, progress);
}

}  // namespace meristem

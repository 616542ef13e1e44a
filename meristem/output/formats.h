// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/document/grow.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/write/provenance.h"

namespace meristem {

/// Properties of a format, for programs.
struct FormatOptions {
  GltfInstances instances = GltfInstances::automatic;  ///< how organs share a mesh, in formats that can
  EncodedPictures* pictures = nullptr;                 ///< shared with other files; may be null
  bool obstacles = false;                              ///< formats with meshes hold the scene's obstacles as well
};

/// What files of a document say about where they came from.
Provenance provenance_of(const Document& document);

/// A kind of file that a grown document can be written to.
struct Format {
  std::string_view ending;  ///< with its dot; may hold more than one
  std::string_view doc;     ///< one line
  /// Writes the file at `path`. Throws MachineError and Cancelled, and InputError for what the format cannot hold.
  void (*write)(const Document& document, const GrownDocument& grown, const std::string& path,
                const FormatOptions& options, Progress& progress);
  GrownPart needs = GrownPart::plant;  ///< what is written
  bool can_instance = false;           ///< true if organs can be instances of one mesh in a file
  /// The files that may be written beside it; null where there are none.
  std::vector<std::string> (*companions)(const Document& document, const std::string& path) = nullptr;
  bool is_whole = false;     ///< it holds the plant alone, without obstacles, and has no levels of detail
  bool can_animate = false;  ///< holds plants that move (moving_file.h)
  TraceWish wish{};          ///< what must be recorded of growth for it

  bool has_meshes() const { return needs >= GrownPart::meshes && !is_whole; }  ///< so that levels of detail differ
  bool has_textures() const { return needs >= GrownPart::textures; }           ///< so that it can show cards
};

/// Where a level of detail is written beside `path`, which is of that format: `oak_lod2.glb` for `oak.glb`; `path`
/// itself for level 0.
std::string detail_path(const Format& format, const std::string& path, int level);

/// Where crossed cards of the plant are written beside `path`, which is of that format: `oak_cards.glb` for `oak.glb`.
std::string cards_path(const Format& format, const std::string& path);

/// All formats, the default first.
std::span<const Format> formats();

/// What files of all of these formats need: what is made of the document, and what is recorded of its growth.
GrownPart needed_part(std::span<const Format* const> formats);
/// Returns the parts of growth that must be recorded for files of all these formats.
TraceWish needed_wish(std::span<const Format* const> formats);

/// The format of a path by its ending, the longest that fits (capitals count as equal); "-" is standard output in the
/// default format. Throws InputError that names the known endings, and the nearest.
const Format& format_of(const std::string& path);

}  // namespace meristem

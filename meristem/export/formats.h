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

/// Options of all formats, for programs.
struct FormatOptions {
  GltfInstances instances = GltfInstances::automatic;  ///< how organs share a mesh, in formats that support this
  EncodedPictures* pictures = nullptr;                 ///< shared with other files; may be null
  bool obstacles = false;                              ///< if true, formats with meshes contain the scene's obstacles
                                                       ///< as well
  bool shared_vertices = false;                        ///< if true, PLY leaves out normals and texture coordinates
  std::vector<std::string> only{};                     ///< objects that formats with meshes contain; empty: all
};

/// Returns the origin of a document that is written to its files.
Provenance provenance_of(const Document& document);

/// A file format to which a grown document can be written.
struct FileFormat {
  std::string_view ending;  ///< with its dot; may contain several dots
  std::string_view doc;     ///< description in one line
  /// Writes the file at `path`. Throws MachineError and Cancelled, and InputError for content that the format cannot
  /// store.
  void (*write)(const Document& document, const GrownDocument& grown, const std::string& path,
                const FormatOptions& options, Progress& progress);
  GrownPart needs = GrownPart::plant;  ///< the part of the grown document that is written
  bool can_instance = false;           ///< true if organs can be instances of one mesh in a file
  /// Returns the other files that may be written together with the file. Null if there are no such files.
  std::vector<std::string> (*companions)(const Document& document, const std::string& path) = nullptr;
  bool is_whole = false;     ///< the file contains only the whole plant, without obstacles or levels of detail
  bool can_animate = false;  ///< the format can store plants that move (moving_file.h)
  TraceRequest request{};    ///< the parts of growth that must be recorded for the format

  bool has_meshes() const {
    return needs >= GrownPart::meshes && !is_whole;
  }                                                                   ///< true if levels of detail differ in
                                                                      ///< this format
  bool has_textures() const { return needs >= GrownPart::textures; }  ///< true if the format can show cards
};

/// Returns the path of a level of detail for the file `path` in that format: `oak_lod2.glb` for `oak.glb`. Returns
/// `path` itself for level 0.
std::string detail_path(const FileFormat& format, const std::string& path, int level);

/// Returns the path of the plant's crossed cards for the file `path` in that format: `oak_cards.glb` for `oak.glb`.
std::string cards_path(const FileFormat& format, const std::string& path);

/// Returns all formats, the default first.
std::span<const FileFormat> formats();

/// Returns the part of a grown document that files of all these formats need.
GrownPart needed_part(std::span<const FileFormat* const> formats);
/// Returns the parts of growth that must be recorded for files of all these formats.
TraceRequest needed_request(std::span<const FileFormat* const> formats);

/// Returns the format of a path by its ending. The longest matching ending counts, and capital letters are equal to
/// small ones. "-" is standard output in the default format. Throws InputError with the known endings and the nearest
/// one.
const FileFormat& format_of(const std::string& path);

}  // namespace meristem

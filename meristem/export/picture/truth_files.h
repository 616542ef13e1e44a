// SPDX-License-Identifier: Apache-2.0
// The ground truth of a picture as files for image tools, robots and detectors.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "meristem/export/picture/truth.h"

namespace meristem {

/// One kind of truth file.
struct TruthFormat {
  std::string_view name;                    ///< name in options and plans: "depth"
  std::array<std::string_view, 2> endings;  ///< endings of its files, the usual one first; the second is empty if there
                                            ///< is only one
  std::string_view doc;                     ///< one sentence

  std::string ending_list() const;  ///< returns a text such as ".png or .pfm"
};

/// A truth file to write.
struct TruthFile {
  const TruthFormat* format = nullptr;  ///< the kind of file; not null
  std::string path;                     ///< with one of the format's endings
};

/// Facts in a truth file besides the pixels.
struct TruthContext {
  std::string picture;  ///< name of the picture's file
  std::string name;     ///< name of the document
  std::string licence;  ///< licence of the document, or empty
};

/// Returns all kinds: depth, normals, organs, shoots, plants, coco.
std::span<const TruthFormat> truth_formats();

/// Returns the kind of that name. Throws InputError with the nearest name.
const TruthFormat& truth_format(std::string_view name);

/// Throws InputError unless `path` has an ending of this kind.
void check_truth_file(const TruthFormat& format, const std::string& path);

/// Returns the bytes of a file of this kind, in the format of the path's ending. Equal truth gives equal bytes.
///
/// - depth, PNG: one channel of 16 bits, millimetres along the viewing direction of the camera; 0 for the sky, 65535
///   for distances of 65.535 m or more. PFM: 32-bit floats in metres, infinite for the sky.
/// - normals, PNG: x, y and z of the camera's frame in red, green and blue, from -1 at 0 to 1 at 255; black for the
///   sky. PFM: three 32-bit floats.
/// - masks, PNG: the number of each pixel's object as red + 256 green + 65536 blue; black for no object.
/// - annotations, JSON: the format of the COCO data sets. Organs, shoots and plants are annotations with run-length
///   encoded masks. `number` is the number in the level's mask, and the ids of annotations are consecutive over all
///   levels.
std::string encode_truth(const PictureTruth& truth, const TruthFormat& format, const std::string& path,
                         const TruthContext& context);

/// Writes the files, each whole or not at all. Throws MachineError.
void write_truths(const PictureTruth& truth, std::span<const TruthFile> files, const TruthContext& context);

/// Returns the run lengths of one object's pixels as the text ("counts") that COCO's tools read. Pixels are ordered
/// column by column from the left, each from the top.
std::string coco_counts(const TruthMask& mask, int width, int height, std::uint32_t number);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The truth behind a picture as files: what tools for pictures, robots and detectors read.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "meristem/output/picture/truth.h"

namespace meristem {

/// One kind of file about a picture.
struct TruthFormat {
  std::string_view name;                    ///< what options and plans call it: "depth"
  std::array<std::string_view, 2> endings;  ///< of its files, the usual one first; the second is empty where one is all
  std::string_view doc;                     ///< one sentence

  std::string ending_list() const;  ///< ".png or .pfm"
};

/// A file about a picture that is to be written.
struct TruthFile {
  const TruthFormat* format = nullptr;  ///< the kind of file; not null
  std::string path;                     ///< with one of the format's endings
};

/// What a file about a picture says besides the pixels.
struct TruthContext {
  std::string picture;  ///< name of the picture's file
  std::string name;     ///< of the document
  std::string licence;  ///< of the document, or empty
};

/// All kinds: depth, normals, organs, shoots, plants, coco.
std::span<const TruthFormat> truth_formats();

/// The kind of that name. Throws InputError with the nearest.
const TruthFormat& truth_format(std::string_view name);

/// Throws InputError unless files of this kind can end as `path` does.
void check_truth_file(const TruthFormat& format, const std::string& path);

/// The bytes of a file of this kind, in the format of the path's ending; the same truth gives the same bytes.
///
/// - depth, PNG: one channel of 16 bits, millimetres along the way that the camera looks; 0 for the sky, 65535 for all
///   that is 65.535 m away or farther. PFM: 32-bit floats in metres, infinite for the sky.
/// - normals, PNG: x, y and z of the camera's frame in red, green and blue, from -1 at 0 to 1 at 255; black for the
/// sky.
///   PFM: three 32-bit floats.
/// - masks, PNG: the number of each pixel's thing as red + 256 green + 65536 blue; black for none.
/// - annotations, JSON: the format of the COCO data sets. Organs, shoots and plants are annotations whose masks are
///   run-length encoded; the ids of each level are the numbers of its mask (`number`), those of annotations run
///   through.
std::string encode_truth(const Truth& truth, const TruthFormat& format, const std::string& path,
                         const TruthContext& context);

/// Writes the files, each whole or not at all. Throws MachineError.
void write_truths(const Truth& truth, std::span<const TruthFile> files, const TruthContext& context);

/// Run lengths of one thing's pixels, column by column from the left and each from the top, as the text that COCO's
/// tools read ("counts").
std::string coco_counts(const TruthMask& mask, int width, int height, std::uint32_t number);

}  // namespace meristem

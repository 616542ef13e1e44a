// SPDX-License-Identifier: Apache-2.0
// Writes pictures as PNG or JPEG by the ending of the path, and checks the options of both formats.
#include "meristem/output/write/picture_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/output/write/jpeg.h"
#include "meristem/output/write/png.h"

namespace meristem {

namespace {

std::string ending_of(const std::string& path) {
  std::string ending = path == "-" ? ".png" : std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

bool is_jpeg(const std::string& path) { return ending_of(path) == ".jpg" || ending_of(path) == ".jpeg"; }

InputError wrong(std::string message, std::string expected) {
  return InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected)});
}

}  // namespace

void check_picture_file(const std::string& path, bool transparent, const PictureFileOptions& options) {
  const bool has_quality = options.quality || options.max_bytes;
  if (is_jpeg(path)) {
    if (transparent) throw wrong("a JPEG cannot be transparent", "a file that ends in .png");
    if (options.quality && (*options.quality < 1 || *options.quality > 100)) {
      throw wrong(fmt::format("the quality of a JPEG cannot be {}", *options.quality), "a whole number from 1 to 100");
    }
  } else if (ending_of(path) == ".png") {
    if (has_quality) throw wrong("a PNG keeps every pixel and has no quality", "a file that ends in .jpg");
  } else {
    throw wrong(fmt::format("pictures cannot be written to '{}'", path), "a file that ends in .png or .jpg");
  }
}

void write_picture(const Image& image, const std::string& path, const PictureFileOptions& options) {
  check_picture_file(path, false, options);
  if (!is_jpeg(path)) return write_png(image, path);
  const std::string bytes =
      encode_jpeg(image, {.quality = options.quality.value_or(kUsualJpegQuality), .max_bytes = options.max_bytes});
  AtomicFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Packs the built page and small pictures of the models into one file, which becomes part of the program.
//
// In:  the path of the pack; the folder of the built page, or "" for no page; the folders of pictures of the models and
// of the parts of the palette. Pictures of parts are named part-NAME.
// Out: for each file a line "NAME BYTES COMPRESSED\n" and its bytes, sorted by name. Equal files give equal bytes.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>
#include <zlib.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/image.h"
#include "meristem/base/limits.h"
#include "meristem/base/read_file.h"
#include "meristem/base/read_image.h"
#include "meristem/output/write/jpeg.h"

namespace {

using namespace meristem;
namespace fs = std::filesystem;

constexpr int kPictureSize = 160;  // length of the longer side, pixels
constexpr int kPictureQuality = 80;
constexpr std::uint64_t kMaxBytes = 100'000'000;

struct PackedFile {
  std::string bytes;
  bool is_compressed = false;
};
using Pack = std::map<std::string, PackedFile>;

std::string compressed(const std::string& bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY) != Z_OK)
    throw MachineError("cannot compress");
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int status = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw MachineError("cannot compress");
  return out;
}

/// Returns a smaller picture. Each pixel is the mean of the pixels that it covers.
Image shrunk(const Image& image) {
  const int longer = std::max(image.width, image.height);
  if (longer <= kPictureSize) return image;
  Image small;
  small.width = std::max(1, image.width * kPictureSize / longer);
  small.height = std::max(1, image.height * kPictureSize / longer);
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const int left = x * image.width / small.width;
      const int right = std::max(left + 1, (x + 1) * image.width / small.width);
      const int top = y * image.height / small.height;
      const int bottom = std::max(top + 1, (y + 1) * image.height / small.height);
      for (int channel = 0; channel < 4; ++channel) {
        int sum = 0;
        for (int row = top; row < bottom; ++row) {
          for (int column = left; column < right; ++column) sum += image.pixel(column, row)[channel];
        }
        small.pixel(x, y)[channel] = static_cast<std::uint8_t>(sum / ((right - left) * (bottom - top)));
      }
    }
  }
  return small;
}

void add_page(const std::string& folder, Pack& pack) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.file_size() == 0) continue;
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    pack[name] = {compressed(read_file(entry.path().string(), kMaxBytes)), true};
  }
}

void add_pictures(const std::string& folder, const std::string& prefix, Pack& pack) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".jpg") continue;
    const Image image = read_image(entry.path().string(), SizeLimits());
    pack["pictures/" + prefix + entry.path().filename().string()] = {
        encode_jpeg(shrunk(image), {.quality = kPictureQuality, .max_bytes = {}}), false};
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 5) throw MachineError("usage: pack_page PACK PAGE_FOLDER PICTURE_FOLDER PART_FOLDER");
    Pack pack;
    if (std::string(argv[2]) != "") add_page(argv[2], pack);
    if (std::string(argv[3]) != "") add_pictures(argv[3], "", pack);
    if (std::string(argv[4]) != "") add_pictures(argv[4], "part-", pack);
    AtomicFile file(argv[1]);
    for (const auto& [name, packed] : pack) {
      file.write(fmt::format("{} {} {}\n", name, packed.bytes.size(), packed.is_compressed ? 1 : 0));
      file.write(packed.bytes);
    }
    file.commit();
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pack_page: {}\n", error.what());
    return 1;
  }
}

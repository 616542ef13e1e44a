// SPDX-License-Identifier: Apache-2.0
// Encodes JPEG with libjpeg-turbo. For a maximum size, a bisection finds the highest quality that fits.
#include "meristem/output/write/jpeg.h"

#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <turbojpeg.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

/// Above this quality, colours have the full resolution of the brightness. Below it, nobody sees the difference.
constexpr int kFullColourQuality = 95;

/// An encoder that is set up once for several attempts at a size.
class JpegEncoder {
 public:
  explicit JpegEncoder(const Image& image) : image_(image) {
    if (encoder_ == nullptr) throw_failure();
  }

  std::string encode(int quality) {
    unsigned char* bytes = nullptr;
    unsigned long size = 0;  // NOLINT(google-runtime-int): libturbojpeg's type
    // The accurate transform gives equal bytes with and without vector instructions.
    const int done = tjCompress2(encoder_.get(), image_.rgba.data(), image_.width, 0, image_.height, TJPF_RGBX, &bytes,
                                 &size, quality >= kFullColourQuality ? TJSAMP_444 : TJSAMP_420, quality,
                                 TJFLAG_ACCURATEDCT | TJFLAG_PROGRESSIVE);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> release(bytes, tjFree);
    if (done != 0) throw_failure();
    return {reinterpret_cast<const char*>(bytes), size};
  }

 private:
  [[noreturn]] void throw_failure() const {
    throw MachineError(fmt::format("JPEG: {}", tjGetErrorStr2(encoder_.get())));
  }

  const Image& image_;
  std::unique_ptr<void, int (*)(tjhandle)> encoder_{tjInitCompress(), tjDestroy};
};

}  // namespace

std::string encode_jpeg(const Image& image, const JpegOptions& options) {
  if (options.quality < 1 || options.quality > 100) {
    throw InputError(Diagnostic{.message = fmt::format("the quality of a JPEG cannot be {}", options.quality),
                                .expected = "a whole number from 1 to 100"});
  }
  if (image.width < 1 || image.height < 1 ||
      image.rgba.size() != std::size_t{4} * image.width * static_cast<std::size_t>(image.height)) {
    throw std::invalid_argument("a picture's size and its bytes do not agree");
  }
  JpegEncoder encoder(image);
  std::string best = encoder.encode(options.quality);
  if (!options.max_bytes || best.size() <= *options.max_bytes) return best;
  // Bisect the qualities between one that fits and one that is too large.
  int small_enough = 0;
  int too_large = options.quality;
  while (too_large - small_enough > 1) {
    const int quality = (small_enough + too_large) / 2;
    std::string bytes = encoder.encode(quality);
    if (bytes.size() <= *options.max_bytes) {
      small_enough = quality;
      best = std::move(bytes);
    } else {
      too_large = quality;
    }
  }
  if (small_enough == 0) {
    throw InputError(
        Diagnostic{.message = fmt::format("the picture has {} x {} pixels and no JPEG of it has only {} bytes",
                                          image.width, image.height, *options.max_bytes),
                   .expected = "more bytes, or fewer pixels"});
  }
  return best;
}

}  // namespace meristem

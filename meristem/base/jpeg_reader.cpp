// SPDX-License-Identifier: Apache-2.0
// Decodes JPEG with libjpeg-turbo, row by row. A progressive JPEG is read in scans over the whole picture before its
// first row, so it is also stopped after rows of blocks.
#include <array>
#include <csetjmp>
#include <cstdio>
#include <exception>
#include <string>

#include <jpeglib.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/image_readers.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

namespace {

constexpr int kMaxScans = 500;  // a small file with thousands of scans would take minutes

/// libjpeg is written in C, so errors leave it by longjmp, and exceptions are stored here until its frames are gone.
struct JpegErrors : jpeg_error_mgr {
  std::jmp_buf place;
  std::array<char, JMSG_LENGTH_MAX> message{};
  std::exception_ptr stop;
};

JpegErrors& errors_of(j_common_ptr jpeg) { return *static_cast<JpegErrors*>(jpeg->err); }

[[noreturn]] void leave_with_error(j_common_ptr jpeg) {
  JpegErrors& errors = errors_of(jpeg);
  (*errors.format_message)(jpeg, errors.message.data());
  std::longjmp(errors.place, 1);
}

/// Damaged data give a warning, with a negative level.
void refuse_warnings(j_common_ptr jpeg, int level) {
  if (level < 0) leave_with_error(jpeg);
}

void check_progress(j_common_ptr jpeg) {
  JpegErrors& errors = errors_of(jpeg);
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > kMaxScans) {
    std::snprintf(errors.message.data(), errors.message.size(), "it has more than %d scans", kMaxScans);
    std::longjmp(errors.place, 1);
  }
  try {
    ReadingStop::check();
    return;
  } catch (...) {
    errors.stop = std::current_exception();
  }
  std::longjmp(errors.place, 1);
}

/// Calls a step of libjpeg. Returns false if the step was left by an error or a stop. The step must not own objects
/// with destructors.
template <class Step>
bool is_done(JpegErrors& errors, const Step& step) {
  if (setjmp(errors.place) != 0) return false;
  step();
  return true;
}

/// libjpeg's objects for one picture.
class JpegReader {
 public:
  JpegReader(std::string_view bytes, const std::string& file) : file_(file) {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = leave_with_error;
    errors_.emit_message = refuse_warnings;
    progress_.progress_monitor = check_progress;
    run([&] {
      jpeg_create_decompress(&jpeg_);
      jpeg_.progress = &progress_;
      jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    });
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  Image read(const SizeLimits& limits) {
    run([&] { jpeg_read_header(&jpeg_, TRUE); });
    Image image = empty_image(jpeg_.image_width, jpeg_.image_height, file_, limits);
    run([&] {
      jpeg_.out_color_space = JCS_EXT_RGBA;
      jpeg_.dct_method = JDCT_ISLOW;
      jpeg_start_decompress(&jpeg_);
    });
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = image.rgba.data() + std::size_t{4} * jpeg_.image_width * jpeg_.output_scanline;
      run([&] { jpeg_read_scanlines(&jpeg_, &row, 1); });
    }
    run([&] { jpeg_finish_decompress(&jpeg_); });
    return image;
  }

 private:
  template <class Step>
  void run(const Step& step) {
    if (is_done(errors_, step)) return;
    if (errors_.stop) std::rethrow_exception(errors_.stop);
    throw_damaged(file_, "JPEG", errors_.message.data());
  }

  const std::string& file_;
  JpegErrors errors_{};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

Image parse_jpeg(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  return JpegReader(bytes, file).read(limits);
}

}  // namespace meristem

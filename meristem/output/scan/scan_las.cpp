// SPDX-License-Identifier: Apache-2.0
// Writes LAS files: a header of 375 bytes, one variable length record that describes the extra bytes, and points of
// format 6. Two extended records of `meristem` follow: 1 with the components and 2 with the labels of shoots, as lines
// "number,text". The pulse number is stored as the time of the point, a microsecond each, so that all returns of one
// pulse have equal times.
//
// Based on: ASPRS, LAS specification 1.4, revision 15 (2019): tables 3 (header), 16 (format 6), 24 (extra bytes).
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/output/scan/scan_writer.h"
#include "meristem/output/write/append_bytes.h"
#include "meristem/output/write/z_up.h"

namespace meristem {

namespace {

constexpr double kLasScale = 1e-4;  // unit of the whole numbers that store positions, metres
constexpr std::size_t kLasHeaderBytes = 375;
constexpr std::size_t kRecordHead = 54;   // bytes of the head of a variable length record
constexpr std::size_t kDescriptor = 192;  // bytes of the description of one extra dimension
constexpr std::uint8_t kPointFormat = 6;
constexpr std::size_t kPointBytes = 30;    // without extra bytes
constexpr std::uint16_t kWktBit = 1 << 4;  // required by this format, also without a coordinate system
constexpr std::uint64_t kNoneInLas = 0xffffffffU;

/// A dimension in extra bytes.
struct ExtraBytes {
  std::string_view name;
  std::string_view doc;  // at most 31 letters
  std::uint8_t type;     // 1, 3 and 5: whole numbers of 1, 2 and 4 bytes; 9: a float
  std::uint8_t bytes;
  bool has_none = false;
};

constexpr std::array<ExtraBytes, 8> kExtraBytes{{{"range", "measured distance, metres", 9, 4},
                                                 {"true_range", "distance without noise, metres", 9, 4},
                                                 {"tree", "number of the tree", 5, 4, true},
                                                 {"component", "number of the component", 5, 4},
                                                 {"instance", "number within the component", 5, 4},
                                                 {"shoot", "number of the axis", 5, 4, true},
                                                 {"order", "branching order of the shoot", 3, 2},
                                                 {"kind", "ground, wood, organ, obstacle", 1, 1}}};

constexpr std::size_t extra_size() {
  std::size_t bytes = 0;
  for (const ExtraBytes& extra : kExtraBytes) bytes += extra.bytes;
  return bytes;
}

constexpr std::size_t kRecordBytes = kPointBytes + extra_size();
constexpr std::size_t kPointsBegin = kLasHeaderBytes + kRecordHead + kExtraBytes.size() * kDescriptor;

/// Appends a text in a field of fixed width, padded with zeros.
void append_field(std::string_view text, std::size_t width, std::string& out) {
  out += text.substr(0, width);
  out.append(width - std::min(width, text.size()), '\0');
}

/// Returns the ASPRS class: ground 2, high vegetation 5, building 6.
std::uint8_t class_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::ground:
      return 2;
    case SurfaceKind::obstacle:
      return 6;
    case SurfaceKind::wood:
    case SurfaceKind::organ:
      break;
  }
  return 5;
}

std::string extra_bytes_record() {
  std::string out;
  append_bytes(out, std::uint16_t{0});
  append_field("LASF_Spec", 16, out);
  append_bytes(out, std::uint16_t{4});
  append_bytes(out, static_cast<std::uint16_t>(kExtraBytes.size() * kDescriptor));
  append_field("extra bytes", 32, out);
  for (const ExtraBytes& extra : kExtraBytes) {
    append_bytes(out, std::uint16_t{0});
    append_bytes(out, extra.type);
    append_bytes(out, static_cast<std::uint8_t>(extra.has_none ? 1 : 0));
    append_field(extra.name, 32, out);
    append_field("", 4, out);
    append_bytes(out, std::array{extra.has_none ? kNoneInLas : 0, std::uint64_t{0}, std::uint64_t{0}});
    append_field("", 96, out);  // minimum, maximum, scale and offset are unused
    append_field(extra.doc, 32, out);
  }
  return out;
}

class ScanLas : public ScanWriter {
 public:
  ScanLas(const std::string& path, ScanHead head)
      : head_(std::move(head)),
        seen_(head_.scanner->labels().shoot_count()),
        file_(path, header(0) + extra_bytes_record()) {}

  void add(std::span<const ScanPoint> points) override {
    count_ += points.size();
    seen_.add(points);
    for (const ScanPoint& point : points) {
      ++by_return_[point.number - 1U];
      const DVec3 position = z_up(point.position);
      if (!(glm::length(position) < kLasScale * std::numeric_limits<std::int32_t>::max())) {
        throw InputError(Diagnostic{.message = "a point is too far away for LAS",
                                    .expected = "positions within 200 km, or a file that ends in .ply"});
      }
      low_ = glm::min(low_, position);
      high_ = glm::max(high_, position);
    }
    std::string bytes;
    append_points(points, bytes, [](const ScanPoint& point, std::string& out) { append(point, out); });
    file_.write(bytes);
  }

  void finish() override {
    const std::size_t end = file_.size();
    const SurfaceLabels& labels = head_.scanner->labels();
    std::string components;
    for (std::size_t k = 0; k < labels.components().size(); ++k) {
      components += fmt::format("{},{}\n", k, labels.components()[k]);
    }
    std::string shoots;
    for (const std::uint32_t shoot : seen_.numbers())
      shoots += fmt::format("{},{}\n", shoot, labels.shoot_label(shoot));
    file_.write(record(1, "components", components) + record(2, "labels of shoots", shoots));
    file_.finish(header(end));
  }

 private:
  /// Returns an extended variable length record.
  static std::string record(std::uint16_t id, std::string_view doc, const std::string& content) {
    std::string out;
    append_bytes(out, std::uint16_t{0});
    append_field("meristem", 16, out);
    append_bytes(out, id);
    append_bytes(out, std::uint64_t{content.size()});
    append_field(doc, 32, out);
    return out + content;
  }

  /// `records` is the offset of the extended records.
  std::string header(std::uint64_t records) const {
    std::string out = "LASF";
    append_bytes(out, std::array<std::uint16_t, 2>{0, kWktBit});
    append_field("", 16, out);  // project id
    append_bytes(out, std::array<std::uint8_t, 2>{1, 4});
    append_field("simulated", 32, out);
    append_field("Meristem " + head_.provenance.version, 32, out);
    append_bytes(out, std::array<std::uint16_t, 2>{0, 0});  // no date, so that the bytes are equal on any day
    append_bytes(out, static_cast<std::uint16_t>(kLasHeaderBytes));
    append_bytes(out, static_cast<std::uint32_t>(kPointsBegin));
    append_bytes(out, std::uint32_t{1});
    append_bytes(out, kPointFormat);
    append_bytes(out, static_cast<std::uint16_t>(kRecordBytes));
    append_bytes(out, std::array<std::uint32_t, 6>{});  // counts of older versions
    append_bytes(out, std::array{kLasScale, kLasScale, kLasScale, 0.0, 0.0, 0.0});
    const bool is_empty = count_ == 0;
    for (int axis = 0; axis < 3; ++axis) {
      append_bytes(out, is_empty ? 0.0 : rounded(high_[axis]));
      append_bytes(out, is_empty ? 0.0 : rounded(low_[axis]));
    }
    append_bytes(out, std::uint64_t{0});  // no waveforms
    append_bytes(out, records);
    append_bytes(out, std::uint32_t{2});
    append_bytes(out, count_);
    append_bytes(out, by_return_);
    return out;
  }

  static double rounded(double metres) { return kLasScale * static_cast<double>(std::llround(metres / kLasScale)); }

  static void append(const ScanPoint& point, std::string& out) {
    const SurfaceLabel& label = point.label;
    const DVec3 position = z_up(point.position);
    for (int axis = 0; axis < 3; ++axis) {
      append_bytes(out, static_cast<std::int32_t>(std::llround(position[axis] / kLasScale)));
    }
    append_bytes(out, static_cast<std::uint16_t>(std::lround(65535 * std::min(1.0F, point.intensity))));
    append_bytes(out, static_cast<std::uint8_t>(point.number | point.count << 4));
    append_bytes(out, std::uint8_t{0});
    append_bytes(out, class_of(label.kind));
    append_bytes(out, std::uint8_t{0});
    append_bytes(out, std::int16_t{0});
    append_bytes(out, static_cast<std::uint16_t>(std::min(65535U, point.station + 1)));
    append_bytes(out, 1e-6 * static_cast<double>(point.pulse));
    append_bytes(out, std::array{point.range, point.true_range});
    append_bytes(out, std::array{label.tree, label.component, label.instance, label.shoot});
    append_bytes(out, label.order);
    append_bytes(out, static_cast<std::uint8_t>(label.kind));
  }

  ScanHead head_;
  ShootsSeen seen_;
  std::uint64_t count_ = 0;
  std::array<std::uint64_t, 15> by_return_{};
  DVec3 low_{std::numeric_limits<double>::infinity()};
  DVec3 high_{-std::numeric_limits<double>::infinity()};
  HeadedFile file_;
};

}  // namespace

std::unique_ptr<ScanWriter> make_scan_las(const std::string& path, ScanHead head) {
  return std::make_unique<ScanLas>(path, std::move(head));
}

}  // namespace meristem

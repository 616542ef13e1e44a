// SPDX-License-Identifier: Apache-2.0
// Writes scans as binary PLY. A comment of blanks in the header reserves space for the numbers of points and shoots,
// which are known only at the end.
#include <limits>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/output/scan/scan_writer.h"
#include "meristem/output/write/append_bytes.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

constexpr std::size_t kRoomForCounts = 40;
constexpr std::size_t kLongestLabel = 255;

/// Returns -1 for the largest number, which marks a missing object, and for all numbers that do not fit.
std::int32_t or_minus_one(std::uint32_t number) {
  return number > static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max())
             ? -1
             : static_cast<std::int32_t>(number);
}

class ScanPly : public ScanWriter {
 public:
  ScanPly(const std::string& path, ScanHead head)
      : head_(std::move(head)), seen_(head_.scanner->labels().shoot_count()), file_(path, header(0, 0)) {}

  void add(std::span<const ScanPoint> points) override {
    count_ += points.size();
    if (count_ > std::numeric_limits<std::int32_t>::max()) {
      throw InputError(Diagnostic{.message = "the scan has more points than PLY can count",
                                  .expected = "a larger step, or a file that ends in .las"});
    }
    seen_.add(points);
    std::string bytes;
    append_points(points, bytes, [](const ScanPoint& point, std::string& out) { append(point, out); });
    file_.write(bytes);
  }

  void finish() override {
    const std::vector<std::uint32_t> shoots = seen_.numbers();
    std::string bytes;
    for (const std::uint32_t shoot : shoots) {
      const std::string label = head_.scanner->labels().shoot_label(shoot).substr(0, kLongestLabel);
      append_bytes(bytes, or_minus_one(shoot));
      append_bytes(bytes, static_cast<std::uint8_t>(label.size()));
      bytes += label;
    }
    file_.write(bytes);
    file_.finish(header(count_, shoots.size()));
  }

 private:
  std::string header(std::size_t points, std::size_t shoots) const {
    const Scanner& scanner = *head_.scanner;
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& line : provenance_lines(head_.provenance)) text += "comment " + line + "\n";
    const std::vector<std::string>& components = scanner.labels().components();
    for (std::size_t k = 0; k < components.size(); ++k) {
      text += fmt::format("comment component {} {}\n", k, single_line(components[k]));
    }
    for (std::size_t k = 0; k < kSurfaceKindNames.size(); ++k) {
      text += fmt::format("comment kind {} {}\n", k, kSurfaceKindNames[k]);
    }
    for (std::size_t k = 0; k < scanner.stations().size(); ++k) {
      const Vec3 station = scanner.stations()[k];
      text += fmt::format("comment station {} {} {} {}\n", k, station.x, station.y, station.z);
    }
    const std::string counts = fmt::format("{}{}", points, shoots);
    text += "comment " + std::string(kRoomForCounts - counts.size(), '.') + "\n";
    text += fmt::format("element vertex {}\n", points);
    for (const char* name : {"x", "y", "z", "range", "true_range", "intensity"}) {
      text += fmt::format("property float {}\n", name);
    }
    text += "property uchar return\nproperty uchar returns\nproperty uchar kind\nproperty ushort order\n";
    for (const char* name : {"station", "tree", "component", "instance", "shoot"}) {
      text += fmt::format("property int {}\n", name);
    }
    text += "property double pulse\n";
    text += fmt::format("element shoot {}\nproperty int shoot\nproperty list uchar uchar label\nend_header\n", shoots);
    return text;
  }

  static void append(const ScanPoint& point, std::string& out) {
    const SurfaceLabel& label = point.label;
    append_bytes(out, point.position);
    append_bytes(out, std::array{point.range, point.true_range, point.intensity});
    append_bytes(out, std::array{point.number, point.count, static_cast<std::uint8_t>(label.kind)});
    append_bytes(out, label.order);
    append_bytes(out, std::array{or_minus_one(point.station), or_minus_one(label.tree), or_minus_one(label.component),
                                 or_minus_one(label.instance), or_minus_one(label.shoot)});
    append_bytes(out, static_cast<double>(point.pulse));
  }

  ScanHead head_;
  ShootsSeen seen_;
  HeadedFile file_;
  std::size_t count_ = 0;
};

}  // namespace

std::unique_ptr<ScanWriter> make_scan_ply(const std::string& path, ScanHead head) {
  return std::make_unique<ScanPly>(path, std::move(head));
}

}  // namespace meristem

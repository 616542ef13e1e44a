// SPDX-License-Identifier: Apache-2.0
// Writes scans as CSV, one row per point, with the names of components and shoots as texts.
#include <string_view>

#include "meristem/output/scan/scan_writer.h"
#include "meristem/output/write/csv.h"

namespace meristem {

namespace {

constexpr std::string_view kScanHeader =
    "x,y,z,range,true_range,intensity,return,returns,station,pulse,kind,tree,component,instance,shoot,label,order\n";

class ScanCsv : public ScanWriter {
 public:
  ScanCsv(const std::string& path, const ScanHead& head) : file_(path), labels_(head.scanner->labels()) {
    for (const std::string& component : labels_.components()) components_.push_back(csv_field(component));
    file_.write(kScanHeader);
  }

  void add(std::span<const ScanPoint> points) override {
    std::string text;
    append_points(points, text, [&](const ScanPoint& point, std::string& out) { append(point, out); });
    file_.write(text);
  }
  void finish() override { file_.commit(); }

 private:
  template <class Number>
  static void append_number(Number number, std::string& out) {
    append_csv_number(number, out);
    out += ',';
  }

  void append(const ScanPoint& point, std::string& out) const {
    const SurfaceLabel& label = point.label;
    for (const float number :
         {point.position.x, point.position.y, point.position.z, point.range, point.true_range, point.intensity}) {
      append_number(number, out);
    }
    append_number(int{point.number}, out);
    append_number(int{point.count}, out);
    append_number(point.station, out);
    append_number(point.pulse, out);
    out += kSurfaceKindNames[static_cast<std::size_t>(label.kind)];
    out += ',';
    if (label.tree != kNoTree) append_csv_number(label.tree, out);
    out += ',';
    out += components_[label.component];
    out += ',';
    append_number(label.instance, out);
    if (label.shoot == kNoShoot) {
      out += ",,\n";
      return;
    }
    append_number(label.shoot, out);
    out += labels_.shoot_label(label.shoot);
    out += ',';
    append_csv_number(int{label.order}, out);
    out += '\n';
  }

  AtomicFile file_;
  const SurfaceLabels& labels_;
  std::vector<std::string> components_;  // as CSV fields
};

}  // namespace

std::unique_ptr<ScanWriter> make_scan_csv(const std::string& path, ScanHead head) {
  return std::make_unique<ScanCsv>(path, head);
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/scan/scan_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "tests/support/sample_plants.h"
#include "tests/support/temporary_folder.h"

namespace meristem::scan_files_test {

/// Returns the bytes at an offset as a number.
template <class Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number{};
  std::memcpy(&number, bytes.data() + offset, sizeof(Number));
  return number;
}

/// A coarse scan of two stems, in all formats and in memory.
class ScanFiles : public testing::Test {
 protected:
  ScanFiles() {
    plant_.materials.emplace_back();
    ScanInstrument& scanner = options_.instrument;
    scanner.step = radians(1.5);
    scanner.lowest = radians(-25);
    scanner.highest = radians(20);
    scanner.farthest = 5;
    // Wide beams, so that some ray hits the thin vine and gives a return of its own before the ground.
    scanner.resolution = 0.05;
    scanner.rays = 7;
    scanner.divergence = 25;
    scanner.threshold = 0;
    options_.around = 2;
    options_.ground = true;
    meshes_ = make_mesh_scene(plant_, {}, progress_);
    scan_ = scan(plant_, {}, meshes_, options_, progress_);
  }

  std::string written(const std::string& name) {
    const Scanner scanner(plant_, {}, meshes_, options_, progress_);
    const std::string path = (folder_.path() / name).string();
    EXPECT_EQ(write_scan(scanner, std::span(&path, 1), {.name = "Fork", .version = "1"}, progress_),
              scan_.points.size());
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

  Plant plant_ = two_stems();
  ScanOptions options_;
  MeshScene meshes_;
  Scan scan_;
  Progress progress_;
  TemporaryFolder folder_;
};

TEST_F(ScanFiles, CsvHasARowPerPointWithItsLabels) {
  const std::string text = written("a.csv");
  EXPECT_TRUE(
      text.starts_with("x,y,z,range,true_range,intensity,return,returns,station,pulse,kind,tree,component,"
                       "instance,shoot,label,order\n"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), scan_.points.size() + 1);
  EXPECT_NE(text.find(",wood,0,tree,0,1,main.1,1\n"), std::string::npos);
  EXPECT_NE(text.find(",wood,1,vine,3,2,main,0\n"), std::string::npos);
  EXPECT_NE(text.find(",ground,,ground,0,,,\n"), std::string::npos);
}

TEST_F(ScanFiles, PlyHasAllPointsAndTheLabelsOfTheirShoots) {
  const std::string bytes = written("a.ply");
  const std::size_t end = bytes.find("end_header\n") + 11;
  const std::string head = bytes.substr(0, end);
  EXPECT_NE(head.find("\nelement vertex " + std::to_string(scan_.points.size()) + "\n"), std::string::npos) << head;
  EXPECT_NE(head.find("\nelement shoot 3\n"), std::string::npos) << head;
  EXPECT_NE(head.find("\ncomment component 1 vine\n"), std::string::npos) << head;
  constexpr std::size_t kRow = 6 * 4 + 3 + 2 + 5 * 4 + 8;
  for (std::size_t k = 0; k < scan_.points.size(); ++k) {
    const ScanPoint& point = scan_.points[k];
    const std::size_t row = end + k * kRow;
    ASSERT_EQ(number_at<Vec3>(bytes, row), point.position) << k;
    ASSERT_EQ(number_at<float>(bytes, row + 16), point.true_range);
    ASSERT_EQ(number_at<std::uint8_t>(bytes, row + 26), static_cast<int>(point.label.kind));
    const auto shoot = number_at<std::int32_t>(bytes, row + 45);
    ASSERT_EQ(shoot, point.label.shoot == kNoShoot ? -1 : static_cast<std::int32_t>(point.label.shoot));
    ASSERT_EQ(number_at<double>(bytes, row + 49), static_cast<double>(point.pulse));
  }
  const std::string shoots = bytes.substr(end + scan_.points.size() * kRow);
  EXPECT_EQ(shoots, std::string("\0\0\0\0\4main\1\0\0\0\6main.1\2\0\0\0\4main", 3 * 5 + 14));
}

/// Checks the bytes against the tables of the specification, not against the writer.
TEST_F(ScanFiles, LasIsAsTheSpecificationSays) {
  const std::string bytes = written("a.las");
  ASSERT_EQ(bytes.substr(0, 4), "LASF");
  EXPECT_EQ(number_at<std::uint8_t>(bytes, 24), 1);
  EXPECT_EQ(number_at<std::uint8_t>(bytes, 25), 4);
  EXPECT_EQ(number_at<std::uint16_t>(bytes, 94), 375);
  const auto first = number_at<std::uint32_t>(bytes, 96);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 100), 1U) << "records before the points";
  EXPECT_EQ(number_at<std::uint8_t>(bytes, 104), 6) << "point format";
  const auto length = number_at<std::uint16_t>(bytes, 105);
  const auto count = number_at<std::uint64_t>(bytes, 247);
  ASSERT_EQ(count, scan_.points.size());
  std::uint64_t of_returns = 0;
  for (std::size_t k = 0; k < 15; ++k) of_returns += number_at<std::uint64_t>(bytes, 255 + 8 * k);
  EXPECT_EQ(of_returns, count);

  // The record that describes the extra bytes lies between header and points.
  EXPECT_EQ(bytes.substr(377, 9), "LASF_Spec");
  EXPECT_EQ(number_at<std::uint16_t>(bytes, 393), 4);
  EXPECT_EQ(first, 375U + 54 + number_at<std::uint16_t>(bytes, 395));
  const std::array<std::size_t, 11> sizes{0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  std::size_t place = 30;
  std::map<std::string, std::size_t> places;
  for (std::size_t at = 375 + 54; at < first; at += 192) {
    places[bytes.c_str() + at + 4] = place;
    place += sizes[number_at<std::uint8_t>(bytes, at + 2)];
  }
  EXPECT_EQ(place, length);

  const auto scale = number_at<double>(bytes, 131);
  double high = -1e9;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = first + k * length;
    const ScanPoint& point = scan_.points[k];
    ASSERT_NEAR(number_at<std::int32_t>(bytes, row) * scale, point.position.x, 6e-5);
    ASSERT_NEAR(number_at<std::int32_t>(bytes, row + 4) * scale, -point.position.z, 6e-5);
    ASSERT_NEAR(number_at<std::int32_t>(bytes, row + 8) * scale, point.position.y, 6e-5);
    high = std::max(high, number_at<std::int32_t>(bytes, row + 8) * scale);
    ASSERT_EQ(number_at<std::uint8_t>(bytes, row + 14) & 15, point.number);
    ASSERT_EQ(number_at<std::uint8_t>(bytes, row + 14) >> 4, point.count);
    ASSERT_EQ(number_at<std::uint8_t>(bytes, row + 16), point.label.kind == SurfaceKind::ground ? 2 : 5);
    ASSERT_EQ(number_at<std::uint16_t>(bytes, row + 20), point.station + 1);
    ASSERT_EQ(number_at<std::uint32_t>(bytes, row + places.at("shoot")), point.label.shoot);
    ASSERT_EQ(number_at<std::uint16_t>(bytes, row + places.at("order")), point.label.order);
    ASSERT_EQ(number_at<float>(bytes, row + places.at("true_range")), point.true_range);
  }
  EXPECT_NEAR(number_at<double>(bytes, 211), high, 1e-9) << "greatest z";
  const auto records = number_at<std::uint64_t>(bytes, 235);
  EXPECT_EQ(records, first + count * length);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 243), 2U);
  EXPECT_EQ(bytes.substr(records + 2, 8), "meristem");
  EXPECT_EQ(bytes.substr(records + 60, 14), "0,tree\n1,vine\n");
  EXPECT_TRUE(bytes.ends_with("0,main\n1,main.1\n2,main\n"));
}

TEST_F(ScanFiles, AreTheSameOnAnyNumberOfThreads) {
  for (const std::string name : {"a.ply", "a.las", "a.csv"}) {
    const std::string one = [&] {
      const ThreadLimit limit(1);
      return written(name);
    }();
    const ThreadLimit limit(3);
    EXPECT_EQ(written(name), one) << name;
  }
}

TEST(ScanFormats, RefusalsNameTheEndings) {
  EXPECT_EQ(scan_format_of("a/b.LAS").ending, ".las");
  EXPECT_EQ(scan_format_of("-").ending, ".ply");
  try {
    scan_format_of("oak.laz");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].message, "'.laz' is not a format that scans are written to");
    EXPECT_EQ(error.diagnostics()[0].nearest, ".las");
  }
}

}  // namespace meristem::scan_files_test

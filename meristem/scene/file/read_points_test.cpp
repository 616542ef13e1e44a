// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/file/read_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace meristem::read_points_test {

const std::array<DVec3, 2> kTwo{DVec3(1, 2.5, -3), DVec3(4, 5, 6e-3)};

PointCloud parse(std::string_view bytes, std::uint64_t limit = 100) {
  SizeLimits limits;
  limits.points = limit;
  return parse_points(bytes, "scan", limits);
}

std::string error(std::string_view bytes) {
  try {
    parse(bytes);
  } catch (const InputError& error) {
    return error.diagnostics().at(0).text();
  }
  return "no fault";
}

void expect_two(std::string_view bytes) {
  const PointCloud points = parse(bytes);
  ASSERT_EQ(points.size(), 2U) << bytes;
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(glm::length(points[k] - kTwo[k]), 1e-6) << bytes;
}

template <class T>
void append(std::string& bytes, T value, bool is_big) {
  std::array<char, sizeof(T)> raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (is_big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

// A scan with another element first, a list in each vertex, and every type.
std::string binary_ply(bool is_big) {
  std::string bytes =
      "ply\r\nformat binary_" + std::string(is_big ? "big" : "little") +
      "_endian 1.0\r\ncomment made here\r\nelement camera 1\r\nproperty short tilt\r\n"
      "element vertex 2\r\nproperty uchar red\r\nproperty double z\r\nproperty list int8 uint16 seen\r\n"
      "property float x\r\nproperty int32 time\r\nproperty float32 y\r\nend_header\r\n";
  append(bytes, std::int16_t{-7}, is_big);
  for (const DVec3 point : kTwo) {
    append(bytes, std::uint8_t{200}, is_big);
    append(bytes, point.z, is_big);
    append(bytes, std::int8_t{3}, is_big);
    for (std::uint16_t k = 0; k < 3; ++k) append(bytes, k, is_big);
    append(bytes, static_cast<float>(point.x), is_big);
    append(bytes, std::int32_t{-1}, is_big);
    append(bytes, static_cast<float>(point.y), is_big);
  }
  return bytes;
}

constexpr const char* kAscii =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty list uchar int n\nproperty double y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "1 2 7 7 2.5 -3\n4 0 5 6e-3\n3 0 1 0\n";

TEST(ReadPoints, ReadsEveryKindOfPly) {
  expect_two(kAscii);
  expect_two(binary_ply(false));
  expect_two(binary_ply(true));
}

TEST(ReadPoints, ReadsTextWithAnySeparators) {
  expect_two("1 2.5 -3\n4 5 6e-3");
  expect_two("x;y;z;intensity\r\n1;2.5;-3;0.4\r\n4;5;6e-3;0.5\r\n");
  expect_two("# a scan\n// of a tree\n\nX,Y,Z\n1,2.5,-3\n\n  \t4,+5,0.006 # the top\n");
  expect_two("1\t2.5\t-3\t255\tabc\n4\t5\t6E-3\n");
}

TEST(ReadPoints, KeepsTheCoordinatesOfAWholeCountry) {
  EXPECT_EQ(parse("446123.125 5712345.0625 12.5")[0], DVec3(446123.125, 5712345.0625, 12.5));
}

TEST(ReadPoints, EveryFaultOfATextHasItsLine) {
  EXPECT_EQ(error("1 2 3\n4 5\n"), "scan:2:4: the line has no z; expected three numbers x, y, z");
  EXPECT_EQ(error("1 2 3\n4 five 6\n"), "scan:2:3: 'five' is not a number; expected y (m)");
  EXPECT_EQ(error("x y z\n1 2 3\nx y z\n"), "scan:3:1: 'x' is not a number; expected x (m)");
  EXPECT_EQ(error("1 2 3\n\n1 2 nan\n"), "scan:3:5: z is not a finite number; expected a number (m)");
  EXPECT_EQ(error("inf 2 3\n"), "scan:1:1: x is not a finite number; expected a number (m)");
  EXPECT_EQ(error("1 2 1e999\n"), "scan:1:5: z is not a finite number; expected a number (m)");
  EXPECT_EQ(error("1 -2e12 3\n"), "scan:1:3: '-2e12' is out of range; expected a coordinate from -1e+12 to 1e+12");
  EXPECT_EQ(error("# nothing\n"), "scan: the file has no points; expected a point or more");
  EXPECT_THROW(parse("1 2 3\n1 2 3\n1 2 3\n", 2), InputError);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  text.replace(text.find(what), what.size(), with);
  return text;
}

TEST(ReadPoints, EveryFaultOfAPlyHasItsPlace) {
  const auto with = [](const std::string& what, const std::string& instead) {
    return error(replaced(kAscii, what, instead));
  };
  EXPECT_EQ(with("vertex 2", "vertx 2"),
            "scan: the file has no element 'vertex'; expected an element 'vertex' with the properties x, y and z; did "
            "you mean 'vertx'?");
  EXPECT_EQ(with("double y", "double Y"),
            "scan: the element 'vertex' has no property 'y'; expected 'y' beside x, n, Y, z; did you mean 'Y'?");
  EXPECT_EQ(with("ascii", "asci"),
            "scan:2:8: 'asci' is not a format; expected one of ascii, binary_little_endian, binary_big_endian; did you "
            "mean 'ascii'?");
  EXPECT_EQ(with("double y", "doubel y").substr(0, 34), "scan:6:10: 'doubel' is not a type;");
  EXPECT_EQ(with("element vertex 2", "element vertex two"),
            "scan:3:16: 'two' is not a number of rows; expected a whole number of at least 0");
  EXPECT_EQ(with("end_header", "endheader").substr(0, 45), "scan:10:1: 'endheader' has no meaning in a he");
  EXPECT_EQ(with("2.5 -3", "2.5 nan"), "scan:11: row 1 of 'vertex': z is not a finite number; expected a number (m)");
  EXPECT_EQ(with("2.5 -3", "2.5 1e13"),
            "scan:11: row 1 of 'vertex': z = 1e+13 is out of range; expected a coordinate from -1e+12 to 1e+12");
  EXPECT_EQ(with("4 0 5", "4 0 five"), "scan:12: row 2 of 'vertex': 'five' is not a number; expected a number");
  EXPECT_EQ(with("4 0 5 6e-3\n3 0 1 0\n", "4 0 5"),
            "scan:12: row 2 of 'vertex': the file is cut off here; expected the whole file");
  EXPECT_EQ(with("4 0 5", "4 999 5"),
            "scan:12: row 2 of 'vertex': the list 'n' has 999 entries, which the file cannot hold");
  EXPECT_NE(error("ply\nformat ascii 1.0\nelement vertex 1\n").find("the header does not end"), std::string::npos);
  const std::string binary = binary_ply(true);
  EXPECT_NE(error(std::string_view(binary).substr(0, binary.size() - 2)).find("row 2 of 'vertex': the file is cut off"),
            std::string::npos);
}

TEST(ReadPoints, AHeaderThatPromisesTooMuchIsRefusedBeforeTheMemoryIsSpent) {
  const std::string huge = replaced(kAscii, "vertex 2", "vertex 1000000000");
  EXPECT_NE(error(huge).find("1000000000 points of a file are too many"), std::string::npos);
  try {
    parse(huge, 4'000'000'000U);
    ADD_FAILURE() << "no fault";
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("the header declares 1000000000 rows of 'vertex', but the file is cut off"),
        std::string::npos)
        << error.what();
  }
  const std::string other =
      replaced(kAscii, "element vertex", "element strip 99999999999\nproperty int a\nelement vertex");
  EXPECT_NE(error(other).find("declares 99999999999 rows of 'strip'"), std::string::npos);
  // Rows without properties take no space, for any number of rows.
  expect_two(replaced(kAscii, "element vertex", "element strip 99999999999\nelement vertex"));
}

TEST(ReadPoints, FilesThatAreNoneHaveTheirOwnFaults) {
  const TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  std::ofstream(folder / "scan.xyz") << "1 2 3\n";
  std::ofstream(folder / "empty.xyz").close();
  const auto error_of = [&](const std::filesystem::path& path) {
    try {
      read_points(path, SizeLimits{});
    } catch (const InputError& error) {
      return error.diagnostics().at(0);
    }
    return Diagnostic{};
  };
  EXPECT_EQ(read_points(folder / "scan.xyz", SizeLimits{}).size(), 1U);
  EXPECT_EQ(error_of(folder / "scam.xyz").message, "there is no such file");
  EXPECT_EQ(error_of(folder / "scam.xyz").nearest, (folder / "scan.xyz").string());
  EXPECT_EQ(error_of(folder / "empty.xyz").message, "the file is empty");
  EXPECT_EQ(error_of(folder).message, "this is a folder");
  EXPECT_EQ(error_of("/dev/zero").message, "this is not a regular file");
  EXPECT_EQ(error_of("").message, "there is no such file");
  SizeLimits small;
  small.file_bytes = 5;
  EXPECT_THROW(read_points(folder / "scan.xyz", small), InputError);
}

}  // namespace meristem::read_points_test

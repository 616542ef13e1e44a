// SPDX-License-Identifier: Apache-2.0
// That other programs read the archives, tests/studio/studio_test.py sees.
#include "zip_file.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace meristem::studio::zip_file_test {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::uint32_t number_at(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t number = 0;
  for (int k = size - 1; k >= 0; --k)
    number = number << 8U | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
  return number;
}

TEST(ZipFile, HoldsFilesUncompressedBehindTheirHeaders) {
  const TemporaryFolder folder;
  const std::string path = (folder / "all.zip").string();
  std::ofstream(folder / "a.txt", std::ios::binary) << "123456789";
  std::ofstream(folder / "b.txt", std::ios::binary);
  write_zip({(folder / "a.txt").string(), (folder / "b.txt").string()}, path, Progress());
  const std::string bytes = bytes_of(folder / "all.zip");
  EXPECT_EQ(number_at(bytes, 0, 4), 0x04034b50U);
  EXPECT_EQ(number_at(bytes, 14, 4), 0xCBF43926U);  // the published checksum of these nine digits
  EXPECT_EQ(number_at(bytes, 22, 4), 9U);
  EXPECT_EQ(bytes.substr(30, 14), "a.txt123456789");
  const std::size_t end = bytes.size() - 22;
  EXPECT_EQ(number_at(bytes, end, 4), 0x06054b50U);
  EXPECT_EQ(number_at(bytes, end + 10, 2), 2U);
  EXPECT_EQ(number_at(bytes, number_at(bytes, end + 16, 4), 4), 0x02014b50U);
}

TEST(ZipFile, TheSameFilesGiveTheSameBytes) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "the same";
  const std::vector<std::string> files{(folder / "a.txt").string()};
  write_zip(files, (folder / "one.zip").string(), Progress());
  write_zip(files, (folder / "two.zip").string(), Progress());
  EXPECT_EQ(bytes_of(folder / "one.zip"), bytes_of(folder / "two.zip"));
}

TEST(ZipFile, WithoutAFileThereIsNoArchive) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_zip({(folder / "none").string()}, (folder / "all.zip").string(), Progress()), MachineError);
  EXPECT_FALSE(std::filesystem::exists(folder / "all.zip"));
}

}  // namespace meristem::studio::zip_file_test

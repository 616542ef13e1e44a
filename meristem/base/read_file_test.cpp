// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/read_file.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace meristem::read_file_test {

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Returns the error of reading a path, with at most 10 bytes.
Diagnostic error_of(const std::string& path) {
  try {
    read_file(path, 10);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U);
    return error.diagnostics()[0];
  }
  ADD_FAILURE() << path << " was read";
  return {};
}

TEST(ReadFile, GivesAllBytesUpToTheLimit) {
  const TemporaryFolder folder;
  const std::string bytes("a\0\r\nb\xff 789", 10);
  write(folder / "ten", bytes);
  EXPECT_EQ(read_file((folder / "ten").string(), 10), bytes);
}

TEST(ReadFile, AMissingFileIsAnErrorWithTheNearestNameOfItsFolder) {
  const TemporaryFolder folder;
  write(folder / "leaves.csv", "x");
  write(folder / "other.obj", "x");
  const Diagnostic error = error_of((folder / "leafs.csv").string());
  EXPECT_EQ(error.message, "there is no such file");
  EXPECT_EQ(error.nearest, (folder / "leaves.csv").string());
  EXPECT_EQ(error.file, (folder / "leafs.csv").string());
  EXPECT_EQ(error_of((folder / "nothing like it at all").string()).nearest, "");
  EXPECT_EQ(error_of((folder / "no folder/leaves.csv").string()).message, "there is no such file");
}

TEST(ReadFile, PathsThatNoFileCanHaveAreErrors) {
  EXPECT_EQ(error_of("").message, "there is no such file");
  const TemporaryFolder folder;
  write(folder / "a", "x");
  EXPECT_EQ(error_of((folder / "a").string() + std::string("\0b", 2)).message, "there is no such file");
}

TEST(ReadFile, WhatIsNoPlainFileIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(folder.path().string()).message, "this is a folder");
  EXPECT_EQ(error_of("/dev/null").message, "this is not a regular file");
}

TEST(ReadFile, EmptyFilesAreErrors) {
  const TemporaryFolder folder;
  write(folder / "empty", "");
  EXPECT_EQ(error_of((folder / "empty").string()).message, "the file is empty");
}

TEST(ReadFile, AFileOverTheLimitIsAnErrorThatNamesTheLimit) {
  const TemporaryFolder folder;
  write(folder / "eleven", "12345678901");
  const Diagnostic error = error_of((folder / "eleven").string());
  EXPECT_EQ(error.file, (folder / "eleven").string());
  EXPECT_NE(error.text().find("11 bytes of a file are too many"), std::string::npos) << error.text();
  EXPECT_NE(error.text().find("limits.file_bytes"), std::string::npos) << error.text();
}

}  // namespace meristem::read_file_test

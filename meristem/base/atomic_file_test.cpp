// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/atomic_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/temporary_folder.h"

namespace meristem::atomic_file_test {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

void put(AtomicFile& file, std::string_view text) { file.write(text.data(), text.size()); }

/// Writes a file with this text.
void write_file(const fs::path& path, std::string_view text) {
  AtomicFile file(path.string());
  put(file, text);
  file.commit();
}

/// Returns the error message of opening `path`, writing `size` bytes and committing.
std::string complaint(const std::string& path, std::size_t size = 1) {
  try {
    AtomicFile file(path);
    put(file, std::string(size, 'x'));
    file.commit();
  } catch (const MachineError& error) {
    return error.what();
  }
  return {};
}

class AtomicFileTest : public testing::Test {
 protected:
  fs::path at(const std::string& name) const { return folder_ / name; }
  std::ptrdiff_t entry_count() const { return std::distance(fs::directory_iterator(folder_), {}); }

 private:
  const TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(AtomicFileTest, AppearsWholeWhenCommitted) {
  AtomicFile file(at("oak.glb").string());
  put(file, "leaves");
  const std::vector<std::uint16_t> numbers = {0x4241, 0x4443};
  file.write(std::span<const std::uint16_t>(numbers));
  EXPECT_EQ(file.size(), 10U);
  EXPECT_FALSE(fs::exists(at("oak.glb")));
  file.commit();
  EXPECT_EQ(content_of(at("oak.glb")), "leavesABCD");
  EXPECT_EQ(entry_count(), 1);
}

TEST_F(AtomicFileTest, LeavesNothingAndChangesNothingWithoutCommit) {
  write_file(at("old"), "before");
  for (const char* name : {"old", "new"}) {
    AtomicFile file(at(name).string());
    put(file, std::string(3'000'000, 'x'));
  }
  EXPECT_EQ(content_of(at("old")), "before");
  EXPECT_EQ(entry_count(), 1);
}

TEST_F(AtomicFileTest, KeepsBytesInOrderAcrossItsBuffer) {
  std::string expected;
  AtomicFile file(at("bytes").string());
  for (const std::size_t size : {1UL, 1'048'575UL, 1UL, 1'048'576UL, 3'000'000UL, 7UL, 0UL, 600'000UL, 600'000UL}) {
    const std::string chunk(size, static_cast<char>('a' + expected.size() % 26));
    put(file, chunk);
    expected += chunk;
  }
  EXPECT_EQ(file.size(), expected.size());
  file.commit();
  EXPECT_TRUE(content_of(at("bytes")) == expected);
}

TEST_F(AtomicFileTest, WritesOverWhatItHoldsAlready) {
  AtomicFile file(at("a").string());
  put(file, "00000 points\n");
  file.overwrite(0, "12345");
  put(file, "more\n");
  file.overwrite(6, "P");
  EXPECT_THROW(file.overwrite(17, "xx"), std::invalid_argument);
  file.commit();
  EXPECT_EQ(content_of(at("a")), "12345 Points\nmore\n");
  EXPECT_THROW(file.overwrite(0, "x"), std::invalid_argument);
  AtomicFile stream("-");
  EXPECT_THROW(stream.overwrite(0, ""), std::invalid_argument);
}

TEST_F(AtomicFileTest, ReadsBackWhatWasWritten) {
  AtomicFile file(at("oak.json").string());
  const std::string text(3'000'000, 'x');
  put(file, text);
  EXPECT_TRUE(file.holds(text));
  EXPECT_FALSE(file.holds(text + "y"));
  EXPECT_FALSE(file.holds(std::string_view(text).substr(1)));
  for (const fs::directory_entry& temporary : fs::directory_iterator(at(""))) {
    std::fstream other(temporary.path(), std::ios::binary | std::ios::in | std::ios::out);
    other.seekp(2'000'000);
    other.put('!');
  }
  EXPECT_FALSE(file.holds(text));
}

TEST_F(AtomicFileTest, ReplacesAFileAndKeepsItsPermissions) {
  write_file(at("file"), "before");
  fs::permissions(at("file"), fs::perms(0640));
  write_file(at("file"), "");
  EXPECT_EQ(content_of(at("file")), "");
  EXPECT_EQ(fs::status(at("file")).permissions(), fs::perms(0640));
}

TEST_F(AtomicFileTest, GivesANewFileThePermissionsOfTheUmask) {
  const mode_t before = ::umask(0027);
  write_file(at("file"), "x");
  ::umask(before);
  EXPECT_EQ(fs::status(at("file")).permissions(), fs::perms(0640));
}

TEST_F(AtomicFileTest, FollowsLinksAlsoToFilesThatDoNotExistYet) {
  fs::create_directory(at("folder"));
  fs::create_symlink("folder/target", at("link"));
  fs::create_symlink("link", at("link_to_link"));
  for (const char* text : {"first", "second"}) {
    write_file(at("link_to_link"), text);
    EXPECT_EQ(content_of(at("folder/target")), text);
    EXPECT_TRUE(fs::is_symlink(at("link_to_link")));
    EXPECT_TRUE(fs::is_symlink(at("link")));
  }
}

TEST_F(AtomicFileTest, TakesTheLongestNames) {
  const std::string name(255, 'n');
  write_file(at(name), "x");
  EXPECT_EQ(content_of(at(name)), "x");
}

TEST_F(AtomicFileTest, TwoWritersOfOnePathDoNotMix) {
  AtomicFile first(at("file").string());
  AtomicFile second(at("file").string());
  put(first, "first");
  put(second, "second");
  second.commit();
  EXPECT_EQ(content_of(at("file")), "second");
  first.commit();
  EXPECT_EQ(content_of(at("file")), "first");
  EXPECT_EQ(entry_count(), 1);
}

TEST_F(AtomicFileTest, FullDeviceIsAnErrorWithPathAndReason) {
  EXPECT_EQ(complaint("/dev/full"), "cannot write '/dev/full': No space left on device");
  EXPECT_EQ(complaint("/dev/full", 5'000'000), "cannot write '/dev/full': No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFileTest, FullDiskLeavesTheOldFileAndNoRemains) {
  write_file(at("file"), "before");
  const FileSizeLimit limit(2'000'000);
  EXPECT_TRUE(complaint(at("file").string(), 5'000'000).ends_with("File too large"));
  EXPECT_EQ(content_of(at("file")), "before");
  EXPECT_EQ(entry_count(), 1);
}

TEST_F(AtomicFileTest, RejectsPathsThatCannotBeWritten) {
  write_file(at("file"), "before");
  fs::create_symlink("loop", at("loop"));
  const auto path = [&](const std::string& name) { return at(name).string(); };
  EXPECT_EQ(complaint(path("missing/file")), "cannot write '" + path("missing/file") + "': No such file or directory");
  EXPECT_EQ(complaint(path("file/inside")), "cannot write '" + path("file/inside") + "': Not a directory");
  EXPECT_EQ(complaint(path("file/")), "cannot write '" + path("file/") + "': Not a directory");
  EXPECT_EQ(complaint(path("")), "cannot write '" + path("") + "': Is a directory");
  EXPECT_EQ(complaint(path("loop")), "cannot write '" + path("loop") + "': Too many levels of symbolic links");
  EXPECT_EQ(complaint(""), "cannot write '': No such file or directory");
  EXPECT_TRUE(complaint(path(std::string(256, 'n'))).ends_with("File name too long"));
  EXPECT_EQ(content_of(at("file")), "before");
  EXPECT_EQ(entry_count(), 2);
}

TEST_F(AtomicFileTest, RejectsAReadOnlyFileAndAReadOnlyDirectory) {
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write anywhere";
  write_file(at("file"), "before");
  fs::permissions(at("file"), fs::perms(0444));
  EXPECT_TRUE(complaint(at("file").string()).ends_with("Permission denied"));
  fs::create_directory(at("folder"));
  fs::permissions(at("folder"), fs::perms(0555));
  EXPECT_TRUE(complaint(at("folder/file").string()).ends_with("Permission denied"));
  EXPECT_EQ(content_of(at("file")), "before");
}

TEST_F(AtomicFileTest, WritesStraightThroughAPipe) {
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = content_of(at("pipe")); });
  write_file(at("pipe"), std::string(2'000'000, 'x'));
  reader.join();
  EXPECT_TRUE(received == std::string(2'000'000, 'x'));
  EXPECT_TRUE(fs::is_fifo(at("pipe")));
}

TEST_F(AtomicFileTest, DashAndDevStdoutAreStandardOutput) {
  for (const char* path : {"-", "/dev/stdout"}) {
    testing::internal::CaptureStdout();
    write_file(path, "to the screen");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "to the screen");
  }
  EXPECT_FALSE(fs::exists("-"));
}

TEST_F(AtomicFileTest, TellsOfAFullDisk) {
  const FileSizeLimit limit(1000);
  AtomicFile file(at("file").string());
  put(file, std::string(2000, 'x'));
  EXPECT_THROW(file.commit(), MachineError);
  EXPECT_THROW(file.commit(), std::invalid_argument);
}

TEST_F(AtomicFileTest, EndsWithCommitOrFailure) {
  AtomicFile file(at("file").string());
  file.commit();
  EXPECT_THROW(put(file, "more"), std::invalid_argument);
  EXPECT_THROW(file.commit(), std::invalid_argument);

  AtomicFile failed("/dev/full");
  EXPECT_THROW(put(failed, std::string(5'000'000, 'x')), MachineError);
  EXPECT_THROW(put(failed, "more"), std::invalid_argument);
  EXPECT_THROW(failed.commit(), std::invalid_argument);
}

TEST_F(AtomicFileTest, FilesOfASetAppearTogether) {
  write_file(at("first"), "before");
  FileSet set;
  write_file(at("first"), "after");
  write_file(at("second"), "new");
  EXPECT_EQ(content_of(at("first")), "before");
  EXPECT_FALSE(fs::exists(at("second")));
  set.commit();
  EXPECT_EQ(content_of(at("first")), "after");
  EXPECT_EQ(content_of(at("second")), "new");
  EXPECT_EQ(entry_count(), 2);
}

TEST_F(AtomicFileTest, SetWithoutCommitLeavesNothing) {
  write_file(at("first"), "before");
  {
    const FileSet set;
    write_file(at("first"), "after");
    write_file(at("second"), "new");
  }
  EXPECT_EQ(content_of(at("first")), "before");
  EXPECT_EQ(entry_count(), 1);
  write_file(at("third"), "by itself");
  EXPECT_EQ(content_of(at("third")), "by itself");
}

TEST_F(AtomicFileTest, InnerSetHandsItsFilesToTheOuterOne) {
  FileSet outer;
  {
    FileSet inner;
    write_file(at("kept"), "kept");
    inner.commit();
  }
  {
    const FileSet dropped;
    write_file(at("dropped"), "dropped");
  }
  EXPECT_FALSE(fs::exists(at("kept")));
  outer.commit();
  EXPECT_EQ(content_of(at("kept")), "kept");
  EXPECT_EQ(entry_count(), 1);
}

TEST_F(AtomicFileTest, SetTellsOfARenamingThatIsRefused) {
  fs::create_directory(at("folder"));
  FileSet set;
  write_file(at("folder/file"), "text");
  write_file(at("other"), "text");
  fs::remove_all(at("folder"));
  EXPECT_THROW(set.commit(), MachineError);
  EXPECT_FALSE(fs::exists(at("other")));
}

TEST_F(AtomicFileTest, StandardOutputWaitsForNoSet) {
  const FileSet set;
  testing::internal::CaptureStdout();
  write_file("-", "to the screen");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "to the screen");
}

}  // namespace meristem::atomic_file_test

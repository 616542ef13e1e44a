// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/left_over.h"

#include <filesystem>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace meristem::left_over_test {

namespace fs = std::filesystem;

/// Runs `body` in a separate process that ends right after it without destructors, like a killed process.
template <class Body>
void in_a_process_that_is_killed(Body body) {
  const pid_t child = ::fork();
  if (child == 0) {
    body();
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
}

std::size_t entry_count(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(LeftOver, FileOfAKilledProcessGoesWithTheNextFile) {
  const TemporaryFolder folder;
  in_a_process_that_is_killed([&] {
    auto* const file = new AtomicFile(folder / "oak.glb");
    file->write("half");
  });
  ASSERT_EQ(entry_count(folder.path()), 1U);
  write_whole_file(folder / "elm.glb", "whole");
  EXPECT_EQ(entry_count(folder.path()), 1U);
  EXPECT_TRUE(fs::exists(folder / "elm.glb"));
}

TEST(LeftOver, FilesOfALivingProcessStay) {
  const TemporaryFolder folder;
  AtomicFile open(folder / "open.glb");
  open.write("half");
  FileSet set;
  write_whole_file(folder / "waiting.glb", "whole");
  ASSERT_EQ(entry_count(folder.path()), 2U);
  in_a_process_that_is_killed([&] {
    remove_left_over_files_once((folder / "").string());
    remove_left_over_files_once(folder.path().string());
  });
  ASSERT_EQ(entry_count(folder.path()), 2U) << "one is open, one waits for its set";
  set.commit();
  EXPECT_EQ(whole_file(folder / "waiting.glb"), "whole");
}

TEST(LeftOver, OneLockProtectsAllFilesOfASet) {
  const TemporaryFolder folder;
  constexpr std::size_t kFiles = 250;  // more than the number of locks that a set keeps
  FileSet set;
  for (std::size_t k = 0; k < kFiles; ++k) write_whole_file(folder / ("leaf" + std::to_string(k)), "whole");
  in_a_process_that_is_killed([&] { remove_left_over_files_once(folder.path().string()); });
  EXPECT_EQ(entry_count(folder.path()), kFiles);
  set.commit();
  EXPECT_EQ(whole_file(folder / "leaf249"), "whole");
}

TEST(LeftOver, FolderOfAKilledProcessGoesAndThatOfALivingOneStays) {
  const TemporaryFolder folder;
  in_a_process_that_is_killed([&] {
    const auto* const scratch = new ScratchFolder(folder.path(), "draft-");
    write_whole_file(scratch->path() + "/oak.png", "oak");
  });
  ASSERT_EQ(entry_count(folder.path()), 1U);
  const std::string left = fs::directory_iterator(folder.path())->path();
  const ScratchFolder own(folder.path(), "draft-");
  EXPECT_FALSE(fs::exists(left));
  in_a_process_that_is_killed([&] { const ScratchFolder other((folder / "").string(), "draft-"); });
  EXPECT_TRUE(fs::exists(own.path()));
  EXPECT_FALSE(remove_left_over(own.path(), WithoutLocks::remove));
}

TEST(LeftOver, NamesOfOthersStay) {
  const TemporaryFolder folder;
  for (const char* const name : {"oak.glb", ".oak.glb.part", ".oak.glb.12-x.part", ".12-3.part", "oak.1-2.part"}) {
    EXPECT_FALSE(is_temporary_name(name)) << name;
    write_whole_file(folder / name, "mine");
  }
  for (const char* const name : {"draft-", "draft-abcdef", "draft-12abcdef", "draft-x12-abcdef"}) {
    make_folders(folder / name);
  }
  EXPECT_TRUE(is_temporary_name(temporary_name(std::string(300, 'x'), 7)));
  EXPECT_LE(temporary_name(std::string(300, 'x'), 4294967295U).size(), 255U);
  const std::size_t before = entry_count(folder.path());
  in_a_process_that_is_killed([&] {
    remove_left_over_files_once(folder.path());
    remove_left_over_folders_once(folder.path(), "draft-");
  });
  EXPECT_EQ(entry_count(folder.path()), before);
}

TEST(LeftOver, ALockThatComesTooLateIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder / temporary_name("oak", 0);
  const int owner = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  EXPECT_TRUE(remove_left_over(path)) << "it has no lock yet";
  EXPECT_FALSE(lock_temporary(owner));
  ::close(owner);
  EXPECT_TRUE(remove_left_over(path)) << "nothing is there";
}

}  // namespace meristem::left_over_test

// SPDX-License-Identifier: Apache-2.0
#include "downloads.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"

namespace meristem::studio::downloads_test {

namespace fs = std::filesystem;

void write(const Downloads::Draft& draft) { std::ofstream(fs::path(draft.path()) / "oak.png") << "oak"; }

TEST(Downloads, ADraftOutlivesTheFilesThatAreKeptMeanwhile) {
  Downloads downloads;
  const auto film = downloads.begin();
  write(*film);
  for (int k = 0; k < 12; ++k) {
    const auto still = downloads.begin();
    write(*still);
    downloads.keep(*still);
  }
  EXPECT_TRUE(fs::exists(fs::path(film->path()) / "oak.png"));
  EXPECT_FALSE(downloads.find(1, "oak.png"));
  EXPECT_TRUE(downloads.find(12, "oak.png"));
  EXPECT_EQ(downloads.keep(*film), 13U);
  EXPECT_TRUE(downloads.find(13, "oak.png"));
}

TEST(Downloads, ADraftThatIsNotKeptLeavesNothing) {
  Downloads downloads;
  fs::path path;
  {
    const auto draft = downloads.begin();
    write(*draft);
    path = draft->path();
    EXPECT_FALSE(downloads.find(1, "oak.png"));
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::is_empty(path.parent_path()));
}

TEST(Downloads, ThoseOfAKilledStudioGoAtTheNextStart) {
  const TemporaryFolder folder;
  ASSERT_EQ(::setenv("TMPDIR", folder.path().c_str(), 1), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    auto* const downloads = new Downloads;
    const auto draft = downloads->begin();
    write(*draft);
    downloads->keep(*draft);
    ::_exit(0);  // as a killed one: no destructors
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_FALSE(fs::is_empty(folder.path()));
  const Downloads downloads;
  EXPECT_TRUE(fs::is_empty(folder.path()));
  ::unsetenv("TMPDIR");
}

}  // namespace meristem::studio::downloads_test

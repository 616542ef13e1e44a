// SPDX-License-Identifier: Apache-2.0
#include "open_files.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "test_studio.h"

namespace meristem::studio::open_files_test {

TEST(OpenFile, CountsOthersOfTheSameFileWhileTheyLive) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "bush.json").string();
  const OpenFile first(path);
  EXPECT_EQ(first.others(), 0);
  {
    const OpenFile second(path);
    const OpenFile other(path + "x");
    EXPECT_EQ(first.others(), 1);
    EXPECT_EQ(second.others(), 1);
    EXPECT_EQ(other.others(), 0);
  }
  EXPECT_EQ(first.others(), 0);
}

TEST(OpenFile, SeesAnotherProgramAndForgetsAKilledOne) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "bush.json").string();
  const OpenFile first(path);
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const OpenFile second(path);
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(1);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_EQ(first.others(), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(first.others(), 0);
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST(OpenFileWatch, AnnouncesASecondPageToBoth) {
  Studio studio;
  studio.open_bush();
  const auto second_mailbox = std::make_shared<Mailbox>();
  StudioSession second(studio.host(), second_mailbox);
  second.receive(R"({"do": "open", "id": 1, "path": "bush.json"})");
  const auto is_elsewhere = [](const Value& message) { return Studio::text_of(message, "is") == "elsewhere"; };
  for (Mailbox* mailbox : {second_mailbox.get(), &studio.mailbox()}) {
    const Value message = mailbox->wait_for(is_elsewhere);
    EXPECT_EQ(Studio::text_of(message, "path"), "bush.json");
    EXPECT_EQ(*message.find("count")->number(), 1);
  }
  second.receive(R"({"do": "open", "id": 2, "model": "sunflower"})");
  studio.mailbox().wait_for(
      [&](const Value& message) { return is_elsewhere(message) && *message.find("count")->number() == 0; });
}

}  // namespace meristem::studio::open_files_test

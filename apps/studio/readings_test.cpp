// SPDX-License-Identifier: Apache-2.0
#include "readings.h"

#include <gtest/gtest.h>

namespace meristem::studio::readings_test {

using Reading = Readings::Reading;

std::string message(const std::string& what, int id, const std::string& more = "") {
  return R"({"do": ")" + what + R"(", "id": )" + std::to_string(id) + more + "}";
}

TEST(Readings, GoOnWhileNothingNewerArrives) {
  Readings readings;
  readings.arrive(message("splice", 1));
  readings.begin_next();
  const Reading reading(readings, 1, MessageKind::text);
  readings.arrive(message("shown", 2));
  EXPECT_FALSE(reading.progress().is_cancelled());
}

TEST(Readings, OfAnOldTextStopWhenANewerTextArrives) {
  Readings readings;
  readings.arrive(message("splice", 1));
  readings.begin_next();
  {
    const Reading reading(readings, 1, MessageKind::text);
    readings.arrive(message("text", 2));
    EXPECT_TRUE(reading.progress().is_cancelled());
  }
  readings.begin_next();
  EXPECT_FALSE(Reading(readings, 2, MessageKind::text).progress().is_cancelled());
}

TEST(Readings, DoNotBeginForAMessageWithANewerTextBehindIt) {
  Readings readings;
  readings.arrive(message("splice", 1));
  readings.arrive(message("splice", 2));
  readings.begin_next();
  EXPECT_TRUE(Reading(readings, 1, MessageKind::text).progress().is_cancelled());
  readings.begin_next();
  EXPECT_FALSE(Reading(readings, 2, MessageKind::text).progress().is_cancelled());
}

TEST(Readings, OfEditsStopForAnotherDocumentAlone) {
  Readings readings;
  readings.arrive(message("edit", 1));
  readings.begin_next();
  const Reading reading(readings, 1, MessageKind::edit);
  readings.arrive(message("splice", 2));
  readings.arrive(message("drag", 3));
  EXPECT_FALSE(reading.progress().is_cancelled());
  readings.arrive(message("open", 4));
  EXPECT_TRUE(reading.progress().is_cancelled());
}

TEST(Readings, OfADragStopForTheNextDrag) {
  Readings readings;
  readings.arrive(message("drag", 1));
  readings.begin_next();
  const Reading reading(readings, 1, MessageKind::drag);
  readings.arrive(message("drag", 2));
  EXPECT_TRUE(reading.progress().is_cancelled());
}

TEST(Readings, StopWhenTheirRequestIsCancelled) {
  Readings readings;
  readings.arrive(message("open", 1));
  readings.begin_next();
  const Reading reading(readings, 1, MessageKind::open);
  readings.arrive(message("cancel", 2, R"(, "re": 7)"));
  EXPECT_FALSE(reading.progress().is_cancelled());
  readings.arrive(message("cancel", 3, R"(, "re": 1)"));
  EXPECT_TRUE(reading.progress().is_cancelled());
}

TEST(Readings, StopForGoodWhenThePageHasGone) {
  Readings readings;
  readings.begin_next();
  {
    const Reading reading(readings, 1, MessageKind::open);
    readings.close();
    EXPECT_TRUE(reading.progress().is_cancelled());
  }
  readings.begin_next();
  EXPECT_TRUE(Reading(readings, 2, MessageKind::other).progress().is_cancelled());
}

TEST(Readings, TellTheKindOfAMessageWhereverItsMembersStand) {
  EXPECT_EQ(message_kind(R"({"id": 1, "text": "{\"do\": \"open\"}", "do": "text"})"), MessageKind::text);
  EXPECT_EQ(message_kind(R"({"values": {"do": "open"}, "do": "drag"})"), MessageKind::drag);
  EXPECT_EQ(message_kind(R"({"do" : "shown"})"), MessageKind::other);
  for (const char* const broken : {"", "{", R"({"do)", R"({"do")", R"({"do":)", R"({"do": 1})", R"({"do": "op)"}) {
    EXPECT_EQ(message_kind(broken), MessageKind::other) << broken;
  }
}

}  // namespace meristem::studio::readings_test

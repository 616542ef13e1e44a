// SPDX-License-Identifier: Apache-2.0
#include "studio_session.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "test_studio.h"

namespace meristem::studio::studio_session_test {

TEST(StudioSession, SaysHelloWithItsLimits) {
  Studio studio;
  studio.page();
  const Value hello =
      studio.mailbox().wait_for([](const Value& message) { return Studio::text_of(message, "is") == "hello"; });
  EXPECT_EQ(*hello.find("protocol")->number(), 1);
  EXPECT_EQ(*hello.find("limits")->find("message_bytes")->number(), 17e6);
}

TEST(StudioSession, OpensADocumentAndShowsIt) {
  Studio studio;
  const Value answer = studio.open_bush();
  EXPECT_EQ(Studio::text_of(answer, "text"), kBush);
  EXPECT_EQ(Studio::text_of(answer, "saved"), Studio::text_of(answer, "hash"));
  EXPECT_TRUE(*answer.find("good")->boolean());
  EXPECT_EQ(answer.find("variables")->list()->size(), 1U);
  EXPECT_NE(answer.find("tree")->find("components")->find("leaf"), nullptr);
  const ReadPacket packet = studio.show();
  EXPECT_TRUE(packet.flag("whole"));
  EXPECT_TRUE(packet.flag("fit"));
  EXPECT_GT(packet.number("triangles"), 40);
  studio.edit(R"([{"set": "leaf.colour", "value": "#ff0000"}])");
  EXPECT_FALSE(studio.show().flag("fit"));
  EXPECT_LT(studio.last_packet().size(), 2000U);
}

TEST(StudioSession, OpensWhatAModelHasBecome) {
  Studio studio;
  const Value model = studio.ask("open", R"("model": "sunflower", "text": "{\"meristem\": 1, \"components\": {}}")");
  EXPECT_EQ(Studio::text_of(model, "model"), "sunflower");
  EXPECT_EQ(Studio::text_of(model, "text"), R"({"meristem": 1, "components": {}})");
}

TEST(StudioSession, OpensModelsAndTexts) {
  Studio studio;
  const Value model = studio.ask("open", R"("model": "sunflower")");
  EXPECT_TRUE(model.find("path")->is_null());
  EXPECT_TRUE(*model.find("good")->boolean());
  EXPECT_TRUE(is_refused(studio.ask("open", R"("model": "../models/oak")")));
  EXPECT_TRUE(is_refused(studio.ask("open", R"("path": "../bush.json")")));
  const Value text = studio.ask("open", R"("text": "{\"meristem\": 1, \"components\": {}}")");
  EXPECT_TRUE(text.find("saved")->is_null());
  EXPECT_GE(studio.ask("models").find("models")->list()->size(), 30U);
}

TEST(StudioSession, EditsGiveThePageWhatUndoesThem) {
  Studio studio;
  studio.open_bush();
  const Value answer = studio.edit(R"([{"set": "leaf.width", "value": 0.05}])");
  ASSERT_FALSE(is_refused(answer));
  const auto apply = [&](const char* patch) {
    return studio.ask("splice", "\"base\": \"" + Studio::text_of(answer, "hash") +
                                    "\", \"patch\": " + write_json_line(*answer.find(patch)));
  };
  const Value undone = apply("inverse");
  EXPECT_EQ(Studio::text_of(undone, "hash"), text_hash(kBush));
}

TEST(StudioSession, RefusesEditsOfAnotherText) {
  Studio studio;
  studio.open_bush();
  const Value answer = studio.ask("splice", R"("base": "0", "patch": [[0, 0, " "]])");
  EXPECT_TRUE(is_refused(answer));
  EXPECT_TRUE(*answer.find("stale")->boolean());
  const Value whole = studio.ask("text", R"("text": "{\"meristem\": 2}")");
  EXPECT_FALSE(*whole.find("good")->boolean());
  const Value& error = (*whole.find("faults")->list())[0];
  EXPECT_EQ(Studio::text_of(error, "path"), "meristem");
  EXPECT_EQ(*error.find("line")->number(), 1);
  EXPECT_EQ(*error.find("offset")->number(), 13);
}

TEST(StudioSession, TakesTypingThatIsNoJson) {
  Studio studio;
  studio.open_bush();
  const Value answer = studio.ask("splice", "\"base\": \"" + studio.hash() + "\", \"patch\": [[0, 1, \"\"]]");
  EXPECT_FALSE(*answer.find("good")->boolean());
  EXPECT_TRUE(answer.find("tree")->is_null());
  EXPECT_EQ(Studio::text_of(answer, "hash"), text_hash(kBush.substr(1)));
}

TEST(StudioSession, RefusesMoreMessagesThanItBears) {
  Studio studio;
  studio.host().limits.messages_per_second = 5;
  Value last;
  for (int k = 0; k < 6; ++k) last = studio.ask("all");
  EXPECT_TRUE(is_refused(last));
  EXPECT_EQ(Studio::text_of(last, "limit"), "messages_per_second");
}

TEST(StudioSession, RefusesMessagesThatAreTooLong) {
  Studio studio;
  studio.host().limits.message_bytes = 100;
  studio.page().receive("{\"do\": \"text\", \"id\": 1, \"text\": \"" + std::string(200, ' ') + "\"}");
  const Value refused = studio.mailbox().wait_for(is_refused);
  EXPECT_EQ(Studio::text_of(refused, "limit"), "message_bytes");
}

TEST(StudioSession, SavesOverWhatWasOpened) {
  Studio studio;
  const std::string opened = Studio::text_of(studio.open_bush(), "saved");
  studio.edit(R"([{"set": "leaf.width", "value": 0.05}])");
  const Value saved = studio.save("bush.json", opened);
  EXPECT_EQ(Studio::text_of(saved, "saved"), studio.hash());
  EXPECT_EQ(text_hash(studio.content("bush.json")), studio.hash());
  EXPECT_TRUE(*studio.save("bush.json", opened).find("changed")->boolean());
}

TEST(StudioSession, SavesUnderANewNameAndGoesOnFromThere) {
  Studio studio;
  for (const char* open : {R"("path": "bush.json")", R"("model": "sunflower")", R"("text": "{\"meristem\": 1}")"}) {
    std::string text = Studio::text_of(studio.open(open), "text");
    const std::string name = "mine" + std::to_string(text.size()) + ".json";
    std::string saved;
    for (int k = 0; k < 3; ++k) {
      const Value answer = studio.save(name, saved);
      ASSERT_FALSE(is_refused(answer)) << Studio::text_of(answer, "message");
      EXPECT_EQ(studio.content(name), text) << open << ", save " << k;
      saved = Studio::text_of(answer, "saved");
      ASSERT_FALSE(is_refused(studio.type(0, "// again\n")));
      text = "// again\n" + text;
    }
  }
}

TEST(StudioSession, FilesThatADocumentNamesGoWithItToItsNewPlace) {
  Studio studio;
  fs::create_directories(studio.folder() / "mine/gardens");
  const std::string text = Studio::text_of(studio.open(R"("model": "garden")"), "text");
  const Value answer = studio.save("mine/gardens/copy.json", "");
  // The plants that it places are shipped models, which every document finds.
  EXPECT_EQ(write_json_line(*answer.find("copied")), R"(["house.obj"])");
  EXPECT_TRUE(answer.find("omitted")->list()->empty());
  EXPECT_TRUE(*answer.find("good")->boolean()) << write_json_line(*answer.find("faults"));
  const Value again = studio.open(R"("path": "mine/gardens/copy.json")");
  EXPECT_TRUE(*again.find("good")->boolean());
  EXPECT_EQ(Studio::text_of(again, "text"), text);
}

TEST(StudioSession, WritesNoOtherTextThanThePages) {
  Studio studio;
  const std::string opened = Studio::text_of(studio.open_bush(), "saved");
  const Value refused = studio.ask(
      "save", R"("path": "bush.json", "hash": "0123456789abcdef", "over": true, "saved": ")" + opened + "\"");
  EXPECT_TRUE(is_refused(refused));
  EXPECT_TRUE(*refused.find("stale")->boolean());
  EXPECT_EQ(studio.content("bush.json"), kBush);
}

TEST(StudioSession, SaysWhereAFileIsNotUtf8AndGoesOn) {
  Studio studio;
  const std::string latin = "{\n  \"meristem\": 1,\n  \"author\": \"K\xF6hler\"\n}\n";
  std::ofstream(studio.folder() / "latin.json") << latin;
  std::ofstream(studio.folder() / "caf\xE9.json") << kBush;
  studio.open_bush();
  const Value refused = studio.ask("open", R"("path": "latin.json")");
  EXPECT_TRUE(is_refused(refused));
  const Value& error = (*refused.find("faults")->list())[0];
  EXPECT_EQ(*error.find("line")->number(), 3);
  EXPECT_EQ(*error.find("column")->number(), 15);
  EXPECT_NE(Studio::text_of(refused, "message").find("byte 0xf6 in line 3 (byte 34 of the file)"), std::string::npos)
      << Studio::text_of(refused, "message");
  // The mailbox reads each message as JSON, which refuses what is not UTF-8.
  EXPECT_EQ(studio.ask("files", R"("folder": "")").find("files")->list()->size(), 3U);
  EXPECT_FALSE(is_refused(studio.edit(R"([{"set": "leaf.length", "value": 0.2}])")));
  // A page that held the text before the file changed has it again.
  const Value back = studio.ask("open", R"("path": "latin.json", "text": "{}")");
  EXPECT_EQ(Studio::text_of(back, "saved"), text_hash(latin));
}

TEST(StudioSession, MakesAnEditOnlyIfTheTextStaysGood) {
  Studio studio;
  studio.open_bush();
  const std::string before = studio.hash();
  const Value refused = studio.ask("edit", "\"base\": \"" + before + R"(", "only_if_good": true,
      "edits": [{"insert": "links[]", "value": ["leaf", "stem"]}])");
  EXPECT_EQ(Studio::text_of(refused, "is"), "refused");
  EXPECT_FALSE(refused.find("faults")->list()->empty());
  EXPECT_NE(Studio::text_of(refused, "message").find("endless circle"), std::string::npos);
  // The server still has the text of before.
  EXPECT_EQ(Studio::text_of(studio.edit(R"([{"set": "leaf.length", "value": 0.2}])"), "is"), "done");
}

TEST(StudioSession, GivesPartsAndPutsThemInElsewhere) {
  Studio studio;
  studio.open_bush();
  const Value part = studio.ask("part", R"("components": ["leaf"])");
  EXPECT_EQ(*(*part.find("roots")->list())[0].text(), "leaf");
  const std::string text = Studio::text_of(part, "text");
  EXPECT_NE(text.find("\"size\": {\"value\": 0.1"), std::string::npos) << text;
  const Value edited = studio.edit("[{\"paste\": " + write_json_line(Value(text)) +
                                   R"(, "names": {"leaf": "petal"}, "index": 1, "link_index": 0}])");
  EXPECT_EQ(Studio::text_of(edited, "is"), "done");
  EXPECT_NE(edited.find("tree")->find("components")->find("petal"), nullptr);
  const Value noted = studio.edit(R"([{"note": "components.petal", "text": "Yellow."}])");
  EXPECT_EQ(Studio::text_of(*noted.find("notes"), "petal"), "Yellow.");
}

TEST(StudioSession, ReadsNothingOutsideOfItsFolder) {
  Studio studio;
  const Value answer = studio.ask(
      "open",
      R"("text": "{\"meristem\": 1, \"components\": {\"a\": {\"type\": \"lsystem\", \"file\": \"/etc/passwd\"}}}")");
  EXPECT_FALSE(*answer.find("good")->boolean());
  EXPECT_NE(write_json_line(*answer.find("faults")).find("outside the folder"), std::string::npos);
}

}  // namespace meristem::studio::studio_session_test

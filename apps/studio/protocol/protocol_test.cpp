// SPDX-License-Identifier: Apache-2.0
// The description of the protocol: what is made from it, and a session that sends each request.
#include "protocol/protocol.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "meristem/output/write/png.h"
#include "protocol/conversation.h"
#include "protocol/markdown.h"
#include "protocol/record_order.h"
#include "protocol/typescript.h"
#include "refusal.h"
#include "test_studio.h"

namespace meristem::studio::protocol_test {

const std::string kStudioFolder = MERISTEM_SOURCE_DIR "/apps/studio";
constexpr const char* kWriteAgain = "run `meristem_studio_protocol --write apps/studio`";

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Protocol, ReferencePageIsWhatTheTablesSay) {
  const std::string page = content_of(kStudioFolder + "/protocol.md");
  const std::size_t begin = page.find(kReferenceBegin);
  ASSERT_NE(begin, std::string::npos);
  EXPECT_TRUE(page.substr(begin) == kReferenceBegin + protocol_reference()) << kWriteAgain;
}

TEST(Protocol, TypesOfThePageAreWhatTheTablesSay) {
  const std::string folder = kStudioFolder + "/page/src/server/types";
  std::set<std::string> names;
  for (const PageSource& file : typescript_files()) {
    EXPECT_TRUE(content_of(folder + "/" + file.name) == file.text) << file.name << ": " << kWriteAgain;
    names.insert(file.name);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    EXPECT_TRUE(names.contains(entry.path().filename().string())) << entry.path() << " belongs to no subject";
}

TEST(Protocol, EachNameStandsForOneThing) {
  std::set<std::string> names;
  const auto add = [&names](std::string name) {
    for (char& letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    EXPECT_TRUE(names.insert(name).second) << name << " is a heading of the reference page twice";
  };
  std::set<std::string> types;
  for (const GroupRecords& group : records_by_group()) {
    add(group.group->name + " (subject)");
    for (const RequestType& request : group.group->requests) add(request.name);
    for (const MessageType& message : group.group->messages) add(message.name);
    for (const Record* record : group.records) {
      EXPECT_TRUE(types.insert(record->name).second) << record->name;
      std::set<std::string> members;
      for (const std::string& member : record->names()) EXPECT_TRUE(members.insert(member).second) << member;
    }
  }
  EXPECT_GT(types.size(), 90U);
}

TEST(Protocol, EachRecordAndMemberHasASentence) {
  for (const GroupRecords& group : records_by_group()) {
    for (const Record* record : group.records) {
      EXPECT_EQ(record->doc.back(), '.') << record->name;
      for (const Member& member : record->members) EXPECT_EQ(member.doc.back(), '.') << record->name << member.name;
    }
  }
}

/// Checks one message of the server, and returns what is wrong.
std::string error_of(const std::string& request, const std::string& message) {
  try {
    check_server_message(parse_json(message), request);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(Protocol, FindsMessagesThatAreNotAsDescribed) {
  EXPECT_EQ(error_of("view", R"({"is": "done", "re": 1})"), "");
  EXPECT_EQ(error_of("view", R"({"is": "done"})"), "the answer has no 're'");
  EXPECT_EQ(error_of("view", R"({"is": "done", "re": 1, "new": 2})"),
            "the message has an unknown member 'new'; there are no members");
  EXPECT_EQ(error_of("command", R"({"is": "done", "re": 1})"), "the message has no 'command'");
  EXPECT_EQ(error_of("command", R"({"is": "done", "re": 1, "command": 3})"), "'command' is not a text");
  EXPECT_EQ(error_of("", R"({"is": "news"})"), "there is no message 'news'");
  EXPECT_EQ(error_of("", R"({"is": "refused", "re": null, "message": "", "stale": null})"),
            "'stale' is not true or false");
  EXPECT_EQ(error_of("", R"({"is": "working", "job": "dance", "stage": null, "share": 1})"),
            "'job' is none of grow, export, measure, sweep, stills, grammar, picture, question");
  // A reading is there as a whole, or was superseded.
  EXPECT_EQ(error_of("text", R"({"is": "done", "re": 1, "hash": "", "superseded": true})"), "");
  EXPECT_EQ(error_of("text", R"({"is": "done", "re": 1, "hash": ""})"), "the message has no 'good'");
  EXPECT_EQ(error_of("text", R"({"is": "done", "re": 1, "hash": "", "superseded": true, "good": true})"),
            "the message has 'good' beside 'superseded'");
  EXPECT_EQ(error_of("save", R"({"is": "done", "re": 1, "path": "", "name": "", "saved": ""})"), "");
  EXPECT_EQ(error_of("save", R"({"is": "done", "re": 1, "path": "", "name": "", "saved": "", "copied": []})"),
            "the message has no 'omitted'");
  EXPECT_EQ(error_of("grammar", R"({"is": "done", "re": 1, "derivation": {"text": null}})"), "");
  EXPECT_EQ(error_of("grammar", R"({"is": "done", "re": 1, "derivation": {"text": ""}})"),
            "'derivation' has no 'instance'");
  EXPECT_EQ(error_of("stills", R"({"is": "done", "re": 1, "stills": [{"picture": "", "faults": []}]})"),
            "'stills[0]' needs exactly one of picture, faults");
}

/// A document in which each question has an answer.
constexpr const char* kGarden = R"({
  "meristem": 1,
  "seed": 4,
  "variables": {"tall": {"value": 0.6, "min": 0.3, "max": 1}},
  "scene": {"lamps": [{"position": [0, 3, 0]}],
            "obstacles": [{"box": [[-3, 0, -2], [-2, "tall", -1]]}]},
  "animation": {"length": 4, "keys": {"leaf.curl": [[0, 0], [4, 60]]}},
  "components": {
    "view": {"type": "camera"},
    "tree": {"type": "colonize", "crown": {"sphere": {"centre": [0, 1, 0], "radius": 0.5}}, "points": 60,
             "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18},
    "pear": {"type": "organize", "frame": {"translate": [2, 0, 0]}, "iterations": 9,
             "operations": [{"do": "cut", "at": 8, "shoots": "leader", "above": 5}]},
    "weed": {"type": "lsystem", "grammar": ["F", "#rules", "F -> F[+F]F"], "steps": 2, "length": 0.1},
    "blade": {"type": "grassleaf", "midrib_points": [[0, 0], [0.1, 0.3], [0.3, 0.4]]},
    "clock": {"type": "sequence", "delay": 1},
    "leaf": {"type": "leaf", "length": 0.3, "width": 0.2, "texture": {"picture": {"colour": "bark.png"}}}
  },
  "links": [["view", "tree"], ["view", "pear"], ["view", "weed"], ["view", "blade"], ["view", "clock"],
            ["clock", "leaf"]]
})";

/// The members of a request for each name. The hash stands for H.
const std::map<std::string, std::string> kMembers{
    {"splice", R"("base": "H", "patch": [[0, 0, " "]])"},
    {"drag", R"("values": {"tall": 0.5})"},
    {"view", R"("skeleton": true, "time": 1, "growth": {"step": 5, "recorded": true, "of": "tree"})"},
    {"pause", R"("paused": false)"},
    {"files", R"("folder": "")"},
    {"parts", R"("model": "sunflower")"},
    {"part", R"("model": "sunflower")"},
    {"picture", R"("file": "bark.png", "size": 16)"},
    {"export", R"("format": ".glb")"},
    {"command", R"("format": ".png", "name": "a", "options": {"width": 64, "height": 64})"},
    {"stills", R"("states": [{}, {"tall": 9}], "width": 16, "height": 16,
                  "camera": {"position": [3, 1, 0], "target": [0, 1, 0], "field_of_view": 40})"},
    {"grammar", R"("component": "weed")"},
    {"overlays", R"("parts": ["sun"])"},
    {"stand", R"("component": "tree")"},
    {"worked_out", R"("expressions": {"scene.obstacles[0].box[1][1]": "tall"})"},
    {"curves", R"("component": "blade")"},
    {"cloud", R"("component": "tree")"},
    {"clocks", R"("up_to": 4)"},
    {"instance", R"("component": "tree", "frame": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], "position": [0, 0.1, 0])"},
    {"shoot", R"("component": "pear", "go": "next")"},
    {"operations", R"("component": "pear", "operation": "components.pear.operations[0]")"},
    {"measures", R"("layer_height": 0.5)"},
    {"sweep", R"("path": "tall", "values": [0.4, 9])"},
};

TEST(Protocol, EachRequestIsAnsweredAsDescribed) {
  Studio studio;
  std::ofstream(studio.folder() / "garden.json") << kGarden;
  std::ofstream(studio.folder() / "bark.png", std::ios::binary)
      << encode_png(Image{.width = 2, .height = 2, .rgba = std::vector<std::uint8_t>(16, 200)}, PixelKind::srgb);
  const Value opened = studio.open(R"("path": "garden.json")");
  ASSERT_EQ(*opened.find("good"), Value(true)) << write_json_line(*opened.find("faults"));
  studio.show();
  ASSERT_FALSE(is_refused(studio.edit(R"([{"set": "tall", "value": 0.7}])")));
  ASSERT_FALSE(is_refused(studio.ask("text", "\"text\": " + write_json_line(Value(kGarden)))));
  const std::string hash = Studio::text_of(opened, "hash");
  const std::set<std::string> apart{"open", "edit", "text", "shown", "save", "continue", "cancel", "all"};
  for (const std::string& name : request_names()) {
    if (apart.contains(name)) continue;
    std::string members = kMembers.contains(name) ? kMembers.at(name) : "";
    if (const std::size_t at = members.find("\"H\""); at != std::string::npos) members.replace(at + 1, 1, hash);
    const double id = studio.send(name, members);
    if (find_request(name)->time == AnswerTime::at_once) {
      EXPECT_TRUE(studio.mailbox().answered().contains(name)) << name << " is answered before the next request";
    }
    const Value answer = studio.mailbox().answer(id);
    EXPECT_FALSE(is_refused(answer)) << name << ": " << Studio::text_of(answer, "message");
  }
  for (const char* name : {"continue", "cancel", "all"}) EXPECT_FALSE(is_refused(studio.ask(name)));
  const std::string now = Studio::text_of(studio.ask("text", "\"text\": " + write_json_line(Value(kGarden))), "hash");
  EXPECT_FALSE(is_refused(studio.ask("save", R"("path": "other.json", "saved": null, "hash": ")" + now + "\"")));
  const std::vector<std::string> names = request_names();
  EXPECT_EQ(studio.mailbox().answered(), std::set<std::string>(names.begin(), names.end()));
}

}  // namespace meristem::studio::protocol_test

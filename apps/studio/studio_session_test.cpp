// SPDX-License-Identifier: Apache-2.0
#include "studio_session.h"

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "tests/support/shown_scene.h"
#include "tests/support/temporary_folder.h"

namespace meristem::studio::studio_session_test {

namespace fs = std::filesystem;

const std::string kBush = R"json({
  "meristem": 1,
  "variables": {"size": {"value": 0.1, "min": 0, "max": 1}},  // "\u00e9\ud83c\udf33"
  "components": {
    "stem": {"type": "tree", "length": 1.5, "radius": 0.01},
    "leaf": {"type": "leaf", "length": "size", "width": 0.03, "colour": "#337722"}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 40}]
}
)json";

/// What the page would have received, in order.
class Mailbox : public Outbox {
 public:
  void send_text(std::string message) override {
    const std::lock_guard lock(mutex_);
    texts_.push_back(parse_json(message));
    news_.notify_all();
  }
  void send_packet(std::string packet) override {
    const std::lock_guard lock(mutex_);
    packets_.push_back(std::move(packet));
    news_.notify_all();
  }

  /// The first message for which that holds, which comes if it is not there yet.
  template <class Holds>
  Value wait_for(Holds holds) {
    std::unique_lock lock(mutex_);
    for (std::size_t k = 0;; ++k) {
      while (k >= texts_.size()) {
        if (news_.wait_for(lock, std::chrono::seconds(60)) == std::cv_status::timeout)
          throw std::runtime_error("silence");
      }
      if (holds(texts_[k])) return texts_[k];
    }
  }
  Value answer(double id) {
    return wait_for([id](const Value& message) {
      const Value* re = message.find("re");
      return re != nullptr && re->number() != nullptr && *re->number() == id &&
             *message.find("is")->text() != "working";
    });
  }
  std::string packet(std::size_t k) {
    std::unique_lock lock(mutex_);
    while (k >= packets_.size()) {
      if (news_.wait_for(lock, std::chrono::seconds(60)) == std::cv_status::timeout)
        throw std::runtime_error("no packet");
    }
    return packets_[k];
  }
  std::size_t packet_count() {
    const std::lock_guard lock(mutex_);
    return packets_.size();
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<Value> texts_;
  std::vector<std::string> packets_;
};

/// A studio with one page, which takes over packets as the page does.
class Studio {
 public:
  explicit Studio(std::chrono::milliseconds still = std::chrono::milliseconds(0)) {
    std::ofstream(folder_ / "bush.json") << kBush;
    host_.still_after = still;
    host_.limits.messages_per_second = 100'000;
  }

  Host& host() { return host_; }
  const fs::path& folder() const { return folder_.path(); }
  Mailbox& mailbox() { return *mailbox_; }
  StudioSession& page() {
    if (!page_) page_.emplace(host_, mailbox_);
    return *page_;
  }

  /// Asks and gives the answer; members are the request's in JSON.
  Value ask(const std::string& what, const std::string& members = "") {
    page().receive(request(what, members));
    return mailbox_->answer(id_);
  }
  std::string request(const std::string& what, const std::string& members) {
    return "{\"do\": \"" + what + "\", \"id\": " + std::to_string(++id_) + (members.empty() ? "" : ", ") + members +
           "}";
  }
  Value open_bush() {
    const Value answer = ask("open", R"("path": "bush.json")");
    hash_ = text_of(answer, "hash");
    return answer;
  }
  Value edit(const std::string& edits) {
    const Value answer = ask("edit", "\"base\": \"" + hash_ + "\", \"edits\": " + edits);
    if (answer.find("hash") != nullptr) hash_ = text_of(answer, "hash");
    return answer;
  }
  /// Takes packets over until one at rest shows the text of this hash.
  ReadPacket show(const std::string& hash) {
    for (;;) {
      last_ = mailbox_->packet(taken_++);
      scene_.apply(last_);
      const ReadPacket packet(last_);
      ask("shown", "\"packet\": " + std::to_string(static_cast<int>(packet.number("packet"))));
      if (!packet.flag("draft") && *packet.head.find("hash")->text() == hash) return packet;
    }
  }
  ReadPacket show() { return show(hash_); }
  const ShownScene& scene() const { return scene_; }
  std::size_t taken() const { return taken_; }
  const std::string& last_packet() const { return last_; }
  const std::string& hash() const { return hash_; }

  static std::string text_of(const Value& message, const char* name) {
    const Value* member = message.find(name);
    return member != nullptr && member->text() != nullptr ? *member->text() : "";
  }

 private:
  TemporaryFolder folder_;
  Host host_{.registry = builtin_components(),
             .root = RootFolder(folder_.path().string()),
             .models_folder = MERISTEM_SOURCE_DIR "/models"};
  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
  std::optional<StudioSession> page_;
  ShownScene scene_;
  std::string hash_;
  std::string last_;
  std::size_t taken_ = 0;
  int id_ = 0;
};

bool is_refused(const Value& answer) { return Studio::text_of(answer, "is") == "refused"; }

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

constexpr const char* kPainted = R"json("text": "{\"meristem\": 1, \"components\": {
  \"stem\": {\"type\": \"tree\", \"length\": 1, \"colour\": \"#6b5a48\", \"texture\": {\"bark\": {}, \"pixels\": 64}},
  \"leaf\": {\"type\": \"leaf\", \"length\": 0.1, \"colour\": \"#337722\", \"texture\": {\"leaf\": {}, \"pixels\": 64}}},
  \"links\": [{\"from\": \"stem\", \"to\": \"leaf\", \"kind\": \"branch\", \"count\": 4}]}")json";

/// The request with its line ends, which JSON texts have no room for, taken out.
std::string painted_document() {
  std::string text = kPainted;
  std::erase(text, '\n');
  return text;
}

std::size_t picture_count(const ReadPacket& packet) {
  const Value* const pictures = packet.head.find("pictures");
  return pictures == nullptr ? 0 : pictures->list()->size();
}

TEST(StudioSession, ADraggedColourTintsThePictureThatThePageHas) {
  Studio studio;
  const std::string hash = Studio::text_of(studio.ask("open", painted_document()), "hash");
  EXPECT_EQ(picture_count(studio.show(hash)), 4U);  // colours and normals of two textures
  for (const char* colour : {"#aa2211", "#2244aa"}) {
    studio.ask("drag", std::string(R"("values": {"leaf.colour": ")") + colour + "\"}");
    const ReadPacket packet = studio.show(hash);
    EXPECT_EQ(picture_count(packet), 0U);
    EXPECT_EQ(packet.head.find("materials")->list()->size(), 1U);
    EXPECT_LT(studio.last_packet().size(), 2048U);
  }
}

TEST(StudioSession, AtRestAPictureCrossesOnlyWhereItsTintLooksOtherwise) {
  Studio studio;
  const Value opened = studio.ask("open", painted_document());
  studio.show(Studio::text_of(opened, "hash"));
  std::string hash = Studio::text_of(opened, "hash");
  const auto set = [&](const char* path, const char* colour) {
    const Value answer = studio.ask(
        "edit", "\"base\": \"" + hash + R"(", "edits": [{"set": ")" + path + R"(", "value": ")" + colour + "\"}]");
    hash = Studio::text_of(answer, "hash");
    return studio.show(hash);
  };
  // All of bark follows its colour; a leaf's veins do not.
  EXPECT_EQ(picture_count(set("stem.colour", "#7a3020")), 0U);
  EXPECT_EQ(picture_count(set("leaf.colour", "#aa2211")), 1U);
  EXPECT_EQ(picture_count(set("stem.colour", "#6b5a48")), 0U);
}

TEST(StudioSession, TellsWhatWasMadeAnewAndWhatWasReused) {
  Studio studio;
  studio.open_bush();
  studio.show();
  studio.edit(R"([{"set": "leaf.width", "value": 0.05}])");
  studio.show();
  const Value grown = studio.mailbox().wait_for([&](const Value& message) {
    return Studio::text_of(message, "is") == "grown" && Studio::text_of(message, "hash") == studio.hash();
  });
  const auto count = [&](const std::string& what, const char* which) {
    for (const Value& one : *grown.find("reuse")->list()) {
      if (Studio::text_of(one, "what") == what) return *one.find(which)->number();
    }
    return -1.0;
  };
  EXPECT_EQ(count("instances", "made"), 40);
  EXPECT_EQ(count("instances", "reused"), 2);  // the root and the stem
  EXPECT_EQ(count("clothed stems", "made"), 0);
  EXPECT_EQ(count("clothed stems", "reused"), 1);
}

constexpr const char* kSideCamera =
    R"("width": 48, "height": 48, "camera": {"position": [0, 1, 5], "target": [0, 1, 0], "field_of_view": 30})";

TEST(StudioSession, DrawsStatesOfADocumentAndLeavesItAlone) {
  Studio studio;
  studio.open_bush();
  studio.show();
  const Value answer = studio.ask(
      "stills",
      std::string(R"("states": [{"leaf.width": 0.01}, {"leaf.width": 0.2}, {"leaf.width": "?"}, {}], )") + kSideCamera);
  const Value::List& stills = *answer.find("stills")->list();
  ASSERT_EQ(stills.size(), 4U);
  EXPECT_NE(Studio::text_of(stills[0], "picture"), Studio::text_of(stills[1], "picture"));
  EXPECT_EQ(Studio::text_of(stills[0], "picture").substr(0, 8), "iVBORw0K");
  EXPECT_EQ(stills[2].find("faults")->list()->size(), 1U);
  EXPECT_EQ(studio.taken(), 1U);
  // What is the same is drawn the same.
  const Value again = studio.ask("stills", std::string(R"("states": [{}, {"leaf.width": 0.01}], )") + kSideCamera);
  EXPECT_FALSE(is_refused(again));
  EXPECT_FALSE(is_refused(studio.ask("stills", R"("states": [])")));
}

TEST(StudioSession, OfStillsOnlyTheNewestAreMade) {
  Studio studio;
  studio.open_bush();
  std::vector<std::string> requests;
  for (int k = 0; k < 20; ++k) {
    studio.page().receive("{\"do\": \"stills\", \"id\": " + std::to_string(1000 + k) + ", \"states\": [{}, {}, {}], " +
                          kSideCamera + "}");
  }
  int made = 0;
  for (int k = 0; k < 20; ++k) made += is_refused(studio.mailbox().answer(1000 + k)) ? 0 : 1;
  EXPECT_FALSE(is_refused(studio.mailbox().answer(1019)));
  EXPECT_LT(made, 20);
}

constexpr const char* kGrammarPlant = R"json("text": "{\"meristem\": 1, \"components\": {\"weed\":
 {\"type\": \"lsystem\", \"grammar\": [\"F\", \"#rules\", \"F -> F[+F]F\"], \"steps\": 3, \"length\": 1}}}")json";

TEST(StudioSession, TellsAStepOfADerivation) {
  Studio studio;
  std::string text = kGrammarPlant;
  std::erase(text, '\n');
  ASSERT_TRUE(*studio.ask("open", text).find("good")->boolean());
  const Value answer = studio.ask("grammar", R"("component": "weed", "step": 1)");
  const Value& told = *answer.find("derivation");
  EXPECT_EQ(*told.find("steps")->number(), 3);
  EXPECT_EQ(*told.find("step")->number(), 1);
  EXPECT_EQ(*told.find("count")->number(), 6);
  EXPECT_EQ(write_json_line(*told.find("modules")), R"(["F", "[", "+", "F", "]", "F"])");
  EXPECT_EQ(told.find("places")->list()->size(), 3U * 7);
  EXPECT_EQ(write_json_line(*told.find("counts")), R"([["[", 1], ["]", 1], ["F", 3], ["+", 1]])");
  const Value part = studio.ask("grammar", R"("component": "weed", "step": 1, "first": 3, "count": 2)");
  EXPECT_EQ(write_json_line(*part.find("derivation")->find("modules")), R"(["F", "]"])");
  EXPECT_EQ(part.find("derivation")->find("places")->list()->size(), 7U);
  EXPECT_TRUE(studio.ask("grammar", R"("component": "nobody")").find("derivation")->find("text")->is_null());
  // A drag that shows another step leaves the text's number of steps.
  studio.ask("drag", R"("values": {"weed.steps": 2})");
  EXPECT_EQ(*studio.ask("grammar", R"("component": "weed", "step": 2)").find("derivation")->find("steps")->number(), 3);
  studio.ask("drag", R"("values": {})");
  // Too much is refused before it is made.
  EXPECT_TRUE(is_refused(studio.ask("grammar", R"("component": "weed", "step": 60)")));
}

TEST(StudioSession, TellsTheDerivationOfTheInstanceThatWasPointedAt) {
  Studio studio;
  std::string text = R"json("text": "{\"meristem\": 1, \"components\": {\"view\": {\"type\": \"camera\"},
    \"row\": {\"type\": \"hydra\", \"number\": 3, \"radius\": 1}, \"weed\": {\"type\": \"lsystem\", \"steps\": 3, \"length\": 1,
    \"grammar\": [\"F\", \"#rules\", \"F : 1 -> F[+F]F\", \"F : 1 -> FF\"]}},
    \"links\": [[\"view\", \"row\"], [\"row\", \"weed\"]]}")json";
  std::erase(text, '\n');
  ASSERT_TRUE(*studio.ask("open", text).find("good")->boolean());
  const auto instance_of = [&](const std::string& members) {
    const Value answer = studio.ask("grammar", R"("component": "weed", )" + members);
    return *answer.find("derivation")->find("instance");
  };
  const Value third = instance_of(R"("number": 2)");
  EXPECT_EQ(*third.find("number")->number(), 2);
  EXPECT_EQ(*third.find("of")->number(), 3);
  const Value by_key = instance_of(R"("instance": ")" + *third.find("key")->text() + "\"");
  EXPECT_EQ(*by_key.find("number")->number(), 2);
  EXPECT_NE(*instance_of(R"("number": 0)").find("key")->text(), *third.find("key")->text());
}

TEST(StudioSession, MeasuresOverTheValuesOfAHandle) {
  Studio studio;
  studio.open_bush();
  const Value rows = *studio.ask("measure_rows").find("rows");
  EXPECT_EQ(*rows.list()->at(0).find("name")->text(), "trees");
  EXPECT_FALSE(rows.list()->at(0).find("doc")->text()->empty());
  const std::string path = "stem.length";
  const Value sweep = *studio.ask("sweep", R"("path": ")" + path + R"(", "values": [1, 2, -1])").find("sweep");
  ASSERT_EQ(sweep.list()->size(), 3U);
  const auto height = [&](std::size_t k) { return *sweep.list()->at(k).find("measures")->find("height")->number(); };
  EXPECT_NEAR(height(0), 1, 1e-6);
  EXPECT_NEAR(height(1), 2, 1e-6);
  EXPECT_NE(sweep.list()->at(2).find("faults"), nullptr);  // no stem is shorter than nothing
  EXPECT_FALSE(studio.ask("measures", R"("light": true)").find("measures")->find("leaf_irradiance")->is_null());
}

TEST(StudioSession, ShowsPicturesSmallAndNoneFromOutside) {
  Studio studio;
  studio.open_bush();
  const Value made = studio.ask("picture", R"("file": "nothing.png")");
  EXPECT_TRUE(is_refused(made));
  EXPECT_TRUE(is_refused(studio.ask("picture", R"("file": "../nothing.png")")));
  EXPECT_TRUE(is_refused(studio.ask("picture", R"("file": "bush.json")")));
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
  const Value& fault = (*whole.find("faults")->list())[0];
  EXPECT_EQ(Studio::text_of(fault, "path"), "meristem");
  EXPECT_EQ(*fault.find("line")->number(), 1);
  EXPECT_EQ(*fault.find("offset")->number(), 13);
}

TEST(StudioSession, TakesTypingThatIsNoJson) {
  Studio studio;
  studio.open_bush();
  const Value answer = studio.ask("splice", "\"base\": \"" + studio.hash() + "\", \"patch\": [[0, 1, \"\"]]");
  EXPECT_FALSE(*answer.find("good")->boolean());
  EXPECT_TRUE(answer.find("tree")->is_null());
  EXPECT_EQ(Studio::text_of(answer, "hash"), text_hash(kBush.substr(1)));
}

TEST(StudioSession, ShowsOfARapidDragTheLastValue) {
  Studio studio(std::chrono::milliseconds(1));
  studio.open_bush();
  studio.show();
  for (int k = 1; k <= 1000; ++k)
    studio.page().receive(
        studio.request("drag", "\"values\": {\"leaf.width\": " + std::to_string(0.02 + k * 1e-5) + "}"));
  studio.edit(R"([{"set": "leaf.width", "value": 0.03001}])");
  studio.show();
  EXPECT_LT(studio.taken(), 1000U);

  Studio other;
  other.open_bush();
  other.edit(R"([{"set": "leaf.width", "value": 0.03001}])");
  other.show();
  EXPECT_EQ(studio.scene(), other.scene());
}

TEST(StudioSession, DragLeavesTheTextAndEndsWithoutATrace) {
  Studio studio;
  studio.open_bush();
  studio.show();
  const ShownScene before = studio.scene();
  studio.ask("drag", R"("values": {"leaf.width": 0.08})");
  studio.show();
  EXPECT_NE(studio.scene(), before);
  const Value wrong = studio.ask("drag", R"("values": {"leaf.width": "wide"})");
  EXPECT_EQ(wrong.find("faults")->list()->size(), 1U);
  studio.ask("drag", R"("values": {})");
  studio.show();
  EXPECT_EQ(studio.scene(), before);
}

TEST(StudioSession, SendsNoPacketBeforeTheLastIsShown) {
  Studio studio;
  studio.open_bush();
  studio.mailbox().packet(0);
  for (const char* width : {"0.04", "0.05", "0.06"})
    studio.edit(std::string(R"([{"set": "leaf.width", "value": )") + width + "}]");
  studio.ask("measures");  // long after what has been asked before is grown
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(studio.mailbox().packet_count(), 1U);
  studio.show();
  EXPECT_EQ(studio.mailbox().packet_count(), 2U);
}

TEST(StudioSession, KeepsWithinTheBudgetOfTriangles) {
  Studio studio;
  studio.ask("view", R"("rest_triangles": 300, "drag_triangles": 100)");
  studio.open_bush();
  const ReadPacket packet = studio.show();
  EXPECT_LE(packet.number("triangles"), 400);
  EXPECT_LT(packet.number("share"), 1);
  EXPECT_GT(*packet.head.find("of")->find("triangles")->number(), 400);
}

TEST(StudioSession, SendsDraftsOfADragFirstAndThenAllOfIt) {
  Studio studio(std::chrono::milliseconds(2000));
  studio.ask("view", R"("drag_triangles": 100)");
  studio.open_bush();
  studio.show();
  const double all = ReadPacket(studio.last_packet()).number("triangles");
  const std::size_t before = studio.taken();
  studio.ask("drag", R"("values": {"stem.length": 1.6})");
  EXPECT_EQ(studio.show().number("triangles"), all);
  EXPECT_EQ(studio.taken(), before + 2);
}

TEST(StudioSession, SendsNoDraftOfAnEditNorOfAColour) {
  Studio studio(std::chrono::milliseconds(2000));
  studio.ask("view", R"("drag_triangles": 100)");
  studio.open_bush();
  studio.show();
  studio.ask("drag", R"("values": {"leaf.colour": "#ff0000"})");
  EXPECT_FALSE(ReadPacket(studio.mailbox().packet(1)).flag("draft"));
  EXPECT_LT(studio.mailbox().packet(1).size(), 2000U);
  studio.show();
  studio.edit(R"([{"set": "leaf.width", "value": 0.05}])");
  EXPECT_FALSE(ReadPacket(studio.mailbox().packet(2)).flag("draft"));
}

TEST(StudioSession, SendsAWholeSceneAgainWhenAsked) {
  Studio studio;
  studio.open_bush();
  studio.show();
  const ShownScene before = studio.scene();
  studio.ask("all");
  EXPECT_TRUE(studio.show().flag("whole"));
  EXPECT_EQ(studio.scene(), before);
}

TEST(StudioSession, ShowsSkeletonsWhereAsked) {
  Studio studio;
  studio.open_bush();
  EXPECT_EQ(studio.show().count("skeletons"), 0U);
  studio.ask("view", R"("skeleton": true, "surface": false)");
  const ReadPacket packet = studio.show();
  EXPECT_EQ(packet.count("skeletons"), 1U);
  EXPECT_EQ(packet.number("triangles"), 0);
}

TEST(StudioSession, ShowsStepsOfOneGrowthWithTheirOverlays) {
  Studio studio;
  const Value opened = studio.ask(
      "open", R"json("text": "{\"meristem\": 1, \"seed\": 4, \"components\": {\"tree\": {)json"
              R"json(\"type\": \"colonize\", \"crown\": {\"sphere\": {\"centre\": [0, 1, 0], \"radius\": 0.5}},)json"
              R"json(\"points\": 60, \"step\": 0.06, \"influence\": 0.8, \"kill\": 0.16,)json"
              R"json(\"iterations\": 18}}}", "path": null)json");
  const std::string hash = Studio::text_of(opened, "hash");
  const auto news_of = [&](const std::string& growth) {
    studio.ask("view", "\"growth\": " + growth);
    studio.show(hash);
  };
  studio.show(hash);
  news_of(R"({"step": null, "recorded": true})");
  news_of(R"({"step": 7, "recorded": true})");
  const Value grown = studio.mailbox().wait_for([](const Value& message) {
    const Value* step = message.find("step");
    return step != nullptr && *message.find("is") == Value("grown") && *step == Value(7);
  });
  EXPECT_EQ(*grown.find("steps"), Value(18));
  bool is_reused = false;
  for (const Value& reuse : *grown.find("reuse")->list()) {
    if (*reuse.find("what") == Value("grown skeletons")) is_reused = *reuse.find("made") == Value(0);
  }
  EXPECT_TRUE(is_reused) << "one growth gives all steps";
  const Value answer = studio.ask("overlays", R"("parts": ["points", "skeleton"])");
  const Value& overlays = *answer.find("overlays");
  EXPECT_EQ(*overlays.find("step"), Value(7));
  const Value::List& layers = *overlays.find("layers")->list();
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(Studio::text_of(*layers[0].find("points"), "positions").size(), 60U * 12 * 4 / 3) << "in base 64";
  EXPECT_FALSE(layers[0].find("legend")->list()->empty());
  EXPECT_EQ(Studio::text_of(studio.ask("overlays", R"("parts": ["nothing"])"), "is"), "refused");
}

TEST(StudioSession, GrowsNothingWhilePaused) {
  Studio studio;
  studio.open_bush();
  studio.show();
  studio.ask("pause", R"("paused": true)");
  studio.edit(R"([{"set": "leaf.width", "value": 0.05}])");
  studio.ask("measures");
  EXPECT_EQ(studio.mailbox().packet_count(), 1U);
  studio.ask("pause", R"("paused": false)");
  studio.show();
}

TEST(StudioSession, TellsWhyADocumentDoesNotGrow) {
  Studio studio;
  studio.open_bush();
  studio.show();
  studio.edit(R"([{"set": "limits.triangles", "value": 10}])");
  const Value failed =
      studio.mailbox().wait_for([](const Value& message) { return Studio::text_of(message, "is") == "failed"; });
  EXPECT_EQ(failed.find("faults")->list()->size(), 1U);
  EXPECT_EQ(studio.mailbox().packet_count(), 1U);
}

TEST(StudioSession, StopsAJobThatTakesTooLong) {
  Studio studio;
  studio.host().limits.job_seconds = 0;
  studio.open_bush();
  studio.edit(R"([{"set": "links[0].count", "value": 2000000}])");
  const Value failed =
      studio.mailbox().wait_for([](const Value& message) { return Studio::text_of(message, "is") == "failed"; });
  EXPECT_EQ(Studio::text_of(failed, "limit"), "job_seconds");
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
  const Value saved = studio.ask("save", "\"path\": \"bush.json\", \"saved\": \"" + opened + "\"");
  EXPECT_EQ(Studio::text_of(saved, "saved"), studio.hash());
  std::ifstream file(studio.folder() / "bush.json");
  EXPECT_EQ(text_hash(std::string(std::istreambuf_iterator<char>(file), {})), studio.hash());
  const Value refused = studio.ask("save", "\"path\": \"bush.json\", \"saved\": \"" + opened + "\"");
  EXPECT_TRUE(*refused.find("changed")->boolean());
}

TEST(StudioSession, ExportsEachFormat) {
  Studio studio;
  studio.open_bush();
  studio.show();
  for (const char* format : {".glb", ".obj", ".ply", ".mtg", ".csv", ".json", ".png"}) {
    const Value answer =
        studio.ask("export", std::string("\"format\": \"") + format +
                                 R"(", "name": "My bush", "options": {"width": 32, "height": 32, "samples": 1})");
    ASSERT_FALSE(is_refused(answer)) << format << write_json_line(answer);
    const Value& file = *answer.find("file");
    const bool has_many = format == std::string(".obj");  // and its materials
    EXPECT_EQ(Studio::text_of(file, "name"), std::string("my-bush") + (has_many ? ".zip" : format));
    EXPECT_EQ(file.find("holds")->list()->size(), has_many ? 2U : 0U);
    EXPECT_GT(*file.find("bytes")->number(), 10);
  }
  EXPECT_FALSE(studio.host().downloads.find(1, "my-bush.glb")->empty());
  EXPECT_FALSE(studio.host().downloads.find(1, "../1/my-bush.glb"));
  EXPECT_TRUE(is_refused(studio.ask("export", R"("format": ".exe")")));
}

TEST(StudioSession, ACoarserLevelIsExportedInTheSameArchive) {
  Studio studio;
  studio.open_bush();
  studio.show();
  const Value answer = studio.ask("export", R"("format": ".glb", "name": "bush", "options": {"lod": 1})");
  const Value& file = *answer.find("file");
  EXPECT_EQ(Studio::text_of(file, "name"), "bush.zip");
  const Value::List& holds = *file.find("holds")->list();
  ASSERT_EQ(holds.size(), 2U);
  EXPECT_EQ(*holds[0].text(), "bush.glb");
  // The loose files are gone.
  const fs::path archive = *studio.host().downloads.find(1, "bush.zip");
  EXPECT_EQ(std::distance(fs::directory_iterator(archive.parent_path()), fs::directory_iterator()), 1);
}

TEST(StudioSession, TellsTheCommandThatDoesTheSame) {
  Studio studio;
  studio.ask("open", R"("model": "oak")");
  EXPECT_EQ(Studio::text_of(studio.ask("command", R"("format": ".glb", "options": {"seed": 3, "lod": 2})"), "command"),
            "meristem grow oak -o oak.glb --seed 3 --lod 2");
  EXPECT_EQ(Studio::text_of(studio.ask("command", R"("format": ".png", "name": "it's", "options": {"samples": 4})"),
                            "command"),
            "meristem render oak -o it-s.png --samples 4");
}

TEST(StudioSession, MeasuresAsTheCommandLineDoes) {
  Studio studio;
  studio.open_bush();
  EXPECT_EQ(*studio.ask("measures").find("measures")->find("leaf_count")->number(), 40);
}

TEST(StudioSession, TellsWhichInstanceIsSeenWithItsValues) {
  Studio studio;
  studio.ask(
      "open",
      R"json("text": "{\"meristem\": 1, \"components\": {\"line\": {\"type\": \"places\", \"line\": {\"points\": [[0, 0], [8, 0]], \"spacing\": 2}}, \"ball\": {\"type\": \"simple\", \"size\": [1, 1, 1], \"colours\": [\"#112233\", \"#ffffff\"], \"colour_at\": \"i/4\"}}, \"links\": [[\"line\", \"ball\"]]}")json");
  studio.mailbox().packet(0);
  const Value answer =
      studio.ask("instance", R"("component": "ball", "frame": [1,0,0,4, 0,1,0,0, 0,0,1,0], "position": [4, 1, 0])");
  const Value* instance = answer.find("instance");
  ASSERT_NE(instance, nullptr);
  EXPECT_EQ(*instance->find("i")->number(), 2);
  EXPECT_EQ(*instance->find("n")->number(), 5);
  const Value& value = (*instance->find("values")->list())[0];
  EXPECT_EQ(Studio::text_of(value, "path"), "components.ball.colour_at");
  EXPECT_EQ(*value.find("value")->number(), 0.5);
  EXPECT_TRUE(
      studio.ask("instance", R"("component": "no", "frame": [1,0,0,4, 0,1,0,0, 0,0,1,0], "position": [0, 0, 0])")
          .find("instance")
          ->is_null());
}

TEST(StudioSession, TellsTheShootThatIsSeen) {
  Studio studio;
  studio.open_bush();
  studio.mailbox().packet(0);
  const Value answer =
      studio.ask("instance", R"("component": "stem", "frame": [1,0,0,0, 0,1,0,0, 0,0,1,0], "position": [0, 1, 0.01])");
  ASSERT_NE(answer.find("instance"), nullptr);
  EXPECT_EQ(Studio::text_of(*answer.find("instance"), "shoot"), "main");
  EXPECT_TRUE(answer.find("instance")->find("iteration")->is_null());
}

const std::string kPear =
    R"json("text": "{\"meristem\": 1, \"scene\": {\"sun\": {\"azimuth\": 90, \"altitude\": 45}, \"obstacles\": [{\"box\": [[-3, 0, -2], [3, 2, -1]]}]}, \"components\": {\"pear\": {\"type\": \"organize\", \"frame\": {\"translate\": [0, 0, 1]}, \"iterations\": 9, \"roots\": [[0, 0, 0], [2, 0, 0]], \"operations\": [{\"do\": \"cut\", \"at\": 8, \"shoots\": \"leader\", \"above\": 5}, {\"do\": \"cut\", \"at\": 9, \"shoots\": \"rank == 1\", \"above\": 1, \"off\": true}]}}}")json";

TEST(StudioSession, TellsWhereAShootIsSeenAndWhatCouldCutIt) {
  Studio studio;
  studio.ask("open", kPear);
  studio.mailbox().packet(0);
  const Value answer = studio.ask(
      "instance", R"("component": "pear", "frame": [1,0,0,0, 0,1,0,0, 0,0,1,0], "position": [2, 0.305, 1.01])");
  const Value& instance = *answer.find("instance");
  EXPECT_EQ(Studio::text_of(instance, "shoot"), "main");
  EXPECT_EQ(*instance.find("tree")->number(), 1);
  EXPECT_EQ(*instance.find("metamer")->number(), 3);
  EXPECT_EQ(*instance.find("iteration")->number(), 9);
  const std::size_t nodes = instance.find("metamers")->list()->size();
  EXPECT_EQ(instance.find("course")->list()->size(), 3 * nodes);
  EXPECT_EQ(*(*instance.find("metamers")->list())[0].number(), 0);
}

TEST(StudioSession, TellsWhatOperationsHaveDone) {
  Studio studio;
  studio.ask("open", kPear);
  studio.mailbox().packet(0);
  const Value all = studio.ask("operations", R"("component": "pear")");
  const Value& told = *all.find("operations");
  EXPECT_EQ(*told.find("iteration")->number(), 9);
  // One that is off does nothing.
  const Value::List& acts = *told.find("acts")->list();
  ASSERT_EQ(acts.size(), 1U);
  EXPECT_EQ(acts[0], Value(Value::List{"components.pear.operations[0]", 8, "cut", 2.0}));
  EXPECT_TRUE(told.find("places")->list()->empty());
  const Value one =
      studio.ask("operations", R"("component": "pear", "operation": "components.pear.operations[0]", "iteration": 8)");
  const Value::List& places = *one.find("operations")->find("places")->list();
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(*places[1].find("tree")->number(), 1);
  EXPECT_EQ(Studio::text_of(places[1], "shoot"), "main");
  EXPECT_EQ(places[1].find("course")->list()->size(), 6U);
  EXPECT_TRUE(studio.ask("operations", R"("component": "nobody")").find("operations")->is_null());
}

TEST(StudioSession, TellsWhereAComponentStandsAndWhatSurroundsIt) {
  Studio studio;
  studio.ask("open", kPear);
  const ReadPacket packet(studio.mailbox().packet(0));
  const Value::List& batches = *packet.head.find("batches")->list();
  EXPECT_EQ(Studio::text_of(batches.back(), "component"), "scene.obstacles[0]");
  EXPECT_NE(packet.head.find("scene"), nullptr);
  const Value answer = studio.ask("stand", R"("component": "pear")");
  const Value::List& stand = *answer.find("stand")->list();
  ASSERT_EQ(stand.size(), 12U);
  EXPECT_EQ(*stand[0].number(), 1);
  EXPECT_EQ(*stand[11].number(), 0);  // before the component's own frame
  EXPECT_TRUE(studio.ask("stand", R"("component": "nobody")").find("stand")->is_null());
}

TEST(StudioSession, CountsInstancesOfTheGraph) {
  Studio studio;
  studio.open_bush();
  const Value grown = studio.mailbox().wait_for(
      [](const Value& message) { return Studio::text_of(message, "is") == "grown" && message.find("placed"); });
  EXPECT_EQ(*grown.find("placed")->find("leaf")->number(), 40);
  EXPECT_EQ(*grown.find("placed")->find("stem")->number(), 1);
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

TEST(StudioSession, EndsInTheMiddleOfWork) {
  Studio studio;
  studio.open_bush();
  studio.edit(R"([{"set": "links[0].count", "value": 2000000}])");
  studio.page().receive(studio.request("export", R"("format": ".glb")"));
}

}  // namespace meristem::studio::studio_session_test

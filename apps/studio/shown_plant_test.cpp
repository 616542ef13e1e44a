// SPDX-License-Identifier: Apache-2.0
// Packets of grown plants, and the messages that accompany them.
#include <thread>

#include <gtest/gtest.h>

#include "test_studio.h"

namespace meristem::studio::shown_plant_test {

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

/// A page whose messages arrive before the first of them is handled.
struct HastyPage {
  explicit HastyPage(Studio& of) : studio(of), page(of.host(), mailbox, readings) {
    // A reading looks only now and then whether it shall stop, so the text has many values.
    std::string keys;
    for (int k = 0; k < 5000; ++k) keys += (k == 0 ? "[" : ", [") + std::to_string(k) + ", 1.5]";
    text.insert(text.find("\"components\""),
                R"("animation": {"length": 5000, "keys": {"stem.length": [)" + keys + "]}}, ");
  }
  void receive(const std::vector<std::string>& messages) {
    for (const std::string& message : messages) readings->arrive(message);
    for (const std::string& message : messages) page.receive(message);
  }
  void show(std::size_t k) {
    const ReadPacket packet(mailbox->packet(k));
    receive({studio.request("shown", "\"packet\": " + std::to_string(static_cast<int>(packet.number("packet"))))});
  }
  /// Opens the text as request 1, and drags as request 3.
  void open_and_drag() {
    receive({studio.request("open", "\"text\": " + write_json_line(Value(text)))});
    show(0);
    receive({studio.request("drag", R"("values": {"leaf.width": 0.08})")});
    show(1);
  }
  /// Waits for a growth with a drag's values, and for one without them after it.
  void wait_for_end_of_drag() {
    bool was_dragged = false;
    mailbox->wait_for([&](const Value& message) {
      if (Studio::text_of(message, "is") != "grown") return false;
      const bool is_dragged = *message.find("dragged")->boolean();
      was_dragged = was_dragged || is_dragged;
      return was_dragged && !is_dragged;
    });
  }

  Studio& studio;
  std::string text = kBush;
  std::shared_ptr<Mailbox> mailbox = std::make_shared<Mailbox>();
  std::shared_ptr<Readings> readings = std::make_shared<Readings>();
  StudioSession page;
};

TEST(StudioSession, ADragThatEndsUnreadEndsWithTheNextText) {
  Studio studio;
  HastyPage page(studio);
  page.open_and_drag();
  ASSERT_TRUE(*page.mailbox->answer(1).find("good")->boolean());
  const std::string drag = studio.request("drag", R"("values": {})");
  const std::string splice =
      studio.request("splice", "\"base\": \"" + text_hash(page.text) + R"(", "patch": [[0, 0, " "]])");
  page.receive({drag, splice});
  ASSERT_NE(page.mailbox->answer(5).find("superseded"), nullptr);
  const Value read = page.mailbox->answer(6);
  ASSERT_TRUE(*read.find("good")->boolean());
  const Value grown = page.mailbox->wait_for([&](const Value& message) {
    return Studio::text_of(message, "is") == "grown" &&
           Studio::text_of(message, "hash") == Studio::text_of(read, "hash");
  });
  EXPECT_FALSE(*grown.find("dragged")->boolean());
}

TEST(StudioSession, ADragThatEndsUnreadEndsWhenAnotherDocumentCannotBeOpened) {
  Studio studio;
  HastyPage page(studio);
  page.open_and_drag();
  page.receive({studio.request("drag", R"("values": {})"), studio.request("open", R"("path": "nothing.json")")});
  ASSERT_NE(page.mailbox->answer(5).find("superseded"), nullptr);
  ASSERT_TRUE(is_refused(page.mailbox->answer(6)));
  page.wait_for_end_of_drag();
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

TEST(StudioSession, ALargePlantShowsADraftFirst) {
  Studio studio;
  studio.ask("view", R"("rest_triangles": 1000, "drag_triangles": 100)");
  const std::string hash = studio.open_large_bush();
  const ReadPacket rest = studio.show(hash);
  ASSERT_EQ(studio.mailbox().packet_count(), 2U);
  const ReadPacket draft(studio.mailbox().packet(0));
  EXPECT_TRUE(draft.flag("draft"));
  EXPECT_TRUE(draft.flag("fit"));
  EXPECT_LE(draft.number("triangles"), 150);
  EXPECT_GT(rest.number("triangles"), 3 * draft.number("triangles"));
  EXPECT_LE(rest.number("triangles"), 1200);
  EXPECT_GT(*rest.head.find("of")->find("triangles")->number(), 100'000);
}

TEST(StudioSession, ShowsNoPlantOfADocumentThatWasLeft) {
  Studio studio;
  studio.ask("view", R"("rest_triangles": 1000, "drag_triangles": 100)");
  const std::string large = studio.open_large_bush();  // its growth is running, or its packets are on their way
  const Value opened = studio.ask("open", painted_document());
  const std::size_t before = studio.mailbox().packet_count();
  const std::string hash = Studio::text_of(opened, "hash");
  const ReadPacket shown = studio.show(hash);
  for (std::size_t k = before; k < studio.mailbox().packet_count(); ++k) {
    const ReadPacket packet(studio.mailbox().packet(k));
    EXPECT_EQ(*packet.head.find("hash")->text(), hash) << "and not " << large;
    EXPECT_EQ(packet.flag("whole"), k == before);
  }
  // The scene holds what the page would draw.
  Studio other;
  other.show(Studio::text_of(other.ask("open", painted_document()), "hash"));
  EXPECT_EQ(studio.scene(), other.scene());
}

TEST(StudioSession, ADocumentWithFaultsShowsNoPlantOfTheOneBefore) {
  Studio studio;
  studio.open_bush();
  studio.show();
  const std::size_t before = studio.mailbox().packet_count();
  const Value opened =
      studio.ask("open", R"("text": "{\"meristem\": 1, \"components\": {\"a\": {\"type\": \"nothing\"}}}")");
  EXPECT_FALSE(*opened.find("good")->boolean());
  studio.ask("stand", R"("component": "a")");  // answered by the thread that grows, after all before
  EXPECT_EQ(studio.mailbox().packet_count(), before);
}

TEST(StudioSession, GrowthThatReachedTheTimeLimitGoesOn) {
  Studio studio;
  studio.host().limits.job_seconds = 0;
  const std::string hash = studio.open_large_bush();
  const Value failed =
      studio.mailbox().wait_for([](const Value& message) { return Studio::text_of(message, "is") == "failed"; });
  EXPECT_EQ(Studio::text_of(failed, "limit"), "job_seconds");
  EXPECT_TRUE(*failed.find("continues")->boolean());
  EXPECT_EQ(studio.mailbox().packet_count(), 0U);
  studio.host().limits.job_seconds = 60;
  studio.ask("continue");
  EXPECT_FALSE(studio.show(hash).flag("draft"));
}

TEST(StudioSession, MeshingThatReachedTheTimeLimitKeepsTheDraftAndGoesOn) {
  Studio studio;
  studio.ask("view", R"("rest_triangles": 1000, "drag_triangles": 100)");
  const std::string hash = studio.open_large_bush();
  const ReadPacket draft(studio.mailbox().packet(0));
  ASSERT_TRUE(draft.flag("draft"));
  studio.host().limits.job_seconds = 0;  // for the picture at rest, which waits for this answer
  studio.ask("shown", "\"packet\": " + std::to_string(static_cast<int>(draft.number("packet"))));
  const Value failed =
      studio.mailbox().wait_for([](const Value& message) { return Studio::text_of(message, "is") == "failed"; });
  EXPECT_EQ(Studio::text_of(failed, "hash"), hash);
  EXPECT_TRUE(*failed.find("continues")->boolean());
  EXPECT_EQ(studio.mailbox().packet_count(), 1U) << "the draft stays";
  studio.host().limits.job_seconds = 60;
  studio.ask("continue");
  const ReadPacket rest(studio.mailbox().packet(1));
  EXPECT_FALSE(rest.flag("draft"));
  EXPECT_GT(rest.number("triangles"), draft.number("triangles"));
  studio.ask("shown", "\"packet\": " + std::to_string(static_cast<int>(rest.number("packet"))));
  studio.ask("continue");
  studio.ask("stand", R"("component": "leaf")");  // answered by the thread that grows, after all before
  EXPECT_EQ(studio.mailbox().packet_count(), 2U) << "there is nothing to go on with";
}

TEST(StudioSession, CountsInstancesOfTheGraph) {
  Studio studio;
  studio.open_bush();
  const Value grown = studio.mailbox().wait_for(
      [](const Value& message) { return Studio::text_of(message, "is") == "grown" && message.find("placed"); });
  EXPECT_EQ(*grown.find("placed")->find("leaf")->number(), 40);
  EXPECT_EQ(*grown.find("placed")->find("stem")->number(), 1);
}

TEST(StudioSession, WhatStandsBesideAPlantIsOfThePlantsTime) {
  Studio studio;
  const std::string hash = Studio::text_of(
      studio.ask(
          "open",
          R"json("text": "{\"meristem\": 1, \"scene\": {\"sun\": {\"azimuth\": 90, \"altitude\": 30}}, \"components\": {\"row\": {\"type\": \"hydra\", \"number\": 3, \"radius\": 1}, \"ball\": {\"type\": \"simple\", \"size\": [1, 1, 1]}}, \"links\": [[\"row\", \"ball\"]], \"animation\": {\"length\": 4, \"keys\": {\"row.number\": [[0, 3], [4, 7]], \"scene.sun.altitude\": [[0, 30], [4, 90]]}}}")json"),
      "hash");
  studio.show(hash);
  studio.ask("view", R"("time": 4)");
  const ReadPacket packet = studio.show(hash);
  const Value& sun = *packet.head.find("scene")->find("sun");
  EXPECT_NEAR(*sun.list()->at(1).number(), 1, 1e-6) << write_json_line(sun);
  const Value grown = studio.mailbox().wait_for([](const Value& message) {
    const Value* placed = message.find("placed");
    return placed != nullptr && *placed->find("ball")->number() != 3;
  });
  EXPECT_EQ(*grown.find("placed")->find("ball")->number(), 7);
}

}  // namespace meristem::studio::shown_plant_test

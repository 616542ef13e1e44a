// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/silent_keys.h"

#include <gtest/gtest.h>

#include "meristem/components/camera.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"

namespace meristem::silent_keys_test {

Document read(const std::string& components, const std::vector<std::string>& sets = {}) {
  ReadOptions options;
  for (const std::string& set : sets) options.overrides.push_back(parse_override(set));
  return read_document(R"({"meristem": 1, "components": )" + components + "}", "plant.json", builtin_components(),
                       options);
}

std::string error_of(const std::string& components, const std::vector<std::string>& sets = {}) {
  try {
    read(components, sets);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(SilentKeys, ARecursionThatNoLinkClosesIsAFault) {
  EXPECT_EQ(error_of(R"({"box": {"type": "simple", "recursion": 3}})"),
            "plant.json:1:58: components.box.recursion: 'recursion' has no meaning here: no link leads back to 'box'; "
            "expected a link from 'box', or from what hangs on it, to 'box', or no such key");
  EXPECT_EQ(error_of(R"({"box": {"type": "simple", "recursion": 3}}, "links": [["box", "box"]])"), "no fault");
}

TEST(SilentKeys, AnglesThatTurnNothingAreFaults) {
  const std::string components = R"({"stem": {"type": "tree"}, "grass": {"type": "grassleaf"}}, "links": [
    {"from": "stem", "to": "grass", "kind": "branch", )";
  EXPECT_NE(
      error_of(components + R"("angle_tip": 20}])").find("links[0].angle_tip: 'angle_tip' has no meaning without"),
      std::string::npos);
  EXPECT_EQ(error_of(components + R"("angle_tip": 20, "angle": 50}])"), "no fault");
}

constexpr const char* kViewed =
    R"({"view": {"type": "camera", "azimuth": 30, "altitude": 5}, "box": {"type": "simple", "shape": "tube",
        "cap": false}}, "links": [["view", "box"]])";

TEST(SilentKeys, WhatIsSetGoesBeforeTheDocument) {
  const Document document = read(kViewed, {"view.position=[0, 1, 5]", "box.shape=cone"});
  EXPECT_EQ(*camera_view(document.graph).position, Vec3(0, 1, 5));
  EXPECT_EQ(document.source.tree.find("components")->find("view")->find("azimuth"), nullptr);
  EXPECT_EQ(document.source.tree.find("components")->find("box")->find("cap"), nullptr);
}

TEST(SilentKeys, WhatIsSetItselfMustMeanSomething) {
  EXPECT_EQ(
      error_of(kViewed, {"view.position=[0, 1, 5]", "view.azimuth=10"}),
      "--set view.azimuth: components.view.azimuth: 'azimuth' has no meaning beside 'position'; expected only one "
      "of them");
  EXPECT_NE(error_of(kViewed, {"box.outline=[[0, 0]]", "box.segments=5"}), "no fault");
}

TEST(SilentKeys, OtherFaultsOfTheDocumentDoNotGiveWay) {
  const char* const faulty = R"({"box": {"type": "simple", "cap": true}, "ball": {"type": "simple"}})";
  EXPECT_EQ(error_of(faulty, {"ball.shape=sphere"}).substr(0, 33), "plant.json:1:58: components.box.c");
}

TEST(SilentKeys, NullTakesAKeyAway) {
  EXPECT_EQ(read(kViewed, {"view.azimuth=null"}).source.tree.find("components")->find("view")->find("azimuth"),
            nullptr);
  EXPECT_EQ(error_of(kViewed, {"veiw.azimuth=null"}).substr(0, 45), "--set veiw.azimuth: components.veiw.azimuth: ");
}

}  // namespace meristem::silent_keys_test

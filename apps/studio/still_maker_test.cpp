// SPDX-License-Identifier: Apache-2.0
#include "still_maker.h"

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/json.h"

namespace meristem::studio::still_maker_test {

constexpr const char* kTree = R"json({"meristem": 1, "variables": {"age": {"value": 4, "min": 1, "max": 9}},
  "components": {
    "stem": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 2, 0], "radii": [1, 1, 1]}}, "points": "10*age",
             "step": 0.3, "influence": 1, "kill": 0.3, "texture": {"bark": {}, "pixels": 32}},
    "leaf": {"type": "leaf", "length": 0.2, "width": 0.1, "texture": {"leaf": {}, "pixels": 32}}},
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 3}]})json";

StillsRequest request_for(const std::vector<double>& ages) {
  StillsRequest request{.states = {}, .width = 8, .height = 8, .camera = {}};
  request.camera.position = Vec3(0, 2, 8);
  request.camera.target = Vec3(0, 2, 0);
  for (const double age : ages) request.states.push_back({{.path = "age", .value = age, .name = "age"}});
  return request;
}

std::string made(StillMaker& maker, const StillsRequest& request, const std::string& text = kTree) {
  Progress progress;
  return write_json_line(
      maker.make({.text = text, .file = "", .root = "", .models = ""}, request, builtin_components(), progress));
}

TEST(StillMaker, MakesTheSamePicturesOnAnyNumberOfThreadsAndOfWhatStayed) {
  const StillsRequest request = request_for({1, 2, 3});
  std::string first;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    StillMaker maker;
    const std::string pictures = made(maker, request);
    if (first.empty()) first = pictures;
    EXPECT_EQ(pictures, first) << threads << " threads";
    EXPECT_EQ(made(maker, request), first) << "of what stayed";
  }
}

TEST(StillMaker, KeepsWhatEveryStateHasGrown) {
  const ThreadLimit limit(2);
  StillMaker maker;
  made(maker, request_for({1, 3, 9}));
  const std::uint64_t kept = maker.kept_bytes();
  made(maker, request_for({9, 9, 9}));
  EXPECT_LT(2 * maker.kept_bytes(), 3 * kept) << "equal states share what they have grown";
  made(maker, request_for({1, 3, 9}));
  EXPECT_EQ(maker.kept_bytes(), kept);
}

TEST(StillMaker, TellsTheFaultsOfAStateAndDrawsTheOthers) {
  StillMaker maker;
  StillsRequest request = request_for({1, 3});
  request.states[0][0].value = "nobody";
  Progress progress;
  const Value pictures =
      maker.make({.text = kTree, .file = "", .root = "", .models = ""}, request, builtin_components(), progress);
  EXPECT_NE((*pictures.list())[0].find("faults"), nullptr);
  EXPECT_NE((*pictures.list())[1].find("picture"), nullptr);
}

TEST(StillMaker, EndsWhereItIsCancelled) {
  StillMaker maker;
  Progress progress;
  progress.cancel();
  EXPECT_THROW(maker.make({.text = kTree, .file = "", .root = "", .models = ""}, request_for({1, 3}),
                          builtin_components(), progress),
               Cancelled);
}

}  // namespace meristem::studio::still_maker_test

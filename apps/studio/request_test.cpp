// SPDX-License-Identifier: Apache-2.0
#include "request.h"

#include <gtest/gtest.h>

#include "refusal.h"

namespace meristem::studio::request_test {

template <class Kind>
Kind read(const std::string& message) {
  return std::get<Kind>(read_request(message).request);
}

std::string refusal(const std::string& message) {
  try {
    read_request(message);
  } catch (const Refusal& refused) {
    return refused.what();
  }
  return "";
}

TEST(Request, ReadsEachKind) {
  EXPECT_EQ(read<OpenRequest>(R"({"do": "open", "id": 1, "model": "oak"})").model, "oak");
  EXPECT_EQ(read<OpenRequest>(R"({"do": "open", "id": 1, "text": "{}", "path": null})").path, std::nullopt);
  const auto splice = read<SpliceRequest>(R"({"do": "splice", "id": 1, "base": "a", "patch": [[0, 2, "x"]]})");
  EXPECT_EQ(splice.patch, (std::vector<UnitSplice>{{0, 2, "x"}}));
  const auto edit = read<EditRequest>(
      R"({"do": "edit", "id": 1, "base": "a", "edits": [{"set": "age", "value": 3}, {"unset": "a.b"},
          {"insert": "links[]", "value": []}, {"remove": "a"}, {"rename": "a", "name": "b"}, {"move": "a", "index": 2}]})");
  ASSERT_EQ(edit.edits.size(), 6U);
  EXPECT_EQ(std::get<MoveValue>(edit.edits[5]).index, 2U);
  EXPECT_EQ(read<DragRequest>(R"({"do": "drag", "id": 1, "values": {"age": 3}})").values[0].path, "age");
  const auto view = read<ViewRequest>(R"({"do": "view", "id": 1, "skeleton": true, "rest_triangles": 1000})");
  EXPECT_EQ(view.skeleton, true);
  EXPECT_EQ(view.surface, std::nullopt);
  EXPECT_EQ(view.rest_triangles, 1000U);
  EXPECT_FALSE(view.growth);
  const auto growth = read<ViewRequest>(R"({"do": "view", "id": 1, "growth": {"step": 12, "recorded": true}})").growth;
  EXPECT_EQ(growth->step, 12);
  EXPECT_TRUE(growth->is_recorded);
  EXPECT_EQ(read<ViewRequest>(R"({"do": "view", "id": 1, "growth": {"step": null, "recorded": false}})").growth->step,
            std::nullopt);
  EXPECT_EQ(read<OverlaysRequest>(R"({"do": "overlays", "id": 1, "parts": ["sun"]})").parts.size(), 1U);
  EXPECT_EQ(read<ShownRequest>(R"({"do": "shown", "id": 1, "packet": 7})").packet, 7U);
  read<ContinueRequest>(R"({"do": "continue", "id": 1})");
  EXPECT_TRUE(read<PauseRequest>(R"({"do": "pause", "id": 1, "paused": true})").paused);
  EXPECT_EQ(read<SaveRequest>(R"({"do": "save", "id": 1, "path": "a.json", "hash": "0", "saved": null})").saved,
            std::nullopt);
  const auto exported = read<ExportRequest>(
      R"({"do": "export", "id": 1, "format": ".png", "name": "a", "options": {"width": 64, "height": 32, "samples": 2,
          "camera": {"position": [1, 2, 3], "target": [0, 0, 0], "field_of_view": 30}}})");
  EXPECT_EQ(exported.options.width, 64);
  EXPECT_EQ(exported.options.camera->position, Vec3(1, 2, 3));
  const auto stills = read<StillsRequest>(
      R"({"do": "stills", "id": 1, "states": [{"age": 3}, {}], "width": 64, "height": 48,
          "camera": {"position": [1, 2, 3], "target": [0, 0, 0], "field_of_view": 30}, "fit": false})");
  ASSERT_EQ(stills.states.size(), 2U);
  EXPECT_EQ(stills.states[0][0].path, "age");
  EXPECT_EQ(stills.height, 48);
  EXPECT_FALSE(stills.fits);
  EXPECT_TRUE(read<StillsRequest>(R"({"do": "stills", "id": 1, "states": []})").states.empty());
  const auto grammar = read<GrammarRequest>(
      R"({"do": "grammar", "id": 1, "component": "fir", "step": 3, "drawn": true, "first": 10, "count": 20,
          "instance": "00000000000000ff"})");
  EXPECT_EQ(grammar.key, 255U);
  EXPECT_EQ(grammar.step, 3);
  EXPECT_TRUE(grammar.is_drawn);
  EXPECT_EQ(grammar.first + grammar.count, 30U);
  EXPECT_EQ(read<PictureRequest>(R"({"do": "picture", "id": 1, "file": "bark.png"})").size, 96);
  EXPECT_EQ(read<StandRequest>(R"({"do": "stand", "id": 1, "component": "oak"})").component, "oak");
  EXPECT_EQ(read<CloudRequest>(R"({"do": "cloud", "id": 1, "component": "oak"})").component, "oak");
  const auto looked =
      read<ViewRequest>(R"({"do": "view", "id": 1, "growth": {"step": 4, "recorded": true, "of": "oak"}})");
  EXPECT_EQ(looked.growth->step, 4);
  EXPECT_EQ(looked.growth->of, "oak");
  EXPECT_EQ(read<ViewRequest>(R"({"do": "view", "id": 1, "growth": {"recorded": true, "of": null}})").growth->of, "");
  const auto shoot = read<ShootRequest>(
      R"({"do": "shoot", "id": 1, "component": "pear", "of": {"stem": 2, "tree": 1, "shoot": "main.4", "metamer": 3},
          "go": "child"})");
  EXPECT_EQ(shoot.of->stem + shoot.of->tree + shoot.of->metamer, 6U);
  EXPECT_EQ(shoot.of->shoot, "main.4");
  EXPECT_EQ(shoot.go, ShootRequest::Go::child);
  EXPECT_FALSE(read<ShootRequest>(R"({"do": "shoot", "id": 1, "component": "pear", "of": null, "go": null})").of);
  const auto worked_out =
      read<WorkedOutRequest>(R"({"do": "worked_out", "id": 1, "expressions": {"scene.latitude": "2*b"}})");
  EXPECT_EQ(worked_out.component, std::nullopt);
  EXPECT_EQ(worked_out.expressions[0].second, "2*b");
  const auto curves = read<CurvesRequest>(R"({"do": "curves", "id": 1, "component": "leaf", "rank": -3})");
  EXPECT_EQ(curves.rank, -3);
  EXPECT_EQ(curves.leaf, std::nullopt);
  const auto operations = read<OperationsRequest>(
      R"({"do": "operations", "id": 1, "component": "pear", "operation": "a", "iteration": 3})");
  EXPECT_EQ(operations.operation, "a");
  EXPECT_EQ(operations.iteration, 3);
  EXPECT_EQ(read<OperationsRequest>(R"({"do": "operations", "id": 1, "component": "pear"})").iteration, std::nullopt);
  const auto film = read<ExportRequest>(
      R"({"do": "export", "id": 1, "format": ".mp4", "options": {"frames": {"from": 1, "to": 2, "step": 0.04}}})");
  EXPECT_EQ(film.options.frames->count(), 26U);
  EXPECT_DOUBLE_EQ(film.options.frames->at(25), 2);
  const auto sweep =
      read<SweepRequest>(R"({"do": "sweep", "id": 1, "path": "age", "values": [1, 2.5], "light": true})");
  EXPECT_EQ(sweep.values, (std::vector<double>{1, 2.5}));
  EXPECT_TRUE(sweep.light);
  EXPECT_EQ(read<ClocksRequest>(R"({"do": "clocks", "id": 1, "up_to": 8})").up_to, 8);
  EXPECT_EQ(read<MeasuresRequest>(R"({"do": "measures", "id": 1, "layer_height": 0.5})").layer_height, 0.5);
  for (const char* plain : {"all", "cancel", "models", "measures"})
    EXPECT_EQ(refusal(std::string(R"({"id": 1, "do": ")") + plain + "\"}"), "") << plain;
}

TEST(Request, NamesThePlaceOfAFault) {
  EXPECT_NE(refusal("").find("not JSON"), std::string::npos);
  EXPECT_EQ(refusal("[]"), "the message is not an object");
  EXPECT_EQ(refusal("{}"), "the message has no 'id'");
  EXPECT_EQ(refusal(R"({"id": 1.5, "do": "all"})"), "'id' is not a whole number from 0 to 9007199254740992");
  EXPECT_EQ(refusal(R"({"id": 1})"), "the message has no 'do'");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "dance"})"), "there is no request 'dance'");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "worked_out", "expressions": {"a": 1}})"), "'expressions.a' is not a text");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "stills", "states": [3]})"), "'states[0]' is not an object");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "stills", "states": [{}], "width": 5000})"),
            "'width' is not a whole number from 16 to 512");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "stills", "states": [{}], "width": 64})"), "the message has no 'height'");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "stills", "states": [{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}]})"),
            "'states' has more than 16 parts");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "grammar", "component": "a", "instance": "ff"})"),
            "'instance' is not the key of an instance: 16 hexadecimal digits");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "grammar", "component": "a", "step": -1})"),
            "'step' is not a whole number from 0 to 1000000");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "grammar", "component": "a", "count": 1e6})"),
            "'count' is not a whole number from 0 to 20000");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "operations", "component": "a", "iteration": -1})"),
            "'iteration' is not a whole number from 0 to 1000000");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "curves", "component": "a", "rank": 2.7})"),
            "'rank' is not a whole number from -1000000 to 1000000");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "picture", "file": "a.png", "size": 1})"),
            "'size' is not a whole number from 16 to 512");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "splice", "base": "a", "patch": [[1, 2]]})"),
            "'patch[0]' is not a list [offset, length, replacement]");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "splice", "base": "a", "patch": [[0, 0, ""], [-1, 2, ""]]})"),
            "'patch[1][0]' is not a whole number from 0 to 9007199254740992");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "edit", "base": "a", "edits": [{}]})"),
            "'edits[0]' has none of set, unset, insert, remove, rename, move, note, paste");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "edit", "base": "a", "edits": [{"set": "a"}]})"), "'edits[0]' has no 'value'");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "edit", "base": "a", "edits": [{"paste": "", "names": {"a": 1}}]})"),
            "'edits[0].names.a' is not a text");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "view", "time": "now"})"),
            "'time' is not a number from -1000000000 to 1000000000 (s)");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "view", "growth": {"step": 1}})"), "'growth' has no 'recorded'");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "view", "rest_triangles": 1e30})"),
            "'rest_triangles' is not a whole number from 100 to 1000000000");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "export", "format": ".png", "options": {"width": 0}})"),
            "'options.width' is not a whole number from 1 to 16384");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "export", "format": ".png", "options": []})"), "'options' is not an object");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "sweep", "path": "age", "values": []})"), "'values' has fewer than 1 parts");
}

TEST(Request, NamesTheNearestValidName) {
  EXPECT_EQ(refusal(R"({"id": 1, "do": "opne", "model": "oak"})"), "there is no request 'opne'; did you mean 'open'?");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "open", "modle": "oak"})"),
            "the message has an unknown member 'modle'; did you mean 'model'?");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "all", "now": true})"),
            "the message has an unknown member 'now'; there are no members");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "export", "format": ".png", "options": {"tiem": 1}})"),
            "'options' has an unknown member 'tiem'; did you mean 'time'?");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "export", "format": ".glb", "options": {"instances": "row"}})"),
            "'options.instances' is none of automatic, rows, nodes; did you mean 'rows'?");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "edit", "base": "a", "edits": [{"unset": "a"}, {"ste": "a", "value": 1}]})"),
            "'edits[1]' has none of set, unset, insert, remove, rename, move, note, paste; did you mean 'set'?");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "shoot", "component": "a", "go": "up"})"),
            "'go' is none of parent, child, next, previous");
  EXPECT_EQ(refusal(R"({"id": 1, "do": "shoot", "component": "a", "go": "chidl"})"),
            "'go' is none of parent, child, next, previous; did you mean 'child'?");
}

TEST(Request, MembersThatDoNotFitTogetherAreRefused) {
  constexpr const char* kOpens =
      "the message opens a document by its 'path', by the name of a 'model', or from a 'text'";
  EXPECT_EQ(refusal(R"({"id": 1, "do": "open"})"), kOpens);
  EXPECT_EQ(refusal(R"({"id": 1, "do": "open", "model": "oak", "path": ""})"), kOpens);
  EXPECT_EQ(refusal(R"({"id": 1, "do": "part", "model": "oak", "text": ""})"),
            "the message has both a 'model' and a 'text'");
  const auto film = [](const std::string& frames) {
    return refusal(R"({"id": 1, "do": "export", "format": ".mp4", "options": {"frames": )" + frames + "}}");
  };
  EXPECT_EQ(film(R"({"to": 2, "step": 1})"), "'options.frames' has no 'from'");
  EXPECT_EQ(film(R"({"from": 3, "to": 2, "step": 1})"), "'options.frames' needs an end that is not before the start");
  EXPECT_EQ(film(R"({"from": 0, "to": 1000, "step": 0.01})"), "'options.frames' needs at most 10000 frames");
  EXPECT_EQ(film(R"({"from": 0, "to": 1e9, "step": 1e-6})"), "'options.frames' needs at most 10000 frames");
  EXPECT_EQ(film(R"({"from": 0, "to": 1, "step": 0})"),
            "'options.frames.step' is not a number from 1e-06 to 1000000000 (s)");
}

TEST(Request, OfNoGoodStillHasANumber) {
  EXPECT_EQ(request_id(R"({"id": 12, "do": "dance"})"), 12);
  EXPECT_EQ(request_id("{"), std::nullopt);
}

}  // namespace meristem::studio::request_test

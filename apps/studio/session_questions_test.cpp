// SPDX-License-Identifier: Apache-2.0
// Questions of a page about a grown plant.
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/export/overlay/overlay.h"
#include "test_studio.h"

namespace meristem::studio::session_questions_test {

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

TEST(StudioSession, TellsTheDerivationAtTheTimeThatIsShown) {
  Studio studio;
  std::string text = R"json("text": "{\"meristem\": 1, \"components\": {\"weed\":
    {\"type\": \"lsystem\", \"grammar\": [\"F\", \"#rules\", \"F -> F[+F]F\"], \"steps\": 1, \"length\": 1}},
    \"animation\": {\"length\": 4, \"keys\": {\"weed.steps\": [[0, 1], [4, 3]]}}}")json";
  std::erase(text, '\n');
  ASSERT_TRUE(*studio.ask("open", text).find("good")->boolean());
  studio.ask("view", R"("time": 4)");
  EXPECT_EQ(*studio.ask("grammar", R"("component": "weed")").find("derivation")->find("steps")->number(), 3);
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

const std::string kColonizedTree =
    R"json("text": "{\"meristem\": 1, \"seed\": 4, \"components\": {\"tree\": {)json"
    R"json(\"type\": \"colonize\", \"crown\": {\"sphere\": {\"centre\": [0, 1, 0], \"radius\": 0.5}},)json"
    R"json(\"points\": 60, \"step\": 0.06, \"influence\": 0.8, \"kill\": 0.16,)json"
    R"json(\"iterations\": 18}}}", "path": null)json";

TEST(StudioSession, MeasuresAllOfGrowthWhileAStepOfItIsShown) {
  Studio studio;
  const std::string hash = Studio::text_of(studio.ask("open", kColonizedTree), "hash");
  studio.show(hash);
  const Value grown = *studio.ask("measures").find("measures");
  studio.ask("view", R"("growth": {"step": 7, "recorded": true})");
  studio.show(hash);
  EXPECT_EQ(write_json_line(*studio.ask("measures").find("measures")), write_json_line(grown));
}

TEST(StudioSession, QuestionsDoNotGrowWhatIsShownAgain) {
  Studio studio;
  const std::string hash = Studio::text_of(studio.ask("open", kColonizedTree), "hash");
  studio.ask("view", R"("growth": {"step": 7, "recorded": true})");
  studio.show(hash);
  EXPECT_FALSE(studio.ask("stand", R"("component": "tree")").find("stand")->is_null());
  EXPECT_FALSE(is_refused(studio.ask("clocks", R"("up_to": 0)")));
  // What those two asked has left the growth in the cache as it was: another step of it is there.
  studio.ask("view", R"("growth": {"step": 8, "recorded": true})");
  studio.show(hash);
  const Value grown = studio.mailbox().wait_for([](const Value& message) {
    const Value* step = message.find("step");
    return step != nullptr && *message.find("is") == Value("grown") && *step == Value(8);
  });
  for (const Value& reuse : *grown.find("reuse")->list()) {
    if (*reuse.find("what") != Value("grown skeletons")) continue;
    EXPECT_EQ(*reuse.find("made"), Value(0));
  }
}

TEST(StudioSession, ShowsStepsOfOneGrowthWithTheirOverlays) {
  Studio studio;
  const Value opened = studio.ask("open", kColonizedTree);
  const std::string hash = Studio::text_of(opened, "hash");
  const auto show_growth = [&](const std::string& growth) {
    studio.ask("view", "\"growth\": " + growth);
    studio.show(hash);
  };
  studio.show(hash);
  show_growth(R"({"step": null, "recorded": true})");
  show_growth(R"({"step": 7, "recorded": true})");
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
  EXPECT_EQ(*(*layers[0].find("points")->find("positions")->list())[1].number(), 60 * 3);
  EXPECT_EQ(*(*layers[0].find("points")->find("colours")->list())[1].number(), 60 * 4);
  EXPECT_FALSE(layers[0].find("legend")->list()->empty());
  const Value refused = studio.ask("overlays", R"("parts": ["sun", "skeletton"])");
  EXPECT_TRUE(is_refused(refused));
  const std::string message = Studio::text_of(refused, "message");
  EXPECT_NE(message.find("'skeletton'"), std::string::npos) << message;
  EXPECT_NE(message.find("did you mean 'skeleton'?"), std::string::npos) << message;
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

const std::string kTwoTrees =
    R"json("text": "{\"meristem\": 1, \"components\": {\"tree\": {\"type\": \"organize\", \"iterations\": 7, \"jitter\": 0, \"roots\": [[0, 0, 0], [1.5, 0, 0]]}}}")json";

/// "main.4 of tree 0 at 5", or nothing.
std::string shoot_text(const Value& answer) {
  const Value& instance = *answer.find("instance");
  if (instance.is_null()) return "";
  return fmt::format("{} of tree {} at {}", Studio::text_of(instance, "shoot"), *instance.find("tree")->number(),
                     *instance.find("metamer")->number());
}

TEST(StudioSession, GoesFromShootToShootAlongTheTree) {
  Studio studio;
  studio.ask("open", kTwoTrees);
  studio.mailbox().packet(0);
  const auto go = [&](const std::string& shoot, int metamer, const std::string& way, int tree = 0) {
    return shoot_text(studio.ask(
        "shoot", fmt::format(R"("component": "tree", "of": {{"stem": 0, "tree": {}, "shoot": "{}", "metamer": {}}}{})",
                             tree, shoot, metamer, way.empty() ? "" : R"(, "go": ")" + way + "\"")));
  };
  EXPECT_EQ(shoot_text(studio.ask("shoot", R"("component": "tree")")), "main of tree 0 at 1");
  EXPECT_EQ(go("main", 1, "next"), "main of tree 1 at 1");
  EXPECT_EQ(go("main", 1, "previous", 1), "main of tree 0 at 1");
  EXPECT_EQ(go("main", 1, "parent"), "");
  EXPECT_EQ(go("main", 1, "child"), "main.2 of tree 0 at 1");
  EXPECT_EQ(go("main", 3, "child"), "main.4 of tree 0 at 1") << "the first at or above the place";
  EXPECT_EQ(go("main.2", 2, "next"), "main.4 of tree 0 at 1");
  EXPECT_EQ(go("main.4", 5, "parent"), "main of tree 0 at 4");
  EXPECT_EQ(go("main.4", 5, ""), "main.4 of tree 0 at 5");
  EXPECT_EQ(go("main.4", 50, ""), "main.4 of tree 0 at 6") << "no further than its tip";
  EXPECT_EQ(go("main.4", 0, ""), "main.4 of tree 0 at 0") << "where it springs from";
  EXPECT_EQ(go("main.77", 1, ""), "");
  // Round and round: all neighbours, each once.
  std::string shoot = "main.2";
  std::set<std::string> seen;
  while (seen.insert(shoot).second) shoot = go(shoot, 1, "next").substr(0, go(shoot, 1, "next").find(' '));
  EXPECT_EQ(shoot, "main.2");
  EXPECT_GT(seen.size(), 3U);
  EXPECT_TRUE(studio.ask("shoot", R"("component": "nobody")").find("instance")->is_null());
}

TEST(StudioSession, TellsWhatExpressionsComeTo) {
  Studio studio;
  std::string text = R"json("text": "{\"meristem\": 1, \"variables\": {\"tall\": 3, \"half\": \"tall/2\"},
    \"components\": {\"line\": {\"type\": \"places\", \"line\": {\"points\": [[0, 0], [8, 0]], \"spacing\": 2}},
    \"ball\": {\"type\": \"simple\", \"size\": [\"tall + i\", 1, \"half\"]}}, \"links\": [[\"line\", \"ball\"]]}")json";
  std::erase(text, '\n');
  ASSERT_TRUE(*studio.ask("open", text).find("good")->boolean());
  studio.mailbox().packet(0);
  const Value of_ball = studio.ask(
      "worked_out",
      R"("component": "ball", "expressions": {"components.ball.size[0]": "tall + i", "components.ball.size[2]": "half", "components.ball.shape": "sphere"})");
  EXPECT_EQ(write_json_line(*of_ball.find("numbers")),
            R"({"components.ball.size[0]": 3, "components.ball.size[2]": 1.5})");
  const Value of_scene =
      studio.ask("worked_out", R"json("expressions": {"scene.latitude": "10*tall", "scene.sun.hour": "rand()"})json");
  EXPECT_EQ(write_json_line(*of_scene.find("numbers")), R"({"scene.latitude": 30})");
}

TEST(StudioSession, TellsWhatOperationsHaveDone) {
  Studio studio;
  studio.ask("open", kPear);
  studio.mailbox().packet(0);
  const Value all = studio.ask("operations", R"("component": "pear")");
  const Value& told = *all.find("operations");
  EXPECT_EQ(*told.find("iteration")->number(), 9);
  // An operation that is off has no effect.
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

TEST(StudioSession, ShootsOfSeveralInstancesAreThoseOfTheirOwnTrees) {
  Studio studio;
  std::string text = R"json("text": "{\"meristem\": 1, \"components\": {\"view\": {\"type\": \"camera\"},
    \"row\": {\"type\": \"hydra\", \"number\": 3, \"radius\": 4}, \"pear\": {\"type\": \"organize\",
    \"iterations\": 9, \"operations\": [{\"do\": \"cut\", \"at\": 8, \"shoots\": \"leader\", \"above\": 5}]}},
    \"links\": [[\"view\", \"row\"], [\"row\", \"pear\"]]}")json";
  std::erase(text, '\n');
  ASSERT_TRUE(*studio.ask("open", text).find("good")->boolean());
  studio.mailbox().packet(0);
  const Value one = studio.ask("operations", R"("component": "pear", "operation": "components.pear.operations[0]")");
  const Value::List& places = *one.find("operations")->find("places")->list();
  ASSERT_EQ(places.size(), 3U);
  const auto numbers_of = [](const Value& point) {
    const Value::List& list = *point.list();
    return Vec3(*list[0].number(), *list[1].number(), *list[2].number());
  };
  for (const Value& place : places) {
    EXPECT_EQ(*place.find("tree")->number(), 0);
    const Value::List& course = *place.find("course")->list();
    ASSERT_EQ(course.size(), 6U);
    EXPECT_EQ(numbers_of(course.back()), numbers_of(*place.find("position")));
  }
  EXPECT_NE(numbers_of(*places[0].find("position")), numbers_of(*places[1].find("position")));
}

TEST(StudioSession, TellsThePointsOfACrownAsAHandMovesIt) {
  Studio studio;
  const Value opened = studio.ask("open", kColonizedTree);
  studio.show(Studio::text_of(opened, "hash"));
  const auto told = [&] { return *studio.ask("cloud", R"("component": "tree")").find("cloud"); };
  const Value before = told();
  EXPECT_EQ(*before.find("count"), Value(60));
  EXPECT_EQ(*(*before.find("positions")->list())[1].number(), 60 * 3);
  EXPECT_EQ(told(), before);
  studio.ask("drag", R"("values": {"components.tree.points": 9000})");
  studio.mailbox().wait_for([](const Value& message) {
    const Value* dragged = message.find("dragged");
    return dragged != nullptr && *dragged == Value(true);
  });
  const Value dragged = told();
  EXPECT_EQ(*dragged.find("count"), Value(9000));
  EXPECT_EQ(*(*dragged.find("positions")->list())[1].number(), 4000 * 3) << "evenly some of them";
  EXPECT_TRUE(studio.ask("cloud", R"("component": "nobody")").find("cloud")->is_null());
}

TEST(StudioSession, OverlaysAreThoseOfPictures) {
  const std::string plant = R"json({"meristem": 1, "scene": {"sun": {"azimuth": 90, "altitude": 45}}, "components":
    {"stem": {"type": "tree", "length": 0.2, "radius": 0.01}, "leaf": {"type": "leaf", "length": 0.4, "width": 0.1}},
    "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 3}]})json";
  Studio studio;
  const Value opened = studio.ask("open", "\"text\": " + write_json_line(Value(plant)));
  studio.show(Studio::text_of(opened, "hash"));
  const Value answer = studio.ask("overlays", R"("parts": ["sun"])");
  const Value& layer = (*answer.find("overlays")->find("layers")->list())[0];

  const Document document = read_document(plant, "", builtin_components());
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  const std::vector<OverlayPart> parts{OverlayPart::sun};
  const std::vector<OverlayLayer> layers = overlay_layers(
      {grown.plant, grown.traces, document.scene, document.graph.limits, grown.meshes.bounds()}, parts, progress);
  std::vector<float> ends;
  for (const OverlayLine& arrow : layers[0].arrows) {
    for (const Vec3 end : {arrow.from, arrow.to}) ends.insert(ends.end(), {end.x, end.y, end.z});
  }
  ASSERT_FALSE(ends.empty());
  const std::string_view bytes(reinterpret_cast<const char*>(ends.data()), ends.size() * sizeof(float));
  const std::string packet = studio.mailbox().packed_answer(*answer.find("re")->number());
  EXPECT_EQ(ReadPacket(packet, "MSA1").bytes(*layer.find("arrows")->find("positions"), sizeof(float)), bytes);
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

}  // namespace meristem::studio::session_questions_test

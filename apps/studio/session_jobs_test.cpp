// SPDX-License-Identifier: Apache-2.0
// Work that a page asks for and that is done later: stills, measures, exports.
#include <filesystem>

#include <gtest/gtest.h>

#include "test_studio.h"

namespace meristem::studio::session_jobs_test {

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
  // Equal states give equal pictures.
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
  EXPECT_EQ(Studio::text_of(studio.ask("export", R"("format": ".gbl")"), "message"),
            "there is no format '.gbl'; did you mean '.glb'?");
  EXPECT_EQ(Studio::text_of(studio.ask("export", R"("format": ".exe")"), "message"), "there is no format '.exe'");
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

TEST(StudioSession, OfMeasuresOnlyTheNewestAreTaken) {
  Studio studio;
  studio.open_bush();
  studio.show();
  for (int k = 0; k < 20; ++k)
    studio.page().receive("{\"do\": \"measures\", \"light\": true, \"id\": " + std::to_string(2000 + k) + "}");
  int made = 0;
  for (int k = 0; k < 20; ++k) made += is_refused(studio.mailbox().answer(2000 + k)) ? 0 : 1;
  EXPECT_FALSE(is_refused(studio.mailbox().answer(2019)));
  EXPECT_LT(made, 20);
}

TEST(StudioSession, ASweepHasTheTimeOfAMeasurementForEachOfItsPlants) {
  Studio studio;
  studio.open_bush();
  studio.show();
  studio.edit(R"([{"set": "links[0].count", "value": 200000}])");
  studio.host().limits.job_seconds = 0.1;
  const Value refused = studio.ask("sweep", R"("path": "stem.length", "values": [1, 2], "light": true)");
  EXPECT_EQ(Studio::text_of(refused, "limit"), "job_seconds");
  EXPECT_EQ(Studio::text_of(refused, "message"), "stopped after 0.2 seconds (job_seconds)");
}

TEST(StudioSession, CancelsTheJobOfOneRequestWhetherItRunsOrWaits) {
  Studio studio;
  studio.open_bush();
  studio.show();
  const auto sends = [&](double id, const std::string& rest) {
    studio.page().receive("{\"do\": " + rest + ", \"id\": " + std::to_string(static_cast<int>(id)) + "}");
  };
  // Pictures one after another; the second waits for the first.
  const std::string picture =
      R"("export", "format": ".png", "options": {"width": 400, "height": 400, "samples": 4000})";
  sends(901, picture);
  sends(902, picture);
  sends(903, R"("stills", "states": [{}], )" + std::string(kSideCamera));
  studio.edit(R"([{"set": "leaf.width", "value": 0.05}])");
  sends(904, R"("cancel", "re": 902)");
  EXPECT_TRUE(*studio.mailbox().answer(902).find("cancelled")->boolean()) << "while the first is still made";
  sends(905, R"("cancel", "re": 901)");
  EXPECT_TRUE(*studio.mailbox().answer(901).find("cancelled")->boolean());
  EXPECT_FALSE(is_refused(studio.mailbox().answer(903))) << "no other job ends";
  studio.show();  // nor does growth
  sends(906, R"("cancel", "re": "all")");
  EXPECT_TRUE(is_refused(studio.mailbox().answer(906)));
}

TEST(StudioSession, EndsInTheMiddleOfWork) {
  Studio studio;
  studio.open_bush();
  studio.edit(R"([{"set": "links[0].count", "value": 2000000}])");
  studio.page().receive(studio.request("export", R"("format": ".glb")"));
}

}  // namespace meristem::studio::session_jobs_test

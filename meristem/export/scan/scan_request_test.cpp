// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/scan/scan_request.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/json.h"
#include "tests/support/check_sentence.h"

namespace meristem::scan_request_test {

ScanPlan plan_of(const std::string& json) { return plan_scan(parse_json(json), 7); }

std::string error_of(const std::string& json) {
  try {
    plan_of(json);
  } catch (const InputError& error) {
    return error.diagnostics()[0].path + ": " + error.diagnostics()[0].message;
  }
  return "no fault";
}

TEST(ScanRequest, WhatIsNotSaidIsAsInTheClass) {
  EXPECT_EQ(plan_scan({}, 7).options.instrument, instrument_of(ScannerClass::terrestrial));
  EXPECT_EQ(plan_scan({}, 7).options.seed, 7U);
  EXPECT_EQ(plan_of(R"({"instrument": "phase"})").options.instrument, instrument_of(ScannerClass::phase));
  ScanInstrument drone = instrument_of(ScannerClass::drone);
  drone.step = radians(0.25);
  drone.altitude = 20;
  EXPECT_EQ(plan_of(R"({"instrument": {"kind": "drone", "step": 0.25, "altitude": 20}})").options.instrument, drone);
  const ScanPlan plan = plan_of(R"({"stations": [[1, 2, 3]], "ground": true, "obstacles": false, "seed": 9})");
  EXPECT_EQ(plan.options.stations, std::vector<Vec3>{Vec3(1, 2, 3)});
  EXPECT_TRUE(plan.options.ground);
  EXPECT_FALSE(plan.obstacles);
  EXPECT_EQ(plan.options.seed, 9U);
}

TEST(ScanRequest, FaultsHaveTheirPaths) {
  EXPECT_EQ(error_of(R"({"instrument": "drones"})"), "instrument: 'drones' is not a value of 'kind'");
  EXPECT_EQ(error_of(R"({"instrument": {"kind": "phase", "stepp": 1}})").substr(0, 16), "instrument.stepp");
  EXPECT_EQ(error_of(R"({"instrument": {"kind": "drone", "lowest": 1}})").substr(0, 17), "instrument.lowest");
  EXPECT_EQ(error_of(R"({"instrument": {"lowest": 20, "highest": 10}})"),
            "instrument.highest: the sweeps would have no height");
  EXPECT_EQ(error_of(R"({"instrument": {"nearest": 20, "farthest": 10}})"),
            "instrument.farthest: no distance would be within the range");
  EXPECT_EQ(error_of(R"({"instrument": "drone", "stations": [[0, 1, 2]]})"),
            "stations: a drone flies lines over the plants and has no stations");
  EXPECT_EQ(error_of(R"({"instrument": "drone", "around": 3})"),
            "around: a drone flies lines over the plants and has no stations around them");
  EXPECT_EQ(error_of(R"({"target": [0, 1, 2]})"), "target: only depth cameras look at a target");
  EXPECT_NE(error_of(R"({"stations": [[0, 1, 2]], "around": 3})"), "no fault");
}

TEST(ScanRequest, EverySentenceStandsAlone) {
  for (const ParameterTable* table : {&scan_table(), &instrument_table()}) {
    EXPECT_EQ(sentence_error(table->doc), "") << table->doc;
    for (const Parameter& row : table->parameters) EXPECT_EQ(sentence_error(row.doc), "") << row.doc;
  }
}

}  // namespace meristem::scan_request_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/light_table.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"

namespace meristem::light_table_test {

/// The document of a box with this scene, which has a line of its own.
Document read_in(const std::string& scene, const std::vector<ValueOverride>& overrides = {}) {
  return read_document(
      fmt::format("{{\"scene\":\n{},\n\"meristem\": 1, \"components\": {{\"box\": {{\"type\": \"simple\"}}}}}}", scene),
      "d.json", builtin_components(), {.overrides = overrides});
}

std::string errors_of(const std::string& scene) {
  try {
    read_in(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

std::string warnings_of(const std::string& scene) {
  std::string texts;
  for (const Diagnostic& warning : read_in(scene).warnings) texts += warning.text();
  return texts;
}

double sum_of(const std::vector<DirectionalLight>& lights) {
  double sum = 0;
  for (const DirectionalLight& light : lights) sum += light.strength;
  return sum;
}

void expect_alike(const std::vector<DirectionalLight>& found, const std::vector<DirectionalLight>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].toward, expected[k].toward);
    EXPECT_DOUBLE_EQ(found[k].strength, expected[k].strength);
  }
}

TEST(SceneLight, ComesFromTheZenithUnlessSaid) {
  const Scene scene = read_in("{}").scene;
  expect_alike(scene.light.sun, {DirectionalLight{}});
  EXPECT_TRUE(scene.light.sky.empty());
  EXPECT_TRUE(scene.light.lamps.empty());
}

TEST(SceneLight, ComesFromWhereAClockSaysTheSunStands) {
  const Scene scene = read_in(
                          R"({"latitude": 39.742476,
          "sun": {"date": "2003-10-17", "time": "12:30:30", "longitude": -105.1786, "utc_offset": -7}})")
                          .scene;
  EXPECT_NEAR(degrees(scene.sun.altitude), 39.872, 0.012);
  EXPECT_NEAR(degrees(scene.sun.azimuth), 194.340, 0.012);
  expect_alike(scene.light.sun, {DirectionalLight{.toward = unit_vector(scene.sun)}});
  ASSERT_TRUE(scene.clock);
  EXPECT_NEAR(degrees(scene.clock->longitude), -105.1786, 1e-9);
  EXPECT_EQ(scene.clock->utc_offset, -7);
  EXPECT_NEAR(degrees(*scene.latitude), 39.742476, 1e-9);
}

TEST(SceneLight, ADateIsADayAndATimeAnHour) {
  const Scene by_date = read_in(R"({"latitude": 50, "sun": {"date": "2026-06-21", "hour": "9:30"}})").scene;
  const Scene by_day = read_in(R"({"latitude": 50, "sun": {"day": 172, "hour": 9.5}})").scene;
  EXPECT_EQ(by_date.sun.altitude, by_day.sun.altitude);
  EXPECT_FALSE(by_date.clock);
  expect_alike(read_in(R"({"latitude": 50, "sun": {"date": "2026-06-21", "every_hours": 1}})").scene.light.sun,
               read_in(R"({"latitude": 50, "sun": {"day": 172, "every_hours": 1}})").scene.light.sun);
}

TEST(SceneLight, SaysWhatIsWrongWithAClock) {
  const auto error = [](const std::string& sun) {
    return errors_of(fmt::format("{{\"latitude\": 50, \"sun\": {}}}", sun));
  };
  EXPECT_NE(error(R"({"date": "2026-06-31"})").find("scene.sun.date: '2026-06-31' is not a date"), std::string::npos);
  EXPECT_NE(error(R"({"date": "2026-06-21", "time": "15:30"})").find("needs a 'longitude' and a 'utc_offset'"),
            std::string::npos);
  EXPECT_NE(error(R"({"date": "2026-06-21", "time": "15:30", "longitude": 7})").find("needs a 'utc_offset'"),
            std::string::npos);
  EXPECT_NE(error(R"({"date": "2026-06-21", "time": "15:70", "longitude": 7, "utc_offset": 1})")
                .find("scene.sun.time: '15:70' is not a time"),
            std::string::npos);
  EXPECT_NE(error(R"({"date": "2026-06-21", "time": 25, "longitude": 7, "utc_offset": 1})").find("scene.sun.time"),
            std::string::npos);
  EXPECT_NE(
      error(R"({"date": "2026-06-21", "time": 9, "longitude": 181, "utc_offset": 1})").find("scene.sun.longitude"),
      std::string::npos);
  for (const char* wrong : {R"({"day": 172, "time": 9, "longitude": 7, "utc_offset": 1})",
                            R"({"date": "2026-06-21", "day": 172})", R"({"date": "2026-06-21", "days": [1, 9]})",
                            R"({"day": 172, "longitude": 7})", R"({"azimuth": 1, "altitude": 1, "date": "2026-06-21"})",
                            R"({"date": "2026-06-21", "time": 9, "hour": 9, "longitude": 7, "utc_offset": 1})"}) {
    EXPECT_NE(error(wrong), "no fault") << wrong;
  }
  EXPECT_NE(warnings_of(R"({"latitude": 50, "sun": {"date": "2026-06-21", "time": "23:30", "longitude": 7,
                                                     "utc_offset": 1}})")
                .find("the sun is below the horizon at 23:30 on 2026-06-21 at latitude 50"),
            std::string::npos);
}

TEST(SceneLight, ComesFromAPlaceOrAnHour) {
  const Scene placed = read_in(R"({"sun": {"azimuth": 180, "altitude": 61}})").scene;
  expect_alike(placed.light.sun, {DirectionalLight{.toward = unit_vector({kPi, radians(61)})}});
  const Scene morning = read_in(R"({"latitude": 51.5, "sun": {"day": 126, "hour": 9.5}})").scene;
  const SkyDirection sun = sun_position(radians(51.5), 126, 9.5);
  EXPECT_EQ(morning.sun.altitude, sun.altitude);
  expect_alike(morning.light.sun, {DirectionalLight{.toward = unit_vector(sun)}});
}

TEST(SceneLight, OfADayHasAllItsHoursAndPicturesOne) {
  const Scene scene = read_in(R"({"latitude": 51.51494, "sun": {"day": 126, "every_hours": 1}})").scene;
  expect_alike(scene.light.sun, sun_of_day(radians(51.51494), 126, 1));
  EXPECT_EQ(scene.light.sun.size(), 15U);
  EXPECT_NEAR(degrees(scene.sun.altitude), 55.03, 0.005);
  const Scene morning = read_in(R"({"latitude": 51.5, "sun": {"day": 126, "every_hours": 2, "hour": 8}})").scene;
  EXPECT_EQ(morning.light.sun.size(), 7U);
  EXPECT_EQ(morning.sun.altitude, sun_position(radians(51.5), 126, 8).altitude);
}

TEST(SceneLight, OfASeasonHasAllItsDays) {
  const Scene scene =
      read_in(R"({"latitude": 40, "sun": {"days": [90, 270], "every_days": 60, "every_hours": 2}})").scene;
  expect_alike(scene.light.sun, sun_of_days(radians(40), {90, 150, 210, 270}, 2));
  EXPECT_EQ(scene.sun.altitude, sun_position(radians(40), 210, 12).altitude);
  const Scene monthly = read_in(R"({"latitude": 40, "sun": {"days": [100, 140]}})").scene;
  expect_alike(monthly.light.sun, sun_of_days(radians(40), {100, 130}, 1));
}

TEST(SceneLight, OfASeasonGoesOnIntoTheNextYear) {
  const Scene south = read_in(R"({"latitude": -35, "sun": {"days": [300, 60], "every_days": 25}})").scene;
  expect_alike(south.light.sun, sun_of_days(radians(-35), {300, 325, 350, 10, 35, 60}, 1));
  const Scene leap = read_in(R"({"latitude": -35, "sun": {"days": [364, 366], "every_days": 2}})").scene;
  expect_alike(leap.light.sun, sun_of_days(radians(-35), {364, 366}, 1));
}

TEST(SceneLight, SharesItselfBetweenSunAndSky) {
  const Scene scene = read_in(R"({"latitude": 50, "sky": 0.3, "sun": {"day": 100, "every_hours": 1}})").scene;
  EXPECT_NEAR(sum_of(scene.light.sun), 0.7, 1e-12);
  EXPECT_NEAR(sum_of(scene.light.sky), 0.3, 1e-12);
  const Scene overcast = read_in(R"({"sky": 1})").scene;
  EXPECT_TRUE(overcast.light.sun.empty());
  EXPECT_NEAR(sum_of(overcast.light.sky), 1, 1e-12);
}

TEST(SceneLight, HasLamps) {
  const Scene scene =
      read_in(R"({"lamps": [{"position": [2, 4, 0], "strength": 0.3}, {"position": [0, 1, 0]}]})").scene;
  ASSERT_EQ(scene.light.lamps.size(), 2U);
  EXPECT_EQ(scene.light.lamps[0].position, Vec3(2, 4, 0));
  EXPECT_EQ(scene.light.lamps[0].strength, 0.3);
  EXPECT_EQ(scene.light.lamps[1].strength, 1);
}

TEST(SceneLight, HasColouredSpots) {
  const Scene scene = read_in(R"({"lamps": [{"position": [0, 3, 0], "colour": "#ff0000", "target": [1, 0, 0],
                                             "angle": 40, "radius": 0.3}]})")
                          .scene;
  const Lamp& lamp = scene.light.lamps.at(0);
  EXPECT_EQ(lamp.colour, Vec3(1, 0, 0));
  EXPECT_EQ(lamp.target, Vec3(1, 0, 0));
  EXPECT_DOUBLE_EQ(lamp.angle, radians(40));
  EXPECT_EQ(lamp.radius, 0.3);
}

TEST(SceneLight, IsSetByOverrides) {
  const std::string season = R"({"latitude": 50, "sun": {"days": [90, 270]}, "lamps": [{"position": [0, 1, 0]}]})";
  const Scene scene = read_in(season, {parse_override("scene.sky=0.5"), parse_override("scene.sun.every_days=90"),
                                       parse_override("scene.lamps[0].strength=2")})
                          .scene;
  EXPECT_NEAR(sum_of(scene.light.sky), 0.5, 1e-12);
  EXPECT_EQ(scene.light.sun.size(), sun_of_days(radians(50), {90, 180, 270}, 1).size());
  EXPECT_EQ(scene.light.lamps[0].strength, 2);
}

TEST(SceneLight, WarnsWhereTheSunDoesNotRise) {
  EXPECT_EQ(warnings_of(R"({"latitude": 80, "sun": {"day": 355, "every_hours": 1}})"),
            "d.json:2:25: scene.sun: the sun does not rise on day 355 at latitude 80, so there is no light");
  EXPECT_EQ(warnings_of(R"({"latitude": -80, "sky": 0.2, "sun": {"days": [150, 200], "every_days": 10}})"),
            "d.json:2:38: scene.sun: the sun does not rise from day 150 to 200 at latitude -80, so the sky gives all "
            "light");
}

TEST(SceneLight, WarnsOfASunBelowTheHorizon) {
  const std::string at_night = R"({"latitude": 51, "sun": {"day": 100, "hour": 1})";
  const std::string warning = "d.json:2:25: scene.sun: the sun is below the horizon at 1 h on day 100 at latitude 51, ";
  EXPECT_EQ(warnings_of(at_night + "}"), warning + "so there is no light");
  EXPECT_EQ(warnings_of(at_night + R"(, "sky": 0.4})"), warning + "so the sky gives all light");
  EXPECT_EQ(warnings_of(R"({"sun": {"azimuth": 0, "altitude": -3}})"),
            "d.json:2:9: scene.sun: the sun is below the horizon, so there is no light");
  EXPECT_TRUE(read_in(at_night + "}").scene.light.sun.empty());
}

TEST(SceneLight, WarnsOfPicturesAtNight) {
  EXPECT_EQ(warnings_of(R"({"latitude": 51, "sun": {"day": 100, "every_hours": 1, "hour": 23}})"),
            "d.json:2:25: scene.sun: in pictures, at 23 h, the sun is below the horizon");
}

TEST(SceneLight, TakesNightsWithLampsAsMeant) {
  const std::string lamps = R"("lamps": [{"position": [0, 3, 0]}])";
  EXPECT_EQ(warnings_of(R"({"latitude": 51, "sun": {"day": 100, "hour": 1}, )" + lamps + "}"), "");
  EXPECT_EQ(warnings_of(R"({"latitude": 51, "sun": {"day": 100, "every_hours": 1, "hour": 23}, )" + lamps + "}"), "");
  EXPECT_EQ(warnings_of(R"({"latitude": 80, "sky": 0.4, "sun": {"day": 355, "every_hours": 1}, )" + lamps + "}"),
            "d.json:2:37: scene.sun: the sun does not rise on day 355 at latitude 80, so sky and lamps give all light");
}

TEST(SceneLight, StaysDarkInThePolarNightButForTheShareOfTheSky) {
  const Scene scene = read_in(R"({"latitude": 80, "sky": 0.2, "sun": {"day": 355, "every_hours": 1}})").scene;
  EXPECT_TRUE(scene.light.sun.empty());
  EXPECT_NEAR(sum_of(scene.light.sky), 0.2, 1e-12);
}

struct Rejection {
  const char* about;
  const char* scene;
  const char* error;
};

class RejectedLight : public testing::TestWithParam<Rejection> {};

TEST_P(RejectedLight, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(errors_of(GetParam().scene), fmt::format("d.json:2:{}", GetParam().error));
}

const Rejection kRejections[] = {
    {"Latitude", R"({"latitude": -91})",
     "14: scene.latitude: the value -91 is out of range for 'latitude'; expected a number (°) from -90 to 90"},
    {"DayOf0", R"({"latitude": 0, "sun": {"day": 0}})",
     "32: scene.sun.day: the value 0 is out of range for 'day'; expected a number (d) from 1 to 366"},
    {"DayOf400", R"({"latitude": 0, "sun": {"day": 400}})",
     "32: scene.sun.day: the value 400 is out of range for 'day'; expected a number (d) from 1 to 366"},
    {"SeasonTo400", R"({"latitude": 0, "sun": {"days": [9, 400]}})",
     "37: scene.sun.days[1]: the value 400 is out of range for 'days'; expected a whole number (d) from 1 to 366"},
    {"SeasonOfOneDay", R"({"latitude": 0, "sun": {"days": [9]}})",
     "33: scene.sun.days: 'days' cannot be a list of 1; expected a list of 2 whole numbers from 1 to 366"},
    {"SeasonWithoutLatitude", R"({"sun": {"days": [9, 20]}})",
     "9: scene.sun: a sun with a day needs a latitude; expected \"latitude\" in the scene"},
    {"DayAndSeason", R"({"latitude": 0, "sun": {"day": 3, "days": [9, 20]}})",
     "35: scene.sun.days: 'days' has no meaning beside 'day'; expected only one of them"},
    {"StepOfDaysWithoutSeason", R"({"latitude": 0, "sun": {"day": 3, "every_days": 5}})",
     "35: scene.sun.every_days: 'every_days' has no meaning without 'days'; expected 'days' beside it"},
    {"StepOf0Days", R"({"latitude": 0, "sun": {"days": [9, 20], "every_days": 0}})",
     "56: scene.sun.every_days: the value 0 is out of range for 'every_days'; expected a number (d) from 1 to 366"},
    {"StepOf0Hours", R"({"latitude": 0, "sun": {"day": 3, "every_hours": 0}})",
     "50: scene.sun.every_hours: the value 0 is out of range for 'every_hours'; expected a number (h) above 0 to 24"},
    {"StepOf30Hours", R"({"latitude": 0, "sun": {"day": 3, "every_hours": 30}})",
     "50: scene.sun.every_hours: the value 30 is out of range for 'every_hours'; expected a number (h) above 0 to 24"},
    {"TooManyHours", R"({"latitude": 0, "sun": {"days": [1, 365], "every_days": 1, "every_hours": 0.001}})",
     "75: scene.sun.every_hours: 8760365 positions of the sun are too many; expected at most 10000: a longer "
     "'every_hours'"},
    {"TooManyHoursOfADay", R"({"latitude": 0, "sun": {"day": 3, "every_hours": 1e-300}})",
     "50: scene.sun.every_hours: 2.4e+301 positions of the sun are too many; expected at most 10000: a longer "
     "'every_hours'"},
    {"TooManyDays", R"({"latitude": 0, "sun": {"days": [1, 365], "every_days": 1, "every_hours": 0.5}})",
     "57: scene.sun.every_days: 17885 positions of the sun are too many; expected at most 10000: a longer "
     "'every_days'"},
    {"HoursOfAPlace", R"({"sun": {"azimuth": 0, "altitude": 9, "every_hours": 1}})",
     "39: scene.sun.every_hours: 'every_hours' has no meaning beside 'azimuth'; expected only one of them"},
    {"HourOfAPlace", R"({"sun": {"azimuth": 0, "altitude": 9, "hour": 8}})",
     "39: scene.sun.hour: 'hour' has no meaning beside 'azimuth'; expected only one of them"},
    {"SunAsNumber", R"({"sun": 3})",
     "9: scene.sun: a sun cannot be the number 3; expected an object with azimuth, altitude, day, days, every_days, "
     "every_hours, sample_hour, hour, date, time, longitude, utc_offset"},
    {"Sky", R"({"sky": 1.5})", "9: scene.sky: the value 1.5 is out of range for 'sky'; expected a number from 0 to 1"},
    {"LampWithoutPlace", R"({"lamps": [{"strength": 1}]})",
     "12: scene.lamps[0]: a lamp has no 'position'; expected a list of three numbers [x, y, z] from -100000 to 100000"},
    {"LampOfNoStrength", R"({"lamps": [{"position": [0, 1, 0], "strength": 0}]})",
     "48: scene.lamps[0].strength: the value 0 is out of range for 'strength'; expected a number above 0 to 1000000"},
    {"LampsAsObject", R"({"lamps": {"position": [0, 1, 0]}})",
     "11: scene.lamps: 'lamps' cannot be an object; expected a list of objects with position, strength, "
     "colour, target, angle, radius"},
    {"BlackLamp", R"({"lamps": [{"position": [0, 1, 0], "colour": "#000000"}]})",
     "46: scene.lamps[0].colour: black light has no hue; expected a colour other than black"},
    {"SpotOntoItself", R"({"lamps": [{"position": [0, 1, 0], "target": [0, 1, 0]}]})",
     "46: scene.lamps[0].target: the lamp shines at its own position; expected another point"},
    {"ConeWithoutTarget", R"({"lamps": [{"position": [0, 1, 0], "angle": 30}]})",
     "36: scene.lamps[0].angle: 'angle' has no meaning without 'target'; expected 'target' beside it"},
};

INSTANTIATE_TEST_SUITE_P(SceneLight, RejectedLight, testing::ValuesIn(kRejections),
                         [](const auto& test) { return test.param.about; });

TEST(SceneLight, RejectsLampsWithoutNumber) {
  std::string lamps;
  for (int k = 0; k < 1001; ++k) lamps += fmt::format(R"({}{{"position": [{}, 3, 0]}})", k == 0 ? "" : ", ", k);
  EXPECT_EQ(errors_of(fmt::format(R"({{"lamps": [{}]}})", lamps)),
            "d.json:2:11: scene.lamps: 1001 lamps are too many; expected at most 1000");
}

}  // namespace meristem::light_table_test

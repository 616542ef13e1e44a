// SPDX-License-Identifier: Apache-2.0
// Translates training systems into lists of operations.
//
// Based on: J. Stevens: Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, sections 4.2 and
// 4.3, for pole, open tree and espalier; the other forms use combinations of these operations.
#include "meristem/components/parts/training.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/graph/table/table.h"

namespace meristem {

namespace {

constexpr double kFar = 1e4;     // metres; size of infinite bodies of cuts
constexpr double kStake = 0.04;  // metres; visible thickness
constexpr double kCane = 0.012;
constexpr double kHigherAngle = 70;  // degrees; topmost arms of a fan
constexpr double kLowerAngle = 12;   // degrees; lowest arms of a fan

/// Rounds a length to micrometres, for readable documents.
double rounded(double metres) { return std::round(1e6 * metres) / 1e6; }

Value point(double x, double y, double z) { return Value::List{rounded(x), rounded(y), rounded(z)}; }

Value box(double x, double low, double high, double z) {
  return Value::Object{{"box", Value::List{point(-x, low, -z), point(x, high, z)}}};
}

/// The operations of one training, in order.
class System {
 public:
  System(const Training& training, double length) : training_(training), length_(length) {}

  Value::List list() {
    switch (training_.form) {
      case Training::Form::espalier:
      case Training::Form::fan:
        layers();
        break;
      case Training::Form::cordon:
        cordon();
        break;
      case Training::Form::spindle:
        spindle();
        break;
      case Training::Form::open_vase:
        open_vase();
        break;
      case Training::Form::standard:
      case Training::Form::half_standard:
        standard();
        break;
      case Training::Form::hedge:
        hedge();
        break;
    }
    return std::move(list_);
  }

 private:
  /// Returns the height of the clear stem.
  double stem() const {
    if (training_.stem) return *training_.stem;
    if (training_.form == Training::Form::standard) return 1.8;
    return training_.form == Training::Form::half_standard ? 1.2 : 0.5;
  }

  void add(Value::Object operation) { list_.emplace_back(std::move(operation)); }

  void pole(double height, double thickness) {
    add({{"do", "support"},
         {"shoots", "leader"},
         {"line", Value::List{point(0, 0, 0), point(0, height, 0)}},
         {"weight", training_.weight},
         {"thickness", training_.shown ? thickness : 0}});
  }

  void keep(const char* what, const char* shoots, int metamers) {
    add({{"do", what}, {"shoots", shoots}, {"metamers", metamers}});
  }

  void layers() {
    const bool is_fan = training_.form == Training::Form::fan;
    pole(training_.layers * training_.spacing * length_, kCane);
    Value::Object rule{{"do", "layers"},
                       {"count", training_.layers},
                       {"metamers", training_.spacing},
                       {"azimuth", rounded(degrees(training_.azimuth))},
                       {"weight", training_.weight},
                       {"wires", training_.shown ? rounded(training_.reach * length_) : 0}};
    if (is_fan) {
      rule.emplace_back("angle", kLowerAngle);
      rule.emplace_back("angle_last", kHigherAngle);
    }
    add(std::move(rule));
    keep("limit", "rank == 1", training_.reach);
    keep("spur", "rank >= 2", training_.spurs);
  }

  void cordon() {
    const double along = training_.reach * length_;
    const double level = along * std::cos(training_.angle);
    add({{"do", "support"},
         {"shoots", "leader"},
         {"line",
          Value::List{point(0, 0, 0), point(level * std::sin(training_.azimuth), along * std::sin(training_.angle),
                                            -level * std::cos(training_.azimuth))}},
         {"weight", training_.weight},
         {"thickness", training_.shown ? kCane : 0}});
    keep("limit", "rank == 0", training_.reach);
    keep("spur", "rank >= 1", training_.spurs);
  }

  /// Removes branches below the height of the clear stem.
  void clear_stem() { add({{"do", "cut"}, {"shoots", "rank >= 1"}, {"outside", box(kFar, stem(), kFar, kFar)}}); }

  void spindle() {
    pole(training_.height, kStake);
    clear_stem();
    add({{"do", "cut"}, {"shoots", "rank == 1 && age >= 1 && inclination > 60"}, {"above", 0}});
    // A cone with its apex above the tree, so that the tree's top is not cut away.
    const double above = 0.25 * training_.height;
    const Value::Object cone{{"base", point(0, 0, 0)},
                             {"radius", 0.5 * training_.width * (training_.height + above) / training_.height},
                             {"height", training_.height + above}};
    add({{"do", "cut"},
         {"from", training_.from},
         {"shoots", "rank >= 0"},
         {"outside", Value::Object{{"intersection", Value::List{Value(Value::Object{{"cone", cone}}),
                                                                box(kFar, -1, training_.height, kFar)}}}}});
  }

  void open_vase() {
    pole(stem(), kStake);
    clear_stem();
    add({{"do", "cut"},
         {"when", fmt::format("height > {:.6g} && laterals >= 3", stem() + 3 * length_)},
         {"once", true},
         {"shoots", "leader"},
         {"above_lateral", 3},
         {"leader", false}});
    add({{"do", "cut"}, {"shoots", "rank >= 2 && inward == 1"}, {"above", 0}});
  }

  void standard() {
    pole(stem(), kStake);
    clear_stem();
    add({{"do", "cut"},
         {"when", fmt::format("leader_length > {:.6g}", stem() + 6 * length_)},
         {"once", true},
         {"shoots", "leader"},
         {"above", std::ceil(stem() / length_) + 4},
         {"leader", false}});
  }

  void hedge() {
    add({{"do", "cut"},
         {"from", training_.from},
         {"shoots", "rank >= 0"},
         {"outside", box(0.5 * training_.width, -1, training_.height, 0.5 * training_.depth)}});
  }

  const Training& training_;
  double length_;
  Value::List list_;
};

/// The target of reading a list of operations.
struct ReadOperations {
  std::vector<AnyOperation> operations;
};

const ParameterTable& read_table() {
  static const ParameterTable table =
      Table<ReadOperations>("a list of operations", "The operations that a training stands for.")
          .list_of_kinds("operations", &ReadOperations::operations, operation_kinds, operation_table,
                         "The operations.");
  return table;
}

}  // namespace

const ParameterTable& training_table() {
  static const ParameterTable table =
      Table<Training>("a training", "A training system, which stands for a list of operations.")
          .choice("form", &Training::form,
                  {"espalier", "cordon", "fan", "spindle", "open_vase", "standard", "half_standard", "hedge"},
                  "Form of the tree: arms in layers ('espalier', 'fan'), one stem ('cordon'), a cone ('spindle'), no "
                  "leader ('open_vase'), a clear stem ('standard', 'half_standard') or a box ('hedge').")
          .integer("layers", &Training::layers, {.min = 1, .max = 1000, .usual = {1, 6}}, "Number of layers of arms.")
          .integer("spacing", &Training::spacing, {.min = 3, .max = 1000, .usual = {3, 10}},
                   "Number of metamers from one layer of arms to the next.")
          .integer("reach", &Training::reach, {.min = 1, .max = 100'000, .usual = {4, 30}},
                   "Number of metamers of an arm, or of a cordon's stem.")
          .integer("spurs", &Training::spurs, {.min = 0, .max = 1000, .usual = {1, 5}},
                   "Number of metamers that spurs on arms and stem keep; raised, longer spurs.")
          .number("azimuth", &Training::azimuth, {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 180}},
                  "Azimuth of the right arms, or of a cordon, from north (0) over east (90).")
          .number("angle", &Training::angle, {.unit = Unit::degree, .min = 5, .max = 90, .usual = {30, 90}},
                  "Angle of a cordon above the horizontal.")
          .number("weight", &Training::weight, {.min = 0, .max = 1000, .usual = {0, 10}},
                  "Weight of the direction of poles and wires in the growth of tied shoots; raised, shoots follow them "
                  "more closely.")
          .number("stem", &Training::stem, {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 3}},
                  "Height of the clear stem below the branches; by default, 1.8 m for a standard, 1.2 m for a half "
                  "standard and 0.5 m for other forms.")
          .number("height", &Training::height,
                  {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0.5, 5}, .above_min = true},
                  "Height to which the tree is cut.")
          .number("width", &Training::width,
                  {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0.3, 5}, .above_min = true},
                  "Width to which the tree is cut, along x.")
          .number("depth", &Training::depth,
                  {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0.3, 3}, .above_min = true},
                  "Depth to which a hedge is cut, along z.")
          .integer("from", &Training::from, {.min = 1, .max = kLastIteration, .usual = {1, 20}},
                   "First iteration in which the tree is cut to its form.")
          .boolean("shown", &Training::shown, "Whether poles and wires are visible.")
          .only_where({{"form", {"espalier", "fan"}}}, {"layers", "spacing"})
          .only_where({{"form", {"espalier", "fan", "cordon"}}}, {"reach", "spurs", "azimuth"})
          .only_where({{"form", {"cordon"}}}, {"angle"})
          .only_where({{"form", {"spindle", "open_vase", "standard", "half_standard"}}}, {"stem"})
          .only_where({{"form", {"spindle", "hedge"}}}, {"height", "width", "from"})
          .only_where({{"form", {"hedge"}}}, {"depth"})
          .only_where({{"form", {"espalier", "fan", "cordon", "spindle", "open_vase", "standard", "half_standard"}}},
                      {"weight", "shown"})
          .shorthand("form");
  return table;
}

Value::List training_operations(const Training& training, double length) { return System(training, length).list(); }

void prepare_training(Training& training, double length, const DocumentPath& path, ParameterReader& reader) {
  ReadOperations read;
  ParameterReader own({}, reader.limits());
  own.read(read_table(), &read, Value(Value::Object{{"operations", training_operations(training, length)}}), path);
  for (const Diagnostic& found : own.diagnostics())
    reader.add_error(path, found.message, found.expected, found.nearest);
  prepare_operations(read.operations, {}, path, reader);
  training.operations = std::move(read.operations);
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Grass leaves with shared meshes, because a field has a million leaves. Unless leaves are exact, shape parameters that
// vary between leaves are rounded, so that many leaves share a mesh. Parameters that are equal for all leaves stay
// exact. The mesh is made for a length of 1 and scaled. The ratio of width to length is rounded to an eighth of an
// octave, so the mesh is stretched by at most 4.4 %. Angles are rounded to 5°, the age to 32 steps of full growth, and
// forces to a quarter of the leaf's weight. Growth histories are drawn from a number of variants.
#include "meristem/components/grassleaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "meristem/base/hash.h"
#include "meristem/base/math.h"
#include "meristem/components/parts/grassleaf_table.h"
#include "meristem/components/parts/shared_shape.h"
#include "meristem/shape/grass/reduce_leaf.h"

namespace meristem {

namespace {

constexpr double kAgeSteps = 32;        // steps of full growth
constexpr double kProportionSteps = 8;  // per octave
constexpr double kRadiusSteps = 2;      // per octave
constexpr double kForceStep = 0.25;     // share of the leaf's weight
constexpr double kWaveStep = 0.05;      // share of the depth
constexpr double kWaveNumberStep = 0.5;
constexpr double kFactorStep = 0.05;  // share of an inclination
constexpr double kTurnStep = kPi / 180;
constexpr double kTurnPlaceStep = 0.01;  // share of the midrib
constexpr double kErrorSteps = 4;        // per octave
constexpr double kAirDensity = 1.2;      // kg/m3
constexpr double kAgeTolerance = 1e-9;
constexpr double kUsualLength = 0.3;    // metres; used if neither document nor file gives a length
constexpr double kUsualSheath = 0.005;  // metres; radius of the sheath away from stems
constexpr double kSheathOverStem = 1.12;
constexpr double kMaxRate = 1000;
constexpr double kUsualAspect = 0.06;   // width over length if the leaf's own is unknown
constexpr double kOwnInclination = -1;  // special value: the midrib's own inclination

/// The indices of a leaf's curves.
struct Choice {
  std::uint32_t midrib = 0, widths = 0;
};

[[noreturn]] void throw_at(const InstanceContext& instance, const char* parameter, std::string message,
                           std::string expected) {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = std::move(expected),
                              .path = fmt::format("components.{}.{}", instance.component(), parameter)});
}

/// Returns "one of 1, 2, 3".
std::string ranks_text(const StockIndex& index) {
  constexpr std::size_t kMaxShown = 20;
  const std::span<const int> shown = std::span(index.ranks()).first(std::min(index.ranks().size(), kMaxShown));
  return fmt::format("one of {}{}", fmt::join(shown, ", "), shown.size() < index.ranks().size() ? ", ..." : "");
}

Choice choose(const Grassleaf& grass, const Site& site, const InstanceContext& instance) {
  const GrassStock& stock = *grass.stock;
  const std::span<const std::uint32_t> midribs = stock.midrib_index.find(grass.rank, grass.leaf);
  if (midribs.empty() && grass.leaf && !stock.midrib_index.find(grass.rank).empty()) {
    throw_at(instance, "leaf", fmt::format("there is no leaf {} of rank {}", *grass.leaf, grass.rank),
             "a lindex that the file has");
  }
  if (midribs.empty()) {
    throw_at(instance, "rank",
             fmt::format("there is no midrib of rank {}{}", grass.rank,
                         grass.leaf ? fmt::format(" and lindex {}", *grass.leaf) : std::string()),
             ranks_text(stock.midrib_index));
  }
  const double drawn = site.key.child("leaf").uniform(0) * static_cast<double>(midribs.size());
  Choice choice{.midrib = midribs[std::min(static_cast<std::size_t>(drawn), midribs.size() - 1)]};
  const StockedMidrib& midrib = stock.midribs[choice.midrib];
  std::span<const std::uint32_t> widths = stock.width_index.find(grass.rank, midrib.leaf);
  if (widths.empty()) widths = stock.width_index.find(grass.rank);
  if (widths.empty()) {
    throw_at(instance, "rank", fmt::format("there are no widths of rank {}", grass.rank),
             ranks_text(stock.width_index));
  }
  choice.widths = widths.front();
  if (grass.stages.age && grass.age > midrib.family.last_age() + kAgeTolerance) {
    throw_at(instance, "age", fmt::format("the age {} is outside the midribs' ages", grass.age),
             fmt::format("at most {}, such as \"min({}, ...)\"", midrib.family.last_age(), midrib.family.last_age()));
  }
  return choice;
}

/// Returns the length of the full-grown leaf in metres.
double full_length(const Grassleaf& grass, const Choice& choice) {
  if (grass.length) return *grass.length;
  const FittedWidths& widths = grass.stock->widths[choice.widths].fitted;
  const double measured = widths.are_shares ? grass.stock->midribs[choice.midrib].length : widths.length;
  return measured > 0 ? grass.source.unit * measured : kUsualLength;
}

double full_width(const Grassleaf& grass, const Choice& choice, double length) {
  if (grass.width) return *grass.width;
  const FittedWidths& widths = grass.stock->widths[choice.widths].fitted;
  return widths.are_widths_shares() ? kUsualAspect * length : grass.source.unit * widths.width;
}

/// Returns the radius of the sheath's rim in metres, in the leaf's own frame.
double sheath_radius(const GrassSheath& sheath, const Site& site) {
  if (sheath.radius) return *sheath.radius;
  const double scale = glm::length(site.frame.axes[2]);
  return site.radius > 0 && scale > 0 ? kSheathOverStem * site.radius / scale : kUsualSheath;
}

/// Shape parameters that vary between instances, rounded, for a leaf of length 1. All members are doubles, so that
/// their bytes identify a shape.
struct ShapeNumbers {
  double midrib, widths, variant;
  double width;
  double age, full_age;
  double inclination, inclination_factor;
  double pull_x = 0, pull_y = 0, wind_x = 0, wind_y = 0, gravity_x = 0, gravity_y = -1;
  double stiffness = 1, tip_thickness = 1;
  double twist, fold, roll;
  double waves, waves_depth, waves_left, waves_right;
  double clasp, clasp_radius;
  double polygons, error;
};
static_assert(sizeof(ShapeNumbers) % sizeof(double) == 0 && sizeof(LocalTurn) == 3 * sizeof(double) &&
              sizeof(LocalWidth) == 3 * sizeof(double));

/// Rounds the parameters of a leaf, unless leaves are exact.
class Rounding {
 public:
  Rounding(const Grassleaf& grass, const InstanceContext& instance) : grass_(grass), instance_(instance) {}

  double step(double value, double step) const { return grass_.exact ? value : to_step(value, step) + 0.0; }
  double octaves(double value, double steps) const {
    return grass_.exact || value <= 0 ? value : to_octaves(value, steps);
  }
  /// Returns a parameter of the leaf, rounded only if it varies between leaves.
  double own(const ComponentMember<double>& number, double steps) const {
    return instance_.varies(number) ? step(number.value(), steps) : number.value() + 0.0;
  }
  double own_octaves(const ComponentMember<double>& number, double steps) const {
    return instance_.varies(number) ? octaves(number.value(), steps) : number.value();
  }
  /// Returns true if a member of the leaf varies between leaves.
  template <class M>
  bool varies(M Grassleaf::*member) const {
    return instance_.varies(member_of(grass_, member));
  }

 private:
  const Grassleaf& grass_;
  const InstanceContext& instance_;
};

/// Returns the rounded turns of the leaf. If varying numbers put the end of a turn before its begin, the turn becomes a
/// kink.
std::vector<LocalTurn> turns_of(const Grassleaf& grass, const InstanceContext& instance) {
  if (!grass.stages.bend) return {};
  const Rounding round(grass, instance);
  std::vector<LocalTurn> turns = grass.turns;
  if (!round.varies(&Grassleaf::turns)) return turns;
  for (LocalTurn& turn : turns) {
    turn.from = round.step(turn.from, kTurnPlaceStep);
    turn.to = std::max(turn.from, round.step(turn.to, kTurnPlaceStep));
    turn.angle = round.step(turn.angle, kTurnStep);
  }
  return turns;
}

/// Returns the changes of the leaf's width, rounded if they vary.
std::vector<LocalWidth> widenings_of(const Grassleaf& grass, const InstanceContext& instance) {
  if (!grass.stages.bend) return {};
  const Rounding round(grass, instance);
  std::vector<LocalWidth> widenings = grass.widenings;
  if (!round.varies(&Grassleaf::widenings)) return widenings;
  for (LocalWidth& widening : widenings) widening.factor = round.step(widening.factor, kFactorStep);
  return widenings;
}

/// Returns a hash of everything that determines the shape.
std::uint64_t shape_hash(const ShapeNumbers& numbers, const std::vector<LocalTurn>& turns,
                         const std::vector<LocalWidth>& widenings) {
  std::string bytes(reinterpret_cast<const char*>(&numbers), sizeof numbers);
  for (const LocalTurn& turn : turns) bytes.append(reinterpret_cast<const char*>(&turn), sizeof turn);
  for (const LocalWidth& widening : widenings) bytes.append(reinterpret_cast<const char*>(&widening), sizeof widening);
  return hash64(bytes);
}

/// Projects a world vector to the plane of a leaf: away from the stem, and along it.
glm::dvec2 in_plane(Vec3 vector, const Frame& frame) {
  return {-glm::dot(vector, glm::normalize(frame.axes[2])), glm::dot(vector, glm::normalize(frame.axes[1]))};
}

/// Sets the forces that bend the leaf, in the plane of its midrib, and the stiffness of the leaf.
void set_forces(const Grassleaf& grass, const Site& site, const InstanceContext& instance, const Rounding& round,
                ShapeNumbers& numbers) {
  if (!grass.forces || !grass.stages.bend) return;
  const GrassForces& forces = *grass.forces;
  const Vec3 all =
      forces.pull + static_cast<float>(forces.light) * instance.directions().light(site.frame.origin).vector();
  // The wind pressure on a plate, relative to the weight of the blade.
  const double speed = glm::length(forces.wind);
  const Vec3 wind = static_cast<float>(0.5 * kAirDensity * speed / forces.weight) * forces.wind;
  const auto set = [&](Vec3 vector, double& x, double& y) {
    const glm::dvec2 plane = in_plane(vector, site.frame);
    x = round.step(plane.x, kForceStep);
    y = round.step(plane.y, kForceStep);
  };
  set(all, numbers.pull_x, numbers.pull_y);
  set(wind, numbers.wind_x, numbers.wind_y);
  set(instance.directions().gravity(site.frame.origin).vector(), numbers.gravity_x, numbers.gravity_y);
  const ComponentMember<LeafStrip> strip = member_of(grass, &Grassleaf::forces, &GrassForces::strip);
  numbers.stiffness = round.own_octaves(strip.part(&LeafStrip::stiffness), kRadiusSteps);
  numbers.tip_thickness = round.own_octaves(strip.part(&LeafStrip::tip_thickness), kRadiusSteps);
}

/// Sets the number of the growth history. Leaves share a limited number of histories, or each has its own.
void set_variant(const Grassleaf& grass, const Site& site, const InstanceContext& instance, ShapeNumbers& numbers) {
  const GrassVariety& vary = grass.vary;
  if (!vary.acts() || !grass.stages.vary || !grass.stages.age) return;
  const RandomKey own = site.key.child("life");
  const bool is_shared = vary.variants > 0 && !grass.exact;
  const double drawn = std::floor(own.uniform(0) * vary.variants);
  const RandomKey life = is_shared ? instance.component_key().child(static_cast<std::uint64_t>(drawn)) : own;
  // The bits of the key that a double can hold.
  numbers.variant = 1 + static_cast<double>(life.bits() >> 12U);
}

/// Sets the age of the leaf and the age at which a leaf is full-grown.
void set_age(const Grassleaf& grass, const Choice& choice, const Rounding& round, ShapeNumbers& numbers) {
  const double last = grass.stock->midribs[choice.midrib].family.last_age();
  const double age = grass.stages.age ? grass.age : last;
  const double step = grass.full_age / kAgeSteps;
  const bool is_rounded = !grass.exact && grass.stages.age && round.varies(&Grassleaf::age);
  numbers.full_age = grass.full_age;
  numbers.age = is_rounded ? round.step(age, step) : age;
  // Rounding must neither remove a young leaf nor make a leaf older than its midribs.
  if (is_rounded && age > 0) numbers.age = std::max(numbers.age, step);
  numbers.age = std::min(numbers.age, last);
}

/// Sets the inclination of the leaf, or a factor on the inclination of its midrib.
void set_inclination(const Grassleaf& grass, const Rounding& round, ShapeNumbers& numbers) {
  numbers.inclination = kOwnInclination;
  numbers.inclination_factor = 1;
  if (!grass.stages.bend) return;
  if (!grass.inclination) {
    numbers.inclination_factor = round.own(member_of(grass, &Grassleaf::inclination_factor), kFactorStep);
    return;
  }
  const double inclination = *grass.inclination * grass.inclination_factor;
  const bool is_drawn = round.varies(&Grassleaf::inclination) || round.varies(&Grassleaf::inclination_factor);
  numbers.inclination = is_drawn ? round.step(inclination, kShapeAngleStep) : inclination;
}

/// Sets twist, fold, roll and waves of the blade, and how it clasps its sheath.
void set_blade(const Grassleaf& grass, const Site& site, double length, const Rounding& round, ShapeNumbers& numbers) {
  if (!grass.stages.blade) return;
  const ComponentMember<GrassBlade> blade = member_of(grass, &Grassleaf::blade);
  numbers.twist = round.own(blade.part(&GrassBlade::twist), kShapeAngleStep);
  numbers.fold = round.own(blade.part(&GrassBlade::fold), kShapeAngleStep);
  numbers.roll = round.own(blade.part(&GrassBlade::roll), kShapeAngleStep);
  const ComponentMember<EdgeWaves> waves = blade.part(&GrassBlade::waves);
  if (waves.value().number > 0 && waves.value().depth != 0) {
    numbers.waves = round.own(waves.part(&EdgeWaves::number), kWaveNumberStep);
    numbers.waves_depth = round.own(waves.part(&EdgeWaves::depth), kWaveStep);
    numbers.waves_left = round.own(waves.part(&EdgeWaves::left), 6 * kShapeAngleStep);
    numbers.waves_right = round.own(waves.part(&EdgeWaves::right), 6 * kShapeAngleStep);
  }
  if (grass.sheath.length > 0) {
    numbers.clasp = grass.sheath.clasp;
    numbers.clasp_radius = round.octaves(sheath_radius(grass.sheath, site) / length, kRadiusSteps);
  }
}

/// Sets the number of polygons of the blade, or the error that a reduction may make.
void set_polygons(const Grassleaf& grass, const Rounding& round, ShapeNumbers& numbers) {
  if (!grass.stages.reduce) {
    numbers.polygons = grass.source.fit.pieces;
    return;
  }
  numbers.polygons = grass.error ? 0 : grass.polygons;
  numbers.error = grass.error ? round.octaves(*grass.error, kErrorSteps) : 0;
}

/// Returns all numbers that determine the shape of a leaf with this length and width, for a leaf of length 1. Leaves
/// with equal numbers share a mesh. Numbers that vary between leaves are therefore rounded, and numbers of disabled
/// stages stay 0.
ShapeNumbers shape_numbers(const Grassleaf& grass, const Site& site, const Choice& choice, double length, double width,
                           const InstanceContext& instance) {
  const Rounding round(grass, instance);
  ShapeNumbers numbers{};
  numbers.midrib = choice.midrib;
  numbers.widths = choice.widths;
  numbers.width = round.octaves(width / length, kProportionSteps);
  set_variant(grass, site, instance, numbers);
  set_age(grass, choice, round, numbers);
  set_inclination(grass, round, numbers);
  set_forces(grass, site, instance, round, numbers);
  set_blade(grass, site, length, round, numbers);
  set_polygons(grass, round, numbers);
  return numbers;
}

/// Returns the value of a formula. Throws if it is not finite or too large.
double value_of(const std::optional<ParameterFormula>& formula, std::span<const double> names, RandomKey key,
                const InstanceContext& instance, const char* parameter) {
  const double value = formula->expression.evaluate(names, key);
  if (!(std::abs(value) <= kMaxRate)) {
    throw_at(instance, parameter, fmt::format("the expression gives {}", value), fmt::format("at most {}", kMaxRate));
  }
  return value;
}

/// The growth rates of one leaf. Each random call of an expression draws one number per leaf.
class LifeRates {
 public:
  LifeRates(const GrassVariety& vary, RandomKey key, const InstanceContext& instance)
      : vary_(vary), key_(key), instance_(instance) {}

  GrowthRates operator()(double lived, double visible) const {
    const std::array<double, 2> names{lived, visible};
    const auto rate = [&](const std::optional<ParameterFormula>& formula, const char* parameter) {
      return formula ? value_of(formula, names, key_.child(parameter), instance_, parameter) : 1.0;
    };
    return {rate(vary_.age, "vary.age"), rate(vary_.length, "vary.length"), rate(vary_.width, "vary.width"),
            rate(vary_.bend, "vary.bend")};
  }

 private:
  const GrassVariety& vary_;
  RandomKey key_;
  const InstanceContext& instance_;
};

/// Returns the leaf before bending, with a length of 1.
GrassLeaf grown_leaf(const Grassleaf& grass, const ShapeNumbers& numbers, const InstanceContext& instance) {
  const StockedMidrib& midrib = grass.stock->midribs[static_cast<std::size_t>(numbers.midrib)];
  GrassLeaf full = midrib.form;
  full.length = 1;
  full.width = numbers.width;
  full.r = grass.stock->widths[static_cast<std::size_t>(numbers.widths)].fitted.r;
  if (!grass.stages.age) return full;
  if (numbers.variant == 0) return aged(full, midrib.family, numbers.age, numbers.full_age);
  const LifeRates rates(grass.vary, RandomKey(static_cast<std::uint64_t>(numbers.variant)), instance);
  return lived(full, midrib.family, numbers.age, grass.vary.step, rates, numbers.full_age);
}

GrassLeaf bent_leaf(const Grassleaf& grass, const ShapeNumbers& numbers, GrassLeaf leaf,
                    const InstanceContext& instance) {
  if (!grass.stages.bend) return leaf;
  if (numbers.inclination != kOwnInclination) {
    leaf = inclined(leaf, numbers.inclination);
  } else if (numbers.inclination_factor != 1) {
    leaf = inclined(leaf, numbers.inclination_factor * inclination(leaf));
  }
  if (!grass.turns.empty()) leaf = turned(leaf, turns_of(grass, instance));
  if (!grass.widenings.empty()) leaf = widened(leaf, widenings_of(grass, instance));
  if (!grass.forces) return leaf;
  try {
    return loaded(leaf, {.stiffness = numbers.stiffness, .tip_thickness = numbers.tip_thickness},
                  {.pull = {numbers.pull_x, numbers.pull_y},
                   .wind = {numbers.wind_x, numbers.wind_y},
                   .gravity = {numbers.gravity_x, numbers.gravity_y}});
  } catch (const std::invalid_argument& error) {
    throw_at(instance, "forces", error.what(), "weaker forces or a stiffer leaf");
  }
}

GrassLeaf reduced_leaf(const ShapeNumbers& numbers, GrassLeaf leaf, const GrassBlade& blade) {
  // Before reduction, the leaf needs enough pieces for the final number and for its waves.
  const auto pieces = static_cast<std::size_t>(numbers.polygons);
  const auto needed = std::max(pieces, static_cast<std::size_t>(2 * kPiecesAWave * blade.waves.number));
  if (needed + 1 > leaf.point_count()) leaf = resampled(leaf, needed);
  if (numbers.error == 0 && pieces + 1 >= leaf.point_count()) return leaf;
  const ReductionOrder order = reduction_order(leaf, blade_relief(leaf, blade));
  return reduced(leaf, numbers.error > 0 ? points_within(order, numbers.error) : points_kept(order, pieces));
}

std::function<DVec3(double, double)> displacement(const Grassleaf& grass, const InstanceContext& instance) {
  if (!grass.f && !grass.g && !grass.h) return {};
  return [&grass, &instance](double s, double u) {
    const std::array<double, 2> names{s, u};
    const auto value = [&](const std::optional<ParameterFormula>& formula, const char* parameter) {
      return formula ? value_of(formula, names, RandomKey(), instance, parameter) : 0.0;
    };
    return DVec3(value(grass.f, "f"), value(grass.g, "g"), value(grass.h, "h"));
  };
}

GrassBlade blade_of(const Grassleaf& grass, const ShapeNumbers& numbers, const InstanceContext& instance) {
  GrassBlade blade = grass.blade;
  blade.twist = numbers.twist;
  blade.fold = numbers.fold;
  blade.roll = numbers.roll;
  blade.waves = {numbers.waves, numbers.waves_depth, numbers.waves_left, numbers.waves_right};
  blade.clasp = numbers.clasp;
  blade.clasp_radius = numbers.clasp_radius;
  // Omit waves that so few pieces cannot show.
  const bool is_coarse = grass.stages.reduce && numbers.error == 0 && numbers.polygons < kPiecesAWave * numbers.waves;
  if (is_coarse) blade.waves.number = blade.waves.depth = 0;
  if (grass.stages.blade) blade.displace = displacement(grass, instance);
  return blade;
}

/// Runs all stages for one shape. Returns an empty mesh if the leaf is invisible.
Mesh make_shape(const Grassleaf& grass, const ShapeNumbers& numbers, const InstanceContext& instance) {
  const GrassLeaf grown = grown_leaf(grass, numbers, instance);
  if (!(grown.length > 0 && grown.width > 0)) return {};
  const GrassLeaf bent = bent_leaf(grass, numbers, grown, instance);
  const GrassBlade blade = blade_of(grass, numbers, instance);
  return make_grass_blade(reduced_leaf(numbers, bent, blade), blade);
}

void emit_sheath(const Grassleaf& grass, const Site& site, const InstanceContext& instance, OrganSink& organs) {
  const GrassSheath& sheath = grass.sheath;
  const auto radius = static_cast<float>(sheath_radius(sheath, site)), length = static_cast<float>(sheath.length);
  const double open =
      Rounding(grass, instance).own(member_of(grass, &Grassleaf::sheath, &GrassSheath::open), kShapeAngleStep);
  organs.add_blade(
      Frame{.axes = Mat3(Vec3(radius, 0, 0), Vec3(0, length, 0), Vec3(0, 0, radius))}, shape_key({1, open}),
      [&] { return make_sheath(open); }, Vec3(1));
  if (!(sheath.ligule > 0)) return;
  const auto height = static_cast<float>(sheath.ligule);
  organs.add_blade(
      Frame{.axes = Mat3(Vec3(radius, 0, 0), Vec3(0, height, 0), Vec3(0, 0, radius))}, shape_key({2}),
      [] { return make_ligule(); }, Vec3(1));
}

/// Returns the distance from the stem's axis to the collar in metres.
double distance_from_axis(const Grassleaf& grass, const Site& site) {
  if (grass.sheath.length > 0 && grass.stages.blade) return sheath_radius(grass.sheath, site);
  if (site.stem == kOnNoStem) return 0;
  const double scale = glm::length(site.frame.axes[2]);
  return scale > 0 ? site.radius / scale : 0;
}

void expand(const Grassleaf& grass, const Site& site, const InstanceContext& instance, OrganSink& organs) {
  if (grass.stages.age && !(grass.age > 0)) return;
  if (grass.sheath.length > 0 && grass.stages.blade) emit_sheath(grass, site, instance, organs);
  if (grass.vary.acts() && grass.stages.vary && grass.age > kMaxLifeSteps * grass.vary.step) {
    throw_at(instance, "vary.step", fmt::format("the life up to the age {} has too many steps", grass.age),
             fmt::format("a step of {} or more", grass.age / kMaxLifeSteps));
  }
  const Choice choice = choose(grass, site, instance);
  const double length = full_length(grass, choice);
  const double width = full_width(grass, choice, length);
  const ShapeNumbers numbers = shape_numbers(grass, site, choice, length, width, instance);
  Frame frame;
  frame.axes *= static_cast<float>(length);
  frame.axes[0] *= static_cast<float>(width / (length * numbers.width));
  frame.origin.z = -static_cast<float>(distance_from_axis(grass, site));
  organs.add(frame, shape_hash(numbers, turns_of(grass, instance), widenings_of(grass, instance)),
             [&] { return make_shape(grass, numbers, instance); });
}

TextureShape texture_shape(const Grassleaf& grass) {
  TextureShape shape;
  const std::vector<double>& r = grass.stock->widths.front().fitted.r;
  const auto add = [&](std::size_t k, double side) {
    shape.outline.emplace_back(0.5 + 0.5 * side * r[k], static_cast<double>(k) / static_cast<double>(r.size() - 1));
  };
  for (std::size_t k = 0; k < r.size(); ++k) add(k, 1);
  for (std::size_t k = r.size(); k-- > 0;) {
    if (r[k] > 0) add(k, -1);
  }
  // Numbers that vary between leaves are 0 here.
  const double length = grass.length.value_or(0);
  const double width = grass.width.value_or(0);
  shape.aspect = length > 0 && width > 0 ? width / length : kUsualAspect;
  return shape;
}

}  // namespace

ComponentType grassleaf_component() {
  return define_component<Grassleaf>({
      .traits =
          {.name = "grassleaf",
           .doc = "A grass leaf from measured or drawn curves, in stages: load, fit, age, vary, bend, reduce, blade.",
           .material = {.colour = {0.30F, 0.46F, 0.17F}, .roughness = 0.55F, .translucency = 0.3F, .two_sided = true},
           .variety = 0.08,
           .blades = {.material = {.colour = {0.38F, 0.5F, 0.24F}, .roughness = 0.6F}, .has_document_colours = true},
           .stance = BranchStance::along_axis},
      .parameters = grassleaf_table(),
      .expand = expand,
      .texture_shape = texture_shape,
  });
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The parameter tables of fields, and the fields that they describe.
#include "meristem/components/parts/world_field.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "meristem/scene/field/expression_field.h"
#include "meristem/scene/field/ready_fields.h"

namespace meristem {

namespace {

constexpr NumberRange kPlace{.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-5, 5}};
constexpr NumberRange kDirection{.min = -1000, .max = 1000, .usual = {-1, 1}};
constexpr NumberRange kDistance{.unit = Unit::metre, .min = 1e-4, .max = 1e5, .usual = {0.01, 2}};

const ParameterTable& axis_table() {
  static const ParameterTable table =
      Table<FieldLine>("an axis", "A line in space.")
          .vector("point", &FieldLine::point, kPlace, "Point on the axis, in the frame of the world.")
          .in_space(InSpace::position)
          .vector("direction", &FieldLine::direction, kDirection,
                  "Direction of the axis, in the frame of the world; its length does not count.")
          .in_space(InSpace::direction);
  return table;
}

const ParameterTable& cylinder_table() {
  static const ParameterTable table =
      Table<CylinderParameters>("a cylinder", "A pull to the surface of an endless cylinder.")
          .members(&CylinderParameters::axis, axis_table())
          .number("radius", &CylinderParameters::radius,
                  {.unit = Unit::metre, .min = 0, .max = 1e5, .usual = {0.01, 1}},
                  "Radius of the cylinder; outside it the field pulls inward, inside it outward.")
          .in_space(InSpace::radius)
          .number("edge", &CylinderParameters::edge, kDistance,
                  "Distance from the surface within which the pull falls to nothing; raised, stems come to the surface "
                  "in a gentler curve.");
  return table;
}

const ParameterTable& vortex_table() {
  static const ParameterTable table =
      Table<VortexParameters>("a vortex", "A pull around an axis.")
          .members(&VortexParameters::axis, axis_table())
          .number("core", &VortexParameters::core, kDistance,
                  "Distance from the axis within which the pull falls to nothing; raised, a calmer middle.");
  return table;
}

const ParameterTable& wind_table() {
  static const ParameterTable table =
      Table<WindParameters>("a wind", "A pull in one direction, with gusts.")
          .vector("direction", &WindParameters::direction, kDirection,
                  "Direction in which the wind blows, in the frame of the world; its length does not count.")
          .in_space(InSpace::direction)
          .number("gusts", &WindParameters::gusts, {.min = 0, .max = 10, .usual = {0, 2}},
                  "Change of the wind from place to place, as a share of its strength; raised, more restless branches.")
          .number("size", &WindParameters::size, kDistance,
                  "Size of a gust; lowered, neighbouring branches differ more.")
          .number("drift", &WindParameters::drift, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {0, 10}},
                  "Distance that the gusts have moved with the wind; \"3*t\" lets them travel by 3 m in each second.")
          .only_with("gusts", {"size", "drift"});
  return table;
}

const ParameterTable& formula_table() {
  static const ParameterTable table =
      Table<FormulaField>("a formula of a field", "How strongly a field pulls along each axis of the world's frame.")
          .formula(
              "x", &FormulaField::x, field_variables(),
              "Expression over x, y, z (metres in the frame of the world) and t (seconds) for the pull along x; by "
              "default, 0.")
          .formula("y", &FormulaField::y, field_variables(), "Expression for the pull along y; by default, 0.")
          .formula("z", &FormulaField::z, field_variables(), "Expression for the pull along z; by default, 0.");
  return table;
}

bool vanishes(Vec3 vector) { return !(glm::dot(vector, vector) > 1e-20F); }

void check_field(const WorldField& field, const DocumentPath& path, ParameterReader& reader) {
  if (field.formula) {
    const DocumentPath at(path, "formula");
    const auto check_formula = [&](const std::optional<ParameterFormula>& formula, const char* name) {
      if (!formula || !formula->expression.is_random()) return;
      reader.add_error(DocumentPath(at, name), "a field is the same whenever it is asked, and draws nothing",
                       "noise(x, y, z) in place of random functions");
    };
    check_formula(field.formula->x, "x");
    check_formula(field.formula->y, "y");
    check_formula(field.formula->z, "z");
  }
  const auto check_direction = [&](const std::optional<Vec3>& vector, const DocumentPath& at) {
    if (vector && vanishes(*vector))
      reader.add_error(at, "the direction has no length", "a direction other than [0, 0, 0]");
  };
  check_direction(field.uniform, DocumentPath(path, "uniform"));
  if (field.cylinder) {
    const DocumentPath at(path, "cylinder");
    check_direction(field.cylinder->axis.direction, DocumentPath(at, "direction"));
  }
  if (field.vortex) {
    const DocumentPath at(path, "vortex");
    check_direction(field.vortex->axis.direction, DocumentPath(at, "direction"));
  }
  if (field.wind) {
    const DocumentPath at(path, "wind");
    check_direction(field.wind->direction, DocumentPath(at, "direction"));
  }
}

/// Returns the unit vector of one instance. Throws InputError if the instance's values give a vector of zero length.
Vec3 unit_of(Vec3 direction, const FieldPlace& place) {
  if (!vanishes(direction)) return glm::normalize(direction);
  throw InputError(Diagnostic{.message = fmt::format("a direction of the {} has no length", place.what),
                              .expected = "a direction other than [0, 0, 0] in each instance",
                              .path = place.path});
}

FieldPointer local_field(const WorldField& form, const FieldPlace& place) {
  constexpr double kForEver = std::numeric_limits<double>::infinity();
  const auto axis_of = [&](const FieldLine& line) { return FieldAxis{line.point, unit_of(line.direction, place)}; };
  if (form.uniform) return std::make_shared<UniformField>(*form.uniform);
  if (form.toward || form.away) {
    return std::make_shared<PointField>(form.toward ? *form.toward : *form.away, form.reach.value_or(kForEver));
  }
  if (form.cylinder) {
    return std::make_shared<CylinderField>(axis_of(form.cylinder->axis), form.cylinder->radius, form.cylinder->edge);
  }
  if (form.vortex) return std::make_shared<VortexField>(axis_of(form.vortex->axis), form.vortex->core);
  if (form.wind) {
    const WindParameters& wind = *form.wind;
    return std::make_shared<WindField>(
        unit_of(wind.direction, place),
        WindGusts{.share = wind.gusts, .size = wind.size, .drift = wind.drift, .key = place.key});
  }
  const auto expression = [](const std::optional<ParameterFormula>& formula) {
    return formula ? formula->expression : Expression();
  };
  return std::make_shared<ExpressionField>(
      std::array{expression(form.formula->x), expression(form.formula->y), expression(form.formula->z)},
      ExpressionField::Options{
          .time = place.time, .must_point = !form.add, .path = place.path + ".formula", .what = place.what});
}

}  // namespace

const ParameterTable& world_field_table() {
  static const ParameterTable table =
      Table<WorldField>("a field", "Direction and strength of a pull at each position.")
          .object("formula", &WorldField::formula, formula_table,
                  "Expressions for the pull along x, y and z; its length counts as strength.")
          .vector("uniform", &WorldField::uniform, kDirection,
                  "Direction of an even pull; its length counts as strength.")
          .in_space(InSpace::direction)
          .vector("toward", &WorldField::toward, kPlace, "Point that the field pulls to.")
          .in_space(InSpace::position)
          .vector("away", &WorldField::away, kPlace, "Point that the field pushes away from.")
          .in_space(InSpace::position)
          .number("reach", &WorldField::reach, kDistance,
                  "Distance from the point at which the pull is half as strong; by default, it never falls.")
          .object("cylinder", &WorldField::cylinder, cylinder_table,
                  "Pull to the surface of an endless cylinder: inward outside it, outward inside.")
          .object("vortex", &WorldField::vortex, vortex_table, "Pull around an axis, counter-clockwise against it.")
          .object("wind", &WorldField::wind, wind_table, "Pull in one direction, with gusts.")
          .number(
              "strength", &WorldField::strength, {.min = 0, .max = 1000, .usual = {0, 4}},
              "Factor on the pull; 1 pulls as strongly as the scene's own light and gravity, 2 turns as much as two "
              "of them.")
          .boolean("add", &WorldField::add,
                   "Whether the field adds to what pulls there already, instead of taking its place.")
          .one_of({"formula", "uniform", "toward", "away", "cylinder", "vortex", "wind"})
          .only_where({{"toward"}, {"away"}}, {"reach"})
          .check(check_field);
  return table;
}

FieldPointer build_field(const WorldField& form, const FieldPlace& place) {
  const double sign = form.away ? -1 : 1;
  return std::make_shared<PlacedField>(local_field(form, place), place.frame, sign * form.strength);
}

}  // namespace meristem

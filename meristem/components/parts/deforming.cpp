// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/deforming.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace meristem {

namespace {

/// Variables of functions in addition to the position: variables of the component's site.
const std::vector<std::string> kOfSite{"t", "i", "n", "u", "depth", "order", "length", "radius"};

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = FunctionMap::coordinate_names();
    all.insert(all.end(), kOfSite.begin(), kOfSite.end());
    return all;
  }();
  return names;
}

std::optional<Expression> expression_of(const std::optional<ParameterFormula>& formula) {
  return formula ? std::optional(formula->expression) : std::nullopt;
}

}  // namespace

const ParameterTable& deforming_table() {
  static const ParameterTable table =
      Table<Deforming>("a deformation", "What a deformation acts on.")
          .choice("on", &Deforming::on, {"geometry", "axes"},
                  "Parts that are deformed: \"geometry\", all vertices of stems, leaves and bodies; or \"axes\", the "
                  "courses of stems, which keep their thickness while organs keep their form.")
          .boolean(
              "off", &Deforming::off,
              "Whether the deformations above end here: what hangs below is turned and moved as they turn and move "
              "the component itself, and not deformed by them.");
  return table;
}

const ParameterTable& space_functions_table() {
  static const ParameterTable table =
      Table<SpaceFunctions>("functions of space", "Where points of space go.")
          .formula("dx", &SpaceFunctions::dx, function_names(),
                   "New x of a point, in metres, as an expression of its x, y and z in the component's frame; a "
                   "hyperpatch evaluates it at its control points. By default x.")
          .formula("dy", &SpaceFunctions::dy, function_names(),
                   "New y of a point, along the component's heading, in metres; by default y.")
          .formula("dz", &SpaceFunctions::dz, function_names(), "New z of a point, in metres; by default z.");
  return table;
}

FunctionMap map_of(const SpaceFunctions& functions, const Site& site, double time) {
  const std::span<const std::string> variables = site_variables();
  std::vector<double> values;
  for (const std::string& name : kOfSite) {
    const auto found = std::find(variables.begin(), variables.end(), name);
    values.push_back(site_variable(static_cast<std::size_t>(found - variables.begin()), site, 0, time));
  }
  return FunctionMap({expression_of(functions.dx), expression_of(functions.dy), expression_of(functions.dz)},
                     std::move(values), site.key.child("deformation"));
}

void deform_below(const Deforming& how, std::shared_ptr<const SpaceMap> map, const Site& site,
                  const InstanceContext& instance, SiteSink& sites) {
  if (map == nullptr && !how.off) return;
  Surroundings said = instance.surroundings();
  if (how.off && said.deformation != nullptr) {
    said.deformation = said.deformation->rigid_at(site.frame.origin, instance.component());
  }
  if (map != nullptr) {
    const std::vector<Deformation::Level> own{
        {std::move(map), site.frame, how.on, "components." + instance.component()}};
    said.deformation = Deformation::nested(std::make_shared<const Deformation>(own), said.deformation);
  }
  sites.surround(std::move(said));
}

}  // namespace meristem

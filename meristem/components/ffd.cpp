// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/ffd.h"

namespace meristem {

namespace {

void expand(const Ffd& ffd, const Site& site, const InstanceContext& instance, SiteSink& sites) {
  std::shared_ptr<const SpaceMap> map;
  if (!ffd.functions.is_empty()) {
    map = std::make_shared<const FunctionMap>(map_of(ffd.functions, site, instance.time()));
  }
  deform_below(ffd.deforming, std::move(map), site, instance, sites);
}

}  // namespace

ComponentType ffd_component() {
  return define_component<Ffd>({
      .traits = {.name = "ffd",
                 .doc = "A free-form deformation by functions: everything below it is bent, twisted or stretched.",
                 .has_geometry = false,
                 .speaks_of_space = true},
      .parameters = Table<Ffd>("an ffd", "A free-form deformation by functions of space.")
                        .members(&Ffd::functions, space_functions_table())
                        .members(&Ffd::deforming, deforming_table()),
      .expand = expand,
  });
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/species.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

bool OrganizedSpecies::has_summer(std::optional<int> iteration) const {
  return std::ranges::any_of(parameters.operations, [&](const TreeOperation& operation) {
    return operation.when.in_summer && (!iteration || operation.when.is_in_turn(*iteration));
  });
}

int OrganizedSpecies::rounds() const { return has_summer() ? std::max(2, parameters.every) : parameters.every; }

bool OrganizedSpecies::looks(int round) const {
  const int within = round % rounds();
  return within == 0 || (has_summer() && within == rounds() / 2);
}

std::string OrganizedSpecies::path(const std::string& parameter) const {
  return fmt::format("components.{}.{}", component, parameter);
}

void OrganizedSpecies::refuse(const std::string& parameter, std::string message, std::string expected,
                              std::string nearest) const {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = std::move(expected),
                              .nearest = std::move(nearest),
                              .path = path(parameter)});
}

}  // namespace meristem

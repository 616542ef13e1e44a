// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/species.h"

#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

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

// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/cut.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

constexpr std::size_t kShownNames = 12;

[[noreturn]] void refuse(std::string path, std::string message, std::string expected, std::string nearest = {}) {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = std::move(expected),
                              .nearest = std::move(nearest),
                              .path = std::move(path)});
}

[[noreturn]] void refuse_shoot(const Metamers& metamers, const Cut& cut, int iteration) {
  // The names to choose from are those on the longest beginning of this one that is there.
  std::string known = cut.shoot;
  while (known.find('.') != std::string::npos && !metamers.find_shoot(known)) known.resize(known.find_last_of('.'));
  const AxisIndex on = metamers.find_shoot(known).value_or(0);
  std::vector<std::string> names = metamers.shoots_on(on);
  names.insert(names.begin(), metamers.name_of(on));
  const std::string nearest = nearest_name(cut.shoot, names);
  if (names.size() > kShownNames) names.resize(kShownNames);
  refuse(cut.path + ".shoot", fmt::format("there is no shoot '{}' after iteration {}", cut.shoot, iteration),
         fmt::format("one that is there, such as {}", fmt::join(names, ", ")), nearest);
}

}  // namespace

MetamerIndex find_cut(const Metamers& metamers, const Cut& cut, int iteration) {
  const std::optional<AxisIndex> shoot = metamers.find_shoot(cut.shoot);
  if (!shoot) refuse_shoot(metamers, cut, iteration);
  if (*shoot == 0 && cut.above == 0) {
    refuse(cut.path + ".above", "nothing would be left of the tree", "a whole number of at least 1");
  }
  const auto first = metamers.find(*shoot, static_cast<std::uint32_t>(cut.above) + 1);
  if (!first) {
    refuse(cut.path + ".above",
           fmt::format("'{}' has {} metamers after iteration {}, and none above that", cut.shoot,
                       metamers.number[metamers.axes[*shoot].last], iteration),
           "fewer metamers that stay, or a later iteration");
  }
  return *first;
}

}  // namespace meristem

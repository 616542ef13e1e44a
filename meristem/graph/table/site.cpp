// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/site.h"

#include <limits>
#include <vector>

#include "meristem/base/fingerprint.h"

namespace meristem {

std::span<const std::string> site_variables() {
  static const std::vector<std::string> names = {"v", "i",  "n",  "u",  "depth", "order",  "x",     "y",
                                                 "z", "hx", "hy", "hz", "t",     "length", "radius"};
  return names;
}

std::uint64_t SiteValues::hash() const { return Fingerprint().add(names).add_array(numbers).hash(); }

double site_variable(std::size_t k, const Site& site, double v, double time) {
  switch (k) {
    case 0:
      return v;
    case 1:
      return site.i;
    case 2:
      return site.n;
    case 3:
      return site.u;
    case 4:
      return site.depth;
    case 5:
      return site.order;
    case 6:
      return site.frame.origin.x;
    case 7:
      return site.frame.origin.y;
    case 8:
      return site.frame.origin.z;
    case 9:
      return site.frame.heading().x;
    case 10:
      return site.frame.heading().y;
    case 11:
      return site.frame.heading().z;
    case 12:
      return site.clock.at(time);
    case 13:
      return site.length;
    case 14:
      return site.radius;
    default:
      break;
  }
  const std::size_t given = k - site_variables().size();
  const bool is_there = site.values != nullptr && given < site.values->numbers.size();
  return is_there ? site.values->numbers[given] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/site.h"

#include <vector>

namespace meristem {

std::span<const std::string> site_variables() {
  static const std::vector<std::string> names = {"v", "i",  "n",  "u",  "depth", "order",  "x",     "y",
                                                 "z", "hx", "hy", "hz", "t",     "length", "radius"};
  return names;
}

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
      return time;
    case 13:
      return site.length;
    default:
      return site.radius;
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/detail/detail.h"

#include <stdexcept>

namespace meristem {

double MeshDetail::kept(int of_level) const {
  double kept = 1;
  for (int k = 0; k < of_level; ++k) kept *= share;
  return kept;
}

void check_detail(const MeshDetail& detail) {
  if (detail.level < 0 || detail.level > kCoarsestDetail)
    throw std::invalid_argument("there is no such level of detail");
  if (!(detail.share > 0 && detail.share < 1)) throw std::invalid_argument("a level's share must lie between 0 and 1");
}

}  // namespace meristem

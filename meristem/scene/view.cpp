// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/view.h"

#include "meristem/base/frame.h"

namespace meristem {

View turned(View view, Vec3 middle, double angle) {
  view.azimuth += angle;
  // Azimuths run clockwise seen from above, rotations about the upward axis the other way.
  const Vec3 centre = view.target.value_or(middle);
  if (view.position) view.position = centre + rotation(kUp, -angle) * (*view.position - centre);
  return view;
}

}  // namespace meristem

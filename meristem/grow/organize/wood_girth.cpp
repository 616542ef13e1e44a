// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/wood_girth.h"

#include "meristem/base/math.h"

namespace meristem {

WoodGirth::WoodGirth(const Metamers& metamers, const StandingWood& standing, const PipeModel& model)
    : standing_(standing), model_(model), tips_(count_tips(metamers.parent, metamers.lost_tips, model.memory)) {}

double WoodGirth::radius(MetamerIndex metamer) const {
  if (standing_.stands(metamer)) return standing_.radius(metamer, tips_[metamer], model_);
  return model_.tip_radius * math::pow(tips_[metamer], 1 / model_.exponent);
}

}  // namespace meristem

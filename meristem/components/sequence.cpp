// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/sequence.h"

namespace meristem {

namespace {

void expand(const Sequence& sequence, const Site&, SiteSink& sites) {
  const bool has_started = sites.begin_clock(sequence.delay, sequence.speed);
  if (!has_started && !sequence.waits) sites.no_children();
}

}  // namespace

ComponentType sequence_component() {
  return define_component<Sequence>({
      .traits = {.name = "sequence",
                 .doc = "A clock for everything below it, which starts when the instance appears.",
                 .has_geometry = false,
                 .speaks_of_space = true,
                 .begins_clock = true},
      .parameters =
          Table<Sequence>("a sequence", "A clock for everything below it.")
              .number("delay", &Sequence::delay,
                      {.unit = Unit::second, .min = -1e6, .max = 1e6, .usual = {0, 10}, .timeless = true},
                      "Time from when the instance appears to when its clock starts; raised, what is below moves "
                      "later.")
              .number("speed", &Sequence::speed,
                      {.min = 0, .max = 1e6, .usual = {0.1, 5}, .above_min = true, .timeless = true},
                      "Seconds of the instance's clock per second of the clock above it; raised, what is below moves "
                      "faster.")
              .boolean("waits", &Sequence::waits,
                       "Whether what is below stands there before the clock starts, as it is at its time 0; otherwise, "
                       "it is not there yet."),
      .expand = expand,
  });
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Published figures of one well-known scanner per class. instrument.h names the sources. The terrestrial scanner has
// the default values of ScanInstrument, and the other classes change what differs.
#include "meristem/measure/scan/instrument.h"

namespace meristem {

namespace {

constexpr double kWholeRange = 1000;  // resolution in metres that mixes all surfaces in the beam into one return

}  // namespace

ScanInstrument instrument_of(ScannerClass kind) {
  ScanInstrument made{.kind = kind};
  switch (kind) {
    case ScannerClass::terrestrial:
      break;
    case ScannerClass::phase:
      made.step = radians(0.036);
      made.lowest = radians(-60);
      made.highest = radians(90);
      made.divergence = 0.19;
      made.exit_diameter = 0.00225;
      made.returns = 1;
      made.resolution = kWholeRange;
      made.noise = 0.002;
      made.nearest = 0.6;
      made.farthest = 130;
      break;
    case ScannerClass::drone:
      made.step = radians(0.05);
      made.field = radians(90);
      made.divergence = 0.5;
      made.exit_diameter = 0.006;
      made.returns = 5;
      made.noise = 0.005;
      made.nearest = 3;
      made.farthest = 500;
      break;
    case ScannerClass::depth_camera:
      made.field = radians(57);
      made.divergence = 1.7;
      made.exit_diameter = 0;
      made.rays = 5;
      made.returns = 1;
      made.resolution = kWholeRange;
      made.noise = 0.0012;
      made.noise_growth = 0.0019;
      made.nearest = 0.4;
      made.farthest = 4.5;
      break;
  }
  return made;
}

}  // namespace meristem

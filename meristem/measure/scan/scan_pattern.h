// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/measure/scan/instrument.h"

namespace meristem {

/// One pulse along the axis of its beam.
struct Pulse {
  DVec3 origin{0};           ///< metres
  DVec3 direction{0, 0, 1};  ///< unit
  std::uint32_t station = 0;
};

/// Returns `count` positions around a box, spread evenly about its middle, the first in the north. Scanners on tripods
/// stand 1.6 m above y = 0. Their distance from the box is its width, or half of its height if that is more. Depth
/// cameras stand where the box fills the picture, or as far away as their range allows.
std::vector<Vec3> stations_around(const Box& box, int count, const ScanInstrument& instrument);

/// All pulses of a scan, numbered station by station in the order of time.
class ScanPattern {
 public:
  /// A drone flies over `box`, and its lines are the stations. All other scanners use `stations`. Depth cameras look at
  /// `target`.
  ScanPattern(const ScanInstrument& instrument, std::vector<Vec3> stations, Vec3 target, const Box& box);

  std::uint64_t pulse_count() const { return station_count() * per_station_; }
  std::uint64_t pulses_per_station() const { return per_station_; }
  std::uint64_t station_count() const { return stations_.size(); }
  /// Positions of the stations. For a drone, the positions where the lines begin.
  const std::vector<Vec3>& stations() const { return stations_; }
  Pulse pulse(std::uint64_t number) const;

 private:
  struct Turn {
    double cosine, sine;
  };
  static std::vector<Turn> turns(double first, double step, std::uint64_t count);
  void plan_sweeps(const ScanInstrument& instrument);
  void plan_lines(const ScanInstrument& instrument, const Box& box);
  void plan_pixels(const ScanInstrument& instrument, Vec3 target);

  ScannerClass kind_;
  std::vector<Vec3> stations_;
  std::uint64_t per_station_ = 0;
  std::uint64_t per_row_ = 1;  // pulses of one sweep, one profile of a line, or one row of pixels
  std::vector<Turn> slow_;     // azimuths of sweeps
  std::vector<Turn> fast_;     // altitudes within a sweep, or angles across a drone's line
  DVec3 along_{0};             // a drone's flight from one profile to the next
  DVec3 across_{0};            // to the right of the flight
  std::vector<DMat3> views_;   // directions of each camera: right, down and forward, scaled to pixels
};

}  // namespace meristem

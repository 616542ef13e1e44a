// SPDX-License-Identifier: Apache-2.0
// Lists the pulses of a scan: origin and direction by number. Terrestrial scanners sweep up and down at each azimuth,
// drones fly parallel lines, and depth cameras look through a grid of pixels. Cosines and sines are computed once per
// row and column of pulses.
#include "meristem/measure/scan/scan_pattern.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr double kTripod = 1.6;        // height of a tripod, metres
constexpr double kCloseTo = 2;         // minimum distance from a small plant, metres
constexpr double kShareOfRange = 0.8;  // maximum share of a camera's range at which its stations stand

/// Returns the number of whole steps in a length, independent of rounding in the last bit of a product.
std::uint64_t steps_in(double length, double step) {
  return static_cast<std::uint64_t>(std::max(0.0, std::floor(length / step + 1e-6)));
}

}  // namespace

std::vector<Vec3> stations_around(const Box& box, int count, const ScanInstrument& instrument) {
  const DVec3 middle = box.is_empty() ? DVec3(0) : DVec3(box.centre());
  const DVec3 size = box.size();
  const double half = 0.5 * std::sqrt(size.x * size.x + size.z * size.z);
  double distance = half + std::max({kCloseTo, half, 0.5 * size.y});
  double height = kTripod;
  if (instrument.kind == ScannerClass::depth_camera) {
    const double across = std::min(1.0, static_cast<double>(instrument.rows) / instrument.columns);
    const double tangent = math::tan(0.5 * instrument.field) * across;
    const double fitting = 0.5 * glm::length(size) * std::sqrt(1 + 1 / (tangent * tangent));
    distance = std::max(half + instrument.nearest, std::min(fitting, half + kShareOfRange * instrument.farthest));
    height = std::max(0.1, middle.y);
  }
  std::vector<Vec3> stations;
  for (int k = 0; k < count; ++k) {
    const double azimuth = 2 * kPi * k / count;
    stations.emplace_back(middle.x + distance * math::sin(azimuth), height, middle.z - distance * math::cos(azimuth));
  }
  return stations;
}

std::vector<ScanPattern::Turn> ScanPattern::turns(double first, double step, std::uint64_t count) {
  std::vector<Turn> made;
  made.reserve(count);
  for (std::uint64_t k = 0; k < count; ++k) {
    const double angle = first + step * static_cast<double>(k);
    made.push_back({math::cos(angle), math::sin(angle)});
  }
  return made;
}

ScanPattern::ScanPattern(const ScanInstrument& instrument, std::vector<Vec3> stations, Vec3 target, const Box& box)
    : kind_(instrument.kind), stations_(std::move(stations)) {
  if (kind_ == ScannerClass::drone) {
    plan_lines(instrument, box);
  } else if (kind_ == ScannerClass::depth_camera) {
    plan_pixels(instrument, target);
  } else {
    plan_sweeps(instrument);
  }
}

void ScanPattern::plan_sweeps(const ScanInstrument& instrument) {
  const std::uint64_t sweeps = std::max<std::uint64_t>(1, steps_in(2 * kPi, instrument.step));
  slow_ = turns(0, instrument.step, sweeps);
  per_row_ = 1 + steps_in(instrument.highest - instrument.lowest, instrument.step);
  fast_ = turns(instrument.lowest, instrument.step, per_row_);
  per_station_ = sweeps * per_row_;
}

void ScanPattern::plan_lines(const ScanInstrument& instrument, const Box& box) {
  const double cosine = math::cos(instrument.heading);
  const double sine = math::sin(instrument.heading);
  const DVec3 ahead(sine, 0, -cosine);
  across_ = DVec3(cosine, 0, sine);
  along_ = instrument.advance * ahead;
  const DVec3 middle = box.is_empty() ? DVec3(0) : DVec3(box.centre());
  const DVec3 half = 0.5 * DVec3(box.size());
  const double length = 2 * (std::abs(sine) * half.x + std::abs(cosine) * half.z);
  const double width = 2 * (std::abs(cosine) * half.x + std::abs(sine) * half.z);
  const std::uint64_t lines = 1 + static_cast<std::uint64_t>(std::ceil(width / instrument.line_spacing - 1e-6));
  const std::uint64_t profiles = 2 + steps_in(length, instrument.advance);
  per_row_ = 1 + 2 * steps_in(0.5 * instrument.field, instrument.step);
  fast_ = turns(-instrument.step * static_cast<double>(per_row_ / 2), instrument.step, per_row_);
  per_station_ = profiles * per_row_;
  stations_.clear();
  for (std::uint64_t k = 0; k < lines; ++k) {
    const double aside = instrument.line_spacing * (static_cast<double>(k) - 0.5 * static_cast<double>(lines - 1));
    const double back = 0.5 * instrument.advance * static_cast<double>(profiles - 1);
    const DVec3 begin = middle + aside * across_ - back * ahead;
    stations_.emplace_back(begin.x, instrument.altitude, begin.z);
  }
}

void ScanPattern::plan_pixels(const ScanInstrument& instrument, Vec3 target) {
  per_row_ = static_cast<std::uint64_t>(instrument.columns);
  per_station_ = per_row_ * static_cast<std::uint64_t>(instrument.rows);
  const double width = 2 * math::tan(0.5 * instrument.field);
  const double pixel = width / instrument.columns;
  for (const Vec3 station : stations_) {
    const DVec3 toward = DVec3(target) - DVec3(station);
    const DVec3 forward = glm::length(toward) > 0 ? glm::normalize(toward) : DVec3(0, 0, -1);
    DVec3 right = glm::cross(forward, DVec3(kUp));
    right = glm::length(right) > 1e-9 ? glm::normalize(right) : DVec3(1, 0, 0);
    const DVec3 down = glm::cross(forward, right);
    // The upper left corner of the picture, and the vectors from one pixel to the next.
    const DVec3 corner = forward - 0.5 * pixel * instrument.columns * right - 0.5 * pixel * instrument.rows * down;
    views_.emplace_back(pixel * right, pixel * down, corner);
  }
}

Pulse ScanPattern::pulse(std::uint64_t number) const {
  Pulse pulse;
  const std::uint64_t station = number / per_station_;
  const std::uint64_t within = number % per_station_;
  const std::uint64_t row = within / per_row_;
  const std::uint64_t column = within % per_row_;
  pulse.station = static_cast<std::uint32_t>(station);
  pulse.origin = stations_[station];
  if (kind_ == ScannerClass::depth_camera) {
    const DMat3& view = views_[station];
    pulse.direction =
        glm::normalize(view * DVec3(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5, 1));
  } else if (kind_ == ScannerClass::drone) {
    pulse.origin += static_cast<double>(row) * along_;
    pulse.direction = fast_[column].sine * across_ - fast_[column].cosine * DVec3(kUp);
  } else {
    const auto [cosine, sine] = slow_[row];
    const double level = fast_[column].cosine;
    pulse.direction = DVec3(sine * level, fast_[column].sine, -cosine * level);
  }
  return pulse;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// What a scanner would see of a plant: points with their returns, and for each what it really is a point of.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/measure/scan/instrument.h"
#include "meristem/measure/surface_labels.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// One return of one pulse.
struct ScanPoint {
  Vec3 position{0};      ///< metres: on the beam's axis, at the measured range
  float range = 0;       ///< metres, with noise; where surfaces are mixed, their mean
  float true_range = 0;  ///< metres to the surface that the label names, without noise
  /// Share of the beam in this return, each ray times the cosine between it and the surface: what a matt surface of
  /// full reflectance gives back at that range.
  float intensity = 0;
  SurfaceLabel label;         ///< of the surface with the largest part of the intensity (tie: the nearest)
  std::uint64_t pulse = 0;    ///< number of the pulse among all of the scan's, whatever they met
  std::uint32_t station = 0;  ///< from 0
  std::uint8_t number = 1;    ///< of the return among those of its pulse, the nearest first, from 1
  std::uint8_t count = 1;     ///< returns of the pulse
};

/// The instrument, the positions and the surroundings of a scan.
struct ScanOptions {
  Instrument instrument{};  ///< the scanner
  /// Positions of the scanner, metres. Empty: `around` ones all around the plants. A drone flies lines over the plants.
  std::vector<Vec3> stations{};
  int around = 4;                ///< number of positions if `stations` is empty
  std::optional<Vec3> target{};  ///< what depth cameras look at; unset: the middle of the plants
  bool ground = false;           ///< whether y = 0 is a flat ground that is seen as well
  std::uint64_t seed = 0;        ///< of the noise
};

/// Pulses that one scan may have.
inline constexpr std::uint64_t kMostPulses = 4'000'000'000;

/// A scan that is ready to be taken.
class Scanner {
 public:
  /// `meshes` is what make_mesh_scene makes of `plant` at level 0, with or without obstacles, and must outlive it;
  /// `plant` need not. Textures with holes must be painted (has_holes, foliage.h), since pulses pass through the holes.
  /// Begins a stage of `progress`. Throws InputError if a limit is passed, if the pulses are too many or if a drone
  /// would fly into the scene, Cancelled, MachineError (memory).
  Scanner(const Plant& plant, const Limits& limits, const MeshScene& meshes, const ScanOptions& options,
          Progress& progress);
  /// Like the constructor above, with labels that were read from the plant before. The plant can be freed already.
  Scanner(PlantLabels&& labels, const MeshScene& meshes, const ScanOptions& options, Progress& progress);
  ~Scanner();
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;

  std::uint64_t pulse_count() const;          ///< pulses of the whole scan
  const std::vector<Vec3>& stations() const;  ///< positions of the scanner, metres
  const SurfaceLabels& labels() const;        ///< labels of all surfaces that the scanner sees
  const ScanOptions& options() const;         ///< options of the scan
  /// Returns the bytes that rays need to find surfaces, without the meshes.
  std::uint64_t ray_bytes() const;

  /// Calls `take` with the points of the scan, some at a time, in the order of the pulses; equal on any number of
  /// threads. Memory stays below 200 MB, whatever the number of points. Begins a stage of `progress`, which counts
  /// pulses. Throws Cancelled.
  void run(FunctionRef<void(std::span<const ScanPoint>)> take, Progress& progress) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// A whole scan in memory.
struct Scan {
  std::vector<ScanPoint> points{};          ///< all points, in the order of the pulses
  std::vector<std::string> components{};    ///< ids that labels index; the last is "ground"
  std::vector<std::uint32_t> shoots{};      ///< numbers of the shoots that have points, rising
  std::vector<std::string> shoot_labels{};  ///< label of each of them
  std::vector<Vec3> stations{};             ///< metres
};

/// All points of a scan. Throws as Scanner does, and InputError for more than `most_points`.
Scan take_scan(const Scanner& scanner, Progress& progress, std::uint64_t most_points = 200'000'000);

/// A scanner and its scan in one.
Scan scan(const Plant& plant, const Limits& limits, const MeshScene& meshes, const ScanOptions& options,
          Progress& progress, std::uint64_t most_points = 200'000'000);

/// Notes which shoots have points.
class ShootsSeen {
 public:
  /// No shoot has points yet; `shoots` is the number of all shoots.
  explicit ShootsSeen(std::uint32_t shoots) : is_seen_(shoots) {}
  /// Notes the shoots of these points.
  void add(std::span<const ScanPoint> points);
  /// Their numbers, rising.
  std::vector<std::uint32_t> numbers() const;

 private:
  std::vector<bool> is_seen_;
};

}  // namespace meristem

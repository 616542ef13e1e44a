// SPDX-License-Identifier: Apache-2.0
// Simulates a laser scan of a plant: points with their returns, and for each point the true label of its surface.
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
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// One return of one pulse.
struct ScanPoint {
  Vec3 position{0};      ///< metres; on the beam's axis, at the measured range
  float range = 0;       ///< metres, with noise; the mean range if surfaces are mixed
  float true_range = 0;  ///< metres to the surface that the label names, without noise
  /// Share of the beam in this return. Each ray is weighted by the cosine between the ray and the surface, so this is
  /// the reflection of a matt surface of full reflectance at that range.
  float intensity = 0;
  SurfaceLabel label;         ///< label of the surface with the largest part of the intensity (tie: the nearest)
  std::uint64_t pulse = 0;    ///< number of the pulse among all pulses of the scan, also those without a return
  std::uint32_t station = 0;  ///< number of the station, from 0
  std::uint8_t number = 1;    ///< number of the return within its pulse, from 1; the nearest is first
  std::uint8_t count = 1;     ///< number of returns of the pulse
};

/// The instrument, the positions and the surroundings of a scan.
struct ScanOptions {
  ScanInstrument instrument{};  ///< the scanner
  /// Positions of the scanner, metres. If empty, `around` positions are used, all around the plants. A drone flies
  /// lines over the plants instead.
  std::vector<Vec3> stations{};
  int around = 4;                ///< number of positions if `stations` is empty
  std::optional<Vec3> target{};  ///< point at which depth cameras look; if unset, the middle of the plants
  bool ground = false;           ///< if true, y = 0 is a flat ground that is scanned as well
  std::uint64_t seed = 0;        ///< seed of the noise
};

/// Maximum number of pulses of one scan.
inline constexpr std::uint64_t kMaxPulses = 4'000'000'000;

/// A prepared scan.
class Scanner {
 public:
  /// Prepares a scan. `meshes` must be the result of make_mesh_scene for `plant` at level 0, with or without obstacles,
  /// and must outlive this object. `plant` may be freed earlier. Textures with holes must be painted (has_holes,
  /// foliage.h), since pulses pass through the holes. Begins a stage of `progress`. Throws InputError if a limit is
  /// exceeded, if there are too many pulses, or if a drone would fly into the scene. Also throws Cancelled and
  /// MachineError (memory).
  Scanner(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes, const ScanOptions& options,
          Progress& progress);
  /// Like the constructor above, with labels that were read from the plant before. The plant may already be freed.
  Scanner(PlantLabels&& labels, const MeshScene& meshes, const ScanOptions& options, Progress& progress);
  ~Scanner();
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;

  std::uint64_t pulse_count() const;          ///< pulses of the whole scan
  const std::vector<Vec3>& stations() const;  ///< positions of the scanner, metres
  const SurfaceLabels& labels() const;        ///< labels of all surfaces that the scanner sees
  const ScanOptions& options() const;         ///< options of the scan
  /// Returns the memory of the search structure for rays in bytes, without the meshes.
  std::uint64_t ray_bytes() const;

  /// Calls `take` with blocks of points of the scan, in the order of the pulses. The points are equal on any number of
  /// threads. Memory stays below 200 MB, whatever the number of points. Begins a stage of `progress`, which counts
  /// pulses. Throws Cancelled.
  void run(FunctionRef<void(std::span<const ScanPoint>)> take, Progress& progress) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// A complete scan in memory.
struct Scan {
  std::vector<ScanPoint> points{};          ///< all points, in the order of the pulses
  std::vector<std::string> components{};    ///< component ids, to which labels refer; the last is "ground"
  std::vector<std::uint32_t> shoots{};      ///< numbers of the shoots that have points, ascending
  std::vector<std::string> shoot_labels{};  ///< label of each of these shoots
  std::vector<Vec3> stations{};             ///< positions of the scanner, metres
};

/// Returns all points of a scan. Throws like Scanner, and InputError for more than `max_points`.
Scan take_scan(const Scanner& scanner, Progress& progress, std::uint64_t max_points = 200'000'000);

/// Prepares and takes a scan.
Scan scan(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes, const ScanOptions& options,
          Progress& progress, std::uint64_t max_points = 200'000'000);

/// Records which shoots have points.
class ShootsSeen {
 public:
  /// `shoots` is the number of all shoots. At first no shoot has points.
  explicit ShootsSeen(std::uint32_t shoots) : is_seen_(shoots) {}
  /// Records the shoots of these points.
  void add(std::span<const ScanPoint> points);
  /// Returns the numbers of the shoots with points, ascending.
  std::vector<std::uint32_t> numbers() const;

 private:
  std::vector<bool> is_seen_;
};

}  // namespace meristem

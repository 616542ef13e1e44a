// SPDX-License-Identifier: Apache-2.0
// Which share of a surface lies in shade, moment by moment: with the plants, and with the obstacles alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A surface as points that are spread evenly over it, each standing for as much of its area.
struct ShadeSurface {
  std::vector<Vec3> positions{};  ///< metres
  std::vector<Vec3> normals{};    ///< unit, of the side that is meant
  double area = 0;                ///< square metres, of all points together
  /// Columns of a grid, whose points stand row by row, the first row last in a picture; 0 where the points form no
  /// grid.
  int columns = 0;
  int rows = 0;  ///< rows of a grid
  /// For each cell of a grid, 1 where the cell has a point, 0 where an obstacle stands on it; `positions` has the cells
  /// with 1 only.
  std::vector<std::uint8_t> has_point{};
};

/// The sides of an obstacle: its walls are the faces that lean less than 45° from upright, its roofs those that look
/// up; a wall belongs to a side if it looks less than 45° away from it.
enum class FacadeSide { walls, north, east, south, west, roof, all };

/// Square metres of those faces of an obstacle that facade_surface covers, what does not count included.
double facade_area(const Obstacles& obstacles, std::size_t obstacle, FacadeSide side, std::optional<double> azimuth);
/// Points on those faces of an obstacle that belong to a side, or, with an `azimuth` (radians, from north over east),
/// on the walls that look less than 45° away from it. What lies below the ground (y = 0) or inside another obstacle
/// does not count. About one point in `spacing` squared, metres. No points where there is no such face.
ShadeSurface facade_surface(const Obstacles& obstacles, std::size_t obstacle, FacadeSide side,
                            std::optional<double> azimuth, double spacing);
/// The points of several surfaces as one, without a grid.
ShadeSurface joined(const std::vector<ShadeSurface>& surfaces);

/// A flat rectangle, such as a field of solar panels. Angles in radians.
struct PanelField {
  Vec3 position{0};      ///< position of the surface's middle, metres
  double width = 1;      ///< along the horizontal, metres
  double length = 1;     ///< up its slope, metres
  double tilt = 0;       ///< from the horizontal: 0 lies flat, a quarter turn stands upright
  double azimuth = kPi;  ///< the way it looks, from north over east
};

/// A grid of points in the middles of equal cells, about `spacing` wide; columns from the left as seen from in front,
/// rows from its lower edge up.
ShadeSurface panel_surface(const PanelField& panels, double spacing);

/// The ground between two corners [x, z], at a height, looking up: columns to the east, rows from south to north. Cells
/// whose middle is inside an obstacle have no point.
ShadeSurface ground_surface(Vec2 from, Vec2 to, double height, const Obstacles& obstacles, double spacing);

/// What of a surface lies in shade while the sun stands at one position.
struct ShadeMoment {
  double cosine = 0;                ///< mean of the cosine between its normals and the sun, 0 where it looks away
  double shade = 1;                 ///< share that the sun does not reach; what looks away from it lies in shade
  double shade_without_plants = 1;  ///< share of shade with the obstacles alone
  double direct = 0;                ///< mean of the cosine where the sun arrives: direct light against full
};

/// The share of all moments in which each point lies in shade.
struct ShadeOfSurface {
  std::vector<ShadeMoment> moments;             ///< for each position of the sun
  std::vector<double> of_point;                 ///< for each point, over the positions above the horizon
  std::vector<double> of_point_without_plants;  ///< like `of_point`, with the obstacles alone
};

/// Rays that one call may take: points times positions of the sun.
inline constexpr std::uint64_t kMostShadeRays = 200'000'000;

/// Rays go from every point to every position of the sun above the horizon (altitude above 0; below it all is shade).
/// Obstacles and all that `plants` shows stop them; the holes of masked textures let them pass, so those must be
/// painted. `plants` is what make_mesh_scene makes. About a microsecond per ray. Results are equal on any number of
/// threads. Begins a stage of `progress`, which counts rays. Throws Cancelled, MachineError (memory), and
/// std::invalid_argument beyond kMostShadeRays.
ShadeOfSurface measure_shade(const ShadeSurface& surface, const std::vector<SkyDirection>& sun, const MeshScene& plants,
                             const Obstacles& obstacles, Progress& progress);

}  // namespace meristem

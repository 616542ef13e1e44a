// SPDX-License-Identifier: Apache-2.0
// Computes the share of a surface that lies in shade, moment by moment: with the plants, and with the obstacles alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// A surface as evenly spread points. Each point represents an equal part of the area.
struct ShadeSurface {
  std::vector<Vec3> positions{};  ///< metres
  std::vector<Vec3> normals{};    ///< unit normals of the side that is measured
  double area = 0;                ///< square metres, of all points together
  /// Columns of a grid, or 0 if the points form no grid. Points are listed row by row, and the first row is the lowest
  /// in a picture.
  int columns = 0;
  int rows = 0;  ///< rows of a grid
  /// For each cell of a grid: 1 if the cell has a point, 0 if an obstacle stands on the cell. `positions` lists only
  /// the cells with 1.
  std::vector<std::uint8_t> has_point{};
};

/// The sides of an obstacle. Walls are the faces that lean less than 45° from upright, and roofs are the faces that
/// look up. A wall belongs to a side if it looks less than 45° away from the direction of the side.
enum class FacadeSide { walls, north, east, south, west, roof, all };

/// Returns the area of the faces of an obstacle that facade_surface covers, in square metres. Hidden parts, which get
/// no points, are included. `obstacle` is an index. Throws std::out_of_range if it is too large.
double facade_area(const Obstacles& obstacles, std::size_t obstacle, FacadeSide side, std::optional<double> azimuth);
/// Returns points on the faces of an obstacle that belong to `side`. With an `azimuth` (radians, from north over east),
/// returns points on the walls that look less than 45° away from it instead. Faces below the ground (y = 0) or inside
/// another obstacle get no points. Each point stands for about `spacing` squared (metres, above 0). Returns no points
/// if there is no such face. Throws std::out_of_range if the index `obstacle` is too large.
ShadeSurface facade_surface(const Obstacles& obstacles, std::size_t obstacle, FacadeSide side,
                            std::optional<double> azimuth, double spacing);
/// Combines the points of several surfaces into one surface without a grid.
ShadeSurface joined(const std::vector<ShadeSurface>& surfaces);

/// A flat rectangle, such as a field of solar panels. Angles are in radians.
struct PanelField {
  Vec3 position{0};      ///< position of the middle of the surface, metres
  double width = 1;      ///< horizontal size, metres
  double length = 1;     ///< size along the slope, metres
  double tilt = 0;       ///< angle from the horizontal: 0 is flat, a quarter turn is upright
  double azimuth = kPi;  ///< direction in which the surface looks, from north over east
};

/// Returns a grid of points in the middles of equal cells, about `spacing` wide (metres, above 0). The grid has at
/// least one cell. Columns count from the left as seen from the front, and rows from the lower edge up.
ShadeSurface panel_surface(const PanelField& panels, double spacing);

/// Returns the ground between two opposite corners [x, z] at a height, looking up. Lengths are in metres, and `spacing`
/// must be above 0. The corners may have any order. Columns count to the east, rows from south to north. Cells have no
/// point if their middle is inside an obstacle.
ShadeSurface ground_surface(Vec2 from, Vec2 to, double height, const Obstacles& obstacles, double spacing);

/// The shade on a surface while the sun stands at one position.
struct ShadeMoment {
  double cosine = 0;                ///< mean cosine between the normals and the sun; 0 where a normal looks away
  double shade = 1;                 ///< share that the sun does not reach; parts that look away from the sun count as
                                    ///< shade
  double shade_without_plants = 1;  ///< share of shade if only the obstacles stand there
  double direct = 0;                ///< mean cosine over the points that the sun reaches and 0 elsewhere: direct light
                                    ///< relative to full light
};

/// The shade on a surface over all moments, and the share of moments in which each point lies in shade.
struct ShadeOfSurface {
  std::vector<ShadeMoment> moments;             ///< for each position of the sun
  std::vector<double> of_point;                 ///< for each point, over the positions above the horizon
  std::vector<double> of_point_without_plants;  ///< like `of_point`, if only the obstacles stand there
};

/// Maximum number of rays of one call: points times positions of the sun.
inline constexpr std::uint64_t kMaxShadeRays = 200'000'000;

/// Computes the shade on a surface. Rays go from every point to every position of the sun above the horizon. If the
/// altitude is not above 0, the whole surface is in shade. Without points, or without such a position, all shares of
/// shade are 1 and no stage begins. Obstacles and all visible parts of `plants` stop rays. The holes of masked textures
/// let rays pass, so these textures must be painted. `plants` must be the result of make_mesh_scene. Takes about a
/// microsecond per ray. Results are equal on any number of threads. Begins a stage of `progress`, which counts rays.
/// Throws Cancelled, MachineError (memory), and std::invalid_argument for more than kMaxShadeRays rays.
ShadeOfSurface measure_shade(const ShadeSurface& surface, const std::vector<SkyDirection>& sun, const MeshScene& plants,
                             const Obstacles& obstacles, Progress& progress);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Draws a word with a turtle: stems, polygons, and sites of other components.
//
//   F G  a segment             f g  a move without a segment          [ ]  a side branch
//   + -  left, right           & ^  down, up                          \ /  roll
//   |    turn around           $    roll until the left is level      ! #  thinner, thicker, or of this width
//   '    the next colour       { }  a polygon                         .    a corner of it, as at the end of F and f
//   ~    places the component that the next symbol names
//
// Each of the first eleven, ! # and ' may have a parameter: metres, degrees, a radius in metres, or a colour's number.
// `\` lowers the left side, as an aeroplane rolls to the left; `/` raises it. All other symbols are ignored.
//
// Based on: P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants (1990), chapters 1, 2 and 5, and its
// appendix on turtles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/word.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/directions.h"

namespace meristem {

/// How symbols are drawn. Lengths are in metres, angles in degrees, as in words.
struct TurtleParameters {
  /// How symbols of turns change the heading.
  enum class Reading {
    frame,  ///< each turn is about the turtle's own axes
    polar,  ///< & and ^ change an elevation, + and - an azimuth; rolls have no effect; starts level, along x
  };
  Reading reading = Reading::frame;  ///< frame or polar
  double angle = 22.5;               ///< turn without a parameter; in polar reading, change of the elevation
  double azimuth = 22.5;             ///< change of the azimuth without a parameter, in polar reading
  double length = 0.1;               ///< length of F, G, f and g without a parameter
  double width = 0.01;               ///< radius at the root
  double thinner = 0.7;              ///< radius factor of `!` without a parameter; `#` divides by it
  /// Radius at a segment's end relative to its begin, outside brackets. Applies to words without ! and #.
  double trunk_decay = 1;
  double branch_decay = 1;      ///< like trunk_decay, for segments inside brackets
  std::optional<Vec3> tropism;  ///< direction in which segments bend; unset: down at the end of each segment
  Directions directions;        ///< gravity for tropism and `$`; added light fields add to the tropism
  double elasticity = 0;        ///< after each segment, the heading turns by this times |heading x tropism|, radians
  bool stack_angles = true;     ///< true: a ] of the polar reading restores the angles, too; false: only the position
};

/// The corners of a filled shape, which may be non-planar.
struct TurtlePolygon {
  std::uint32_t first = 0;   ///< index of the first corner in WordDrawing::corners
  std::uint32_t count = 0;   ///< at least 3
  Frame frame;               ///< frame of the turtle at the begin of the polygon
  std::uint32_t colour = 0;  ///< number of the colour
  NodeIndex node = kNoNode;  ///< node at the begin of the polygon; kNoNode if nothing has been drawn there
  std::uint32_t module = 0;  ///< index in the word of the { that begins it
};

/// The place of a component, from a `~`.
struct TurtleSite {
  LetterIndex letter = kNoLetter;  ///< letter that names the component
  Frame frame;                     ///< heading along y, up along z; scaled by the letter's first parameter
  float radius = 0;                ///< radius of the stem at the site
  NodeIndex node = kNoNode;        ///< node that the site stands on; kNoNode if nothing has been drawn there
  std::uint32_t module = 0;        ///< index in the word of the letter that names the component
};

/// The result of drawing a word.
struct WordDrawing {
  /// Segments that no other segment precedes begin at a root. Births equal the births of the modules, or 0. The column
  /// "end" is 1 where a ] has ended a branch, also a branch without length.
  Skeleton skeleton;
  /// By node, the index in the word of the module that drew the segment to the node. For a root, the module of the
  /// first segment from it.
  std::vector<std::uint32_t> module_of_node;
  std::vector<Vec3> corners;            ///< corners of all polygons, metres
  std::vector<TurtlePolygon> polygons;  ///< in the order of their ends
  std::vector<TurtleSite> places;       ///< places of components, in the order of the word
};

/// Draws a word with letters of `alphabet` in the world. Starts at `start` with its heading and its z axis up; lengths
/// and widths are multiplied by its scale. Cost: linear in modules.
///
/// The segment that follows without a bracket continues the axis. If there is none, the widest child continues it, and
/// among equally wide ones the straightest. Segments without length make no node.
///
/// Throws InputError at `path` for unmatched braces, polygons with more than 2,000 corners, and a ~ without a name.
/// Throws it also for brackets nested deeper than a million, and for positions and radii beyond a million kilometres.
/// Throws InputError before making more nodes than the limit, or more instances (including polygons and sites). Throws
/// Cancelled.
WordDrawing draw(const Word& word, const Alphabet& alphabet, const TurtleParameters& parameters, const Frame& start,
                 const SizeLimits& limits, const std::string& path, Progress& progress);

}  // namespace meristem

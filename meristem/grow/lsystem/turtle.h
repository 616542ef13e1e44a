// SPDX-License-Identifier: Apache-2.0
// Walks along a word and draws it: stems, polygons, and sites of other components.
//
//   F G  a segment             f g  the same way without one       [ ]  a side branch
//   + -  left, right           & ^  down, up                       \ /  roll
//   |    about                 $    rolls until the left is level  ! #  thinner, thicker, or of this width
//   '    the next colour       { }  a polygon                      .    a corner of it, as at the end of F and f
//   ~    places the component that the next symbol names
//
// Each of the first eleven, ! # and ' may have a parameter: metres, degrees, a radius in metres, a colour's number.
// `\` lets the left side sink, as an aeroplane rolls to the left; `/` lets it rise. All other symbols mean nothing
// here.
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

/// How symbols are drawn. Lengths in metres, angles in degrees, as words write them.
struct TurtleParameters {
  enum class Reading {
    frame,  ///< each turn is about the turtle's own axes
    polar,  ///< & and ^ change an elevation, + and - an azimuth; rolls mean nothing. Begins level, along x
  };
  Reading reading = Reading::frame;
  double angle = 22.5;    ///< turn without a parameter; in polar reading, turn of the elevation
  double azimuth = 22.5;  ///< turn of the azimuth without a parameter, in polar reading
  double length = 0.1;    ///< length of F, G, f and g without a parameter
  double width = 0.01;    ///< radius at the root
  double thinner = 0.7;   ///< factor of `!` without a parameter on the radius; `#` divides by it
  double trunk_decay =
      1;  ///< radius at a segment's end over its beginning, outside all brackets, where words have no ! and #
  double branch_decay = 1;      ///< radius at a segment's end over its beginning, within brackets
  std::optional<Vec3> tropism;  ///< what segments bend toward; unset: down, as it is where they end
  Directions directions;        ///< which way is down, for tropism and for $; given light adds to the tropism
  double elasticity = 0;        ///< after each segment it turns by this times |heading x tropism|, radians
  bool stack_angles = true;     ///< a ] of the polar reading brings the angles back, and not the position alone
};

/// The corners of a filled shape, which need not lie in a plane.
struct TurtlePolygon {
  std::uint32_t first = 0;  ///< index of the first corner in Drawing::corners
  std::uint32_t count = 0;  ///< at least 3
  Frame frame;              ///< frame of the turtle where the polygon begins
  std::uint32_t colour = 0;
  NodeIndex node = kNoNode;  ///< node that the polygon begins on; kNoNode where nothing has been drawn there
  std::uint32_t module = 0;  ///< index in the word of the { that begins it
};

/// Where a `~` places a component.
struct TurtleSite {
  LetterIndex letter = kNoLetter;  ///< letter that names the component
  Frame frame;                     ///< heading along y, up along z; scaled by the letter's first parameter
  float radius = 0;                ///< radius of the stem at the site
  NodeIndex node = kNoNode;        ///< node that the site stands on; kNoNode where nothing has been drawn there
  std::uint32_t module = 0;        ///< index in the word of the letter that names the component
};

struct Drawing {
  Skeleton skeleton;  ///< a root where segments begin without another before them; births are those of the modules, or
                      ///< 0; its column "end" is 1 where a ] has ended a branch, if one of no length
  std::vector<std::uint32_t> module_of_node;  ///< index in the word of the module that drew the segment to each node,
                                              ///< or the first segment from a root
  std::vector<Vec3> corners;
  std::vector<TurtlePolygon> polygons;  ///< by their ends
  std::vector<TurtleSite> places;
};

/// Draws a word of `alphabet`'s letters in the world, beginning at `start` along its heading, its z up; lengths and
/// widths grow with its scale. Cost linear in modules.
///
/// On a segment's axis goes the next one that no bracket parts from it; where there is none, the widest, and of those
/// the straightest. Segments without a length make no node.
///
/// Throws InputError at `path` for braces without their like, polygons of more than 2,000 corners, a ~ without a name,
/// brackets nested deeper than a million, positions and radii beyond a million kilometres, and beyond the limits of
/// nodes and, with polygons and sites, of instances, before they are made; Cancelled.
Drawing draw(const Word& word, const Alphabet& alphabet, const TurtleParameters& parameters, const Frame& start,
             const Limits& limits, const std::string& path, Progress& progress);

}  // namespace meristem

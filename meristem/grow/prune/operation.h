// SPDX-License-Identifier: Apache-2.0
// What people do to self-organizing trees as they grow: cuts, supports and rules that hold over the years. An operation
// says when it acts, on which shoots, and what it does there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/base/vec.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// The last iteration that an operation may name.
inline constexpr int kLastIteration = 65535;

/// What the condition of a schedule may name, all of one tree: `iteration`, `height`, `width` (metres), `metamers`,
/// `laterals` (shoots on the leader), `leader_length` (metres).
const std::vector<std::string>& tree_variables();

/// What a condition over shoots may name; the numbers are those of choose_shoots(). Lengths in metres, angles in
/// degrees.
const std::vector<std::string>& shoot_variables();

/// As many different marks an operation list may have.
inline constexpr std::size_t kMostMarks = 32;

/// When an operation acts: after all growth of these iterations, or in summer after a share of it.
struct Schedule {
  int from = 1;   ///< iteration, from 1
  int every = 1;  ///< iterations from one time to the next
  int to = kLastIteration;
  std::optional<Expression> when;  ///< over tree_variables(): it acts only where that holds
  bool once = false;               ///< on each tree no more than once
  bool in_summer = false;          ///< the rest of the iteration's growth follows it

  static Schedule at(int iteration) { return {iteration, 1, iteration, std::nullopt}; }
  bool is_in_turn(int iteration) const {
    return iteration >= from && iteration <= to && (iteration - from) % every == 0;
  }
};

/// Which shoots an operation is for.
struct ShootChoice {
  enum class Kind {
    label,      ///< the shoot of this name; it is a fault where that is not there
    leader,     ///< the shoot that leads, from the ground on
    condition,  ///< all shoots for which it holds; none is no fault
  };
  Kind kind = Kind::leader;
  std::string text;            ///< as the document wrote it
  Expression condition;        ///< over shoot_variables() and, after them, the marks of the operation list
  std::string key = "shoots";  ///< of the operation in the document, for errors

  static ShootChoice label(std::string name) { return {Kind::label, std::move(name), {}, "shoots"}; }
  static ShootChoice leader() { return {Kind::leader, "leader", {}, "shoots"}; }
};

/// A cut, always just above a living bud or a lateral shoot: where there is none it moves down to the next.
struct Cut {
  enum class Place {
    above,          ///< a number of metamers stays: Cut::above
    above_lateral,  ///< just above a lateral shoot
    to_bud,         ///< just above a sleeping bud that faces one way
    outside,        ///< at the surface of a body
  };
  enum class Toward { down, up, out, direction };
  Place place = Place::above;
  int above = 0;                 ///< metamers that stay; 0: the shoot goes whole
  Expression lateral;            ///< which lateral shoot from the base, from 1; may be drawn by chance
  Toward toward = Toward::down;  ///< where the bud faces
  Vec3 direction{0, 1, 0};       ///< where the bud faces with Toward::direction
  int window = 0;                ///< metamers to both sides of the youngest stretch's middle to choose from
  CrownPointer outside;          ///< relative to the root
  bool has_successor = true;     ///< false: no shoot takes the lead of the shoots that are cut
};

/// Shortens shoots to a number of metamers, without branches.
struct Spur {
  int metamers = 2;
};

/// Shoots grow no longer than this.
struct Limit {
  int metamers = 12;
};

/// The rule of the espalier, layer by layer along the leader: the first shoots off, then one arm to each side, then the
/// leader cut to a bud that leads on.
struct Layers {
  int count = 3;
  int metamers = 6;       ///< metamers of the leader in each layer; the last is cut, the two below it bear the arms
  Vec3 right{1, 0, 0};    ///< unit vector, level: where the right arms go
  double angle = 0;       ///< inclination of the lowest arms above level, radians
  double angle_last = 0;  ///< inclination of the topmost arms above level, radians
  double weight = 6;      ///< weight of the arms' wires, as Support::weight
};

/// A pole, rod or wire that shoots are tied to.
struct Support {
  std::vector<Vec3> line;  ///< metres from the root; shoots follow it from its first point on, and beyond its last
  std::string named;       ///< name of a support of the scene, instead of a line
  double weight = 6;  ///< weight of the line's direction beside the weights of growth; raised, shoots are straighter
  int until = kLastIteration;  ///< the last iteration that shoots are tied to it
};

/// Gives shoots a mark that other operations can ask for.
struct Mark {
  double chance = 1;        ///< 0 to 1, of each shoot
  std::uint32_t state = 0;  ///< number of the mark in the operation list, below kMostMarks
};

/// A ring of bark taken off: what leaves above it make stays above it.
struct Girdle {
  int below = 0;       ///< metamers of the shoot below the ring
  double share = 1;    ///< 0 to 1, of what leaves above make that does not pass the ring
  int iterations = 1;  ///< after which it has healed
};

/// Shoots are bent, a little more in each iteration, and then held: they no longer sag.
struct Bend {
  int below = 0;           ///< metamers of the shoot below the bend
  int metamers = 3;        ///< that the bend goes over; raised, wider
  double inclination = 0;  ///< inclination above level of what lies beyond the bend, radians
  int iterations = 1;      ///< that the bending takes
};

/// Shoots are drawn by a string to another shoot or to the ground, a little more in each iteration, and then held.
struct Tie {
  std::optional<int> below;       ///< metamers of the shoot below the string; unset: all, it is tied at its tip
  std::optional<ShootChoice> to;  ///< the shoot that they are tied to, where that is nearest; unset: the ground
  double length = 0;              ///< metres of the string; raised, shoots are drawn less far
  int iterations = 1;             ///< that the drawing takes
};

struct Operation {
  Schedule when;
  ShootChoice shoots;
  std::optional<int> tree;  ///< the number of the one root that it is for, from 0; else all
  std::string path;         ///< in the document, for errors: "components.apple.operations[3]"
  int number = 0;           ///< in the component's list, from 1; by it a plan's skeleton tells what it would cut
  std::variant<Cut, Spur, Limit, Layers, Support, Mark, Girdle, Bend, Tie> what;
};

}  // namespace meristem

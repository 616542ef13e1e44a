// SPDX-License-Identifier: Apache-2.0
// Operations of people on self-organizing trees during growth: cuts, supports, and rules that apply over years. An
// operation defines when it acts, on which shoots, and what it does.
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

/// The largest iteration that an operation may name.
inline constexpr int kLastIteration = 65535;

/// Returns the variables for the condition of a schedule, all of one tree: `iteration`, `height`, `width` (metres),
/// `metamers`, `laterals` (shoots on the leader), `leader_length` (metres).
const std::vector<std::string>& tree_variables();

/// Returns the variables for a condition over shoots, in the order that choose_shoots() uses. Lengths are in metres,
/// angles in degrees.
const std::vector<std::string>& shoot_variables();

/// The largest number of different marks in an operation list.
inline constexpr std::size_t kMaxMarks = 32;

/// When an operation acts: after all growth of these iterations, or in summer after a part of it.
struct OperationSchedule {
  int from = 1;                    ///< first iteration, from 1
  int every = 1;                   ///< iterations between two times
  int to = kLastIteration;         ///< last iteration
  std::optional<Expression> when;  ///< condition over tree_variables(); unset: always true
  bool once = false;               ///< true: acts at most once on each tree
  bool in_summer = false;          ///< true: the rest of the iteration's growth comes after it

  /// A schedule of one iteration.
  static OperationSchedule at(int iteration) { return {iteration, 1, iteration, std::nullopt}; }
  /// Returns true if the operation acts in this iteration, apart from `when` and `once`.
  bool is_in_turn(int iteration) const {
    return iteration >= from && iteration <= to && (iteration - from) % every == 0;
  }
};

/// The shoots of an operation.
struct ShootChoice {
  /// How the shoots are chosen.
  enum class Kind {
    label,      ///< the shoot with this name; an error if it does not exist
    leader,     ///< the shoot that leads, from the ground up
    condition,  ///< all shoots for which the condition holds; an empty set is no error
  };
  Kind kind = Kind::leader;    ///< label, leader or condition
  std::string text;            ///< as written in the document
  Expression condition;        ///< over shoot_variables(), followed by the marks of the operation list
  std::string key = "shoots";  ///< key in the operation's document object, for errors

  /// The shoot with this name.
  static ShootChoice label(std::string name) { return {Kind::label, std::move(name), {}, "shoots"}; }
  /// The shoot that leads.
  static ShootChoice leader() { return {Kind::leader, "leader", {}, "shoots"}; }
};

/// A cut just above a living bud or a lateral shoot. If the position has no such bud or shoot, the cut moves down to
/// the next one.
struct CutOperation {
  /// Where a shoot is cut.
  enum class Place {
    above,          ///< keeps a number of metamers: CutOperation::above
    above_lateral,  ///< just above a lateral shoot
    to_bud,         ///< just above a dormant bud that faces one direction
    outside,        ///< at the surface of a body
  };
  /// Which of the buds is preferred, by its direction.
  enum class Toward { down, up, out, direction };
  Place place = Place::above;    ///< the rule for the place
  int above = 0;                 ///< number of metamers that stay; 0: removes the whole shoot
  Expression lateral;            ///< number of the lateral shoot from the base, from 1; may be random
  Toward toward = Toward::down;  ///< desired direction of the bud
  Vec3 direction{0, 1, 0};       ///< desired direction for Toward::direction
  int window = 0;                ///< metamers on both sides of the youngest section's middle to choose from
  CrownPointer outside;          ///< relative to the root
  bool has_successor = true;     ///< false: no other shoot succeeds a cut shoot
  double stub = 0;               ///< length of the dead stub that stays above the bud, in metamers, 0 to 1
};

/// Shortens shoots to a number of metamers and removes their branches.
struct SpurOperation {
  int metamers = 2;  ///< metamers that stay
};

/// Limits the length of shoots, counted with the lateral shoot that continues a shoot after the cut.
struct LimitOperation {
  int metamers = 12;  ///< largest number of metamers
};

/// The rule of the espalier, layer by layer along the leader. First all shoots are removed, then one arm grows on each
/// side, then the leader is cut to a bud that continues it.
struct LayersOperation {
  int count = 3;          ///< number of layers
  int metamers = 6;       ///< metamers of the leader in each layer; the last is cut, and the two below it bear the arms
  Vec3 right{1, 0, 0};    ///< horizontal unit vector: direction of the right arms
  double angle = 0;       ///< inclination of the lowest arms above the horizontal, radians
  double angle_last = 0;  ///< inclination of the topmost arms above the horizontal, radians
  double weight = 6;      ///< weight of the arms' wires, like TrainingSupport::weight
};

/// A pole, rod or wire that shoots are tied to.
struct TrainingSupport {
  std::vector<Vec3> line;  ///< metres from the root; shoots follow it from its first point on and beyond its last point
  std::string named;       ///< name of a support of the scene, instead of a line
  double weight = 6;       ///< weight of the line's direction among the weights of growth; larger: straighter shoots
  int until = kLastIteration;  ///< last iteration in which shoots are tied to it
};

/// Gives shoots a mark that other operations can test.
struct MarkOperation {
  double chance = 1;        ///< 0 to 1, for each shoot
  std::uint32_t state = 0;  ///< number of the mark in the operation list, below kMaxMarks
};

/// Removes a ring of bark: resource made above it stays above it.
struct GirdleOperation {
  int below = 0;       ///< metamers of the shoot below the ring
  double share = 1;    ///< 0 to 1: share of the resource made above that does not pass the ring
  int iterations = 1;  ///< iterations until it has healed
};

/// Bends shoots gradually over several iterations and then holds them, so that they no longer sag.
struct BendOperation {
  int below = 0;           ///< metamers of the shoot below the bend
  int metamers = 3;        ///< metamers in the bend; larger: wider
  double inclination = 0;  ///< inclination above the horizontal of the part beyond the bend, radians
  int iterations = 1;      ///< duration of the bending
};

/// Draws shoots by a string to another shoot or to the ground, gradually over several iterations, and then holds them.
struct TieOperation {
  std::optional<int> below;       ///< metamers of the shoot below the string; unset: it is tied at its tip
  std::optional<ShootChoice> to;  ///< the shoot that they are tied to, at its nearest point; unset: the ground
  double length = 0;              ///< length of the string, metres; larger: shoots are drawn less far
  int iterations = 1;             ///< duration of the drawing
};

/// An operation with its schedule, its shoots and its trees.
struct TreeOperation {
  OperationSchedule when;   ///< the iterations in which it acts
  ShootChoice shoots;       ///< the shoots that it acts on
  std::optional<int> tree;  ///< number of the one root that it applies to, from 0; unset: all roots
  std::string path;         ///< document path for errors: "components.apple.operations[3]"
  int number = 0;           ///< number in the component's list, from 1; the column `plan_cut` refers to it
  /// The act of the operation, with its parameters.
  std::variant<CutOperation, SpurOperation, LimitOperation, LayersOperation, TrainingSupport, MarkOperation,
               GirdleOperation, BendOperation, TieOperation>
      what;
};

}  // namespace meristem

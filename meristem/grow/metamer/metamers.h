// SPDX-License-Identifier: Apache-2.0
// The building blocks of a self-organizing tree: metamers. A metamer is an internode with a terminal and a lateral bud
// at its tip. The chain of terminal buds is an axis. An axis with everything that it bears is a shoot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

using MetamerIndex = std::uint32_t;  ///< index of a metamer in its tree

/// A bud, or the metamer that it has grown into.
class Bud {
 public:
  /// The fate of a bud.
  enum class State : std::uint8_t {
    open,     ///< may grow, but may also be dormant
    grown,    ///< has become a metamer
    damaged,  ///< its metamer was cut
    dead,     ///< its metamer was shed, or the bud never existed
  };

  constexpr Bud() = default;
  /// A bud that has become this metamer.
  static constexpr Bud grown(MetamerIndex metamer) { return Bud(metamer); }
  /// A bud whose metamer was cut.
  static constexpr Bud damaged() { return Bud(kOpen - 1); }
  /// A bud whose metamer was shed, or that never existed.
  static constexpr Bud dead() { return Bud(kOpen - 2); }

  /// Returns the bud's state.
  constexpr State state() const {
    if (bits_ < kOpen - 2) return State::grown;
    return bits_ == kOpen ? State::open : (bits_ == kOpen - 1 ? State::damaged : State::dead);
  }
  constexpr bool is_grown() const { return bits_ < kOpen - 2; }     ///< true if it has become a metamer
  constexpr bool is_open() const { return bits_ == kOpen; }         ///< true if it may grow
  constexpr bool is_damaged() const { return bits_ == kOpen - 1; }  ///< true if its metamer was cut
  constexpr MetamerIndex metamer() const { return bits_; }          ///< the metamer that a grown bud has become

 private:
  static constexpr std::uint32_t kOpen = 0xffffffffU;
  explicit constexpr Bud(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = kOpen;
};

/// The states of the buds that had grown into removed metamers.
struct BudsLeft {
  Bud terminal;  ///< state of terminal buds
  Bud lateral;   ///< state of lateral buds

  /// One state for both kinds of buds, or a state for each.
  BudsLeft(Bud both) : terminal(both), lateral(both) {}  // NOLINT(google-explicit-constructor): usually both are equal
  BudsLeft(Bud of_terminal, Bud of_lateral) : terminal(of_terminal), lateral(of_lateral) {}
};

/// Keeps the elements of a column whose mark is 0.
template <class T>
void erase_marked(std::vector<T>& column, const std::vector<std::uint8_t>& marks) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (marks[k] == 0) column[kept++] = column[k];
  }
  column.resize(kept);
}

/// The metamers of one tree as a structure of arrays. Metamer 0 is the seed: a position without length and without a
/// lateral bud. A metamer has a larger index than the metamer that bears it, so loops run from seed to tips and back.
///
/// Metamers are numbered on their axis, from 1 at the base. Shoots are named by the numbers of the metamers where they
/// branch off: `main`, `main.4`, `main.4.2`. Numbers and names never change. They are never reused unless a removal
/// leaves an open bud.
struct Metamers {
  std::vector<MetamerIndex> parent;   ///< kNoNode for the seed
  std::vector<Bud> terminal;          ///< terminal bud of each metamer
  std::vector<Bud> lateral;           ///< lateral bud of each metamer
  std::vector<Vec3> tip;              ///< metres from the root
  std::vector<Vec3> side;             ///< unit vector from the axis to the lateral bud
  std::vector<AxisIndex> axis;        ///< axes are numbered from 0 in the order of their first metamers
  std::vector<std::uint32_t> number;  ///< number on its axis, from 1; 0 for the seed
  std::vector<std::uint16_t> order;   ///< branching order: 0 on the stem
  std::vector<std::uint16_t> birth;   ///< iteration
  std::vector<float> lost_tips;       ///< number of tips beyond it that were shed or cut

  /// A chain of metamers that terminal buds have grown.
  struct Axis {
    RandomKey key;             ///< derived from the shoot's name
    MetamerIndex first = 0;    ///< metamer at its base
    MetamerIndex last = 0;     ///< metamer at its end
    std::uint32_t tie = 0;     ///< number of the line that the shoot is tied to, from 1; 0: not tied
    bool has_no_heir = false;  ///< true: no other shoot takes over if its terminal bud is damaged
    std::uint32_t marks = 0;   ///< one bit for each mark of the shoot
    bool is_loose = false;     ///< true: it was cut off and will be removed by clear_away()
  };
  std::vector<Axis> axes;  ///< axes by number

  /// A tree that consists of the seed at the root. `heading` is a unit vector.
  Metamers(Vec3 heading, Vec3 side, RandomKey key);

  std::size_t count() const { return parent.size(); }  ///< number of metamers, the seed included
  void reserve(std::size_t metamers);                  ///< reserves memory for this number of metamers in all columns
  /// Grows the open terminal or lateral bud of a metamer. Returns the index of the new metamer. The caller must set
  /// side and tip.
  MetamerIndex grow(MetamerIndex from, bool is_lateral, int iteration);

  /// Returns the unit vector from a metamer's base to its tip; for the seed, its first growth direction.
  Vec3 heading(MetamerIndex metamer) const;
  float length(MetamerIndex metamer) const;  ///< from base to tip, metres
  /// Returns the unit vector in which a metamer's terminal or lateral bud points. The angle between axis and lateral
  /// buds is `branching_angle`.
  Vec3 bud_heading(MetamerIndex metamer, bool is_lateral, double branching_angle) const;
  /// Returns true if a bud competes for light: an open bud, or a damaged bud at the end of its axis.
  bool competes(MetamerIndex metamer, bool is_lateral) const {
    const Bud bud = (is_lateral ? lateral : terminal)[metamer];
    return bud.is_open() || (!is_lateral && bud.is_damaged());
  }
  /// Returns the key of the shoot to which the next metamer of this bud will belong.
  RandomKey key_of_shoot(MetamerIndex from, bool is_lateral) const;
  /// Returns true if the metamer is the first of a lateral axis. The metamer must not be cut off.
  bool begins_shoot(MetamerIndex metamer) const { return metamer != 0 && axis[metamer] != axis[parent[metamer]]; }

  /// Returns the axis of a shoot by name, or nothing if it does not exist.
  std::optional<AxisIndex> find_shoot(std::string_view name) const;
  /// Returns the metamer with that number on an axis, or nothing if it does not exist.
  std::optional<MetamerIndex> find(AxisIndex on, std::uint32_t wanted) const;
  std::string name_of(AxisIndex of) const;  ///< returns the name of a shoot, such as `main.4`
  /// Returns the names of the shoots on an axis, from its base.
  std::vector<std::string> shoots_on(AxisIndex on) const;
  /// Returns a metamer and everything that it bears, nearest first. Cost: proportional to the result.
  std::vector<MetamerIndex> with_borne(MetamerIndex first) const;

  /// Cuts off a metamer with everything that it bears. It must not be the seed. The buds that had grown get the states
  /// `after`, and the parent metamer counts the lost tips. Until clear_away(), removed metamers keep their places in
  /// all columns, no bud leads to them, and nothing may grow. The parent of `first` is kNoNode until then, so do not
  /// call heading(), length() or begins_shoot() with it. Cost: proportional to what is cut off; the first call also
  /// costs the size of the tree.
  void cut_off(MetamerIndex first, const BudsLeft& after);
  /// Returns true if a metamer was cut off and has not been cleared away.
  bool is_loose(MetamerIndex metamer) const { return metamer < loose_.size() && loose_[metamer] != 0; }
  /// Removes all metamers that were cut off. Returns marks that are not 0 for removed metamers, or an empty list if
  /// nothing was removed. Indices change, but the order stays.
  std::vector<std::uint8_t> clear_away();
  /// Removes the metamers whose entry in `gone`, one per metamer, is not 0, by cut_off() and clear_away(). Afterwards
  /// `gone` marks all removed metamers.
  void remove(std::vector<std::uint8_t>& gone, const BudsLeft& after);

 private:
  Vec3 seed_heading_;
  std::vector<std::uint8_t> loose_;  // marks of metamers that were cut off; empty if there are no such metamers
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// What a self-organizing tree is made of: metamers, each an internode with a terminal and a lateral bud at its tip. The
// chain of terminal buds is an axis; an axis with all that it bears is a shoot.
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

using MetamerIndex = std::uint32_t;

/// A bud, or the metamer that it has grown.
class Bud {
 public:
  enum class State : std::uint8_t {
    open,     ///< may grow, be it dormant
    grown,    ///< has become a metamer
    damaged,  ///< what it had grown was cut
    dead,     ///< what it had grown was shed, or it never was
  };

  constexpr Bud() = default;
  static constexpr Bud grown(MetamerIndex metamer) { return Bud(metamer); }
  static constexpr Bud damaged() { return Bud(kOpen - 1); }
  static constexpr Bud dead() { return Bud(kOpen - 2); }

  constexpr State state() const {
    if (bits_ < kOpen - 2) return State::grown;
    return bits_ == kOpen ? State::open : (bits_ == kOpen - 1 ? State::damaged : State::dead);
  }
  constexpr bool is_grown() const { return bits_ < kOpen - 2; }
  constexpr bool is_open() const { return bits_ == kOpen; }
  constexpr bool is_damaged() const { return bits_ == kOpen - 1; }
  constexpr MetamerIndex metamer() const { return bits_; }  ///< the metamer that a grown bud has become

 private:
  static constexpr std::uint32_t kOpen = 0xffffffffU;
  explicit constexpr Bud(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = kOpen;
};

/// What becomes of the buds that had grown what is taken away.
struct BudsLeft {
  Bud terminal;
  Bud lateral;

  BudsLeft(Bud both) : terminal(both), lateral(both) {}  // NOLINT(google-explicit-constructor): mostly equal
  BudsLeft(Bud of_terminal, Bud of_lateral) : terminal(of_terminal), lateral(of_lateral) {}
};

/// Keeps those elements of a column by metamer whose mark is 0.
template <class T>
void erase_marked(std::vector<T>& column, const std::vector<std::uint8_t>& marks) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (marks[k] == 0) column[kept++] = column[k];
  }
  column.resize(kept);
}

/// The metamers of one tree, structure of arrays. Metamer 0 is the seed: a position without length and without a
/// lateral bud. What a metamer bears has a larger index, so that loops run from seed to tips and back.
///
/// A metamer has a number on its axis, from 1 at the base. Shoots are named by the numbers of the metamers where they
/// branch off: `main`, `main.4`, `main.4.2`. Numbers and names never change, and are never used again unless an open
/// bud is left where something was removed.
struct Metamers {
  std::vector<MetamerIndex> parent;  ///< kNoNode for the seed
  std::vector<Bud> terminal;
  std::vector<Bud> lateral;
  std::vector<Vec3> tip;        ///< metres from the root
  std::vector<Vec3> side;       ///< unit vector from the axis to the lateral bud
  std::vector<AxisIndex> axis;  ///< rising from 0 in the order of the axes' first metamers
  std::vector<std::uint32_t> number;
  std::vector<std::uint16_t> order;
  std::vector<std::uint16_t> birth;  ///< iteration
  std::vector<float> lost_tips;      ///< tips beyond it that were shed or cut

  struct Axis {
    RandomKey key;  ///< made of the shoot's name
    MetamerIndex first = 0;
    MetamerIndex last = 0;
    std::uint32_t tie = 0;     ///< number of the line that the shoot is tied to, from 1; 0: none
    bool has_no_heir = false;  ///< no other shoot succeeds it where its terminal bud is damaged
    std::uint32_t marks = 0;   ///< a bit for each mark that it bears
    bool is_loose = false;     ///< it was cut off and is yet to be cleared away
  };
  std::vector<Axis> axes;

  /// The seed alone, at the root. `heading` is a unit vector.
  Metamers(Vec3 heading, Vec3 side, RandomKey key);

  std::size_t count() const { return parent.size(); }
  void reserve(std::size_t metamers);
  /// Grows the terminal or lateral bud of a metamer, which is open. Side and tip are yet to be set.
  MetamerIndex grow(MetamerIndex from, bool is_lateral, int iteration);

  /// Unit vector from a metamer's base to its tip; for the seed, the direction in which it will grow.
  Vec3 heading(MetamerIndex metamer) const;
  float length(MetamerIndex metamer) const;
  /// Unit vector in which a metamer's terminal or lateral bud points; lateral ones stand off by `branching_angle`.
  Vec3 bud_heading(MetamerIndex metamer, bool is_lateral, double branching_angle) const;
  /// Whether a bud has a claim by its light: an open one, or a damaged one at the end of its axis.
  bool competes(MetamerIndex metamer, bool is_lateral) const {
    const Bud bud = (is_lateral ? lateral : terminal)[metamer];
    return bud.is_open() || (!is_lateral && bud.is_damaged());
  }
  /// The key of the shoot on which the next metamer from here will stand.
  RandomKey key_of_shoot(MetamerIndex from, bool is_lateral) const;
  /// Whether the metamer is the first of a lateral axis.
  bool begins_shoot(MetamerIndex metamer) const { return metamer != 0 && axis[metamer] != axis[parent[metamer]]; }

  /// The axis of a shoot by name; nothing where there is none.
  std::optional<AxisIndex> find_shoot(std::string_view name) const;
  /// The metamer of that number on an axis, if it is there.
  std::optional<MetamerIndex> find(AxisIndex on, std::uint32_t wanted) const;
  std::string name_of(AxisIndex of) const;
  /// The names of the shoots on an axis, from its base on.
  std::vector<std::string> shoots_on(AxisIndex on) const;
  /// A metamer and all that it bears, nearer ones first. Cost goes with what it bears.
  std::vector<MetamerIndex> with_borne(MetamerIndex first) const;

  /// Cuts a metamer, which is not the seed, off with all that it bears. The bud that had grown it becomes what `after`
  /// says, and the metamer that bore it is told how many tips it has lost. What was cut off keeps its place in all
  /// columns until clear_away(), but no bud leads there; nothing may grow until then. Cost goes with what is cut off,
  /// the first time also with the tree.
  void cut_off(MetamerIndex first, const BudsLeft& after);
  /// Whether a metamer was cut off and is yet to be cleared away.
  bool is_loose(MetamerIndex metamer) const { return metamer < loose_.size() && loose_[metamer] != 0; }
  /// Takes away all that was cut off. Returns marks that are not 0 for what is no more, or nothing where all stays.
  /// Indices change; order stays.
  std::vector<std::uint8_t> clear_away();
  /// Takes away the metamers whose entry in `gone`, one per metamer, is not 0, as cut_off() and clear_away() do.
  /// `gone` then marks all that are no more.
  void remove(std::vector<std::uint8_t>& gone, const BudsLeft& after);

 private:
  Vec3 seed_heading_;
  std::vector<std::uint8_t> loose_;  // marks of what was cut off; empty: nothing
};

}  // namespace meristem

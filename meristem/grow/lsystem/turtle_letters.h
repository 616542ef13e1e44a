// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "meristem/grow/lsystem/word.h"

namespace meristem {

enum class TurtleAction : std::uint8_t {
  none,
  draw,
  move,
  yaw,
  pitch,
  roll,
  about,
  level,
  width,
  colour,
  push,
  pop,
  begin_polygon,
  end_polygon,
  corner,
  place,
};

/// The meaning of a letter for the turtle, computed once per letter. Caches the sine and cosine of its last angle.
struct LetterMeaning {
  TurtleAction action = TurtleAction::none;
  bool records = false;  ///< true if its end position is a corner of an open polygon
  std::uint16_t arity = 0;
  double sign = 1;
  double angle = std::numeric_limits<double>::quiet_NaN();  ///< degrees
  double sine = 0;                                          ///< of sign times angle
  double cosine = 1;
};

LetterMeaning meaning_of(const Letter& letter);

}  // namespace meristem

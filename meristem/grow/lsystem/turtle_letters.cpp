// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/turtle_letters.h"

#include <algorithm>
#include <array>

namespace meristem {

namespace {

struct Entry {
  char symbol;
  TurtleAction action;
  double sign = 1;
  bool records = false;
};

constexpr std::array kEntries{
    Entry{'F', TurtleAction::draw, 1, true}, Entry{'G', TurtleAction::draw},
    Entry{'f', TurtleAction::move, 1, true}, Entry{'g', TurtleAction::move},
    Entry{'+', TurtleAction::yaw},           Entry{'-', TurtleAction::yaw, -1},
    Entry{'&', TurtleAction::pitch},         Entry{'^', TurtleAction::pitch, -1},
    Entry{'\\', TurtleAction::roll, -1},     Entry{'/', TurtleAction::roll},
    Entry{'|', TurtleAction::about},         Entry{'$', TurtleAction::level},
    Entry{'!', TurtleAction::width},         Entry{'#', TurtleAction::width, -1},
    Entry{'\'', TurtleAction::colour},       Entry{'[', TurtleAction::push},
    Entry{']', TurtleAction::pop},           Entry{'{', TurtleAction::begin_polygon},
    Entry{'}', TurtleAction::end_polygon},   Entry{'.', TurtleAction::corner},
    Entry{'~', TurtleAction::place},
};

}  // namespace

LetterMeaning meaning_of(const Letter& letter) {
  LetterMeaning meaning{.arity = letter.arity};
  if (letter.symbol.size() != 1) return meaning;
  const auto* const entry = std::ranges::find(kEntries, letter.symbol[0], &Entry::symbol);
  if (entry == kEntries.end()) return meaning;
  meaning.action = entry->action;
  meaning.sign = entry->sign;
  meaning.records = entry->records;
  return meaning;
}

}  // namespace meristem

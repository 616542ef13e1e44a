// SPDX-License-Identifier: Apache-2.0
// Grows and removes metamers in columns. Removal marks metamers first; clear_away() then compacts all columns at once.
#include "meristem/grow/metamer/metamers.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr std::string_view kMain = "main";

}  // namespace

Metamers::Metamers(Vec3 heading, Vec3 side_of_seed, RandomKey key) : seed_heading_(heading) {
  parent.push_back(kNoNode);
  terminal.emplace_back();
  lateral.push_back(Bud::dead());
  tip.emplace_back(0.0F);
  side.push_back(side_of_seed);
  axis.push_back(0);
  number.push_back(0);
  order.push_back(0);
  birth.push_back(0);
  lost_tips.push_back(0);
  axes.push_back({key, 0, 0});
}

void Metamers::reserve(std::size_t metamers) {
  if (metamers <= parent.capacity()) return;
  // Reserve a quarter more than requested, so that growth stays linear and little memory is wasted.
  metamers += metamers / 4;
  parent.reserve(metamers);
  terminal.reserve(metamers);
  lateral.reserve(metamers);
  tip.reserve(metamers);
  side.reserve(metamers);
  axis.reserve(metamers);
  number.reserve(metamers);
  order.reserve(metamers);
  birth.reserve(metamers);
  lost_tips.reserve(metamers);
}

MetamerIndex Metamers::grow(MetamerIndex from, bool is_lateral, int iteration) {
  const auto made = static_cast<MetamerIndex>(count());
  AxisIndex own = axis[from];
  if (is_lateral) {
    own = static_cast<AxisIndex>(axes.size());
    axes.push_back({key_of_shoot(from, true), made, made});
  } else {
    axes[own].last = made;
  }
  parent.push_back(from);
  terminal.emplace_back();
  lateral.emplace_back();
  tip.push_back(tip[from]);
  side.push_back(side[from]);
  axis.push_back(own);
  number.push_back(is_lateral ? 1 : number[from] + 1);
  order.push_back(static_cast<std::uint16_t>(order[from] + (is_lateral ? 1 : 0)));
  birth.push_back(static_cast<std::uint16_t>(iteration));
  lost_tips.push_back(0);
  (is_lateral ? lateral : terminal)[from] = Bud::grown(made);
  return made;
}

Vec3 Metamers::heading(MetamerIndex metamer) const {
  if (metamer == 0) return seed_heading_;
  return normalized_or(tip[metamer] - tip[parent[metamer]], seed_heading_);
}

float Metamers::length(MetamerIndex metamer) const {
  return metamer == 0 ? 0 : glm::distance(tip[metamer], tip[parent[metamer]]);
}

Vec3 Metamers::bud_heading(MetamerIndex metamer, bool is_lateral, double branching_angle) const {
  const Vec3 along = heading(metamer);
  if (!is_lateral) return along;
  // Far from the root, rounding errors make headings not quite perpendicular to their sides, so normalise.
  return normalized_or(static_cast<float>(math::cos(branching_angle)) * along +
                           static_cast<float>(math::sin(branching_angle)) * side[metamer],
                       along);
}

RandomKey Metamers::key_of_shoot(MetamerIndex from, bool is_lateral) const {
  const RandomKey own = axes[axis[from]].key;
  return is_lateral ? own.child(number[from]) : own;
}

std::optional<MetamerIndex> Metamers::find(AxisIndex on, std::uint32_t wanted) const {
  MetamerIndex metamer = axes[on].first;
  while (number[metamer] < wanted && terminal[metamer].is_grown()) metamer = terminal[metamer].metamer();
  return number[metamer] == wanted ? std::optional(metamer) : std::nullopt;
}

std::optional<AxisIndex> Metamers::find_shoot(std::string_view name) const {
  if (!name.starts_with(kMain)) return std::nullopt;
  AxisIndex found = 0;
  std::string_view rest = name.substr(kMain.size());
  while (!rest.empty()) {
    std::uint32_t wanted = 0;
    const char* const end = rest.data() + rest.size();
    const auto [after, error] = std::from_chars(rest.data() + 1, end, wanted);
    if (rest[0] != '.' || error != std::errc()) return std::nullopt;
    const std::optional<MetamerIndex> bearer = find(found, wanted);
    if (!bearer || !lateral[*bearer].is_grown()) return std::nullopt;
    found = axis[lateral[*bearer].metamer()];
    rest = std::string_view(after, static_cast<std::size_t>(end - after));
  }
  return found;
}

std::string Metamers::name_of(AxisIndex of) const {
  std::vector<std::uint32_t> numbers;
  for (MetamerIndex first = axes[of].first; axis[first] != 0; first = axes[axis[parent[first]]].first) {
    numbers.push_back(number[parent[first]]);
  }
  std::ranges::reverse(numbers);
  std::string name(kMain);
  for (const std::uint32_t place : numbers) name += fmt::format(".{}", place);
  return name;
}

std::vector<std::string> Metamers::shoots_on(AxisIndex on) const {
  std::vector<std::string> names;
  const std::string own = name_of(on);
  for (MetamerIndex metamer = axes[on].first;; metamer = terminal[metamer].metamer()) {
    if (lateral[metamer].is_grown()) names.push_back(fmt::format("{}.{}", own, number[metamer]));
    if (!terminal[metamer].is_grown()) return names;
  }
}

std::vector<MetamerIndex> Metamers::with_borne(MetamerIndex first) const {
  std::vector<MetamerIndex> all{first};
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const Bud bud : {terminal[all[k]], lateral[all[k]]}) {
      if (bud.is_grown()) all.push_back(bud.metamer());
    }
  }
  return all;
}

void Metamers::cut_off(MetamerIndex first, const BudsLeft& after) {
  loose_.resize(count(), 0);
  std::vector<MetamerIndex> beyond = with_borne(first);
  // A removed metamer adds its tips to the lost tips of its parent. Iterate from the tips, so that each metamer knows
  // the tips that it bears.
  std::ranges::sort(beyond);
  std::vector<double> tips(beyond.size(), 0);
  for (std::size_t k = beyond.size(); k-- > 0;) {
    const MetamerIndex metamer = beyond[k];
    const bool bears = tips[k] > 0;
    tips[k] += lost_tips[metamer];
    if (!bears) tips[k] = std::max(tips[k], 1.0);
    loose_[metamer] = 1;
    if (begins_shoot(metamer)) axes[axis[metamer]].is_loose = true;
    if (k == 0) break;
    const auto bearer = std::ranges::lower_bound(beyond, parent[metamer]);
    tips[static_cast<std::size_t>(bearer - beyond.begin())] += tips[k];
  }
  const MetamerIndex bearer = parent[first];
  lost_tips[bearer] += static_cast<float>(tips[0]);
  if (begins_shoot(first)) {
    lateral[bearer] = after.lateral;
  } else {
    terminal[bearer] = after.terminal;
    axes[axis[first]].last = bearer;
  }
  parent[first] = kNoNode;
}

std::vector<std::uint8_t> Metamers::clear_away() {
  std::vector<std::uint8_t> gone = std::exchange(loose_, {});
  if (gone.empty()) return gone;
  gone.resize(count(), 0);
  std::vector<MetamerIndex> place(count());
  MetamerIndex kept = 0;
  for (MetamerIndex metamer = 0; metamer < count(); ++metamer) {
    place[metamer] = kept;
    if (gone[metamer] == 0) ++kept;
  }
  std::vector<AxisIndex> axis_place(axes.size());
  std::vector<Axis> axes_kept;
  for (AxisIndex k = 0; k < axes.size(); ++k) {
    axis_place[k] = static_cast<AxisIndex>(axes_kept.size());
    if (axes[k].is_loose) continue;
    Axis own = axes[k];
    own.first = place[own.first];
    own.last = place[own.last];
    axes_kept.push_back(own);
  }
  const auto renumber = [&](Bud& bud) {
    if (bud.is_grown()) bud = Bud::grown(place[bud.metamer()]);
  };
  for (MetamerIndex metamer = 0; metamer < count(); ++metamer) {
    if (gone[metamer] != 0) continue;
    renumber(terminal[metamer]);
    renumber(lateral[metamer]);
    if (metamer != 0) parent[metamer] = place[parent[metamer]];
    axis[metamer] = axis_place[axis[metamer]];
  }
  axes = std::move(axes_kept);
  erase_marked(parent, gone);
  erase_marked(terminal, gone);
  erase_marked(lateral, gone);
  erase_marked(tip, gone);
  erase_marked(side, gone);
  erase_marked(axis, gone);
  erase_marked(number, gone);
  erase_marked(order, gone);
  erase_marked(birth, gone);
  erase_marked(lost_tips, gone);
  return gone;
}

void Metamers::remove(std::vector<std::uint8_t>& gone, const BudsLeft& after) {
  for (MetamerIndex metamer = 1; metamer < count(); ++metamer) {
    if (gone[metamer] != 0 && !is_loose(metamer)) cut_off(metamer, after);
  }
  if (std::vector<std::uint8_t> cleared = clear_away(); !cleared.empty()) gone = std::move(cleared);
}

}  // namespace meristem

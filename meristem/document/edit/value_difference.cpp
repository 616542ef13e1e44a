// SPDX-License-Identifier: Apache-2.0
// Finds one part to insert or remove on the way from an old value to a new one. Lists are compared from both ends,
// objects by the order of their shared names. Values with equal parts are compared part by part.
#include "meristem/document/edit/value_difference.h"

#include <algorithm>
#include <vector>

#include "meristem/document/member_index.h"

namespace meristem {

namespace {

std::optional<PartDifference> difference_of_lists(LocatedValue old, const Value::List& was, const Value::List& is) {
  const std::size_t shorter = std::min(was.size(), is.size());
  std::size_t first = 0;  // index of the first difference
  while (first < shorter && was[first] == is[first]) ++first;
  std::size_t behind = 0;  // number of equal elements at the end
  while (behind < shorter - first && was[was.size() - 1 - behind] == is[is.size() - 1 - behind]) ++behind;
  // Between both ends, elements are paired. The remaining ones are added or removed after the pairs.
  const std::size_t place = shorter - behind;
  if (was.size() > is.size()) return PartDifference{.container = old, .index = place};
  return PartDifference{.container = old, .index = place, .added = &is[place]};
}

/// Returns the names that both have, in the order of the first.
std::vector<std::string_view> shared_names(const Value& one, const Value& other) {
  std::vector<std::string_view> names;
  const MemberIndex members(&other);
  for (const auto& [name, member] : *one.object()) {
    if (members.position(name)) names.push_back(name);
  }
  return names;
}

std::optional<PartDifference> difference_of_objects(LocatedValue old, const Value& was, const Value& is) {
  const Value::Object& old_members = *was.object();
  const Value::Object& new_members = *is.object();
  const MemberIndex members(&is);
  for (std::size_t k = 0; k < old_members.size(); ++k) {
    if (!members.position(old_members[k].first)) return PartDifference{.container = old, .index = k};
  }
  // All old members stay in their order, so the first difference is a new member.
  for (std::size_t k = 0; k < new_members.size(); ++k) {
    if (k < old_members.size() && old_members[k].first == new_members[k].first) continue;
    return PartDifference{.container = old, .index = k, .name = &new_members[k].first, .added = &new_members[k].second};
  }
  return std::nullopt;
}

}  // namespace

bool have_same_parts(const Value& one, const Value& other) {
  if (one.list() != nullptr && other.list() != nullptr) return one.list()->size() == other.list()->size();
  if (one.object() == nullptr || other.object() == nullptr) return false;
  return std::equal(one.object()->begin(), one.object()->end(), other.object()->begin(), other.object()->end(),
                    [](const Value::Member& a, const Value::Member& b) { return a.first == b.first; });
}

std::optional<PartDifference> first_part_difference(const LocatedTree& tree, LocatedValue old, const Value& value) {
  const Value& was = *old.value;
  if (was == value) return std::nullopt;
  const bool are_lists = was.list() != nullptr && value.list() != nullptr;
  const bool are_objects = was.object() != nullptr && value.object() != nullptr;
  if (!are_lists && !are_objects) return std::nullopt;
  // A change from or to an empty value is written as a whole.
  if (part_count(was) == 0 || part_count(value) == 0) return std::nullopt;
  if (!have_same_parts(was, value)) {
    if (are_lists) return difference_of_lists(old, *was.list(), *value.list());
    const bool is_in_order = shared_names(was, value) == shared_names(value, was);
    return is_in_order && !shared_names(was, value).empty() ? difference_of_objects(old, was, value) : std::nullopt;
  }
  for (std::size_t k = 0; k < part_count(value); ++k) {
    const Value& part = are_lists ? (*value.list())[k] : (*value.object())[k].second;
    if (auto found = first_part_difference(tree, tree.part(old, k), part)) return found;
  }
  return std::nullopt;
}

}  // namespace meristem

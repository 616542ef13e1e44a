// SPDX-License-Identifier: Apache-2.0
// Names members of a component's parameters by pointers to members. Addresses would also accept a copy of a member, and
// the distance of a copy from the parameters has no meaning.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace meristem {

struct ComponentBase;

namespace component_member {

/// Returns the value itself.
template <class T>
const T& held(const T& value) {
  return value;
}
/// Returns the value of an optional, which must have one.
template <class T>
const T& held(const std::optional<T>& value) {
  return *value;
}

/// True if Step is a pointer to a data member of M, or of the value of an optional M.
template <class M, class Step>
concept StepFrom = std::is_member_object_pointer_v<Step> && requires(const M& value, Step step) {
  held(value).*step;
};

}  // namespace component_member

/// A member of a component's parameters, with its position in them. It is made by `member_of` and `part` only: a
/// number, a reference or a copy of a member is refused by the compiler. It refers to the parameters, which must
/// outlive it.
template <class M>
class ComponentMember {
 public:
  /// Makes the whole of a component's parameters.
  explicit ComponentMember(const M& parameters) requires std::derived_from<M, ComponentBase>
      : ComponentMember(parameters, 0) {}

  /// Returns the member's value.
  const M& value() const { return *value_; }
  /// Returns the distance from the beginning of the parameters, bytes.
  std::size_t offset() const { return offset_; }
  /// Returns true if a position in the parameters, in bytes, lies within the member.
  bool contains(std::size_t position) const { return position >= offset_ && position < offset_ + sizeof(M); }

  /// Returns a member of this member, after one step or several. An optional member must have a value.
  template <class N, class Holder, class... Steps>
  requires component_member::StepFrom<M, N Holder::*>
  auto part(N Holder::*step, Steps... further) const {
    const N& inner = component_member::held(*value_).*step;
    const auto distance = reinterpret_cast<const std::byte*>(&inner) - reinterpret_cast<const std::byte*>(value_);
    const ComponentMember<N> member(inner, offset_ + static_cast<std::size_t>(distance));
    if constexpr (sizeof...(Steps) == 0) {
      return member;
    } else {
      return member.part(further...);
    }
  }

 private:
  template <class>
  friend class ComponentMember;

  ComponentMember(const M& value, std::size_t offset) : value_(&value), offset_(offset) {}

  const M* value_;
  std::size_t offset_;
};

/// Returns a member of a component's parameters. Each step is a pointer to a member of the step before it:
/// `member_of(leaf, &Leaf::blade, &LeafBlade::curl)` is `leaf.blade.curl`.
template <class P, class Step, class... Steps>
requires std::derived_from<P, ComponentBase> && component_member::StepFrom<P, Step>
auto member_of(const P& parameters, Step step, Steps... further) {
  return ComponentMember<P>(parameters).part(step, further...);
}

}  // namespace meristem

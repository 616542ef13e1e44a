// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/component_member.h"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/graph/component.h"
#include "meristem/graph/minimum_counts.h"

namespace meristem::component_member_test {

struct Tip {
  double width = 1;
  float angle = 2;
};

struct Blade {
  double length = 3;
  Tip tip;
};

struct Sprig : ComponentBase {
  double height = 4;
  Blade blade;
  std::optional<Blade> second = Blade{};
  int leaves = 5;
  PartCount parts{3.5};
};

template <class... Arguments>
concept NamesMember = requires(const Arguments&... arguments) {
  member_of(arguments...);
};
template <class Known, class Argument>
concept Knows = requires(const Known& known, Argument argument) {
  known.varies(argument);
};
template <class Known, class Argument>
concept KnowsMinimum = requires(const Known& known, Argument argument) {
  known.minimum(argument);
};

// Only pointers to members name a member, and only members of the parameters of a component.
static_assert(NamesMember<Sprig, double Sprig::*>);
static_assert(NamesMember<Sprig, Blade Sprig::*, Tip Blade::*>);
static_assert(NamesMember<Sprig, std::optional<Vec3> ComponentBase::*>);
static_assert(!NamesMember<Sprig, double>);
static_assert(!NamesMember<Sprig, double*>);
static_assert(!NamesMember<Sprig, double Blade::*>);
static_assert(!NamesMember<Blade, double Blade::*>);

// A number, which may be a copy of a member, has no answer.
static_assert(Knows<KnownMembers, ComponentMember<double>>);
static_assert(!Knows<KnownMembers, double>);
static_assert(!Knows<KnownMembers, const double&>);
static_assert(!Knows<KnownMembers, Blade>);
static_assert(KnowsMinimum<KnownMembers, ComponentMember<int>>);
static_assert(!KnowsMinimum<KnownMembers, int>);
static_assert(!KnowsMinimum<KnownMembers, PartCount>);
static_assert(Knows<InstanceContext, ComponentMember<double>>);
static_assert(!Knows<InstanceContext, double>);
static_assert(!Knows<InstanceContext, const double&>);
static_assert(!Knows<InstanceContext, std::size_t>);
static_assert(!std::is_constructible_v<ComponentMember<double>, double>);
static_assert(!std::is_constructible_v<ComponentMember<Blade>, const Blade&>);

/// Returns the distance between the addresses of a struct and of a part of it.
std::size_t distance(const Sprig& sprig, const void* part) {
  return static_cast<std::size_t>(static_cast<const std::byte*>(part) - reinterpret_cast<const std::byte*>(&sprig));
}

Varying varying_at(std::size_t offset) {
  Varying varying;
  varying.offset = offset;
  return varying;
}

TEST(ComponentMember, HasTheValueAndThePositionOfTheMember) {
  const Sprig sprig;
  const auto width = member_of(sprig, &Sprig::blade, &Blade::tip, &Tip::width);
  EXPECT_EQ(&width.value(), &sprig.blade.tip.width);
  EXPECT_EQ(width.offset(), distance(sprig, &sprig.blade.tip.width));
  EXPECT_EQ(member_of(sprig, &Sprig::height).offset(), distance(sprig, &sprig.height));
  EXPECT_EQ(member_of(sprig, &ComponentBase::place, &InstanceTransform::scale).offset(),
            distance(sprig, &sprig.place.scale));
}

TEST(ComponentMember, StepsIntoTheValueOfAnOptional) {
  const Sprig sprig;
  const auto length = member_of(sprig, &Sprig::second, &Blade::length);
  EXPECT_EQ(&length.value(), &sprig.second->length);
  EXPECT_EQ(length.offset(), distance(sprig, &sprig.second->length));
}

TEST(ComponentMember, APartIsNamedFromItsWhole) {
  const Sprig sprig;
  const ComponentMember<Blade> blade = member_of(sprig, &Sprig::blade);
  EXPECT_EQ(blade.part(&Blade::tip, &Tip::angle).offset(), distance(sprig, &sprig.blade.tip.angle));
  EXPECT_TRUE(blade.contains(distance(sprig, &sprig.blade.tip)));
  EXPECT_FALSE(blade.contains(distance(sprig, &sprig.second)));
  EXPECT_FALSE(blade.contains(distance(sprig, &sprig.height)));
}

TEST(ComponentMember, ACopyOfTheParametersHasEqualPositions) {
  const Sprig sprig;
  const Sprig copy = sprig;
  EXPECT_EQ(member_of(copy, &Sprig::leaves).offset(), member_of(sprig, &Sprig::leaves).offset());
}

TEST(KnownMembers, AMemberVariesIfAPartOfItVaries) {
  const Sprig sprig;
  const std::vector<Varying> varyings{varying_at(distance(sprig, &sprig.blade.tip.width))};
  const KnownMembers known(varyings);
  EXPECT_TRUE(known.varies(member_of(sprig, &Sprig::blade)));
  EXPECT_TRUE(known.varies(member_of(sprig, &Sprig::blade, &Blade::tip, &Tip::width)));
  EXPECT_FALSE(known.varies(member_of(sprig, &Sprig::blade, &Blade::length)));
  EXPECT_FALSE(known.varies(member_of(sprig, &Sprig::second)));
}

TEST(KnownMembers, AListVariesIfANumberInAnElementVaries) {
  const Sprig sprig;
  Varying varying = varying_at(0);
  varying.way.push_back({.offset = distance(sprig, &sprig.blade), .type = nullptr, .index = 1});
  const std::vector<Varying> varyings{varying};
  EXPECT_TRUE(KnownMembers(varyings).varies(member_of(sprig, &Sprig::blade)));
  EXPECT_FALSE(KnownMembers(varyings).varies(ComponentMember<Sprig>(sprig).part(&Sprig::height)));
}

TEST(KnownMembers, TheMinimumOfANumberIsItsPlainValueOrTheLowerEndOfItsRange) {
  const Sprig sprig;
  Varying range = varying_at(distance(sprig, &sprig.parts));
  range.first = 7.5;
  range.last = 2.5;
  range.max = 100;
  const std::vector<Varying> varyings{range};
  EXPECT_EQ(KnownMembers({}).minimum(member_of(sprig, &Sprig::parts)), 3);
  EXPECT_EQ(KnownMembers(varyings).minimum(member_of(sprig, &Sprig::parts)), 2);
  EXPECT_EQ(KnownMembers(varyings).minimum(member_of(sprig, &Sprig::leaves)), 5);
}

}  // namespace meristem::component_member_test

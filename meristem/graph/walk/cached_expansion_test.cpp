// SPDX-License-Identifier: Apache-2.0
// An expansion with a cache gives the bytes of one without, whatever happened before, and expands only what it must.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/table/fingerprint.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::cached_expansion_test {

Scene known_scene() {
  Scene scene;
  scene.fingerprint = 1;
  return scene;
}

/// Poles on a star, with sticks along them and on their tips; on the sticks a recursion of sticks.
struct Settings {
  int poles = 40;
  double height = 2;
  double density = 6;
  double width = 0.1;
  double length = 1;
  int depth = 3;
  std::uint64_t seed = 0;

  GraphBuilder builder() const {
    GraphBuilder graph(test_components());
    graph.seed(seed).variable("wide", width);
    graph.component("view", "camera").component("star", "star", {{"number", poles}, {"step", 0.5}});
    graph.component("pole", "pole", {{"height", height}, {"nodes", "3 + i % 4"}});
    graph.component("twig", "pole", {{"height", "0.3*length*rand(0.5, 1)"}, {"nodes", 4}});
    graph.component("leaf", "stick", {{"width", "wide*(1 + i % 3)"}, {"length", 0.1}});
    graph.component("spray", "stick", {{"length", length}, {"recursion", depth}, {"variety", 0.2}});
    graph.link("view", "star").link("star", "pole");
    graph.link("pole", "twig", LinkKind::branch, {{"density", density}, {"angle", 50}});
    graph.link("twig", "leaf", LinkKind::branch, {{"density", 20}, {"where", "1"}});
    return graph.link("pole", "spray", LinkKind::leaf).link("spray", "spray");
  }
};

Plant grow(const Settings& settings, Cache* cache = nullptr) {
  return settings.builder().grow(0, known_scene(), cache);
}

/// Instances that growing one after the other makes anew.
std::uint64_t made_after(const Settings& first, const Settings& second) {
  Cache cache;
  grow(first, &cache);
  EXPECT_EQ(hash_of(grow(second, &cache)), hash_of(grow(second)));
  return cache.reuse<BatchResult>().made;
}

Settings with(const std::function<void(Settings&)>& change) {
  Settings settings;
  change(settings);
  return settings;
}

std::size_t count_of(std::string_view component) { return organs_of(grow(Settings()), component).size(); }

TEST(CachedExpansion, WithoutAChangeNothingIsMadeAnew) {
  Cache cache;
  const std::string hash = hash_of(grow(Settings(), &cache));
  const std::uint64_t all = cache.reuse<BatchResult>().made;
  EXPECT_GT(all, 1000U);
  EXPECT_EQ(cache.reuse<BatchResult>().reused, 0U);
  EXPECT_EQ(hash_of(grow(Settings(), &cache)), hash);
  EXPECT_EQ(cache.reuse<BatchResult>().made, 0U);
  EXPECT_EQ(cache.reuse<BatchResult>().reused, all);
}

TEST(CachedExpansion, AChangeExpandsWhatDependsOnIt) {
  EXPECT_EQ(made_after({}, with([](Settings& s) { s.width = 0.2; })), count_of("leaf"));
  // One batch for each round of the recursion.
  EXPECT_EQ(made_after({}, with([](Settings& s) { s.length = 2; })), count_of("spray"));
  EXPECT_EQ(made_after({}, with([](Settings& s) { s.depth = 4; })), 4U * 40U);
  // All but the camera and the star.
  const Settings higher = with([](Settings& s) { s.height = 3; });
  Cache fresh;
  grow(higher, &fresh);
  EXPECT_EQ(made_after({}, higher), fresh.reuse<BatchResult>().made - 2);
}

TEST(CachedExpansion, AChangeThatLeavesThePlacesLeavesWhatStandsOnThem) {
  Cache cache;
  auto builder = Settings().builder();
  builder.grow(0, known_scene(), &cache);
  builder.component("twig", "pole", {{"height", "0.3*length*rand(0.5, 1)"}, {"nodes", 4}, {"colour", "#aa5500"}});
  builder.grow(0, known_scene(), &cache);
  std::uint64_t twigs = 0;
  for (const Stem& stem : grow(Settings()).stems) {
    twigs += static_cast<std::uint64_t>(std::ranges::count(stem.parts, "twig", &StemPart::component));
  }
  EXPECT_GT(twigs, 100U);
  EXPECT_EQ(cache.reuse<BatchResult>().made, twigs);
}

TEST(CachedExpansion, AnotherSeedTimeSceneOrLimitIsAMiss) {
  Cache cache;
  const Settings settings;
  const std::string hash = hash_of(grow(settings, &cache));
  const auto makes_all = [&] {
    return cache.reuse<BatchResult>().reused == 0 && cache.reuse<BatchResult>().made > 1000;
  };
  grow(with([](Settings& s) { s.seed = 1; }), &cache);
  EXPECT_TRUE(makes_all());
  EXPECT_EQ(hash_of(settings.builder().grow(1, known_scene(), &cache)), hash);
  EXPECT_TRUE(makes_all());
  Scene other = known_scene();
  other.fingerprint = 2;
  EXPECT_EQ(hash_of(settings.builder().grow(1, other, &cache)), hash);
  EXPECT_TRUE(makes_all());
  EXPECT_EQ(hash_of(settings.builder().node_limit(1'000'000).grow(1, other, &cache)), hash);
  EXPECT_TRUE(makes_all());
}

TEST(CachedExpansion, OfASceneWithoutAFingerprintThereIsNothing) {
  Cache cache;
  for (int k = 0; k < 2; ++k) {
    Settings().builder().grow(0, Scene(), &cache);
    EXPECT_EQ(cache.reuse<BatchResult>().reused, 0U);
    EXPECT_EQ(cache.bytes(), 0U);
  }
}

TEST(CachedExpansion, HoldsWhatTheLastExpansionUsed) {
  Cache cache;
  grow(Settings(), &cache);
  const std::uint64_t bytes = cache.bytes();
  EXPECT_GT(bytes, 100'000U);
  for (int k = 1; k < 20; ++k) grow(with([&](Settings& s) { s.width = 0.1 + 0.01 * k; }), &cache);
  EXPECT_EQ(cache.bytes(), bytes);
  grow(with([](Settings& s) { s.poles = 1; }), &cache);
  EXPECT_LT(cache.bytes(), bytes / 10);
  cache.clear();
  EXPECT_EQ(cache.bytes(), 0U);
}

TEST(CachedExpansion, ShapesOfTheExpansionBeforeAreSharedThoughPlacesChange) {
  Cache cache;
  const Plant first = grow(Settings(), &cache);
  const Plant second = grow(with([](Settings& s) { s.density = 7; }), &cache);
  const auto before = prototypes_of(first, "leaf");
  const auto after = prototypes_of(second, "leaf");
  ASSERT_EQ(before.size(), 3U);
  ASSERT_EQ(after.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(before[k].mesh, after[k].mesh);
}

/// Settings as somebody might change them at random.
Settings changed(Settings settings, RandomKey key) {
  switch (static_cast<int>(key.uniform(0, 0, 8))) {
    case 0:
      settings.poles = static_cast<int>(key.uniform(1, 1, 60));
      break;
    case 1:
      settings.height = key.uniform(1, 1, 3);
      break;
    case 2:
      settings.density = key.uniform(1, 0, 12);
      break;
    case 3:
      settings.length = key.uniform(1, 0, 2);
      break;
    case 4:
      settings.depth = static_cast<int>(key.uniform(1, 2, 6));
      break;
    case 5:
      settings.seed = static_cast<std::uint64_t>(key.uniform(1, 0, 3));
      break;
    default:
      settings.width = key.uniform(1, 0, 1);
  }
  return settings;
}

TEST(CachedExpansion, GivesTheSameBytesAfterAnyEditsOnAnyNumberOfThreads) {
  std::vector<std::string> without_cache;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    Cache cache;
    Settings settings;
    std::uint64_t reused = 0;
    for (std::uint64_t edit = 0; edit < 40; ++edit) {
      settings = changed(settings, RandomKey(edit));
      if (threads == 1) without_cache.push_back(hash_of(grow(settings)));
      ASSERT_EQ(hash_of(grow(settings, &cache)), without_cache[edit]) << edit << " on " << threads;
      reused += cache.reuse<BatchResult>().reused;
    }
    EXPECT_GT(reused, 10'000U);
  }
}

TEST(CachedExpansion, StaysInOrderWhenCancelledInTheMiddle) {
  Cache cache;
  Settings settings;
  int cancelled = 0;
  for (std::uint64_t edit = 0; edit < 40; ++edit) {
    settings = changed(settings, RandomKey(edit));
    const Graph graph = settings.builder().sound_graph();
    int reports = static_cast<int>(edit % 7);
    Progress* told = nullptr;
    Progress progress([&](std::string_view, double) {
      if (reports-- == 0) told->cancel();
    });
    told = &progress;
    try {
      expand(graph, known_scene(), 0, progress, &cache);
    } catch (const Cancelled&) {
      ++cancelled;
    }
    if (edit % 3 != 2) continue;
    ASSERT_EQ(hash_of(grow(settings, &cache)), hash_of(grow(settings))) << edit;
  }
  EXPECT_GT(cancelled, 5);
}

TEST(CachedExpansion, AFaultLeavesWhatWasThereBefore) {
  Cache cache;
  grow(Settings(), &cache);
  const Settings settings = with([](Settings& s) { s.height = 3; });
  EXPECT_FALSE(errors_of([&] { settings.builder().mesh_limit(100).grow(0, known_scene(), &cache); }).empty());
  EXPECT_EQ(hash_of(grow(Settings(), &cache)), hash_of(grow(Settings())));
  EXPECT_EQ(cache.reuse<BatchResult>().made, 0U);
}

/// Returns the text of all faults, or an empty text.
std::string error_of(const GraphBuilder& graph, Cache* cache) {
  std::string text;
  for (const Diagnostic& error : errors_of([&] { graph.grow(0, known_scene(), cache); })) text += error.text();
  return text;
}

TEST(CachedExpansion, FaultsAreThoseThatThereWouldBeWithoutIt) {
  Cache cache;
  int errors = 0;
  Settings settings;
  for (std::uint64_t edit = 0; edit < 40; ++edit) {
    settings = changed(settings, RandomKey(edit));
    auto graph = settings.builder();
    graph.instance_limit(5000).node_limit(2500).mesh_limit(48 * 9);
    const std::string error = error_of(graph, nullptr);
    EXPECT_EQ(error_of(graph, &cache), error) << edit;
    errors += error.empty() ? 0 : 1;
    if (!error.empty()) continue;
    EXPECT_EQ(hash_of(graph.grow(0, known_scene(), &cache)), hash_of(graph.grow(0, known_scene())));
  }
  EXPECT_GT(errors, 3);
  EXPECT_LT(errors, 37);
}

/// Hash of a value with one variable and no files.
std::uint64_t hash_of_text(const Value& value, double size) {
  return *fingerprint_of(value, ConstantTable({{"size", size}}), {}, 0);
}

TEST(Fingerprint, TellsValuesApartAndTheVariablesThatTheyName) {
  const Value::Object leaf{{"type", "leaf"}, {"length", "0.1*size"}};
  EXPECT_EQ(hash_of_text(leaf, 1), hash_of_text(leaf, 1));
  EXPECT_NE(hash_of_text(leaf, 1), hash_of_text(leaf, 2));
  const Value::Object other{{"type", "leaf"}, {"length", "0.1*sizes + resize"}};
  EXPECT_EQ(hash_of_text(other, 1), hash_of_text(other, 2));
  const Value::Object nested{{"a", Value::List{1, Value::Object{{"b", Value::List{"(size)"}}}}}};
  EXPECT_NE(hash_of_text(nested, 1), hash_of_text(nested, 2));
  EXPECT_NE(hash_of_text(Value::List{1, Value::List{2}}, 1), hash_of_text(Value::List{Value::List{1}, 2}, 1));
  EXPECT_NE(hash_of_text("ab", 1), hash_of_text(Value::List{"a", "b"}, 1));
  EXPECT_NE(hash_of_text(1, 1), hash_of_text(true, 1));
}

TEST(Fingerprint, WhatIsNoFileHasNone) {
  const std::vector<NamedFile> files{{.path = "/dev/null"}};
  EXPECT_FALSE(fingerprint_of("x", ConstantTable(), files, 100).has_value());
}

}  // namespace meristem::cached_expansion_test

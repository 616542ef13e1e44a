// SPDX-License-Identifier: Apache-2.0
// What reading does in the same way for every size of a document: orders, faults and stops. Times are measured by
// reading_bench.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/edit/session.h"
#include "meristem/document/locate.h"

namespace meristem::large_document_test {

struct Drawn {
  std::string name;
  std::size_t owner = 0;
  std::vector<std::size_t> uses;
};

struct Plan {
  std::vector<Drawn> variables;
  std::vector<std::size_t> used;                           // by component: a variable
  std::vector<std::pair<std::size_t, std::size_t>> links;  // from a component to a later one
};

std::string text_of(const Plan& plan) {
  std::vector<std::string> variables;
  for (const Drawn& variable : plan.variables) {
    std::string value = "1";
    for (const std::size_t used : variable.uses) value += " + " + plan.variables[used].name;
    variables.push_back(fmt::format(R"("{}": {{"value": "{}", "per": "c{}"}})", variable.name, value, variable.owner));
  }
  std::vector<std::string> components;
  for (std::size_t c = 0; c < plan.used.size(); ++c) {
    components.push_back(fmt::format(R"("c{}": {{"type": "leaf", "length": "0.1 + 0.01*v{}"}})", c, plan.used[c]));
  }
  std::vector<std::string> links;
  for (const auto& [from, to] : plan.links) links.push_back(fmt::format(R"(["c{}", "c{}"])", from, to));
  return fmt::format(R"({{"meristem": 1, "variables": {{{}}}, "components": {{{}}}, "links": [{}]}})",
                     fmt::join(variables, ", "), fmt::join(components, ", "), fmt::join(links, ", "));
}

Plan drawn_plan(RandomKey key) {
  const auto below = [&](const char* what, std::uint64_t k, std::size_t count) {
    return static_cast<std::size_t>(static_cast<double>(count) * key.child(what).uniform(k));
  };
  Plan plan;
  const std::size_t components = 2 + below("components", 0, 12);
  const std::size_t variables = 1 + below("variables", 0, 5);
  for (std::size_t v = 0; v < variables; ++v) {
    Drawn variable{.name = fmt::format("v{}", v), .owner = below("owner", v, components), .uses = {}};
    // Only later ones, so that none go in a circle.
    if (v + 1 < variables && below("uses", v, 2) == 1) {
      variable.uses.push_back(v + 1 + below("used", v, variables - v - 1));
    }
    plan.variables.push_back(std::move(variable));
  }
  for (std::size_t c = 0; c < components; ++c) plan.used.push_back(below("use", c, variables));
  for (std::size_t c = 1; c < components; ++c) {
    for (std::size_t k = 0; k < 1 + below("more", c, 2); ++k) {
      plan.links.emplace_back(below("from", 2 * c + k, c), c);
    }
  }
  return plan;
}

/// Whether a component stands somewhere without `giver` above it. Components without a parent stand on the camera.
bool stands_without(const Plan& plan, std::size_t component, std::size_t giver) {
  std::vector<bool> reached(plan.used.size(), true);
  for (const auto& [from, to] : plan.links) reached[to] = false;
  // Links lead to later components, so one pass in their order is enough.
  for (std::size_t c = 0; c < reached.size(); ++c) {
    for (const auto& [from, to] : plan.links) {
      if (to == c && reached[from] && from != giver) reached[c] = true;
    }
  }
  return reached[component];
}

std::vector<std::string> expected_errors(const Plan& plan) {
  std::vector<std::string> errors;
  for (std::size_t v = 0; v < plan.variables.size(); ++v) {
    const std::size_t owner = plan.variables[v].owner;
    for (std::size_t c = 0; c < plan.used.size(); ++c) {
      if (plan.used[c] == v && c != owner && stands_without(plan, c, owner)) {
        errors.push_back(fmt::format("components.c{}: 'c{}' uses 'v{}'", c, c, v));
      }
    }
    for (std::size_t user = 0; user < plan.variables.size(); ++user) {
      const Drawn& variable = plan.variables[user];
      const bool uses = std::ranges::find(variable.uses, v) != variable.uses.end();
      if (uses && variable.owner != owner && stands_without(plan, variable.owner, owner)) {
        errors.push_back(fmt::format("variables.v{}.value: 'v{}' uses 'v{}'", user, user, v));
      }
    }
  }
  return errors;
}

TEST(LargeDocument, ComponentsWithoutTheirVariablesAreThoseThatAWalkFinds) {
  int with_errors = 0;
  int without = 0;
  for (std::uint64_t round = 0; round < 100; ++round) {
    const Plan plan = drawn_plan(RandomKey().child(round));
    std::vector<std::string> found;
    try {
      read_document(text_of(plan), "d.json", builtin_components());
      ++without;
    } catch (const InputError& error) {
      for (const Diagnostic& diagnostic : error.diagnostics()) {
        found.push_back(diagnostic.path + ": " + diagnostic.message.substr(0, diagnostic.message.find(',')));
      }
      ++with_errors;
    }
    EXPECT_EQ(found, expected_errors(plan)) << text_of(plan);
  }
  EXPECT_GT(with_errors, 20);
  EXPECT_GT(without, 0);
}

TEST(LargeDocument, VariablesOfInstancesFollowThoseThatTheyUse) {
  // a uses c, b uses a, c uses nothing, d uses f. c comes first; variables that wait for others follow in later rounds.
  const std::string text = R"json({"meristem": 1, "variables": {
    "a": {"value": "c", "per": "leaf"}, "b": {"value": "a", "per": "leaf"}, "c": {"value": "1", "per": "leaf"},
    "d": {"value": "f + c", "per": "leaf"}, "f": {"value": "2", "per": "leaf"}},
    "components": {"leaf": {"type": "leaf", "length": "0.1*a + 0.1*b + 0.1*d"}}})json";
  const Document document = read_document(text, "d.json", builtin_components());
  std::vector<std::string> names;
  for (const InstanceVariable& variable : document.graph.instance_variables) names.push_back(variable.name);
  EXPECT_EQ(names, (std::vector<std::string>{"c", "f", "a", "b", "d"}));
}

TEST(LargeDocument, TooManyVariablesAreTheOnlyFault) {
  std::vector<std::string> variables;
  for (int k = 0; k < 1001; ++k) variables.push_back(fmt::format(R"("v{}": {{"value": "1", "per": "leaf"}})", k));
  const std::string text = fmt::format(
      R"({{"meristem": 1, "variables": {{{}}}, "components": {{"leaf": {{"type": "leaf", "length": "v0"}}}}}})",
      fmt::join(variables, ", "));
  try {
    read_document(text, "d.json", builtin_components());
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1u);
    EXPECT_EQ(error.diagnostics()[0].message, "the document has 1001 variables");
    EXPECT_EQ(error.diagnostics()[0].path, "variables");
  }
}

TEST(LargeDocument, FaultsAmongManyNamesProposeOnlySoManyNames) {
  constexpr std::size_t kComponents = 30'000;
  std::vector<std::string> components;
  for (std::size_t k = 0; k < kComponents; ++k) components.push_back(fmt::format(R"("c{}": {{"type": "leaf"}})", k));
  std::vector<std::string> links;
  for (std::size_t k = 0; k < 100; ++k) links.push_back(fmt::format(R"(["c1", "c_{}"])", k));
  const std::string text = fmt::format(R"({{"meristem": 1, "components": {{{}}}, "links": [{}]}})",
                                       fmt::join(components, ", "), fmt::join(links, ", "));
  try {
    read_document(text, "d.json", builtin_components());
    FAIL();
  } catch (const InputError& error) {
    const std::vector<Diagnostic>& errors = error.diagnostics();
    ASSERT_EQ(errors.size(), 100u);
    const auto has_nearest = [](const Diagnostic& diagnostic) { return !diagnostic.nearest.empty(); };
    EXPECT_EQ(std::ranges::count_if(errors, has_nearest), 2'000'000 / kComponents);
    EXPECT_FALSE(errors.front().nearest.empty());
    EXPECT_EQ(errors.back().expected, "the id of a component");
  }
}

std::string many_leaves(std::size_t count) {
  std::vector<std::string> components;
  for (std::size_t k = 0; k < count; ++k) components.push_back(fmt::format(R"("c{}": {{"type": "leaf"}})", k));
  return fmt::format(R"({{"meristem": 1, "components": {{{}}}}})", fmt::join(components, ", "));
}

TEST(LargeDocument, IsNotReadAfterItWasCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(read_document(many_leaves(5000), "d.json", builtin_components(), {.progress = &progress}), Cancelled);
  std::vector<Diagnostic> errors{{.message = "m", .path = "components.c4999"}};
  EXPECT_THROW(locate_diagnostics(many_leaves(5000), errors, &progress), Cancelled);
  EXPECT_THROW(component_notes(many_leaves(5000), &progress), Cancelled);
}

TEST(LargeDocument, ItsLimitOfBytesCanBeRaisedAndLowered) {
  const std::string text = many_leaves(10);
  EXPECT_THROW(read_document(text, "d.json", builtin_components(), {.document_bytes = text.size() - 1}), InputError);
  EXPECT_EQ(
      read_document(text, "d.json", builtin_components(), {.document_bytes = text.size()}).graph.components.size(),
      11u);
}

TEST(LargeDocument, OfOneLineHasTheNotesOfItsComponents) {
  std::string text = R"({"meristem": 1, "components": {)";
  for (int k = 0; k < 100; ++k) text += fmt::format(R"("c{}": {{"type": "leaf"}}, )", k);
  text += R"("last": {"type": "leaf"} /* the last */)";
  text += "\n}}";
  const auto notes = component_notes(text);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].first, "last");
  EXPECT_EQ(notes[0].second, "the last");
}

TEST(LargeDocument, EditsThatAreCancelledChangeNothing) {
  Session session(many_leaves(3000), "d.json", builtin_components());
  const std::string text = session.text();
  const Document* document = session.document();
  Progress progress;
  progress.cancel();
  EXPECT_THROW(session.edit({SetValue{"c1.length", 0.2}}, &progress), Cancelled);
  EXPECT_THROW(session.edit_text({{0, 0, " "}}, &progress), Cancelled);
  EXPECT_THROW(session.set_overrides({{.path = "c1.length", .value = 0.2}}, &progress), Cancelled);
  EXPECT_EQ(session.text(), text);
  EXPECT_EQ(session.document(), document);
  EXPECT_TRUE(session.is_good());
  EXPECT_TRUE(session.overrides().empty());
  EXPECT_EQ(session.undo_count(), 0u);
}

TEST(LargeDocument, ATextThatIsNotReadYetIsReadLater) {
  Session session(many_leaves(3), "d.json", builtin_components());
  const std::string text = session.text();
  const Change change = session.change_text({{text.size(), 0, "\n"}});
  EXPECT_EQ(session.text(), text + "\n");
  EXPECT_FALSE(session.is_read());
  EXPECT_FALSE(session.is_good());
  EXPECT_EQ(session.document()->source.text, text);
  session.read();
  EXPECT_TRUE(session.is_read());
  EXPECT_TRUE(session.is_good());
  EXPECT_EQ(session.document()->source.text, text + "\n");
  session.undo();
  EXPECT_EQ(session.text(), text);
  EXPECT_EQ(apply_patch(text + "\n", change.inverse), text);
}

}  // namespace meristem::large_document_test

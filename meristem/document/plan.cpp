// SPDX-License-Identifier: Apache-2.0
// Makes the overrides that turn a document into a plan: the operations of its trees at their last iteration, together
// with further rules, are found but not carried out.
#include "meristem/document/plan.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/expanded.h"

namespace meristem {

namespace {

/// Returns the components whose trees have operations, each with its last iteration.
std::vector<std::pair<std::string, int>> pruned_components(const Document& document) {
  std::vector<std::pair<std::string, int>> found;
  for (const Prototype& component : document.graph.components) {
    if (const std::optional<int> last = last_iteration(component)) found.emplace_back(component.id, *last);
  }
  if (!found.empty()) return found;
  throw InputError(Diagnostic{.message = fmt::format("'{}' has no trees that operations act on", document.source.file),
                              .expected = "a document with a component of type organize"});
}

/// Returns a key of a component, including overrides. Returns null if it is not given.
const Value* key_of(const Document& document, const std::string& id, const char* key) {
  const Value* const components = document.source.tree.find("components");
  const Value* const own = components != nullptr ? components->find(id) : nullptr;
  return own != nullptr ? own->find(key) : nullptr;
}

/// Returns a rule as an operation of trees with this last iteration.
Value operation_of(Value rule, int last, const std::string& name) {
  if (rule.object() == nullptr) {
    throw InputError(Diagnostic{.message = fmt::format("{} cannot be {}", name, rule.description()),
                                .expected = R"(an operation, such as {"do": "cut", "shoots": "inward", "above": 0})"});
  }
  const auto has = [&](const char* key) { return rule.find(key) != nullptr; };
  if (const Value* season = rule.find("season"); season != nullptr && *season == Value("summer")) {
    throw InputError(
        Diagnostic{.message = "what is planned acts after all growth of the last iteration, and not in summer",
                   .expected = "an operation without 'season'",
                   .file = name});
  }
  if (!has("at") && !has("from") && !has("every") && !has("to")) {
    rule.object()->insert(rule.object()->begin(), {"at", Value(last)});
  }
  return rule;
}

}  // namespace

std::vector<ValueOverride> with_rules(const Document& document, const PlanRules& rules) {
  std::vector<ValueOverride> overrides;
  for (const auto& [id, last] : pruned_components(document)) {
    if (rules.operations.empty()) continue;
    const Value* const given = key_of(document, id, "operations");
    Value::List operations = given != nullptr && given->list() != nullptr ? *given->list() : Value::List();
    for (const Value& rule : rules.operations) operations.push_back(operation_of(rule, last, rules.name));
    overrides.push_back({fmt::format("components.{}.operations", id), std::move(operations), rules.name});
  }
  return overrides;
}

std::vector<ValueOverride> only_planned(const Document& document, const PlanRules& rules) {
  std::vector<ValueOverride> overrides = with_rules(document, rules);
  for (const auto& component : pruned_components(document)) {
    const std::string& id = component.first;
    const bool has_own = key_of(document, id, "operations") != nullptr || key_of(document, id, "training") != nullptr;
    if (!has_own && rules.operations.empty()) continue;  // this component has nothing to plan
    overrides.push_back({fmt::format("components.{}.plan", id), true, ""});
  }
  return overrides;
}

}  // namespace meristem

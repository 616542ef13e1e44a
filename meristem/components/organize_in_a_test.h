// SPDX-License-Identifier: Apache-2.0
// A self-organizing tree for tests, with few or no other parameters than the tested ones.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "meristem/components/organize.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::organize_test {

inline GraphBuilder tree(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("tree", "organize", parameters).link("view", "tree");
}

/// The tree with boxes instead of leaves.
inline GraphBuilder leafy(const Value::Object& parameters, const Value::Object& placement = {}) {
  return tree(parameters)
      .component("leaf", "simple", {{"size", Value::List{1, 1, 1}}})
      .link("tree", "leaf", LinkKind::branch, placement);
}

inline Skeleton skeleton_of(const Value::Object& parameters) { return tree(parameters).grow().stems.at(0).skeleton; }

/// Returns the only error of reading and growing.
inline Diagnostic error(const Value::Object& parameters) {
  const auto errors = errors_of([&] { tree(parameters).grow(); });
  EXPECT_EQ(errors.size(), 1U);
  return errors.empty() ? Diagnostic{} : errors[0];
}

/// Returns the warnings of reading, one per line.
inline std::string warnings(const Value::Object& parameters) {
  const ComponentType type = organize_component();
  const auto read = type.make_parameters();
  ParameterReader reader({}, SizeLimits());
  const DocumentPath top;
  reader.read_varying(type.parameters, read.get(), parameters, DocumentPath(top, "tree"));
  EXPECT_EQ(reader.error_count(), 0U);
  std::string texts;
  for (const Diagnostic& found : reader.diagnostics()) texts += found.text() + "\n";
  return texts;
}

inline Value::Object operation(Value::Object more) {
  Value::Object whole{{"at", 5}, {"do", "cut"}, {"shoots", "main"}};
  for (auto& [key, value] : more) {
    std::erase_if(whole, [&name = key](const auto& member) { return member.first == name; });
    whole.emplace_back(key, value);
  }
  return {{"operations", Value::List{Value(std::move(whole))}}};
}

}  // namespace meristem::organize_test

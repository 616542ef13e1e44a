// SPDX-License-Identifier: Apache-2.0
// Graphs for tests, built from document values, and the plants that they grow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/expand.h"
#include "meristem/graph/graph.h"

namespace meristem {

/// Builds a graph over `registry`, which must outlive it. Throws InputError for any error in the input.
class GraphBuilder {
 public:
  explicit GraphBuilder(const Registry& registry) : registry_(registry) {}

  GraphBuilder& variable(std::string name, double value);
  GraphBuilder& seed(std::uint64_t seed);
  GraphBuilder& instance_limit(std::uint64_t limit);
  GraphBuilder& node_limit(std::uint64_t limit);
  GraphBuilder& mesh_limit(std::uint64_t bytes);
  GraphBuilder& texture_limit(std::uint64_t pixels);
  /// Adds a component of the given type, or replaces the component with this id.
  GraphBuilder& component(const std::string& id, const std::string& type, const Value::Object& parameters = {});
  GraphBuilder& link(std::string_view from, std::string_view to, LinkKind kind = LinkKind::child,
                     const Value::Object& placement = {});

  const Graph& graph() const { return graph_; }  ///< without structure
  /// Returns the graph with its structure. Throws InputError if the structure is invalid.
  Graph sound_graph() const;
  /// Returns the reports of analyse_structure(), one line per report.
  std::vector<std::string> structure_errors() const;
  /// Expands the valid graph.
  Plant grow(double time = 0, const Scene& scene = {}, Cache* cache = nullptr) const;

 private:
  ComponentIndex index_of(std::string_view id) const;

  const Registry& registry_;
  std::vector<ExpressionNames::Constant> variables_;
  Graph graph_;
};

/// Returns the organs of one component in the plant's order.
std::vector<Organ> organs_of(const Plant& plant, std::string_view component);
/// Returns the prototypes of one component.
std::vector<OrganPrototype> prototypes_of(const Plant& plant, std::string_view component);
/// Returns a hash of the frames, births, meshes and skeletons of one component. It does not depend on other components.
std::string hash_of(const Plant& plant, std::string_view component);
/// Returns a hash of the whole plant.
std::string hash_of(const Plant& plant);

/// Returns the diagnostics of the InputError that `call` throws, or an empty list if it throws none.
template <class Call>
std::vector<Diagnostic> errors_of(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

}  // namespace meristem

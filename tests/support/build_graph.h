// SPDX-License-Identifier: Apache-2.0
// Graphs for tests, from values as documents hold them, and what they grow into.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/expand.h"
#include "meristem/graph/graph.h"

namespace meristem {

/// Builds a graph over `registry`, which must outlive it. Any fault in what is given is an InputError.
class GraphBuilder {
 public:
  explicit GraphBuilder(const Registry& registry) : registry_(registry) {}

  GraphBuilder& variable(std::string name, double value);
  GraphBuilder& seed(std::uint64_t seed);
  GraphBuilder& instance_limit(std::uint64_t limit);
  GraphBuilder& node_limit(std::uint64_t limit);
  GraphBuilder& mesh_limit(std::uint64_t bytes);
  GraphBuilder& texture_limit(std::uint64_t pixels);
  /// Adds a component of the given type, or replaces the one with this id.
  GraphBuilder& component(const std::string& id, const std::string& type, const Value::Object& parameters = {});
  GraphBuilder& link(std::string_view from, std::string_view to, LinkKind kind = LinkKind::child,
                     const Value::Object& placement = {});

  const Graph& graph() const { return graph_; }  ///< without its structure
  /// With it; throws InputError if it is faulty.
  Graph sound_graph() const;
  /// What analyse_structure reports, one line per report.
  std::vector<std::string> structure_faults() const;
  /// Expands the sound graph.
  Plant grow(double time = 0, const Scene& scene = {}, Cache* cache = nullptr) const;

 private:
  ComponentIndex index_of(std::string_view id) const;

  const Registry& registry_;
  std::vector<ExpressionNames::Constant> variables_;
  Graph graph_;
};

/// The organs of one component in the plant's order.
std::vector<Organ> organs_of(const Plant& plant, std::string_view component);
/// The prototypes of one component.
std::vector<OrganPrototype> prototypes_of(const Plant& plant, std::string_view component);
/// Hash of all that one component made: frames, births, meshes, skeletons. Independent of the other components.
std::string hash_of(const Plant& plant, std::string_view component);
/// Hash of the whole plant.
std::string hash_of(const Plant& plant);

/// The diagnostics of the InputError that `call` throws; empty if it throws none.
template <class Call>
std::vector<Diagnostic> faults_of(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

}  // namespace meristem

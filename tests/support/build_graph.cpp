// SPDX-License-Identifier: Apache-2.0
#include "tests/support/build_graph.h"

#include <cstddef>
#include <span>
#include <stdexcept>

#include "meristem/base/hash.h"
#include "meristem/graph/table/fingerprint.h"

namespace meristem {
namespace {

template <class T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& items) {
  const auto view = std::as_bytes(std::span(items));
  bytes.insert(bytes.end(), view.begin(), view.end());
}

void append_mesh(std::vector<std::byte>& bytes, const Mesh& mesh) {
  append(bytes, mesh.positions);
  append(bytes, mesh.normals);
  append(bytes, mesh.uvs);
  append(bytes, mesh.triangles);
}

void append_component(std::vector<std::byte>& bytes, const Plant& plant, std::string_view component) {
  for (const Stem& stem : plant.stems) {
    if (stem.parts[0].component != component) continue;
    const std::string hash = skeleton_hash(stem.skeleton);
    append(bytes, std::vector<char>(hash.begin(), hash.end()));
  }
  for (const Organ& organ : organs_of(plant, component)) {
    append(bytes, std::vector<Mat3>{organ.frame.axes});
    append(bytes, std::vector<Vec3>{organ.frame.origin});
    append(bytes, std::vector<float>{organ.birth});
    append_mesh(bytes, *plant.prototypes[organ.prototype].mesh);
  }
}

}  // namespace

GraphBuilder& GraphBuilder::variable(std::string name, double value) {
  variables_.push_back({std::move(name), value});
  return *this;
}

GraphBuilder& GraphBuilder::seed(std::uint64_t seed) {
  graph_.seed = seed;
  return *this;
}

GraphBuilder& GraphBuilder::instance_limit(std::uint64_t limit) {
  graph_.limits.instances = limit;
  return *this;
}

GraphBuilder& GraphBuilder::node_limit(std::uint64_t limit) {
  graph_.limits.nodes = limit;
  return *this;
}

GraphBuilder& GraphBuilder::mesh_limit(std::uint64_t bytes) {
  graph_.limits.mesh_bytes = bytes;
  return *this;
}

GraphBuilder& GraphBuilder::texture_limit(std::uint64_t pixels) {
  graph_.limits.texture_pixels = pixels;
  return *this;
}

GraphBuilder& GraphBuilder::component(const std::string& id, const std::string& type, const Value::Object& parameters) {
  Prototype prototype{.id = id, .type = registry_.find(type), .parameters = {}, .varyings = {}};
  if (prototype.type == nullptr) throw std::invalid_argument("no component type " + type);
  prototype.parameters = prototype.type->make_parameters();
  ParameterReader reader(variables_, graph_.limits);
  const DocumentPath top;
  const DocumentPath components(top, "components");
  prototype.varyings = reader.read_varying(prototype.type->parameters, prototype.parameters.get(), parameters,
                                           DocumentPath(components, id));
  if (reader.error_count() > 0) throw InputError(reader.take_diagnostics());
  Value::Object described = parameters;
  described.emplace_back("type", type);
  set_fingerprints(prototype, Value(std::move(described)), ConstantTable(variables_), {}, graph_.limits);
  for (Prototype& present : graph_.components) {
    if (present.id != id) continue;
    present = std::move(prototype);
    return *this;
  }
  graph_.components.push_back(std::move(prototype));
  return *this;
}

GraphBuilder& GraphBuilder::link(std::string_view from, std::string_view to, LinkKind kind,
                                 const Value::Object& placement) {
  Link link{.from = index_of(from), .to = index_of(to), .kind = ChildLink()};
  ParameterReader reader(variables_, graph_.limits);
  const DocumentPath top;
  const DocumentPath links(top, "links");
  BranchLink branch;
  branch.given = reader.read(placement_table(), &branch.placement, placement, DocumentPath(links, graph_.links.size()));
  if (kind == LinkKind::branch) link.kind = std::move(branch);
  if (kind == LinkKind::leaf) link.kind = LeafLink();
  if (reader.error_count() > 0) throw InputError(reader.take_diagnostics());
  link.fingerprint = fingerprint_of(Value(placement), ConstantTable(variables_), {}, 0);
  graph_.links.push_back(std::move(link));
  return *this;
}

std::vector<std::string> GraphBuilder::structure_errors() const {
  std::vector<Diagnostic> diagnostics;
  Graph graph = graph_;
  analyse_structure(graph, diagnostics);
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : diagnostics) texts.push_back(diagnostic.text());
  return texts;
}

Graph GraphBuilder::sound_graph() const {
  std::vector<Diagnostic> diagnostics;
  Graph graph = graph_;
  analyse_structure(graph, diagnostics);
  if (!diagnostics.empty()) throw InputError(std::move(diagnostics));
  return graph;
}

Plant GraphBuilder::grow(double time, const Scene& scene, Cache* cache) const {
  Progress progress;
  return expand(sound_graph(), scene, time, progress, cache);
}

ComponentIndex GraphBuilder::index_of(std::string_view id) const {
  for (ComponentIndex c = 0; c < graph_.components.size(); ++c) {
    if (graph_.components[c].id == id) return c;
  }
  throw std::invalid_argument("no component " + std::string(id));
}

std::vector<Organ> organs_of(const Plant& plant, std::string_view component) {
  std::vector<Organ> organs;
  for (const Organ& organ : plant.organs) {
    if (plant.prototypes[organ.prototype].component == component) organs.push_back(organ);
  }
  return organs;
}

std::vector<OrganPrototype> prototypes_of(const Plant& plant, std::string_view component) {
  std::vector<OrganPrototype> prototypes;
  for (const OrganPrototype& prototype : plant.prototypes) {
    if (prototype.component == component) prototypes.push_back(prototype);
  }
  return prototypes;
}

std::string hash_of(const Plant& plant, std::string_view component) {
  std::vector<std::byte> bytes;
  append_component(bytes, plant, component);
  return hash128_hex(bytes);
}

std::string hash_of(const Plant& plant) {
  std::vector<std::byte> bytes;
  for (const Material& material : plant.materials) {
    append(bytes, std::vector<char>(material.name.begin(), material.name.end()));
    append_component(bytes, plant, material.name);
  }
  return hash128_hex(bytes);
}

}  // namespace meristem

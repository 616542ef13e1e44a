// SPDX-License-Identifier: Apache-2.0
// Reads the links of a document and checks them against the components at their ends: both must exist, crown links need
// a crown body, and placement keys need stems. Each link gets a fingerprint of its text, so that cached sites can be
// reused.
#include "meristem/graph/link_reader.h"

#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "meristem/graph/table/fingerprint.h"
#include "meristem/graph/table/table.h"

namespace meristem {

const ParameterTable& link_table() {
  static const ParameterTable table =
      Table<LinkHead>("a link", "Joins two components: the child stands on the parent.")
          .text("from", &LinkHead::from, "Id of the parent, which bears the child.")
          .required()
          .text("to", &LinkHead::to, "Id of the child, which stands on the parent.")
          .required()
          .choice("kind", &LinkHead::kind, {"child", "branch", "leaf", "crown"},
                  "Position of the children: 'child' at the end of the parent, 'branch' along its stems or ribs, "
                  "'leaf' at tips or where a recursion ends, 'crown' in its crown body.");
  return table;
}

LinkReader::LinkReader(Graph& graph, ParameterReader& reader)
    : graph_(graph), reader_(reader), component_by_id_(graph.components.size()) {
  const auto id_at = [&](std::size_t c) -> std::string_view { return graph.components[c].id; };
  for (std::size_t c = 0; c < graph.components.size(); ++c) {
    reader.check_stop();
    component_by_id_.enter(graph.components[c].id, c, id_at);
  }
}

ComponentIndex LinkReader::component(std::string_view id) const {
  const auto id_at = [&](std::size_t c) -> std::string_view { return graph_.components[c].id; };
  const std::optional<std::size_t> found = component_by_id_.find(id, id_at);
  return found ? static_cast<ComponentIndex>(*found) : kNoIndex;
}

std::string LinkReader::nearest_id(std::string_view id) {
  if (ids_.empty()) {
    for (const Prototype& prototype : graph_.components) ids_.push_back(prototype.id);
  }
  return reader_.nearest(id, ids_);
}

void LinkReader::read(const Value& links, const DocumentPath& path) {
  const Value::List* list = links.list();
  if (list == nullptr) {
    return reader_.add_error(path, fmt::format("the links are {}", links.description()),
                             R"(a list such as [["view", "tree"]])");
  }
  // A link has 600 bytes, so a list of 300,000 links that grows would move 200 MB at once, without a check whether to
  // stop. The camera gets at most one link for each component. Memory that is not used is not touched.
  constexpr std::size_t kMaxReserved = 2'000'000;  // a list of wrong values must not reserve all memory
  graph_.links.reserve(std::min(list->size() + placed_count() + graph_.components.size(), kMaxReserved));
  for (std::size_t k = 0; k < list->size(); ++k) read_link((*list)[k], DocumentPath(path, k));
}

/// Returns the number of links that link_placed will add at most.
std::size_t LinkReader::placed_count() const {
  std::size_t count = 0;
  for (const Prototype& prototype : graph_.components) {
    reader_.check_stop();
    if (prototype.type == nullptr || !prototype.type->placed) continue;
    count += prototype.type->placed(prototype.parameters.get()).size();
  }
  return count;
}

void LinkReader::read_link(const Value& value, const DocumentPath& path) {
  reader_.check_stop();
  Link link;
  const std::size_t files_before = reader_.files().named().size();
  if (const Value::List* pair = value.list()) {
    if (pair->size() != 2) {
      return reader_.add_error(path, fmt::format("a link is {}", value.description()), R"(a pair ["from", "to"])");
    }
    link.from = read_end((*pair)[0], DocumentPath(path, std::size_t{0}));
    link.to = read_end((*pair)[1], DocumentPath(path, std::size_t{1}));
  } else if (value.object() == nullptr) {
    return reader_.add_error(path, fmt::format("a link cannot be {}", value.description()),
                             R"(["from", "to"] or {"from": ..., "to": ..., "kind": ...})");
  } else {
    link.from = read_named_end(value, "from", path);
    link.to = read_named_end(value, "to", path);
    read_kind(value, path, link);
  }
  // An expression that uses t gives other sites at another time, and the fingerprint does not contain the time.
  if (!mentions(value, "t")) {
    link.fingerprint =
        fingerprint_of(value, reader_.expressions().constant_table(),
                       std::span(reader_.files().named()).subspan(files_before), reader_.limits().file_bytes);
  }
  if (link.from != kNoIndex && link.to != kNoIndex) graph_.links.push_back(std::move(link));
}

/// Reads the kind of a link and the keys that links of this kind have.
void LinkReader::read_kind(const Value& value, const DocumentPath& path, Link& link) {
  LinkHead head;
  const std::size_t errors_before = reader_.error_count();
  if (const Value* given = value.find("kind")) {
    const Parameter& row = *link_table().find("kind");
    row.read(&head, *given, DocumentPath(path, row.name), reader_);
  }
  const bool is_known = reader_.error_count() == errors_before;
  if (head.kind == LinkKind::crown) {
    CrownLink crown;
    reader_.read(crown_placement_table(), &crown.placement, value, path);
    check_crown(path, link);
    link.kind = crown;
    return;
  }
  BranchLink branch;
  branch.given = reader_.read(placement_table(), &branch.placement, value, path);
  if (is_known) check_placement(value, path, link, head.kind);
  if (head.kind == LinkKind::branch) link.kind = std::move(branch);
  if (head.kind == LinkKind::leaf) link.kind = LeafLink();
}

ComponentIndex LinkReader::read_named_end(const Value& link, const char* name, const DocumentPath& path) {
  if (const Value* end = link.find(name)) return read_end(*end, DocumentPath(path, name));
  reader_.add_error(path, fmt::format("the link has no '{}'", name), "the id of a component");
  return kNoIndex;
}

ComponentIndex LinkReader::read_end(const Value& value, const DocumentPath& path) {
  if (value.text() == nullptr) {
    reader_.add_error(path, fmt::format("the end of a link cannot be {}", value.description()),
                      "the id of a component");
    return kNoIndex;
  }
  if (const ComponentIndex found = component(*value.text()); found != kNoIndex) return found;
  const std::string nearest = nearest_id(*value.text());
  reader_.add_error(path, fmt::format("there is no component '{}'", *value.text()),
                    nearest.empty() ? "the id of a component" : "", nearest);
  return kNoIndex;
}

void LinkReader::link_placed(const DocumentPath& components) {
  for (ComponentIndex from = 0; from < graph_.components.size(); ++from) {
    reader_.check_stop();
    const Prototype& prototype = graph_.components[from];
    if (prototype.type == nullptr || !prototype.type->placed) continue;
    const std::vector<PlacedComponent> placed = prototype.type->placed(prototype.parameters.get());
    for (std::uint32_t k = 0; k < placed.size(); ++k) {
      const std::string& id = placed[k].id;
      const ComponentIndex found = component(id);
      if (found != kNoIndex) {
        // Constructed in the list itself: g++ 12 warns about the unused alternatives of a variant that is moved.
        Link& link = graph_.links.emplace_back();
        link.from = from;
        link.to = found;
        link.kind = PlacedLink{k};
        link.fingerprint = 0;
        continue;
      }
      if (!placed[k].is_needed) continue;
      const std::string nearest = nearest_id(id);
      reader_.add_error(DocumentPath(components, prototype.id),
                        fmt::format("'{}' places '{}', and there is no such component", prototype.id, id),
                        nearest.empty() ? fmt::format("a component '{}'{}", id, placed[k].hint) : "", nearest);
    }
  }
}

const Prototype* LinkReader::parent_of(const Link& link) const {
  if (link.from == kNoIndex || graph_.components[link.from].type == nullptr) return nullptr;
  return &graph_.components[link.from];
}

/// Reports a crown link from a component that has no crown body.
void LinkReader::check_crown(const DocumentPath& path, const Link& link) {
  const Prototype* from = parent_of(link);
  if (from == nullptr) return;
  const auto& surface = from->type->surface;
  if (surface && surface(from->parameters.get()).crown) return;
  reader_.add_error(DocumentPath(path, "kind"),
                    surface ? fmt::format("the surface of '{}' has no crown", from->id)
                            : fmt::format("'{}' makes no stems that could have a crown", from->id),
                    R"("crown": {...} in the surface of a component with stems)");
}

/// Reports placement keys on a link that is no branch link, or whose parent has no stems.
void LinkReader::check_placement(const Value& value, const DocumentPath& path, const Link& link, LinkKind kind) {
  const Prototype* from = parent_of(link);
  const bool is_branch = kind == LinkKind::branch;
  if (from == nullptr || (is_branch && from->type->makes_stems)) return;
  for (const auto& [name, member] : *value.object()) {
    if (placement_table().find(name) == nullptr) continue;
    reader_.add_name_error(
        DocumentPath(path, name),
        is_branch ? fmt::format("'{}' has no meaning here, since '{}' makes no stems", name, from->id)
                  : fmt::format("'{}' belongs to branch links", name),
        is_branch ? "a link from a component with stems" : "\"kind\": \"branch\", or no such key", "");
  }
}

}  // namespace meristem

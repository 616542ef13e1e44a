// SPDX-License-Identifier: Apache-2.0
// Renames components and variables with all their uses. Uses are found by position: ends of links, the row `of`,
// expressions, and symbols of grammars. Strings that only look like the name stay.
#include "meristem/document/edit/rename.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/expression/expression.h"
#include "meristem/document/edit/grammar_text_value.h"
#include "meristem/document/edit/path.h"
#include "meristem/document/edit/text_edit.h"
#include "meristem/document/json.h"
#include "meristem/document/locate.h"
#include "meristem/document/mentions.h"
#include "meristem/document/variables.h"
#include "meristem/graph/table/node_condition.h"
#include "meristem/graph/table/site.h"

namespace meristem {

namespace {

[[noreturn]] void refuse_name(const std::string& path, std::string message, std::string expected) {
  throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .path = path});
}

/// Returns the member of an object with its position. Its value is null if the member does not exist.
LocatedValue member_of(const LocatedTree& tree, LocatedValue object, std::string_view name) {
  const std::size_t index = tree.index_of(object, name);
  return index == TextNode::kNone ? LocatedValue() : tree.part(object, index);
}

/// Calls `take(id, grammar, path)` for each grammar in the document.
template <class Take>
void for_each_grammar(const LocatedTree& tree, const Registry& registry, Take take) {
  const LocatedValue components = member_of(tree, tree.root(), "components");
  for (std::size_t k = 0; components.value != nullptr && k < part_count(*components.value); ++k) {
    const LocatedValue component = tree.part(components, k);
    const std::string& id = (*components.value->object())[k].first;
    const Value* named = component.value->find("type");
    const ComponentType* type = named != nullptr && named->text() != nullptr ? registry.find(*named->text()) : nullptr;
    if (type == nullptr) continue;
    for (const Parameter& row : type->parameters.parameters) {
      if (row.kind != ParameterKind::lines) continue;
      const LocatedValue grammar = member_of(tree, component, row.name);
      if (grammar.value == nullptr) continue;
      take(id, GrammarInDocument(tree, grammar), fmt::format("components.{}.{}", id, row.name));
    }
  }
}

TextSplice text_over(const LocatedTree& tree, LocatedValue value, const std::string& text) {
  const TextNode& node = tree.at(value);
  return {node.begin, node.end - node.begin, write_json_line(Value(text))};
}

/// Renames a component in links.
void rename_in_links(const LocatedTree& tree, const std::string& id, const std::string& name, TextPatch& patch) {
  const LocatedValue links = member_of(tree, tree.root(), "links");
  if (links.value == nullptr || links.value->list() == nullptr) return;
  for (std::size_t k = 0; k < part_count(*links.value); ++k) {
    const LocatedValue link = tree.part(links, k);
    std::vector<LocatedValue> ends{member_of(tree, link, "from"), member_of(tree, link, "to")};
    if (link.value->list() != nullptr) {
      for (std::size_t end = 0; end < part_count(*link.value); ++end) ends.push_back(tree.part(link, end));
    }
    for (const LocatedValue end : ends) {
      if (end.value != nullptr && end.value->text() != nullptr && *end.value->text() == id) {
        patch.push_back(text_over(tree, end, name));
      }
    }
  }
}

/// Renames a component in the components that show it.
void rename_where_shown(const LocatedTree& tree, const std::string& id, const std::string& name,
                        const Registry& registry, TextPatch& patch) {
  const LocatedValue components = member_of(tree, tree.root(), "components");
  if (components.value == nullptr || components.value->object() == nullptr) return;
  for (std::size_t k = 0; k < part_count(*components.value); ++k) {
    const LocatedValue component = tree.part(components, k);
    const LocatedValue type = member_of(tree, component, "type"), of = member_of(tree, component, "of");
    if (type.value == nullptr || type.value->text() == nullptr || of.value == nullptr) continue;
    const ComponentType* known = registry.find(*type.value->text());
    if (known == nullptr || known->shows.type.empty() || *of.value != Value(id)) continue;
    patch.push_back(text_over(tree, of, name));
  }
}

/// Renames a variable in an expression.
void rename_in_expression(const LocatedTree& tree, LocatedValue value, const std::string& variable,
                          const std::string& name, const std::string& path, TextPatch& patch) {
  const std::string& text = *value.value->text();
  std::vector<std::size_t> places;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_of_name(text[end])) ++end;
    const std::string_view word = std::string_view(text).substr(at, end - at);
    if (word == name) refuse_name(path, fmt::format("'{}' already has a meaning here", name), "another name");
    if (word == variable) {
      if (places.empty()) places = places_of_bytes(tree.text(), tree.at(value).begin);
      patch.push_back({places[at], places[end] - places[at], name});
    }
    at = std::max(end, at + 1);
  }
}

TextPatch in_order(TextPatch patch) {
  std::stable_sort(patch.begin(), patch.end(),
                   [](const TextSplice& a, const TextSplice& b) { return a.offset < b.offset; });
  // An expression may have been read twice.
  patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
  return patch;
}

void append(TextPatch& patch, const TextPatch& more) { patch.insert(patch.end(), more.begin(), more.end()); }

}  // namespace

TextPatch rename_component(const LocatedTree& tree, const std::string& id, const std::string& name,
                           const Registry& registry, const std::function<bool(const std::string& placer)>& placed_by) {
  const std::string path = path_below("components", id);
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_of_name)) {
    refuse_name(path, fmt::format("'{}' cannot name a component", name), "letters, digits and _");
  }
  TextPatch patch = rename_member(tree, path, name);
  if (patch.empty()) return patch;
  rename_in_links(tree, id, name, patch);
  rename_where_shown(tree, id, name, registry, patch);
  for_each_grammar(tree, registry,
                   [&](const std::string& placer, const GrammarInDocument& grammar, const std::string& at) {
                     if (grammar.has_symbol(id) && (grammar.places(id) || placed_by(placer))) {
                       append(patch, grammar.with_symbol(id, name, at));
                     }
                   });
  return in_order(std::move(patch));
}

TextPatch rename_variable(const LocatedTree& tree, const std::string& variable, const std::string& name,
                          const Registry& registry, const std::vector<std::string>& expression_paths) {
  const std::string path = path_below("variables", variable);
  if (!is_identifier(name)) {
    refuse_name(path, fmt::format("'{}' is not a name", name), "letters, digits and _, not beginning with a digit");
  }
  if (has_meaning(name)) {
    refuse_name(path, fmt::format("'{}' already has a meaning in expressions", name), "another name");
  }
  TextPatch patch = rename_member(tree, path, name);
  if (patch.empty()) return patch;
  for (const std::string& expression : expression_paths) {
    const PathTarget target = follow_path(tree, expression);
    if (!target.missing.empty() || target.last().value->text() == nullptr) continue;
    rename_in_expression(tree, target.last(), variable, name, expression, patch);
  }
  for_each_grammar(tree, registry, [&](const std::string&, const GrammarInDocument& grammar, const std::string& at) {
    append(patch, grammar.with_name(variable, name, at));
  });
  return in_order(std::move(patch));
}

}  // namespace meristem

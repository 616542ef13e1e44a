// SPDX-License-Identifier: Apache-2.0
// Copies components between documents as text. A part is built as a document of its own: written components with their
// notes, links among them, and the variables that they use. Indentation and line ends are adapted to the target.
#include "meristem/document/edit/plant_part.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/edit/layout.h"
#include "meristem/document/edit/note.h"
#include "meristem/document/edit/part_edit.h"
#include "meristem/document/edit/path.h"
#include "meristem/document/edit/text_edit.h"
#include "meristem/document/edit/tree_edit.h"
#include "meristem/document/json.h"
#include "meristem/document/mentions.h"

namespace meristem {

namespace {

constexpr const char* kEmptyPart = "{\n  \"meristem\": 1,\n  \"components\": {},\n  \"links\": []\n}\n";

/// Returns an object, or the list of links, at the top level of the document. Its value is null if it does not exist.
/// Throws an InputError if it is of another kind.
LocatedValue top_member(const LocatedTree& tree, std::string_view name) {
  const Value::Object* top = tree.root().value->object();
  if (top == nullptr) throw InputError(Diagnostic{.message = "the text is no document", .expected = "an object"});
  for (std::size_t k = 0; k < top->size(); ++k) {
    if ((*top)[k].first != name) continue;
    const LocatedValue found = tree.part(tree.root(), k);
    const bool is_list = name == "links";
    if (is_list ? found.value->list() != nullptr : found.value->object() != nullptr) return found;
    throw InputError(Diagnostic{.message = fmt::format("the {} cannot be taken along", name),
                                .expected = is_list ? "a list" : "an object",
                                .path = std::string(name)});
  }
  return {};
}

const std::string& name_in(LocatedValue object, std::size_t index) { return (*object.value->object())[index].first; }

std::optional<std::size_t> index_in(const LocatedTree& tree, LocatedValue object, std::string_view name) {
  const std::size_t index = tree.index_of(object, name);
  return index == TextNode::kNone ? std::nullopt : std::optional(index);
}

std::pair<std::string, std::string> ends_of(const Value& link) {
  const auto text = [](const Value* end) { return end != nullptr && end->text() != nullptr ? *end->text() : ""; };
  if (const Value::List* ends = link.list()) {
    return ends->size() == 2 ? std::pair(text(&(*ends)[0]), text(&(*ends)[1])) : std::pair<std::string, std::string>();
  }
  return {text(link.find("from")), text(link.find("to"))};
}

/// Returns a text of several lines with other indentation and line ends. `from` is the indentation of its present first
/// line, `to` the indentation of its new first line.
std::string moved_lines(std::string_view text, std::string_view from, std::string_view from_unit, std::string_view to,
                        std::string_view to_unit, std::string_view line_end) {
  std::string made;
  for (bool is_first = true;; is_first = false) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (is_first) {
      made += line;
    } else {
      made += line_end;
      if (line.starts_with(from)) {
        line.remove_prefix(from.size());
        made += to;
        while (from_unit != to_unit && line.starts_with(from_unit)) {
          line.remove_prefix(from_unit.size());
          made += to_unit;
        }
      }
      made += line;
    }
    if (end == std::string_view::npos) return made;
    text.remove_prefix(end + 1);
  }
}

/// Returns the indentation of the parts of a list or object.
std::string indent_of_parts(const LocatedTree& tree, LocatedValue container) {
  const std::string& text = tree.text();
  const TextNode& node = tree.at(container);
  if (part_count(*container.value) > 0) {
    const std::size_t first = tree.at(tree.part(container, 0)).first();
    if (line_begin(text, first) > node.begin) return std::string(indent_at(text, first));
  }
  return std::string(indent_at(text, node.begin)) + std::string(indent_unit_of(text));
}

/// Inserts a part of the document `from` into the top-level list or object of that name as it is written there. Adds
/// the list or object if it is missing.
void insert_written(TreeEdit& document, std::string_view name, const LocatedTree& from, LocatedValue container,
                    std::size_t index, std::optional<std::size_t> place) {
  const bool is_object = container.value->object() != nullptr;
  if (top_member(document.tree(), name).value == nullptr) {
    set_value(document, name, is_object ? Value(Value::Object{}) : Value(Value::List{}));
  }
  const LocatedTree& tree = document.tree();
  const LocatedValue into = top_member(tree, name);
  const std::size_t count = part_count(*into.value);
  WrittenPart written = remove_part(from, container, index).written;
  const std::size_t first = from.at(from.part(container, index)).first();
  written.text = moved_lines(written.text, indent_at(from.text(), first), indent_unit_of(from.text()),
                             indent_of_parts(tree, into), indent_unit_of(tree.text()), line_end_of(tree.text()));
  written.comments = moved_lines(written.comments, "", "", "", "", line_end_of(tree.text()));
  document.take(insert_part(tree, into, std::min(place.value_or(count), count), {.written = &written}));
}

void insert_component(TreeEdit& document, const LocatedTree& from, LocatedValue components, std::size_t index,
                      std::optional<std::size_t> place) {
  const std::string note = note_on(from, components, index);
  const std::string& name = name_in(components, index);
  insert_written(document, "components", from, components, index, place);
  // A note after the component was copied with it.
  const std::string path = path_below("components", name);
  const LocatedTree& tree = document.tree();
  const PathTarget target = find_path(tree, path);
  const std::string come = note_on(tree, target.container(), target.places.back());
  if (come != note) document.take(set_note(tree, path, note));
}

/// Adds the variables that a value uses, directly and through other variables.
void add_variables(const LocatedTree& tree, const Value& value, std::set<std::string>& named) {
  const LocatedValue variables = top_member(tree, "variables");
  for_each_mention(value, [&](std::string_view name) {
    const std::optional<std::size_t> index = index_in(tree, variables, name);
    if (!index || !named.insert(std::string(name)).second) return;
    // The sentence of a variable uses no other variable.
    const Value& variable = (*variables.value->object())[*index].second;
    const Value* expression = variable.object() != nullptr ? variable.find("value") : &variable;
    if (expression != nullptr) add_variables(tree, *expression, named);
  });
}

}  // namespace

std::string part_text(const LocatedTree& tree, const std::vector<std::string>& components, const Progress* progress) {
  const LocatedValue all = top_member(tree, "components");
  const std::set<std::string> wanted(components.begin(), components.end());
  for (const std::string& id : components) {
    if (!index_in(tree, all, id)) {
      throw InputError(Diagnostic{.message = fmt::format("there is no component '{}'", id), .path = "components"});
    }
  }
  LocatedTree made(kEmptyPart);
  TreeEdit part(&made, progress);
  std::set<std::string> named;
  for (std::size_t k = 0; all.value != nullptr && k < part_count(*all.value); ++k) {
    if (!wanted.contains(name_in(all, k))) continue;
    insert_component(part, tree, all, k, std::nullopt);
    add_variables(tree, (*all.value->object())[k].second, named);
  }
  const LocatedValue links = top_member(tree, "links");
  for (std::size_t k = 0; links.value != nullptr && k < part_count(*links.value); ++k) {
    const Value& link = (*links.value->list())[k];
    const auto [from, to] = ends_of(link);
    if (!wanted.contains(from) || !wanted.contains(to)) continue;
    insert_written(part, "links", tree, links, k, std::nullopt);
    add_variables(tree, link, named);
  }
  const LocatedValue variables = top_member(tree, "variables");
  for (std::size_t k = 0; !named.empty() && k < part_count(*variables.value); ++k) {
    if (named.contains(name_in(variables, k))) insert_written(part, "variables", tree, variables, k, std::nullopt);
  }
  return part.tree().text();
}

void insert_plant_part(TreeEdit& document, const LocatedTree& part, const PartPlace& place) {
  const LocatedValue variables = top_member(part, "variables");
  for (std::size_t k = 0; variables.value != nullptr && k < part_count(*variables.value); ++k) {
    if (!index_in(document.tree(), top_member(document.tree(), "variables"), name_in(variables, k))) {
      insert_written(document, "variables", part, variables, k, std::nullopt);
    }
  }
  const LocatedValue components = top_member(part, "components");
  for (std::size_t k = 0; components.value != nullptr && k < part_count(*components.value); ++k) {
    const std::string& id = name_in(components, k);
    if (index_in(document.tree(), top_member(document.tree(), "components"), id)) {
      throw InputError(Diagnostic{.message = fmt::format("there is a component '{}' already", id),
                                  .expected = "a name that is free",
                                  .path = path_below("components", id)});
    }
    insert_component(document, part, components, k,
                     place.component ? std::optional(*place.component + k) : std::nullopt);
  }
  const LocatedValue links = top_member(part, "links");
  for (std::size_t k = 0; links.value != nullptr && k < part_count(*links.value); ++k) {
    insert_written(document, "links", part, links, k, place.link ? std::optional(*place.link + k) : std::nullopt);
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Translates edits of a document into patches of its text. Paths may begin with a variable or a component. Edits of
// names change all uses of the name, which are found in links, expressions and grammars.
#include "meristem/document/edit/edits.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "meristem/document/edit/note.h"
#include "meristem/document/edit/path.h"
#include "meristem/document/edit/plant_part.h"
#include "meristem/document/edit/rename.h"
#include "meristem/document/edit/text_edit.h"
#include "meristem/document/edit/tree_edit.h"
#include "meristem/document/tables.h"

namespace meristem {

namespace {

/// Returns the path from the root. A path that begins with no key of the document begins with a variable or a
/// component.
std::string whole_path(const LocatedTree& tree, const std::string& path) {
  const std::string_view first = std::string_view(path).substr(0, path.find_first_of(".["));
  const std::vector<std::string> keys = head_table().names();
  const bool is_key = std::find(keys.begin(), keys.end(), first) != keys.end() || first.empty();
  if (first.size() == path.size()) {
    const std::size_t variables = tree.index_of(tree.root(), "variables");
    const bool is_variable =
        variables != TextNode::kNone && tree.index_of(tree.part(tree.root(), variables), path) != TextNode::kNone;
    return is_variable || !is_key ? "variables." + path : path;
  }
  return is_key ? path : "components." + path;
}

/// Returns the member's name if the path is a member of `group` ("components", "variables"). Returns an empty text
/// otherwise.
std::string named_in(const LocatedTree& tree, const std::string& path, std::string_view group) {
  const PathTarget target = find_path(tree, path);
  const Value::Object* top = tree.root().value->object();
  if (top == nullptr || target.places.size() != 2 || (*top)[target.places[0]].first != group) return {};
  const Value::Object* members = target.container().value->object();
  return members == nullptr ? std::string() : (*members)[target.places[1]].first;
}

/// Throws an InputError if the component or variable of a path does not exist. Missing members within it may be added.
void require_named(const LocatedTree& tree, const std::string& path) {
  const PathTarget target = follow_path(tree, path);
  const Value::Object* top = tree.root().value->object();
  if (top == nullptr || target.places.size() != 1 || target.missing.empty()) return;
  const std::string& group = (*top)[target.places[0]].first;
  const bool is_part = group == "components" && target.missing.size() > 1;
  if (is_part || (group == "variables" && target.missing.size() > 1)) throw_missing(target, path);
}

bool names_component(const Value& link, const std::string& id) {
  const auto is_it = [&](const Value* end) { return end != nullptr && end->text() != nullptr && *end->text() == id; };
  if (is_it(link.find("from")) || is_it(link.find("to"))) return true;
  const Value::List* ends = link.list();
  return ends != nullptr && std::any_of(ends->begin(), ends->end(), [&](const Value& end) { return is_it(&end); });
}

/// Removes a component with its links. The last link is removed first, so that other indices stay valid.
void remove_component(TreeEdit& document, const std::string& path, const std::string& id) {
  document.take(remove_value(document.tree(), path));
  const Value* links = document.tree().root().value->find("links");
  if (links == nullptr || links->list() == nullptr) return;
  std::vector<std::size_t> gone;
  for (std::size_t k = links->list()->size(); k-- > 0;) {
    if (names_component((*links->list())[k], id)) gone.push_back(k);
  }
  for (const std::size_t k : gone) document.take(remove_value(document.tree(), fmt::format("links[{}]", k)));
}

/// Returns all paths of expressions that can be read.
std::vector<std::string> expression_paths(const LocatedTree& tree, const EditContext& context) {
  std::vector<std::string> paths;
  try {
    ReadOptions reading = context.reading;
    reading.expression_paths = &paths;
    read_document(tree.text(), context.file, context.registry, reading);
  } catch (const InputError&) {
    // Paths read before the fault are kept.
  }
  return paths;
}

/// Returns true if the component `placer` of the last valid document places `id` by its name.
bool places(const Document* document, const std::string& placer, const std::string& id) {
  if (document == nullptr) return false;
  for (const Prototype& prototype : document->graph.components) {
    if (prototype.id != placer || prototype.type == nullptr || !prototype.type->placed) continue;
    for (const PlacedComponent& placed : prototype.type->placed(prototype.parameters.get())) {
      if (placed.id == id) return true;
    }
  }
  return false;
}

/// Reads a text as a document. Returns nothing if it has faults.
std::optional<Document> document_of(const LocatedTree& tree, const EditContext& context) {
  try {
    return read_document(tree.text(), context.file, context.registry, context.reading);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Renames components of a part. Processes a rename only after its new name has become free.
LocatedTree with_names(LocatedTree part, std::vector<std::pair<std::string, std::string>> names,
                       const EditContext& context) {
  const std::optional<Document> document = document_of(part, context);
  std::erase_if(names, [](const auto& name) { return name.first == name.second; });
  std::map<std::string, std::string> first_names;  // original names, by present names
  const auto rename = [&](const std::string& id, const std::string& name) {
    const std::string& first = first_names.contains(id) ? first_names[id] : id;
    const auto placed_by = [&](const std::string& placer) {
      return places(document ? &*document : nullptr, placer, first);
    };
    part.apply(rename_component(part, id, name, context.registry, placed_by), context.reading.progress);
    first_names[name] = first;
  };
  while (!names.empty()) {
    const Value* components = part.root().value->find("components");
    const auto is_free = [&](const auto& name) {
      return components == nullptr || components->find(name.second) == nullptr;
    };
    auto next = std::find_if(names.begin(), names.end(), is_free);
    if (next == names.end()) {
      // The names form a circle: one component gets a temporary name.
      std::string aside = names[0].first + "_";
      while (components->find(aside) != nullptr) aside += '_';
      rename(names[0].first, aside);
      names[0].first = aside;
      continue;
    }
    rename(next->first, next->second);
    names.erase(next);
  }
  return part;
}

/// Gives free names to variables of a part that have another value in the document.
LocatedTree with_own_variables(LocatedTree part, const LocatedTree& tree, const EditContext& context) {
  const Value* own = tree.root().value->find("variables");
  if (own == nullptr || own->object() == nullptr) return part;
  // Renaming a variable may change the value of another one.
  for (;;) {
    const Value* brought = part.root().value->find("variables");
    if (brought == nullptr || brought->object() == nullptr) return part;
    const auto differs = [&](const Value::Member& variable) {
      const Value* known = own->find(variable.first);
      return known != nullptr && !(*known == variable.second);
    };
    const auto other = std::find_if(brought->object()->begin(), brought->object()->end(), differs);
    if (other == brought->object()->end()) return part;
    std::string free;
    for (int k = 2; free.empty(); ++k) {
      const std::string tried = fmt::format("{}_{}", other->first, k);
      if (own->find(tried) == nullptr && brought->find(tried) == nullptr) free = tried;
    }
    const std::string name = other->first;
    const TextPatch patch = rename_variable(part, name, free, context.registry, expression_paths(part, context));
    part.apply(patch, context.reading.progress);
  }
}

struct EditMaker {
  TreeEdit& document;
  const EditContext& context;

  const LocatedTree& tree() const { return document.tree(); }

  void operator()(const SetValue& edit) const {
    std::string path = whole_path(tree(), edit.path);
    require_named(tree(), path);
    // The bare name of a variable stands for its value.
    const bool is_bare = edit.path.find_first_of(".[") == std::string::npos;
    if (is_bare && edit.value.object() == nullptr && path.starts_with("variables.")) {
      const PathTarget target = follow_path(tree(), path);
      if (target.missing.empty() && target.last().value->object() != nullptr) path += ".value";
      if (!target.missing.empty() && edit.path == path.substr(std::string_view("variables.").size())) {
        throw_missing(target, path);
      }
    }
    set_value(document, path, edit.value);
  }
  void operator()(const UnsetValue& edit) const {
    const std::string path = whole_path(tree(), edit.path);
    const PathTarget target = follow_path(tree(), path);
    if (target.missing.empty()) {
      document.take(remove_value(tree(), path));
    } else if (target.missing.front().is_index) {
      throw_missing(target, path);
    }
  }
  void operator()(const InsertValue& edit) const {
    document.take(insert_value(tree(), whole_path(tree(), edit.path), edit.value, edit.index));
  }
  void operator()(const RemoveValue& edit) const {
    const std::string path = whole_path(tree(), edit.path);
    const std::string id = named_in(tree(), path, "components");
    id.empty() ? document.take(remove_value(tree(), path)) : remove_component(document, path, id);
  }
  void operator()(const RenameValue& edit) const { document.take(renamed(edit)); }
  void operator()(const SetNote& edit) const {
    document.take(set_note(tree(), whole_path(tree(), edit.path), edit.note));
  }
  void operator()(const InsertPart& edit) const {
    LocatedTree part = with_names(LocatedTree(edit.text, context.reading.progress), edit.names, context);
    part = with_own_variables(std::move(part), tree(), context);
    insert_plant_part(document, part, {.component = edit.index, .link = edit.link_index});
  }
  void operator()(const MoveValue& edit) const { move_value(document, whole_path(tree(), edit.path), edit.index); }

 private:
  TextPatch renamed(const RenameValue& edit) const {
    const std::string path = whole_path(tree(), edit.path);
    if (const std::string id = named_in(tree(), path, "components"); !id.empty()) {
      return rename_component(tree(), id, edit.name, context.registry,
                              [&](const std::string& placer) { return places(context.document, placer, id); });
    }
    if (const std::string variable = named_in(tree(), path, "variables"); !variable.empty()) {
      return rename_variable(tree(), variable, edit.name, context.registry, expression_paths(tree(), context));
    }
    return rename_member(tree(), path, edit.name);
  }
};

}  // namespace

void make_edit(const SessionEdit& edit, TreeEdit& document, const EditContext& context) {
  std::visit(EditMaker{document, context}, edit);
}

}  // namespace meristem

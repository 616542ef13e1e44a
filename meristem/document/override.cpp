// SPDX-License-Identifier: Apache-2.0
// Sets values in the tree of a document by their paths. A path is split into names and indices; missing members are
// added, and the reader checks them later. Values of the document that lose their effect beside an override are
// removed.
#include "meristem/document/override.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include <fmt/format.h>

#include "meristem/document/json.h"
#include "meristem/document/short_forms.h"
#include "meristem/document/tables.h"

namespace meristem {

namespace {

std::vector<std::string> member_names(const Value& value) {
  std::vector<std::string> names;
  if (const Value::Object* object = value.object()) {
    for (const auto& [name, member] : *object) names.push_back(name);
  }
  return names;
}

Diagnostic unknown(const std::string& path, std::string message, const std::string& name,
                   const std::vector<std::string>& candidates) {
  Diagnostic diagnostic{.message = std::move(message), .path = path};
  diagnostic.nearest = nearest_name(name, candidates);
  if (diagnostic.nearest.empty() && !candidates.empty()) {
    diagnostic.expected = fmt::format("one of {}", fmt::join(candidates, ", "));
  }
  return diagnostic;
}

/// Returns the element of a list that `element`, for example "[2]", names. Returns null after a fault.
Value* find_element(Value& at, const std::string& element, const std::string& path,
                    std::vector<Diagnostic>& diagnostics) {
  std::size_t index = 0;
  const char* const end = element.data() + element.size() - 1;
  const auto parsed = std::from_chars(element.data() + 1, end, index);
  Value::List* list = at.list();
  if (parsed.ec == std::errc() && parsed.ptr == end && list != nullptr && index < list->size()) return &(*list)[index];
  Diagnostic diagnostic{.message = fmt::format("there is no element {} in {}", element, at.description()),
                        .path = path};
  if (list != nullptr && !list->empty()) diagnostic.expected = fmt::format("[0] to [{}]", list->size() - 1);
  diagnostics.push_back(std::move(diagnostic));
  return nullptr;
}

/// Returns the member of that name and adds it if it is missing. Returns null after a fault if the value cannot have
/// members.
Value* find_or_add_member(Value& at, const std::string& name, const std::string& path,
                          std::vector<Diagnostic>& diagnostics) {
  if (Value* member = at.find(name)) return member;
  if (at.is_null()) at = Value(Value::Object{});
  if (at.object() == nullptr) {
    diagnostics.push_back({.message = fmt::format("{} has no member '{}'", at.description(), name), .path = path});
    return nullptr;
  }
  return &at.object()->emplace_back(name, Value()).second;
}

/// Returns true if the component or variable of a path exists. All other names are added here and checked by the
/// reader.
bool is_known(const Value& root, const std::vector<std::string>& elements, const std::string& path,
              std::vector<Diagnostic>& diagnostics) {
  if (elements.size() < 2 || (elements[0] != "components" && elements[0] != "variables")) return true;
  const Value* const named = root.find(elements[0]);
  if (named != nullptr && named->find(elements[1]) != nullptr) return true;
  const std::vector<std::string> names = named == nullptr ? std::vector<std::string>() : member_names(*named);
  diagnostics.push_back(
      unknown(path, fmt::format("there is no {} '{}'", elements[0].substr(0, elements[0].size() - 1), elements[1]),
              elements[1], names));
  return false;
}

}  // namespace

std::vector<std::string> path_elements(const std::string& path) {
  std::vector<std::string> elements;
  if (path.starts_with('[')) return elements;
  std::size_t at = 0;
  while (at < path.size()) {
    const bool is_index = path[at] == '[';
    std::size_t end = is_index ? path.find(']', at) : path.find_first_of(".[", at);
    if (is_index && end == std::string::npos) return {};
    end = is_index ? end + 1 : std::min(end, path.size());
    if (end == at) return {};
    elements.push_back(path.substr(at, end - at));
    at = end;
    if (at == path.size() || path[at] == '[') continue;
    if (path[at] != '.' || ++at == path.size() || path[at] == '[') return {};
  }
  return elements;
}

std::string full_path(const Value& root, const std::string& path) {
  const std::vector<std::string> elements = path_elements(path);
  const std::vector<std::string> keys = head_table().names();
  const bool is_key = std::find(keys.begin(), keys.end(), elements[0]) != keys.end();
  if (elements.size() == 1) {
    const Value* variables = root.find("variables");
    const Value* variable = variables == nullptr ? nullptr : variables->find(path);
    if (variable == nullptr) return is_key ? path : "variables." + path;
    return variable->object() == nullptr ? "variables." + path : "variables." + path + ".value";
  }
  return is_key ? path : "components." + path;
}

Value* find_or_add(Value& root, const std::string& path, const std::string& place,
                   std::vector<Diagnostic>& diagnostics) {
  const std::vector<std::string> elements = path_elements(path);
  return is_known(root, elements, place, diagnostics) ? find_or_add_below(root, elements, place, diagnostics) : nullptr;
}

Value* find_or_add_below(Value& value, std::span<const std::string> elements, const std::string& place,
                         std::vector<Diagnostic>& diagnostics) {
  Value* at = &value;
  for (std::size_t k = 0; k < elements.size() && at != nullptr; ++k) {
    at = elements[k][0] == '[' ? find_element(*at, elements[k], place, diagnostics)
                               : find_or_add_member(*at, elements[k], place, diagnostics);
  }
  return at;
}

namespace {

/// Removes a member if it exists.
void remove_member(Value& root, const std::string& path, std::vector<Diagnostic>& diagnostics) {
  const std::vector<std::string> elements = path_elements(path);
  if (!is_known(root, elements, path, diagnostics)) return;
  Value* at = &root;
  for (std::size_t k = 0; k + 1 < elements.size() && at != nullptr; ++k) {
    at = elements[k][0] == '[' ? find_element(*at, elements[k], path, diagnostics) : at->find(elements[k]);
  }
  if (at == nullptr || at->object() == nullptr) return;
  std::erase_if(*at->object(), [&](const Value::Member& member) { return member.first == elements.back(); });
}

/// Adds an override in the form of `--set`. Replaces an earlier value of that path.
void note_set(const ValueOverride& override, std::vector<std::string>& sets) {
  const std::string path = override.path + "=";
  std::erase_if(sets, [&path](const std::string& set) { return set.starts_with(path); });
  sets.push_back(path + write_json_line(override.value));
}

}  // namespace

ValueOverride parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string path(text.substr(0, equals));
  if (equals == std::string_view::npos || equals == 0) {
    throw InputError(Diagnostic{.message = fmt::format("'{}' sets nothing", text),
                                .expected = "NAME=VALUE, such as age=20, stem.length=2 or links[1].density=90"});
  }
  const std::string written(text.substr(equals + 1));
  try {
    return {path, parse_json(written), "--set " + path};
  } catch (const InputError&) {
    return {path, Value(written), "--set " + path};
  }
}

void apply_overrides(Value& root, const std::vector<ValueOverride>& overrides, DocumentOrigin& source,
                     std::vector<Diagnostic>& diagnostics, const Registry* registry) {
  for (const ValueOverride& override : overrides) {
    note_set(override, source.sets);
    const bool is_path = !path_elements(override.path).empty();
    const std::string path = is_path ? full_path(root, override.path) : override.path;
    source.overridden.push_back(path);
    source.override_names.push_back(override.name.empty() ? "set " + override.path : override.name);
    if (!is_path) {
      diagnostics.push_back({.message = fmt::format("'{}' is not a path", path),
                             .expected = "one such as age, stem.length or links[1].density",
                             .path = path});
      continue;
    }
    if (registry != nullptr) write_out_short_forms(root, *registry, path_elements(path));
    if (override.value.is_null()) {
      remove_member(root, path, diagnostics);
    } else if (Value* target = find_or_add(root, path, path, diagnostics)) {
      *target = override.value;
    }
  }
}

namespace {

/// Returns the part of a path that names a component, a link or a top-level key: "components.view" of
/// "components.view.position[0]", "links[1]" of "links[1].angle", "scene" of "scene.latitude".
std::string part_of(const std::string& path) {
  const std::size_t first = path.find('.');
  return path.substr(0, path.starts_with("components.") ? path.find_first_of(".[", first + 1) : first);
}

}  // namespace

bool give_way(Value& root, const std::vector<ParameterReader::Meaningless>& meaningless,
              const std::vector<std::string>& overridden) {
  if (overridden.empty()) return false;
  const auto contains = [](const std::string& outer, const std::string& inner) {
    return inner.starts_with(outer) && (inner.size() == outer.size() || std::strchr(".[", inner[outer.size()]));
  };
  const auto is_set = [&](const std::string& path) {
    return std::ranges::any_of(overridden, [&](const auto& set) { return contains(set, path) || contains(path, set); });
  };
  bool any = false;
  for (const auto& [path, other] : meaningless) {
    const std::string& weaker = is_set(path) ? other : path;
    const auto is_beside = [&weaker](const auto& set) { return part_of(set) == part_of(weaker); };
    if (weaker.empty() || is_set(weaker) || std::ranges::none_of(overridden, is_beside)) continue;
    std::vector<Diagnostic> none;
    remove_member(root, weaker, none);
    any = true;
  }
  return any;
}

}  // namespace meristem

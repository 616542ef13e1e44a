// SPDX-License-Identifier: Apache-2.0
// Tests that no parameter is ignored silently. In each of the small documents of this folder, a different value of any
// parameter must change the result or be rejected. Every parameter must change something in at least one document. A
// document tests the parameters of its component "subject" with nested tables. The document "links" tests all links,
// "scene" the scene, and "head" the rest of the top level.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/json.h"
#include "meristem/document/tables.h"
#include "tests/rows/hash_of_result.h"
#include "tests/rows/other_values.h"

namespace meristem {
namespace {

/// Parameters that may have no effect, with the reason.
const std::map<std::string, std::string>& exceptions() {
  static const std::map<std::string, std::string> reasons = {
      {"a document.meristem", "there is one version of the format"},
      {"a document.name", "what it is called is for people and files' names"},
      {"a document.description", "for people"},
      {"a document.author", "for people, carried into files"},
      {"a document.licence", "for people, carried into files"},
      {"an obstacle.broken", "what is not closed is refused without it"},
      {"an operation.do", "other kinds have other keys"},
      {"a hyperpatch.degree", "another degree has another number of control points"},
      {"a support.line", "supports stand under their names, among which the walk does not go"},
      {"limits.diagnostics", "counts faults, of which a sound document has none"},
  };
  return reasons;
}

/// Parameters whose effect depends on other tables, with the reason why they may have no effect in one document.
const std::map<std::string, std::string>& circumstances() {
  static const std::map<std::string, std::string> reasons = {
      {"a component.alone", "there may be nobody to compete with"},
      {"an organize.every", "as alone"},
      {"a cloud.roots", "points of a file are all of one tree"},
      {"a cloud.removed_colour", "no point may be removed"},
      {"points.count", "a cloud may show the points that growth has left"},
      {"points.blue_noise", "as count"},
      {"points.file", "as count"},
      {"a limit.share", "as points.count"},
      {"a component.variety", "a body of many stems has one colour"},
      {"a tree.trim", "no body may stand above"},
      {"a trim.off", "no trim may stand above"},
      {"a horn.trim", "as with a tree"},
      {"an lsystem.trim", "as with a tree"},
      {"a colonize.trim", "as with a tree"},
      {"an organize.trim", "as with a tree"},
      {"a skeleton.trim", "as with a tree"},
      {"a surface.cap", "a stem may end where it is cut"},
      {"a surface.error", "a stem may have no section to spare"},
      {"a surface.collar", "a stem may have no branches"},
      {"a surface.flare", "a stem may stand on another"},
      {"an lsystem.palette", "a grammar may draw no polygons"},
      {"an lsystem.thinner", "a grammar may have no ! without a parameter"},
      {"a decay.trunk", "a grammar may set the widths itself"},
      {"a decay.branch", "as trunk"},
      {"an organize.laterals_wait", "no lateral bud may be ready before its terminal one"},
      {"an organize.summer", "no operation may act in summer"},
      {"an organize.terminal_threshold", "all terminal buds may have enough, or none"},
      {"a resource model.laterals", "no axis may have so many"},
      {"a resource model.lambda_curve", "it may change shares that make no metamer more or less"},
      {"a resource model.pass_back", "terminal buds may be cut that claim nothing"},
      {"an organize.takeover", "no bud beside a cut may open"},
      {"a sequence.speed", "the clock may not have started"},
      {"a sequence.waits", "the clock may have started"},
      {"MTG features.x", "a table has columns of its own"},
      {"MTG features.y", "as x"},
      {"MTG features.z", "as x"},
      {"MTG features.diameter", "as x"},
      {"a skeleton.scale", "a table has no scales"},
      {"a skeleton file.scale", "a table has no scales"},
      {"a skeleton.pipe_exponent", "all nodes may have radii"},
      {"a skeleton.tip_radius", "all nodes may have radii"},
      {"an operation.from", "there may be nothing to do then"},
      {"an operation.every", "as from"},
      {"an operation.to", "as from"},
      {"an operation.off", "as from"},
      {"an operation.once", "it may find nothing to do a second time"},
      {"an operation.leader", "no shoot may be there to take the lead"},
      {"a bud to cut to.window", "there may be one bud that faces the right way"},
      {"shedding.below", "no shoot may be old enough"},
      {"stages.load", "a switch may stand where there is nothing to switch off, as all stages"},
      {"stages.fit", "as stages.load"},
      {"stages.age", "as stages.load"},
      {"stages.vary", "as stages.load"},
      {"stages.bend", "as stages.load"},
      {"stages.reduce", "as stages.load"},
      {"stages.blade", "as stages.load"},
  };
  return reasons;
}

struct Base {
  std::string name;
  std::string file;
  std::string text;
  Value tree;
};

std::vector<Base> base_documents() {
  std::vector<Base> bases;
  for (const auto& entry : std::filesystem::directory_iterator(MERISTEM_ROWS)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream stream(entry.path());
    Base& base = bases.emplace_back();
    base.name = entry.path().stem().string();
    base.file = entry.path().string();
    base.text.assign(std::istreambuf_iterator<char>(stream), {});
    base.tree = parse_json(base.text);
  }
  std::sort(bases.begin(), bases.end(), [](const Base& a, const Base& b) { return a.name < b.name; });
  return bases;
}

/// Returns the name of a parameter: table and parameter. Parameters that all components share count as one table.
std::string name_of(const ParameterTable& table, const Parameter& row) {
  const bool is_shared = component_base_table().find(row.name) != nullptr || row.name == "alone";
  const bool is_component = table.find("recursion") != nullptr;
  return (is_component && is_shared ? "a component" : table.name) + "." + row.name;
}

const Value* member(const Value* value, std::string_view name) {
  return value == nullptr ? nullptr : value->find(name);
}

/// Tests all parameters of the tables of a document.
class RowWalk {
 public:
  RowWalk(const Base& base, std::set<std::string>& changing)
      : base_(base), changing_(changing), hash_(*result_with({})) {}

  void run() {
    if (base_.name.starts_with("links")) {
      const Value::List& links = *base_.tree.find("links")->list();
      for (std::size_t k = 0; k < links.size(); ++k) {
        if (links[k].object() == nullptr) continue;
        const Value* kind = links[k].find("kind");
        const bool is_crown = kind != nullptr && *kind == Value("crown");
        walk(is_crown ? crown_placement_table() : placement_table(), "links[" + std::to_string(k) + "]", &links[k]);
      }
    } else if (base_.name.starts_with("scene")) {
      walk(head_table().find("scene")->nested(), "scene", base_.tree.find("scene"));
    } else if (base_.name.starts_with("head")) {
      walk_head();
    } else {
      const Value* subject = base_.tree.find("components")->find("subject");
      const std::string& type = *subject->find("type")->text();
      walk(builtin_components().find(type)->parameters, "components.subject", subject);
    }
  }

 private:
  enum class Outcome { changes, refused, silent, unfit };

  void walk_head() {
    for (const Parameter& row : head_table().parameters) {
      if (row.name == "scene") continue;
      if (row.nested != nullptr) {
        walk(row.nested(), row.name, base_.tree.find(row.name));
      } else {
        try_row(name_of(head_table(), row), row, row.name, Value());
      }
    }
    walk(limits_table(), "limits", base_.tree.find("limits"));
  }

  /// Returns the table of a list element, which depends on its kind if there are several kinds.
  static const ParameterTable& table_of(const Parameter& list, const Value& element) {
    if (list.kinds == nullptr) return list.nested();
    const ElementKinds& kinds = list.kinds();
    const auto of_element = [&](const ElementKinds::Kind& kind) {
      return *element.find(kinds.key) == Value(kind.name);
    };
    return std::find_if(kinds.kinds.begin(), kinds.kinds.end(), of_element)->table();
  }

  void walk(const ParameterTable& table, const std::string& path, const Value* given, const std::string& called = {}) {
    const std::vector<Value> defaults = table.defaults();
    for (std::size_t k = 0; k < table.parameters.size(); ++k) {
      const Parameter& row = table.parameters[k];
      const Value* present = member(given, row.name);
      walk_row(row, called.empty() ? name_of(table, row) : called + "." + row.name, path + "." + row.name, present,
               defaults[k]);
    }
  }

  void walk_row(const Parameter& row, const std::string& name, const std::string& path, const Value* present,
                const Value& usual) {
    if (row.kind == ParameterKind::object) {
      // Skip values that are missing or written in short form.
      const bool is_short = present != nullptr && present->object() == nullptr;
      if (!is_short && !(present == nullptr && usual.is_null())) walk(row.nested(), path, present);
    } else if (row.kind == ParameterKind::list) {
      if (present == nullptr) return;
      for (std::size_t k = 0; k < present->list()->size(); ++k) {
        const Value& element = (*present->list())[k];
        walk(table_of(row, element), path + "[" + std::to_string(k) + "]", &element, row.nested().name);
      }
    } else if (row.kind == ParameterKind::map) {
      if (present == nullptr) return;
      for (const auto& [key, element] : *present->object()) {
        if (element.object() != nullptr) walk(row.nested(), path + "." + key, &element);
      }
    } else {
      try_row(name, row, path, present != nullptr ? *present : usual);
    }
  }

  void try_row(const std::string& name, const Parameter& row, const std::string& path, const Value& present) {
    if (exceptions().contains(name)) return;
    Outcome outcome = Outcome::unfit;
    said_.clear();
    for (const Value& value : other_values(name, row, present)) {
      const Outcome found = outcome_of(path, value);
      if (found == Outcome::unfit) continue;
      outcome = found;
      if (found != Outcome::silent) break;
    }
    if (outcome == Outcome::changes) changing_.insert(name);
    if (outcome == Outcome::silent && !circumstances().contains(name))
      ADD_FAILURE() << base_.name << ": " << path << " changes nothing";
    if (outcome == Outcome::unfit) ADD_FAILURE() << base_.name << ": no value fits " << path << "; " << said_;
  }

  Outcome outcome_of(const std::string& path, const Value& value) {
    try {
      return *result_with({{path, value, ""}}) == hash_ ? Outcome::silent : Outcome::changes;
    } catch (const InputError& error) {
      said_ = error.what();
    }
    const auto says = [this](const char* words) { return said_.find(words) != std::string::npos; };
    // A limit that stops growth has an effect.
    if (path.starts_with("limits.")) return Outcome::changes;
    const bool is_refused = says("no meaning") || says("more than one of") || says("both a density and a count") ||
                            says("belongs to branch links") || says("given both by") || says("has no 'crown'") ||
                            says("only one of") || says("there is no colonize") || says("counts no steps") ||
                            says("knows no time");
    return is_refused ? Outcome::refused : Outcome::unfit;
  }

  std::optional<std::uint64_t> result_with(const std::vector<ValueOverride>& overrides) const {
    return hash_of_result(read_document(base_.text, base_.file, builtin_components(), {.overrides = overrides}));
  }

  const Base& base_;
  std::set<std::string>& changing_;
  std::uint64_t hash_ = 0;
  std::string said_;
};

void add_names(const ParameterTable& table, std::set<std::string>& names) {
  for (const Parameter& row : table.parameters) {
    const std::string name = name_of(table, row);
    const bool is_new = names.insert(name).second;
    if (row.nested != nullptr) names.erase(name);
    if (row.nested != nullptr && is_new && &row.nested() != &table) add_names(row.nested(), names);
  }
}

TEST(EveryRow, ChangesTheResultOrIsRefused) {
  std::set<std::string> changing;
  for (const Base& base : base_documents()) {
    try {
      RowWalk(base, changing).run();
    } catch (const InputError& error) {
      ADD_FAILURE() << base.name << ": " << error.what();
    }
  }
  std::set<std::string> names;
  for (const ComponentType& type : builtin_components().types()) add_names(type.parameters, names);
  add_names(placement_table(), names);
  add_names(crown_placement_table(), names);
  add_names(head_table(), names);
  add_names(limits_table(), names);
  for (const std::string& name : names) {
    if (changing.contains(name) || exceptions().contains(name)) continue;
    ADD_FAILURE() << name << " changes nothing in any of the documents";
  }
}

}  // namespace
}  // namespace meristem

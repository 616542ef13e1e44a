// SPDX-License-Identifier: Apache-2.0
// Reads a plan: its tables, the parts without a table, and its documents. Checks whether values suit the documents.
// Each value is tried on each document with the first value of everything else, so that a fault names the value that
// caused it.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "meristem/base/limits.h"
#include "meristem/base/read_file.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/plan_parts.h"
#include "meristem/dataset/plan_tables.h"
#include "meristem/dataset/plant_output.h"
#include "meristem/document/json.h"
#include "meristem/document/locate.h"
#include "meristem/document/models.h"
#include "meristem/document/override.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/within_root.h"
#include "meristem/measure/measures.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPlanDocuments = 1000;
constexpr std::size_t kMaxTries = 200;  // number of values that are tried on a document
constexpr char kFromPlan = '\x1f';      // begins the name of a value that the plan sets; the value's path follows

/// Adds values of a plan as overrides of a document. The name of each override is its position in the plan.
void add_overrides(const PathValues& values, const std::string& place, std::vector<ValueOverride>& overrides) {
  for (const auto& [path, value] : values) overrides.push_back({path, value, kFromPlan + place + "." + path});
}

class PlanReader {
 public:
  PlanReader(const std::string& text, const std::string& file, const Registry& registry, const PlanOptions& options)
      : text_(text), file_(file), registry_(registry), options_(options), reader_({}, SizeLimits()) {}

  DatasetPlan run() {
    plan_.tree = parse_json_of(text_, file_);
    if (plan_.tree.object() == nullptr) {
      throw InputError(Diagnostic{.message = fmt::format("the plan is {}", plan_.tree.description()),
                                  .expected = "an object with \"meristem_dataset\": 1",
                                  .file = file_});
    }
    read_head();
    if (const Value* seeds = plan_.tree.find("seeds")) {
      read_plan_seeds(*seeds, DocumentPath(top_, "seeds"), reader_, plan_);
    }
    read_values();
    read_files();
    read_measures();
    if (plan_.files.empty() && plan_.measures.empty() && !plan_.pictures && reader_.error_count() == 0) {
      reader_.add_error(top_, "the plan keeps nothing of its plants",
                        "one or more of \"files\", \"pictures\" and \"measures\"");
    }
    if (reader_.error_count() == 0) read_documents();
    if (reader_.error_count() == 0 && others_.empty()) check_count();
    finish();
    return std::move(plan_);
  }

 private:
  void read_head() {
    reader_.read(plan_table(), &head_, plan_.tree, top_);
    plan_.name = head_.name;
    plan_.description = head_.description;
    plan_.author = head_.author;
    plan_.licence = head_.licence;
    plan_.seed = head_.seed;
    plan_.rows = head_.rows;
    plan_.time = head_.time;
    plan_.pictures = head_.pictures;
    const Value* const given = plan_.tree.find("pictures");
    if (plan_.pictures && given != nullptr && given->object() != nullptr) {
      read_plan_views(*given, DocumentPath(top_, "pictures"), reader_, *plan_.pictures);
    }
  }

  /// Reads an object of paths and values. Reports a fault for any other value and returns nothing.
  std::optional<PathValues> paths_and_values(const Value& given, const DocumentPath& path, std::string_view what) {
    if (given.object() == nullptr) {
      reader_.add_error(path, fmt::format("{} {}", what, given.description()),
                        "an object of values by their paths, such as {\"age\": 20}");
      return std::nullopt;
    }
    PathValues values;
    for (const auto& [name, value] : *given.object()) {
      const DocumentPath own(path, name);
      if (name == "seed") {
        reader_.add_name_error(own, "seeds are not set by a value", "\"seeds\" of the plan", "");
      } else if (path_elements(name).empty()) {
        reader_.add_name_error(own, fmt::format("'{}' is not a path", name),
                               "one such as age, stem.length or links[1].density", "");
      } else {
        values.emplace_back(name, value);
      }
    }
    return values;
  }

  void read_values() {
    if (const Value* set = plan_.tree.find("set")) {
      if (auto values = paths_and_values(*set, DocumentPath(top_, "set"), "the set values are")) plan_.set = *values;
    }
    const Value* const grid = plan_.tree.find("grid");
    const Value* const samples = plan_.tree.find("samples");
    if (grid != nullptr && samples != nullptr) {
      reader_.add_name_error(DocumentPath(top_, "samples"), "a plan has a grid or samples, not both", "one of them",
                             "");
      return;
    }
    if (grid != nullptr) read_grid(*grid, DocumentPath(top_, "grid"));
    if (samples != nullptr) read_samples(*samples, DocumentPath(top_, "samples"));
    const Value* const vary = plan_.tree.find("vary");
    if (vary == nullptr) return;
    const DocumentPath path(top_, "vary");
    const auto given = paths_and_values(*vary, path, "the distributions are");
    if (!given) return;
    for (const auto& [name, value] : *given) {
      const DocumentPath own(path, name);
      if (std::find(plan_.columns.begin(), plan_.columns.end(), name) != plan_.columns.end()) {
        reader_.add_name_error(own, fmt::format("'{}' has a distribution and other values as well", name),
                               "one of them", "");
      }
      if (auto variation = read_variation(value, own, reader_)) {
        vary_.emplace_back(name, std::move(*variation));
        plan_.columns.push_back(name);
      }
    }
  }

  void read_grid(const Value& grid, const DocumentPath& path) {
    const auto given = paths_and_values(grid, path, "the grid is");
    if (!given) return;
    for (const auto& [name, values] : *given) {
      if (values.list() == nullptr || values.list()->empty()) {
        reader_.add_error(DocumentPath(path, name),
                          fmt::format("a path of the grid cannot have {}", values.description()),
                          "a list of at least one value");
        continue;
      }
      plan_.grid.emplace_back(name, *values.list());
      plan_.columns.push_back(name);
    }
  }

  void read_samples(const Value& samples, const DocumentPath& path) {
    if (samples.list() == nullptr || samples.list()->empty()) {
      reader_.add_error(path, fmt::format("the samples are {}", samples.description()),
                        "a list of objects, such as [{\"age\": 20}, {\"age\": 40}]");
      return;
    }
    std::set<std::string> known;
    for (std::size_t k = 0; k < samples.list()->size(); ++k) {
      auto values = paths_and_values((*samples.list())[k], DocumentPath(path, k), "a sample cannot be");
      if (!values) continue;
      for (const auto& [name, value] : *values) {
        if (known.insert(name).second) plan_.columns.push_back(name);
      }
      plan_.samples.push_back(std::move(*values));
    }
  }

  void read_files() {
    const Value* const given = plan_.tree.find("files");
    if (given == nullptr) return;
    const DocumentPath path(top_, "files");
    if (given->list() == nullptr) {
      reader_.add_error(path, fmt::format("the files are {}", given->description()),
                        "a list of endings, such as [\".glb\", \".mtg\"]");
      return;
    }
    std::vector<std::string> endings;
    for (const PlantOutput& output : plant_outputs()) endings.push_back(output.ending);
    for (std::size_t k = 0; k < given->list()->size(); ++k) {
      const Value& element = (*given->list())[k];
      const DocumentPath own(path, k);
      const Value* const said = element.object() == nullptr ? &element : element.find("ending");
      if (said == nullptr || said->text() == nullptr) {
        reader_.add_error(own, fmt::format("a file cannot be {}", element.description()),
                          "an ending such as \".glb\", or an object with \"ending\" and settings");
        continue;
      }
      std::string ending = lower_case(*said->text());
      if (!ending.starts_with('.')) ending.insert(0, ".");
      const PlantOutput* const output = find_plant_output(ending);
      if (output == nullptr) {
        reader_.add_error(element.object() == nullptr ? own : DocumentPath(own, "ending"),
                          fmt::format("'{}' is not a format that can be written", *said->text()),
                          fmt::format("one of {}", fmt::join(endings, ", ")), nearest_name(ending, endings));
        continue;
      }
      const auto is_it = [output](const PlannedFile& file) { return file.output == output; };
      if (std::any_of(plan_.files.begin(), plan_.files.end(), is_it)) {
        reader_.add_error(own, fmt::format("'{}' stands twice", ending), "each ending once");
      }
      plan_.files.push_back({output, settings_of(*output, element, own)});
    }
  }

  /// Returns the settings of an element of `files` beside its ending.
  Value settings_of(const PlantOutput& output, const Value& element, const DocumentPath& path) {
    if (element.object() == nullptr) return {};
    Value settings = element;
    std::erase_if(*settings.object(), [](const Value::Member& member) { return member.first == "ending"; });
    std::vector<std::string> names;
    if (output.settings != nullptr) names = output.settings().names();
    for (const auto& [name, value] : *settings.object()) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      reader_.add_name_error(
          DocumentPath(path, name), fmt::format("'{}' is no setting of {} files", name, output.ending),
          names.empty() ? "no settings" : fmt::format("one of {}", fmt::join(names, ", ")), nearest_name(name, names));
      return {};
    }
    if (output.check) {
      try {
        output.check(settings);
      } catch (const InputError& error) {
        for (const Diagnostic& found : error.diagnostics()) {
          reader_.add_error(found.path.empty() ? path : DocumentPath(path, found.path), found.message, found.expected,
                            found.nearest);
        }
      }
    }
    return settings;
  }

  void read_measures() {
    const Value* const given = plan_.tree.find("measures");
    if (given == nullptr) return;
    const DocumentPath path(top_, "measures");
    std::vector<std::string> names;
    for (const MeasureRow& row : measure_rows()) names.emplace_back(row.name);
    if (given->text() != nullptr && *given->text() == "all") {
      // The light on leaves takes longer than all other measures, so it must be requested by name.
      for (const MeasureRow& row : measure_rows()) {
        if (!row.needs_light) plan_.measures.emplace_back(row.name);
      }
      return;
    }
    if (given->list() == nullptr) {
      reader_.add_error(path, fmt::format("the measures are {}", given->description()),
                        "a list of names, such as [\"height\", \"leaf_area\"], or \"all\"");
      return;
    }
    for (std::size_t k = 0; k < given->list()->size(); ++k) {
      const Value& element = (*given->list())[k];
      const bool is_known =
          element.text() != nullptr && std::find(names.begin(), names.end(), *element.text()) != names.end();
      if (!is_known) {
        reader_.add_error(DocumentPath(path, k), fmt::format("there is no measure that is {}", element.description()),
                          fmt::format("one of {}", fmt::join(names, ", ")),
                          element.text() == nullptr ? "" : nearest_name(*element.text(), names));
      } else if (std::find(plan_.measures.begin(), plan_.measures.end(), *element.text()) == plan_.measures.end()) {
        plan_.measures.push_back(*element.text());
      }
    }
  }

  // Documents.

  struct Named {
    std::string file;  // path of the file that was found
    std::string root;  // folder that limits the files that it may name
    std::string text;
    std::string name;
    PathValues set;
    std::string place;  // position in the plan
  };

  DocumentFile path_of(const std::string& file) const {
    if (file.find_first_of("./") == std::string::npos) {
      const fs::path beside = fs::path(file_).parent_path() / file;
      std::error_code error;
      const bool is_beside = is_within_root(beside.string(), options_.root) && fs::is_regular_file(beside, error);
      return find_document_within(is_beside ? beside.string() : file, options_.models, options_.root);
    }
    const std::string path = (fs::path(file_).parent_path() / file).string();
    FileAccess{.root = options_.root}.require_within(path);
    return {path, options_.root};
  }

  std::vector<Named> named_documents() {
    std::vector<Named> named;
    if (!options_.documents.empty()) {
      for (const GivenDocument& given : options_.documents) {
        const std::string stem = given.file.starts_with('<') ? "document" : fs::path(given.file).stem().string();
        named.push_back(
            {given.file, options_.root, given.text, given.name.empty() ? stem : given.name, given.set, "documents"});
      }
      return named;
    }
    const DocumentPath path(top_, "documents");
    const Value* const list = plan_.tree.find("documents");
    for (std::size_t k = 0; k < head_.documents.size(); ++k) {
      const PlanDocument& document = head_.documents[k];
      const DocumentPath own(path, k);
      Named one{.file = {}, .root = {}, .text = {}, .name = document.name, .set = {}, .place = own.text()};
      if (one.name.empty()) one.name = fs::path(document.file).stem().string();
      try {
        const DocumentFile found = path_of(document.file);
        one.file = found.file;
        one.root = found.root;
        if (std::error_code ignored; !fs::exists(one.file, ignored)) read_file(one.file, SizeLimits().file_bytes);
        one.text = read_text_file(one.file);
      } catch (const InputError& error) {
        const Diagnostic& first = error.diagnostics().front();
        const fs::path nearest = fs::path(first.nearest).lexically_relative(fs::path(file_).parent_path());
        reader_.add_error(own, first.message, first.expected, nearest.empty() ? first.nearest : nearest.string());
        continue;
      } catch (const MachineError& error) {
        reader_.add_error(own, error.what(), "a document, or the name of a shipped model");
        continue;
      }
      if (const Value* set = (*list->list())[k].find("set")) {
        if (auto values = paths_and_values(*set, DocumentPath(own, "set"), "the set values are")) one.set = *values;
      }
      named.push_back(std::move(one));
    }
    return named;
  }

  void read_documents() {
    const DocumentPath path(top_, "documents");
    std::vector<Named> named = named_documents();
    if (reader_.error_count() > 0) return;
    if (named.empty()) {
      return reader_.add_error(top_, "the plan has no documents", "a list such as \"documents\": [\"oak\"]");
    }
    if (named.size() > kMaxPlanDocuments) {
      return reader_.add_error(path, fmt::format("{} documents are too many", named.size()),
                               fmt::format("at most {}", kMaxPlanDocuments));
    }
    std::set<std::string> names;
    for (Named& one : named) {
      one.name = file_word(one.name);
      if (!names.insert(one.name).second) {
        reader_.add_error(path, fmt::format("two documents are called '{}'", one.name), "a \"name\" for one of them");
        continue;
      }
      read_document_of(one);
    }
    check_columns();
    tell_documents(named);
  }

  void read_document_of(const Named& named) {
    PlannedDocument planned{.name = named.name, .set = named.set, .bundle = {}, .file = named.file, .vary = vary_};
    const std::optional<Document> document = tried(named, planned, first_values());
    if (!document) return;
    planned.bundle = bundle_of(*document, options_.models);
    planned.title = document->name;
    planned.licence = document->licence;
    for (const Diagnostic& warning : document->warnings) plan_.warnings.push_back(warning);
    for (auto& [path, variation] : planned.vary) bound(path, variation, *document);
    if (reader_.error_count() == 0) try_values(named, planned);
    plan_.documents.push_back(std::move(planned));
  }

  /// Limits a distribution without bounds of its own to the range of the document's variable.
  void bound(const std::string& path, ValueVariation& variation, const Document& document) {
    const bool is_bounded = variation.low || variation.kind == ValueVariation::Kind::choice;
    for (const Variable& variable : document.variables) {
      if (is_bounded || variable.name != path || !(variable.min < variable.max)) continue;
      const Value* const said = document.source.tree.find("variables")->find(path);
      if (said->find("min") != nullptr) variation.low = variable.min;
      if (said->find("max") != nullptr) variation.high = variable.max;
    }
    if (variation.share_within() >= kMinShareWithin) return;
    const DocumentPath vary(top_, "vary");
    const double inf = std::numeric_limits<double>::infinity();
    reader_.add_error(DocumentPath(vary, path),
                      fmt::format("less than a hundredth of this distribution lies from {} to {}",
                                  variation.low.value_or(-inf), variation.high.value_or(inf)),
                      "a distribution within the range of the variable, or bounds in \"within\"");
  }

  /// Returns the first value of everything. Each override is named by its position in the plan.
  std::vector<ValueOverride> first_values() const {
    std::vector<ValueOverride> overrides;
    add_overrides(plan_.set, "set", overrides);
    for (const auto& [path, values] : plan_.grid) {
      overrides.push_back({path, values[0], fmt::format("{}grid.{}[0]", kFromPlan, path)});
    }
    if (!plan_.samples.empty()) add_overrides(plan_.samples[0], "samples[0]", overrides);
    return overrides;
  }

  /// Returns the document with these values. Reports faults and returns nothing if there are any.
  std::optional<Document> tried(const Named& named, const PlannedDocument& planned, std::vector<ValueOverride> values) {
    std::vector<ValueOverride> overrides;
    add_overrides(planned.set, named.place + ".set", overrides);
    // A later value replaces an earlier value of an equal path.
    for (ValueOverride& value : values) {
      std::erase_if(overrides, [&](const ValueOverride& earlier) { return earlier.path == value.path; });
      overrides.push_back(std::move(value));
    }
    try {
      return read_document(named.text, named.file, registry_,
                           {.overrides = std::move(overrides),
                            .time = plan_.time,
                            .root = named.root,
                            .store = &store_,
                            .models = options_.models});
    } catch (const InputError& error) {
      for (const Diagnostic& found : error.diagnostics()) add_error(found, named);
      return std::nullopt;
    }
  }

  /// Adds a fault of a document. If the plan has set the faulty value, the fault is placed there.
  void add_error(Diagnostic error, const Named& named) {
    if (error.severity != Severity::error) return;
    if (!error.file.starts_with(kFromPlan)) {
      others_.push_back(std::move(error));
      return;
    }
    const std::string place = error.file.substr(1);
    error.message = fmt::format("{} in the document '{}': {}", error.path, named.name, error.message);
    error.path = place;
    error.file.clear();
    error.text_offset = -1;
    error.line = error.column = 0;
    const auto is_equal = [&](const Diagnostic& other) {
      return other.path == error.path && other.message == error.message;
    };
    if (std::none_of(own_.begin(), own_.end(), is_equal)) own_.push_back(std::move(error));
  }

  void try_values(const Named& named, const PlannedDocument& planned) {
    std::size_t tries = 0;
    const auto attempt = [&](const std::string& path, const Value& value, const std::string& place) {
      if (tries++ >= kMaxTries) return;
      std::vector<ValueOverride> values = first_values();
      std::erase_if(values, [&](const ValueOverride& other) { return other.path == path; });
      values.push_back({path, value, kFromPlan + place});
      tried(named, planned, std::move(values));
    };
    for (const auto& [path, variation] : planned.vary) {
      for (const Value& end : variation.ends()) attempt(path, end, "vary." + path);
    }
    for (const auto& [path, values] : plan_.grid) {
      for (std::size_t k = 1; k < values.size(); ++k) attempt(path, values[k], fmt::format("grid.{}[{}]", path, k));
    }
    for (std::size_t k = 1; k < plan_.samples.size() && tries < kMaxTries; ++k, ++tries) {
      std::vector<ValueOverride> values;
      add_overrides(plan_.set, "set", values);
      add_overrides(plan_.samples[k], fmt::format("samples[{}]", k), values);
      tried(named, planned, std::move(values));
    }
  }

  /// Checks that the values of one path come from one part of the plan.
  void check_columns() {
    for (const auto& [path, value] : plan_.set) {
      if (std::find(plan_.columns.begin(), plan_.columns.end(), path) == plan_.columns.end()) continue;
      const DocumentPath set(top_, "set");
      reader_.add_name_error(DocumentPath(set, path),
                             fmt::format("'{}' is set and differs from plant to plant as well", path), "one of them",
                             "");
    }
  }

  /// Puts the names of the documents into the plan's tree. Plans are compared without the positions of their documents.
  void tell_documents(const std::vector<Named>& named) {
    Value::List list;
    for (const Named& one : named) {
      Value::Object document{{"name", one.name}};
      if (!one.set.empty()) document.emplace_back("set", Value::Object(one.set.begin(), one.set.end()));
      list.emplace_back(std::move(document));
    }
    if (Value* documents = plan_.tree.find("documents")) {
      *documents = std::move(list);
    } else {
      plan_.tree.object()->emplace_back("documents", std::move(list));
    }
  }

  void check_count() {
    double count = static_cast<double>(plan_.documents.size()) * static_cast<double>(plan_.seed_count);
    if (!plan_.samples.empty()) count *= static_cast<double>(plan_.samples.size());
    for (const auto& [path, values] : plan_.grid) count *= static_cast<double>(values.size());
    if (count <= static_cast<double>(kMaxPlants)) return;
    reader_.add_error(top_, fmt::format("{:.4g} plants are too many", count), fmt::format("at most {}", kMaxPlants));
  }

  void finish() {
    std::vector<Diagnostic> errors = reader_.take_diagnostics();
    errors.insert(errors.end(), std::make_move_iterator(own_.begin()), std::make_move_iterator(own_.end()));
    locate_diagnostics(text_, errors);
    for (Diagnostic& diagnostic : errors) diagnostic.file = file_;
    const bool is_faulty = !others_.empty() || std::any_of(errors.begin(), errors.end(), [](const Diagnostic& error) {
      return error.severity == Severity::error;
    });
    if (!is_faulty) {
      plan_.hash = hash_of_plan(plan_.tree);
      plan_.warnings.insert(plan_.warnings.end(), errors.begin(), errors.end());
      return;
    }
    errors.insert(errors.end(), std::make_move_iterator(others_.begin()), std::make_move_iterator(others_.end()));
    throw InputError(std::move(errors));
  }

  const std::string& text_;
  const std::string& file_;
  const Registry& registry_;
  const PlanOptions& options_;
  ParameterReader reader_;
  ReadStore store_;
  const DocumentPath top_;
  DatasetPlan plan_;
  PlanHead head_;
  std::vector<std::pair<std::string, ValueVariation>> vary_;  // as in the plan
  std::vector<Diagnostic> own_;                               // faults of values, by their positions in the plan
  std::vector<Diagnostic> others_;                            // faults in documents
};

}  // namespace

DatasetPlan read_dataset_plan(const std::string& text, const std::string& file, const Registry& registry,
                              const PlanOptions& options) {
  return PlanReader(text, file, registry, options).run();
}

}  // namespace meristem

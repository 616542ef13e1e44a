// SPDX-License-Identifier: Apache-2.0
// A document that another one names is first read unchanged, so that its faults are reported at once. It is read again
// with the requested values for each variant that is grown.
#include "meristem/document/sources.h"

#include <filesystem>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/base/read_file.h"
#include "meristem/document/grow.h"
#include "meristem/document/models.h"
#include "meristem/document/override.h"
#include "meristem/graph/expand.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/graph/looks.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/fingerprint.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNested = 8;  // maximum depth of documents within each other

/// The painted textures of all variants of one document.
class PaintedTextures {
 public:
  std::shared_ptr<const Texture> find(std::uint64_t fingerprint) {
    const std::scoped_lock lock(mutex_);
    const auto found = painted_.find(fingerprint);
    return found == painted_.end() ? nullptr : found->second;
  }
  void keep(std::uint64_t fingerprint, std::shared_ptr<const Texture> texture) {
    const std::scoped_lock lock(mutex_);
    painted_.emplace(fingerprint, std::move(texture));
  }

 private:
  std::mutex mutex_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const Texture>> painted_;
};

/// Paints the sketches among the materials that no other variant has painted.
void paint(const Graph& graph, PaintedTextures& painted, std::vector<Material>& materials, Progress& progress) {
  std::vector<Material> fresh;
  std::vector<std::size_t> numbers;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (materials[m].texture == nullptr) continue;
    if (auto known = painted.find(materials[m].texture->fingerprint)) {
      materials[m].texture = std::move(known);
    } else {
      fresh.push_back(materials[m]);
      numbers.push_back(m);
    }
  }
  if (fresh.empty()) return;
  paint_textures(graph, fresh, progress);
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    painted.keep(materials[numbers[k]].texture->fingerprint, fresh[k].texture);
    materials[numbers[k]].texture = fresh[k].texture;
  }
}

/// The plant of one document. Its growth is kept if a view requests its steps.
class DocumentGrowth : public PlacedGrowth {
 public:
  DocumentGrowth(std::shared_ptr<const Document> document, double time, std::shared_ptr<PaintedTextures> painted)
      : document_(std::move(document)), time_(time), painted_(std::move(painted)) {}

  ShownPlant show(const GrowthView& view, const Progress& progress) override {
    if (shown_.plant != nullptr && view == view_) return shown_;
    const bool is_kept = view.step || view.request.any();
    auto traces = std::make_shared<GrowthTraces>();
    auto variant = std::make_shared<PlantVariant>();
    Progress part(&progress);
    try {
      const ExpandOptions options{is_kept ? &cache_ : nullptr, view, traces.get()};
      variant->plant = std::make_shared<const Plant>(expand(document_->graph, document_->scene, time_, part, options));
    } catch (const InputError& error) {
      std::vector<Diagnostic> errors = error.diagnostics();
      document_->source.place(errors);
      throw InputError(std::move(errors));
    }
    variant->paint = [document = document_, painted = painted_](std::vector<Material>& materials, Progress& painting,
                                                                Cache*) {
      meristem::paint(document->graph, *painted, materials, painting);
    };
    const ShownPlant shown{std::move(variant), std::move(traces)};
    if (is_kept) {
      view_ = view;
      shown_ = shown;
    }
    return shown;
  }

  std::uint64_t bytes() const override {
    return cache_.bytes() + (shown_.plant != nullptr ? shown_.plant->bytes() + shown_.traces->bytes() : 0);
  }

 private:
  const std::shared_ptr<const Document> document_;
  const double time_;  // seconds
  const std::shared_ptr<PaintedTextures> painted_;
  Cache cache_;       // cache of the growth, used if the growth is kept
  GrowthView view_;   // the view that was shown last
  ShownPlant shown_;  // empty if the growth is not kept
};

class DocumentSource : public PlantSource {
 public:
  DocumentSource(std::string file, std::string text, const Registry& registry, const ReadOptions& options,
                 const Document& document)
      : file_(std::move(file)),
        text_(std::move(text)),
        registry_(registry),
        root_(options.root),
        models_(options.models),
        chain_(whole_chain(options.chain)),
        tree_(document.source.tree),
        within_(options.within),
        painted_(std::make_shared<PaintedTextures>()) {
    for (const Variable& variable : document.variables) variables_.push_back(variable.name);
    Fingerprint fingerprint;
    fingerprint.add_text(file_).add_text(text_);
    for (const std::string& named : document.source.named_files) {
      std::error_code error;
      const bool is_file = fs::is_regular_file(named, error);
      fingerprint.add_text(named).add(is_file ? hash64(read_file(named, document.graph.limits.file_bytes)) : 0);
    }
    fingerprint_ = fingerprint.hash();
  }

  const std::string& file() const override { return file_; }
  std::uint64_t fingerprint() const override { return fingerprint_; }

  Handle handle(const std::string& name) const override {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    Handle handle{.min = -kAny, .max = kAny};
    if (name.find_first_of(".[") == std::string::npos) {
      const Value* variables = tree_.find("variables");
      const Value* said = variables == nullptr ? nullptr : variables->find(name);
      handle.is_known = said != nullptr;
      if (said == nullptr) {
        handle.nearest = nearest_name(name, variables_);
        return handle;
      }
      const auto bound = [&](const char* end, double otherwise) {
        const Value* given = said->find(end);
        return given != nullptr && given->number() != nullptr ? *given->number() : otherwise;
      };
      handle.min = bound("min", -kAny);
      handle.max = bound("max", kAny);
      return handle;
    }
    Value tree = tree_;
    DocumentOrigin ignored;
    std::vector<Diagnostic> errors;
    apply_overrides(tree, {{.path = name, .value = Value(1.0)}}, ignored, errors);
    handle.is_known = errors.empty();
    if (!errors.empty()) handle.nearest = errors.front().nearest;
    return handle;
  }

  std::shared_ptr<PlacedGrowth> plant(const PlantRequest& request) const override {
    ReadOptions options{.seed = request.seed,
                        .time = request.time,
                        .root = root_,
                        .models = models_,
                        .chain = &chain_.back(),
                        .within = within_};
    for (const auto& [name, value] : request.values) options.overrides.push_back({name, Value(value), "set " + name});
    return std::make_shared<DocumentGrowth>(
        std::make_shared<const Document>(read_document(text_, file_, registry_, options)), request.time, painted_);
  }

 private:
  /// Returns a copy of a chain that stays valid. Its last element is the document itself.
  static std::vector<DocumentChain> whole_chain(const DocumentChain* last) {
    std::vector<DocumentChain> chain;
    for (const DocumentChain* link = last; link != nullptr; link = link->before) chain.insert(chain.begin(), *link);
    for (std::size_t k = 0; k < chain.size(); ++k) chain[k].before = k == 0 ? nullptr : &chain[k - 1];
    return chain;
  }

  std::string file_;
  std::string text_;
  const Registry& registry_;
  std::string root_;
  std::string models_;
  std::vector<DocumentChain> chain_;
  Value tree_;
  std::optional<SizeLimits> within_;
  std::vector<std::string> variables_;
  std::uint64_t fingerprint_ = 0;
  std::shared_ptr<PaintedTextures> painted_;
};

/// Returns a chain of documents as text: "street.json -> row.json -> street.json".
std::string chain_text(const DocumentChain* last, const std::string& next) {
  std::string text = next;
  for (const DocumentChain* link = last; link != nullptr; link = link->before) text = link->name + " -> " + text;
  return text;
}

/// Returns the files that a document was read from. `is_beside` says how the document itself was named.
std::vector<NamedFile> files_of(const Document& document, const std::string& file, bool is_beside) {
  const std::set<std::string> beside(document.source.files_beside.begin(), document.source.files_beside.end());
  std::vector<NamedFile> files{{.path = file, .is_beside = is_beside}};
  for (const std::string& named : document.source.named_files) {
    files.push_back({.path = named, .is_beside = is_beside && beside.contains(named)});
  }
  return files;
}

std::size_t length_of(const DocumentChain* chain) {
  std::size_t length = 0;
  for (; chain != nullptr; chain = chain->before) ++length;
  return length;
}

}  // namespace

std::string real_file(const std::string& file) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(file, error);
  return error || file.empty() ? file : real.string();
}

PlantSources::Opened DocumentSources::open(const std::string& name, const FileAccess& access) {
  // A file takes precedence over a model of the name.
  std::string file = (fs::path(access.folder) / name).string();
  std::error_code error;
  bool is_model = false;
  if (name.empty() || name.find('\0') != std::string::npos) {
    throw InputError(Diagnostic{.message = "this names no document", .expected = "a file or a shipped model"});
  }
  const bool is_plain = name.find_first_of("./") == std::string::npos;
  // With a root, the target of a link is not examined before it is known to lie within the root.
  const bool is_link = !options_.root.empty() && fs::is_symlink(fs::symlink_status(file, error));
  if (is_plain && !is_link && (!fs::exists(file, error) || fs::is_directory(file, error))) {
    if (options_.models.empty()) {
      throw InputError(Diagnostic{.message = fmt::format("there is no file '{}'", name), .expected = "a document"});
    }
    file = find_document(name, options_.models);
    is_model = true;
  } else {
    access.require_within(file);
  }

  const DocumentChain here{.file = real_file(file), .name = name, .before = options_.chain};
  for (const DocumentChain* link = options_.chain; link != nullptr; link = link->before) {
    if (link->file != here.file) continue;
    throw InputError(Diagnostic{
        .message = fmt::format("the documents {} contain each other in a circle", chain_text(options_.chain, name)),
        .expected = "a document that does not contain this one"});
  }
  if (length_of(&here) > kMaxNested) {
    throw InputError(
        Diagnostic{.message = fmt::format("the documents {} are nested too deep", chain_text(options_.chain, name)),
                   .expected = fmt::format("at most {}", kMaxNested)});
  }

  ReadOptions options{.root = is_model && !options_.root.empty() ? options_.models : options_.root,
                      .store = options_.store,
                      .models = options_.models,
                      .chain = &here,
                      .within = limits_,
                      .progress = options_.progress,
                      .document_bytes = options_.document_bytes};
  std::string text = read_text_file(file, options_.document_bytes);
  const Document document = read_document(text, file, registry_, options);
  Opened opened;
  opened.files = files_of(document, file, !is_model && !fs::path(name).is_absolute());
  options.chain = &here;
  options.progress = nullptr;  // the progress may be destroyed before the source
  opened.source = std::make_shared<const DocumentSource>(file, std::move(text), registry_, options, document);
  return opened;
}

}  // namespace meristem

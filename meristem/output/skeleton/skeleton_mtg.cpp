// SPDX-License-Identifier: Apache-2.0
// Writes multiscale tree graphs, one line per entity.
//
// Based on: the MTG user guide, section "File syntax". The output respects these properties of other programs:
// - OpenAlea.mtg joins the cells of a line into one code and splits it again at `+ < / [ ] ( ) , =`, so no text and
//   no number may contain them. It recognises laterals by one more column than their bearer, and takes the first word
//   after the topmost one as the column of the first feature.
// - MultiScaleTreeGraph.jl requires the heads of sections word by word, features in the order of their declaration,
//   and both relations in DESCRIPTION. It ends lines at `;` as well as at `#`.
#include "meristem/output/skeleton/skeleton_mtg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/output/skeleton/skeleton_table.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"
#include "meristem/output/write/finite.h"
#include "meristem/output/write/names.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/mtg/mtg_columns.h"
#include "meristem/plant/mtg/mtg_layout.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {
namespace {

using Kind = SkeletonColumn::Kind;

constexpr const char* kClasses =
    "CODE:\tFORM-A\n"
    "\n"
    "CLASSES:\n"
    "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
    "$\t0\tFREE\tFREE\tIMPLICIT\n"
    "P\t1\tCONNECTED\tFREE\tIMPLICIT\n"
    "A\t2\t<-LINEAR\tFREE\tEXPLICIT\n"
    "B\t3\tNONE\tFREE\tEXPLICIT\n"
    "S\t3\tNONE\tFREE\tEXPLICIT\n"
    "\n"
    "DESCRIPTION:\n"
    "LEFT\tRIGHT\tRELTYPE\tMAX\n"
    "A\tA\t+\t?\n"
    "B\tS\t<\t1\n"
    "B\tS\t+\t?\n"
    "S\tS\t<\t1\n"
    "S\tS\t+\t?\n"
    "\n";

/// Returns a text that no reader splits.
std::string mtg_word(const std::string& text) {
  std::string word = text;
  std::replace_if(word.begin(), word.end(), is_mtg_sign, '_');
  return word;
}

/// Returns true if a reader derives equal axes and orders: a successor continues its parent's axis, and every other
/// node begins one.
bool has_plain_axes(const Skeleton& skeleton) {
  const std::vector<bool> is_successor = find_successors(skeleton);
  AxisIndex axes = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    const int order = parent == kNoNode ? 0 : skeleton.order[parent] + (is_successor[node] ? 0 : 1);
    if (skeleton.order[node] != order || (!is_successor[node] && skeleton.axis[node] != axes)) return false;
    if (!is_successor[node]) ++axes;
  }
  return true;
}

/// A feature that every node has: a column of the table, or a column times a factor.
struct NodeFeature {
  std::string name;
  std::size_t column = 0;
  Kind kind = Kind::number;
  double factor = 1;
};

class MtgWriter {
 public:
  MtgWriter(const Plant& plant, Progress& progress)
      : plant_(plant), table_(plant), layout_(skeletons_of(plant), progress), progress_(progress) {
    const bool is_plain = std::all_of(plant.stems.begin(), plant.stems.end(),
                                      [](const Stem& stem) { return has_plain_axes(stem.skeleton); });
    find_node_features(is_plain);
    const std::vector<std::string>& ids = table_.components();
    if (std::any_of(ids.begin(), ids.end(), [](const std::string& id) { return !id.empty(); })) {
      for (const std::string& id : ids) components_.push_back(mtg_word(id));
      components_ = distinct_words(components_);
    }
    number_nodes();
  }

  void write(AtomicFile& file, const std::optional<Provenance>& provenance) {
    progress_.begin("writing MTG", table_.row_count());
    file.write(header(provenance));
    const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
      table_.for_each_row(begin, end, [&](const SkeletonRow& line) { append(line, out); });
    };
    BlockWriter(file, progress_).write(table_.row_count(), max_row_bytes(), fill);
  }

 private:
  static std::vector<const Skeleton*> skeletons_of(const Plant& plant) {
    std::vector<const Skeleton*> skeletons;
    for (const Stem& stem : plant.stems) skeletons.push_back(&stem.skeleton);
    return skeletons;
  }

  /// Returns the index of a column that every table has.
  std::size_t column_of(std::string_view name) const {
    std::size_t column = 0;
    while (table_.columns()[column].name != name) ++column;
    return column;
  }

  void find_node_features(bool is_plain) {
    const std::vector<SkeletonColumn>& columns = table_.columns();
    const auto add = [&](const char* name, std::string_view column_name, double factor = 1) {
      const std::size_t column = column_of(column_name);
      features_.push_back({name, column, columns[column].kind, factor});
    };
    add("XX", "x");
    add("YY", "z", -1);
    add("ZZ", "y");
    add("TopDia", "radius", 2);
    add("node", "node");
    if (!is_plain) {
      add("axis", "axis");
      add("order", "order");
    }
    add("birth", "birth");
    for (std::size_t k = features_.back().column + 1; k < columns.size(); ++k) {
      if (columns[k].kind != Kind::number) continue;
      if (!is_mtg_column_name(columns[k].name)) {
        throw InputError(Diagnostic{.message = fmt::format("a file cannot have the column '{}'", columns[k].name),
                                    .expected = "further columns whose names are words and no features of every MTG"});
      }
      features_.push_back({columns[k].name, k, Kind::number, 1});
    }
  }

  /// Numbers nodes on their axes, and finds the lines at which trees begin.
  void number_nodes() {
    numbers_.reserve(table_.row_count());
    for (const Stem& stem : plant_.stems) {
      for (std::size_t k = 0; k < stem.skeleton.node_count(); ++k) {
        const std::size_t line = numbers_.size() + k;
        if (stem.skeleton.is_root(layout_.places()[line].node)) root_lines_.push_back(line);
      }
      const std::vector<std::uint32_t> numbers = axis_numbers(stem.skeleton);
      numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
      progress_.check();
    }
  }

  std::string header(const std::optional<Provenance>& provenance) const {
    std::string text;
    if (provenance) {
      for (const std::string& line : provenance_lines(*provenance, "metres; XX east, YY north, ZZ up")) {
        text += fmt::format("# {}\n", line);
      }
    }
    text += kClasses;
    text += "FEATURES:\nNAME\tTYPE\n";
    std::string names = "ENTITY-CODE" + std::string(layout_.column_count() - 1, '\t');
    const auto declare = [&](const std::string& name, const char* type) {
      text += fmt::format("{}\t{}\n", name, type);
      names += '\t' + name;
    };
    for (const NodeFeature& feature : features_) declare(feature.name, feature.kind == Kind::index ? "INT" : "REAL");
    if (!components_.empty()) {
      declare("component", "ALPHA");
      declare("instance", "INT");
    }
    if (!table_.labels().empty()) declare("label", "ALPHA");
    return text + "\nMTG:\n" + names + '\n';
  }

  std::size_t max_row_bytes() const {
    constexpr std::size_t kCodes = 64;  // maximum size of the codes of a plant, an axis and a segment, with line ends
    std::size_t longest = 0;
    for (const std::string& text : components_) longest = std::max(longest, text.size());
    std::size_t longest_label = 0;
    for (const std::string& text : table_.labels()) longest_label = std::max(longest_label, text.size());
    return kCodes + longest + longest_label + 2 * layout_.column_count() + (2 * features_.size() + 3) * kCsvNumberBytes;
  }

  /// Appends the entity of a line, preceded by the plant and the axis that begin with it.
  void append(const SkeletonRow& line, std::string& out) const {
    const MtgEntry& place = layout_.places()[line.row];
    const SkeletonRow row{line.row - line.node + place.node, line.stem, place.node};
    const bool is_root = plant_.stems[row.stem].skeleton.is_root(row.node);
    if (is_root) {
      const auto tree = std::lower_bound(root_lines_.begin(), root_lines_.end(), line.row) - root_lines_.begin() + 1;
      out += "/P";
      append_csv_number(tree, out);
      out += '\n';
    }
    if (!place.is_successor) append_axis(row, place, is_root, out);
    out.append(place.column, '\t');
    if (place.is_successor) {
      out += place.stays ? "^<S" : "<S";
    } else {
      out += is_root ? "^/B" : "^/S";
    }
    append_csv_number(numbers_[row.row], out);
    out.append(layout_.column_count() - place.column, '\t');
    for (const NodeFeature& feature : features_) {
      append_value(feature, row, out);
      out += '\t';
    }
    end_line(out);
  }

  void append_axis(const SkeletonRow& row, const MtgEntry& place, bool is_root, std::string& out) const {
    out.append(place.column, '\t');
    out += is_root ? "^/A" : place.stays ? "^+A" : "+A";
    append_csv_number(static_cast<std::uint64_t>(table_.value(row, axis_column_)), out);
    out.append(layout_.column_count() - place.column + features_.size(), '\t');
    if (!components_.empty()) {
      out += components_[static_cast<std::size_t>(table_.value(row, component_column_))];
      out += '\t';
      append_csv_number(static_cast<std::uint64_t>(table_.value(row, instance_column_)), out);
      out += '\t';
    }
    if (!table_.labels().empty()) out += table_.labels()[static_cast<std::size_t>(table_.value(row, axis_column_))];
    end_line(out);
  }

  void append_value(const NodeFeature& feature, const SkeletonRow& row, std::string& out) const {
    const double value = feature.factor * table_.value(row, feature.column);
    if (feature.kind == Kind::index) {
      append_csv_number(static_cast<std::uint64_t>(value), out);
    } else if (std::isfinite(value)) {
      const std::size_t begin = out.size();
      append_csv_number(static_cast<float>(value), out);
      // A plus sign would mean a branch.
      const std::size_t plus = out.find('+', begin);
      if (plus != std::string::npos) out.erase(plus, 1);
    }
  }

  static void end_line(std::string& out) {
    while (out.back() == '\t') out.pop_back();
    out += '\n';
  }

  const Plant& plant_;
  SkeletonTable table_;
  MtgLayout layout_;
  Progress& progress_;
  std::size_t axis_column_ = column_of("axis");
  std::size_t component_column_ = column_of("component");
  std::size_t instance_column_ = column_of("instance");
  std::vector<NodeFeature> features_;
  std::vector<std::string> components_;  // as words; empty if stems belong to no component
  std::vector<std::uint32_t> numbers_;   // for all nodes, their number on the axis
  std::vector<std::size_t> root_lines_;
};

}  // namespace

void write_skeleton_mtg(const Plant& grown, const SizeLimits& limits, const std::string& path,
                        const MtgOptions& options, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  require_finite(*expanded);
  const Plant& plant = *expanded;
  MtgWriter writer(plant, progress);
  AtomicFile file(path);
  writer.write(file, options.provenance);
  file.commit();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The table is compared with its known hash, with the hashes of its rows and columns, and with the plan. A table with
// the right hash needs no hashes of rows. In any other table, a row with the right hash is right at any position.
// Columns with wrong hashes show what has changed in the other rows.
#include "meristem/dataset/table_check.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "meristem/base/whole_file.h"
#include "meristem/dataset/table_hashes.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxColumnsNamed = 4;

std::string_view without_line_end(const std::string& line) { return std::string_view(line).substr(0, line.size() - 1); }

/// Checks one file.
class TableReader {
 public:
  TableReader(const TableKnowledge& knowledge, std::string path, std::uint64_t table)
      : knowledge_(knowledge), path_(std::move(path)) {
    const DatasetInfo& info = knowledge.info;
    begin_ = table * info.rows;
    end_ = std::min(info.plants, begin_ + info.rows);
  }

  TableRows whole(std::uint64_t table) {
    const std::optional<std::string> content = whole_file(path_);
    if (!content) {
      tell("{}: the table is missing", path_);
      return std::move(out_);
    }
    out_.hash = text_hash(*content);
    known_ = known_table_hash(knowledge_.info, knowledge_.folder, table);
    is_confirmed_ = out_.hash == known_;
    if (!is_confirmed_ && !known_.empty()) {
      hashes_ = read_table_hashes(knowledge_.folder, table);
      if (hashes_ && hashes_->table != known_) hashes_.reset();
    }
    read(*content);
    tell_missing();
    if (!is_confirmed_ && !known_.empty() && out_.errors.empty()) {
      tell("{}: the table has other bytes than were written", path_);
    }
    return std::move(out_);
  }

  TableRows part() {
    const std::optional<std::string> content = whole_file(path_);
    if (!content) return std::move(out_);  // the file has become part of a table
    std::string_view text = *content;
    bool is_right = true;
    take_end_line(text, is_right);
    if (is_right) {
      read(text);
    } else {
      tell("{}: the rows have other bytes than were written", path_);
    }
    return std::move(out_);
  }

 private:
  template <class... Arguments>
  void tell(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    out_.errors.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
  }

  void read(std::string_view text) {
    const std::string_view labels = take_line(text);
    const std::string planned = knowledge_.plan != nullptr ? manifest_header(*knowledge_.plan) : std::string();
    bool are_right = planned.empty() || labels == without_line_end(planned);
    layout_ = ManifestLayout::of_header(are_right || planned.empty() ? labels : without_line_end(planned));
    if (!are_right) tell_labels(labels, without_line_end(planned));
    // Without hashes of rows, it is unknown whether these are rows of this data set.
    if (!layout_ || (!are_right && !hashes_ && !is_confirmed_)) {
      if (are_right) tell("{}:1: these are not the labels of a manifest", path_);
      return;
    }
    find_changed_columns(labels, text);
    is_there_.assign(end_ - begin_, false);
    for (std::size_t number = 2; !text.empty(); ++number) {
      const bool is_ended = text.find('\n') != std::string_view::npos;
      read_row(take_line(text), number, is_ended);
    }
  }

  void tell_labels(std::string_view labels, std::string_view planned) {
    const auto found = csv_fields(labels).value_or(std::vector<std::string>());
    const auto expected = csv_fields(planned).value_or(std::vector<std::string>());
    const std::size_t column = static_cast<std::size_t>(
        std::mismatch(expected.begin(), expected.end(), found.begin(), found.end()).first - expected.begin());
    const std::string is = column < found.size() ? "'" + found[column] + "'" : "missing";
    const std::string was = column < expected.size() ? "'" + expected[column] + "'" : "the end of the line";
    tell("{}:1: the label of column {} is {}; expected {}", path_, column + 1, is, was);
  }

  /// Finds the columns after the drawn ones that have changed in some row.
  void find_changed_columns(std::string_view labels, std::string_view text) {
    if (!hashes_) return;
    std::vector<std::string_view> lines;
    while (!text.empty()) lines.push_back(take_line(text));
    const std::vector<std::string> now = column_hashes(lines, hashes_->columns.size());
    const std::size_t drawn = knowledge_.plan != nullptr ? 3 + knowledge_.plan->columns.size() : 0;
    for (std::size_t k = drawn; k < now.size(); ++k) {
      if (now[k] != hashes_->columns[k].second) changed_columns_.push_back(hashes_->columns[k].first);
    }
    if (changed_columns_.size() > kMaxColumnsNamed || labels.empty()) changed_columns_.clear();
  }

  void read_row(std::string_view line, std::size_t number, bool is_ended) {
    const auto fields = csv_fields(line);
    auto entry = fields ? layout_->entry(*fields) : std::nullopt;
    if (!entry || !is_ended) return tell("{}:{}: this is no row", path_, number);
    const std::uint64_t plant = entry->number;
    if (plant < begin_ || plant >= end_) {
      return tell("{}:{}: the row of the plant {} belongs to another table", path_, number, fields->front());
    }
    if (is_there_[plant - begin_]) return tell("{}:{}: the row {} stands twice", path_, number, fields->front());
    // The first row of a part may have any number.
    if (!out_.rows.empty() && plant != out_.rows.back().entry.number + 1) {
      tell("{}:{}: the row {} follows the row of the plant {}", path_, number, fields->front(),
           out_.rows.back().entry.number);
    }
    is_there_[plant - begin_] = true;
    const bool is_drawn = check_drawn(plant, *fields, number);
    out_.rows.push_back({std::move(*entry), std::string(line), is_drawn && check_hash(plant, *fields, line, number)});
  }

  /// Draws the values of the plant again and compares them with its row.
  bool check_drawn(std::uint64_t number, const std::vector<std::string>& fields, std::size_t line) {
    if (knowledge_.plan == nullptr) return true;
    const DatasetPlan& plan = *knowledge_.plan;
    const std::vector<std::string> expected = planned_fields(plan, plan.plant(number));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      if (fields[k] == expected[k]) continue;
      tell("{}:{}: row {}, column '{}': '{}' has changed; the plan draws '{}'", path_, line, fields.front(),
           manifest_columns(plan)[k], fields[k], expected[k]);
      return false;
    }
    return true;
  }

  bool check_hash(std::uint64_t number, const std::vector<std::string>& fields, std::string_view line,
                  std::size_t line_number) {
    if (known_.empty() || is_confirmed_) return true;
    if (!hashes_) return false;
    const std::uint64_t at = number - begin_;
    if (at < hashes_->rows.size() && hashes_->rows[at] == row_hash(line)) return true;
    std::string where;
    for (const std::string& column : changed_columns_) {
      const auto same = [&](const auto& one) { return one.first == column; };
      const auto place =
          std::find_if(hashes_->columns.begin(), hashes_->columns.end(), same) - hashes_->columns.begin();
      where +=
          fmt::format("{}'{}' ('{}')", where.empty() ? "" : " or ", column, fields[static_cast<std::size_t>(place)]);
    }
    tell("{}:{}: row {}{}: the row has changed since it was written", path_, line_number, fields.front(),
         where.empty() ? "" : ", column " + where);
    return false;
  }

  void tell_missing() {
    for (std::size_t k = 0; k < is_there_.size(); ++k) {
      if (is_there_[k]) continue;
      std::size_t last = k;
      while (last + 1 < is_there_.size() && !is_there_[last + 1]) ++last;
      if (last == k) {
        tell("{}: the row of the plant {} is missing", path_, begin_ + k);
      } else {
        tell("{}: the rows of the plants {} to {} are missing", path_, begin_ + k, begin_ + last);
      }
      k = last;
    }
  }

  const TableKnowledge& knowledge_;
  std::string path_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
  std::string known_;
  bool is_confirmed_ = false;
  std::optional<TableHashes> hashes_;  // read only if the table has changed
  std::optional<ManifestLayout> layout_;
  std::vector<std::string> changed_columns_;
  std::vector<bool> is_there_;
  TableRows out_;
};

}  // namespace

std::string known_table_hash(const DatasetInfo& info, const std::string& folder, std::uint64_t table) {
  const bool is_known = info.is_as_written && table < info.tables.size() && !info.tables[table].empty();
  if (is_known) return info.tables[table];
  const std::optional<TableHashes> hashes = read_table_hashes(folder, table);
  return hashes && hashes->plan == info.plan ? hashes->table : "";
}

TableRows check_table_rows(const TableKnowledge& knowledge, std::uint64_t table) {
  return TableReader(knowledge, manifest_path(knowledge.folder, table), table).whole(table);
}

TableRows check_part_rows(const TableKnowledge& knowledge, const std::string& path, std::uint64_t table) {
  return TableReader(knowledge, path, table).part();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Reads PLY files row by row. A header may declare any elements and properties. Sizes are checked against the bytes
// that are left before anything is allocated.
#include "meristem/scene/file/ply_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/reading_stop.h"
#include "meristem/scene/file/text_scanner.h"

namespace meristem {

namespace {

/// The old and new names of types, indexed by PlyType.
constexpr std::array<std::array<std::string_view, 2>, 8> kTypeNames{{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
constexpr std::array<std::size_t, 8> kTypeBytes{1, 1, 2, 2, 4, 4, 4, 8};

std::size_t size_of(PlyType type) { return kTypeBytes[static_cast<std::size_t>(type)]; }

PlyType parse_type(TextScanner& header) {
  const std::string_view word = header.word();
  std::vector<std::string> names;
  for (std::size_t k = 0; k < kTypeNames.size(); ++k) {
    if (word == kTypeNames[k][0] || word == kTypeNames[k][1]) return static_cast<PlyType>(k);
    names.emplace_back(kTypeNames[k][0]);
  }
  header.fail(fmt::format("'{}' is not a type", word), fmt::format("one of {}", fmt::join(names, ", ")),
              nearest_name(word, names));
}

PlyProperty parse_property(TextScanner& header) {
  PlyProperty property;
  TextScanner ahead = header;
  if (ahead.word() == "list") {
    header.word();
    property.count_type = parse_type(header);
    if (*property.count_type >= PlyType::float32)
      header.fail("a list cannot have a fraction of entries", "a whole type");
  }
  property.type = parse_type(header);
  property.name = header.word();
  if (property.name.empty()) header.fail("the property has no name", "a name such as x");
  return property;
}

template <class T>
double decode(const char* bytes, bool is_swapped) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (is_swapped) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

double decode(PlyType type, const char* bytes, bool is_swapped) {
  switch (type) {
    case PlyType::int8:
      return decode<std::int8_t>(bytes, is_swapped);
    case PlyType::uint8:
      return decode<std::uint8_t>(bytes, is_swapped);
    case PlyType::int16:
      return decode<std::int16_t>(bytes, is_swapped);
    case PlyType::uint16:
      return decode<std::uint16_t>(bytes, is_swapped);
    case PlyType::int32:
      return decode<std::int32_t>(bytes, is_swapped);
    case PlyType::uint32:
      return decode<std::uint32_t>(bytes, is_swapped);
    case PlyType::float32:
      return decode<float>(bytes, is_swapped);
    case PlyType::float64:
      return decode<double>(bytes, is_swapped);
  }
  return 0;
}

/// Reads the values of a body in sequence. Each call returns nothing at the end of the file.
class Values {
 public:
  virtual ~Values() = default;
  virtual std::optional<double> next(PlyType type) = 0;
  virtual std::uint64_t bytes_left() const = 0;
  virtual int line() const { return 0; }
};

class BinaryValues : public Values {
 public:
  BinaryValues(std::string_view bytes, bool is_swapped) : bytes_(bytes), is_swapped_(is_swapped) {}
  std::optional<double> next(PlyType type) override {
    const std::size_t size = size_of(type);
    if (bytes_.size() < size) return std::nullopt;
    const double value = decode(type, bytes_.data(), is_swapped_);
    bytes_.remove_prefix(size);
    return value;
  }
  std::uint64_t bytes_left() const override { return bytes_.size(); }

 private:
  std::string_view bytes_;
  bool is_swapped_;
};

class AsciiValues : public Values {
 public:
  AsciiValues(std::string_view bytes, const std::string& file, int first_line)
      : text_(bytes), scanner_(bytes, file), first_line_(first_line) {}
  std::optional<double> next(PlyType) override {
    const std::string_view word = scanner_.word_anywhere();
    if (word.empty()) return std::nullopt;
    const std::optional<double> value = parse_number(word);
    if (!value) {
      Diagnostic diagnostic{.message = fmt::format("{} is not a number", in_quotes(word)), .expected = "a number"};
      throw InputError(std::move(diagnostic));
    }
    return value;
  }
  std::uint64_t bytes_left() const override { return text_.size() - scanner_.offset(); }
  int line() const override { return first_line_ + scanner_.line() - 1; }

 private:
  std::string_view text_;
  TextScanner scanner_;
  int first_line_;
};

/// Reads one row. Returns false at the end of the file.
bool read_row(const PlyElement& element, Values& values, PlyRow& row, StopCounter& stop) {
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const std::optional<double> value = values.next(property.count_type.value_or(property.type));
    if (k == 0) row.line = values.line();
    if (!value) return false;
    if (!property.count_type) {
      row.values[k] = *value;
      continue;
    }
    row.lists[k].clear();
    // A list cannot have more entries than bytes are left.
    if (!(*value >= 0 && *value <= static_cast<double>(values.bytes_left()) && *value == std::floor(*value))) {
      throw InputError(
          Diagnostic{.message = fmt::format("the list '{}' has {:.12g} entries, which the file cannot hold",
                                            property.name, *value)});
    }
    for (auto left = static_cast<std::uint64_t>(*value); left > 0; --left) {
      stop.step();
      const std::optional<double> entry = values.next(property.type);
      if (!entry) return false;
      row.lists[k].push_back(*entry);
    }
  }
  return true;
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (properties[k].name == property) return k;
  }
  return std::nullopt;
}

bool PlyFile::begins(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); }

PlyFile::PlyFile(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) { read_header(); }

void PlyFile::read_header() {
  TextScanner header(bytes_, file_);
  if (!begins(bytes_)) header.fail("this is not a PLY file", "a first line 'ply'");
  const std::vector<std::string> words = {"format", "comment", "obj_info", "element", "property", "end_header"};
  const std::vector<std::string> formats = {"ascii", "binary_little_endian", "binary_big_endian"};
  bool has_format = false;
  while (header.next_line()) {
    const std::string_view word = header.word();
    if (word == "end_header") {
      if (!has_format) header.fail("the header names no format", "a line such as 'format ascii 1.0'");
      header.next_line();
      body_ = header.offset();
      header.word();
      body_line_ = header.line();
      return;
    }
    if (word == "format") {
      const std::string_view given = header.word();
      const auto found = std::find(formats.begin(), formats.end(), given);
      if (found == formats.end()) {
        header.fail(fmt::format("'{}' is not a format", given), fmt::format("one of {}", fmt::join(formats, ", ")),
                    nearest_name(given, formats));
      }
      format_ = static_cast<PlyFormat>(found - formats.begin());
      has_format = true;
    } else if (word == "element") {
      PlyElement& element = elements_.emplace_back();
      element.name = header.word();
      const std::string_view count = header.word();
      const auto parsed = std::from_chars(count.data(), count.data() + count.size(), element.count);
      if (parsed.ec != std::errc() || parsed.ptr != count.data() + count.size()) {
        header.fail(fmt::format("'{}' is not a number of rows", count), "a whole number of at least 0");
      }
    } else if (word == "property") {
      if (elements_.empty()) header.fail("a property before any element", "an element first");
      elements_.back().properties.push_back(parse_property(header));
    } else if (!word.empty() && word != "comment" && word != "obj_info") {
      header.fail(fmt::format("{} has no meaning in a header", in_quotes(word)),
                  fmt::format("one of {}", fmt::join(words, ", ")), nearest_name(word, words));
    }
  }
  header.fail("the header does not end", "a line 'end_header'");
}

const PlyElement* PlyFile::find(std::string_view element) const {
  for (const PlyElement& each : elements_) {
    if (each.name == element) return &each;
  }
  return nullptr;
}

std::size_t PlyFile::need(const PlyElement& element, std::string_view property) const {
  if (const auto found = element.find(property)) return *found;
  std::vector<std::string> names;
  for (const PlyProperty& each : element.properties) names.push_back(each.name);
  throw InputError(
      Diagnostic{.message = fmt::format("the element '{}' has no property '{}'", element.name, property),
                 .expected = names.empty() ? "" : fmt::format("'{}' beside {}", property, fmt::join(names, ", ")),
                 .nearest = nearest_name(property, names),
                 .file = file_});
}

void PlyFile::check_size(const PlyElement& element, std::uint64_t bytes_left) const {
  // The smallest size of a row. In text, each value takes at least a digit and a blank, and the last blank may be
  // missing.
  std::uint64_t row = 0;
  for (const PlyProperty& property : element.properties) {
    row += format_ == PlyFormat::ascii ? 2 : size_of(property.count_type.value_or(property.type));
  }
  if (row == 0) return;
  const std::uint64_t rows = (bytes_left + (format_ == PlyFormat::ascii ? 1 : 0)) / row;
  if (element.count <= rows) return;
  throw InputError(Diagnostic{
      .message = fmt::format("the header declares {} rows of '{}', but the file is cut off: {} bytes hold at most {}",
                             element.count, element.name, bytes_left, rows),
      .expected = "the whole file",
      .file = file_});
}

void PlyFile::read(FunctionRef<void(const PlyElement&, const PlyRow&)> take) const {
  const std::string_view body = bytes_.substr(body_);
  const bool is_big = std::endian::native == std::endian::big;
  BinaryValues binary(body, is_big != (format_ == PlyFormat::big_endian));
  AsciiValues ascii(body, file_, body_line_);
  Values& values = format_ == PlyFormat::ascii ? static_cast<Values&>(ascii) : binary;
  StopCounter stop;
  for (const PlyElement& element : elements_) {
    // Rows without properties take no bytes.
    if (element.properties.empty()) continue;
    check_size(element, values.bytes_left());
    PlyRow row;
    row.values.resize(element.properties.size());
    row.lists.resize(element.properties.size());
    for (; row.index < element.count; ++row.index) {
      try {
        stop.step();
        if (!read_row(element, values, row, stop)) fail(element, row, "the file is cut off here", "the whole file");
      } catch (const InputError& error) {
        const Diagnostic& found = error.diagnostics()[0];
        if (!found.file.empty()) throw;
        fail(element, row, found.message, found.expected);
      }
      take(element, row);
    }
  }
}

void PlyFile::fail(const PlyElement& element, const PlyRow& row, const std::string& message,
                   std::string expected) const {
  throw InputError(Diagnostic{.message = fmt::format("row {} of '{}': {}", row.index + 1, element.name, message),
                              .expected = std::move(expected),
                              .file = file_,
                              .line = row.line});
}

}  // namespace meristem

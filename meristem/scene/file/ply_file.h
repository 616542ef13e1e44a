// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/function_ref.h"

namespace meristem {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< type of the length; set for lists only
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyRow {
  std::uint64_t index = 0;                 ///< from 0, within its element
  int line = 0;                            ///< in ASCII files
  std::vector<double> values;              ///< by property; 0 for lists
  std::vector<std::vector<double>> lists;  ///< by property; empty for scalar properties
};

/// Reads a file in the Stanford polygon format (PLY) with any elements and properties. Based on: G. Turk, The PLY
/// polygon file format (1994).
class PlyFile {
 public:
  /// Returns true if the bytes begin like a PLY file.
  static bool begins(std::string_view bytes);

  /// Reads the header. `bytes` are the whole file and must outlive this object; `file` is its name in messages. Throws
  /// InputError for an invalid header, and before allocating memory if the header declares more rows than the bytes can
  /// hold.
  PlyFile(std::string_view bytes, std::string file);

  const std::vector<PlyElement>& elements() const { return elements_; }
  const PlyElement* find(std::string_view element) const;
  /// Returns the index of a property. Throws InputError with the nearest name if the element does not have the
  /// property.
  std::size_t need(const PlyElement& element, std::string_view property) const;

  /// Calls `take` for each row of each element, in the order of the file. Throws InputError if the file ends too early
  /// or a value cannot be read.
  void read(FunctionRef<void(const PlyElement&, const PlyRow&)> take) const;
  /// Throws InputError with the place of a row.
  [[noreturn]] void fail(const PlyElement& element, const PlyRow& row, const std::string& message,
                         std::string expected = {}) const;

 private:
  void read_header();
  void check_size(const PlyElement& element, std::uint64_t bytes_left) const;

  std::string_view bytes_;
  std::string file_;
  PlyFormat format_ = PlyFormat::ascii;
  std::vector<PlyElement> elements_;
  std::size_t body_ = 0;  // offset of the first row
  int body_line_ = 1;
};

}  // namespace meristem

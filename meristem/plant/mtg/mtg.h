// SPDX-License-Identifier: Apache-2.0
// Reads plants from multiscale tree graphs (MTG), the tables that botanists use to code and digitise plants. Each line
// names an entity (plant, axis, growth unit, internode), states how it is joined to another entity, and gives values.
//
// The syntax is that of the MTG user guide, section "File syntax", form A: scales and classes; `/` for parts, `<` for
// successors, `+` for branches; indentation by columns; `^` for the entity above in the same column; `<<` and `++` for
// runs of entities; `<.<` and `+.+` for runs that share values; `*` for a later measurement of an entity, whose values
// replace the earlier ones; aliases. Rules of a DESCRIPTION section are not enforced, but their names are checked.
// Comments run from # to the end of the line.
//
// Based on: C. Godin, Y. Caraglio, A multiscale model of plant topological structures, 1998.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"

namespace meristem {

using MtgVertex = std::uint32_t;
inline constexpr MtgVertex kNoVertex = 0xffffffffU;

/// How an entity is joined to its parent of the same scale.
enum class MtgEdge : std::uint8_t { none, successor, branch };

/// A kind of entity. Each class belongs to one scale. Scale 0 is the whole scene; higher scales are finer.
struct MtgClass {
  std::string name;
  int scale = 0;
};

/// A column of values.
struct MtgFeature {
  std::string name;
  std::string type;  ///< type name from the file: INT, REAL, ALPHA, DD/MM/YY, ...
  bool is_number = false;
};

/// The values of entities, with one row for each line of the file that has values.
struct MtgValues {
  struct Cell {
    std::uint32_t feature, begin, size;  ///< the cell's text is `size` bytes of `text` from `begin`
  };
  struct Row {
    MtgVertex first, last;   ///< range of entities with these values, both included
    std::size_t begin, end;  ///< the row's cells
  };
  std::vector<Row> rows;
  std::vector<Cell> cells;
  std::string text;
};

/// Entities in the order of the file. Vertex 0 is the scene, the only vertex of scale 0. The complex and the parent of
/// a vertex come before it.
struct MtgTree {
  std::vector<MtgClass> classes;
  std::vector<MtgFeature> features;
  // One entry per vertex.
  std::vector<std::uint32_t> type;  ///< index into `classes`
  std::vector<std::int32_t> index;  ///< the number in its label, or -1
  std::vector<MtgVertex> complex;   ///< the coarser entity that contains it, one scale up; kNoVertex for the scene
  std::vector<MtgVertex> parent;    ///< the entity of the same scale that bears it, or kNoVertex
  std::vector<MtgEdge> edge;        ///< how it is joined to its parent
  std::vector<std::uint32_t> line;  ///< line of the file, from 1
  MtgValues values;

  std::size_t vertex_count() const { return type.size(); }
  int scale(MtgVertex vertex) const { return classes[type[vertex]].scale; }
  /// Returns the finest scale that has entities.
  int finest_scale() const;
  /// Returns the class and number of an entity, such as "S12".
  std::string label(MtgVertex vertex) const;

  /// Returns the index of the feature with this name.
  std::optional<std::uint32_t> find_feature(std::string_view name) const;
  /// Returns a feature's value for every vertex; NaN if it is missing or not a number.
  std::vector<double> numbers(std::uint32_t feature) const;
  /// Returns a feature's value for every vertex as written, empty if it is missing. The texts point into `values.text`.
  std::vector<std::string_view> texts(std::uint32_t feature) const;
};

/// Reads the text of an MTG file. Throws one InputError with all errors (up to the limit), each with line and column in
/// `file`. More entities than `limits.nodes` are an error. Cost and memory: linear in the text and the entities.
MtgTree read_mtg(std::string_view text, const std::string& file, const Limits& limits);

}  // namespace meristem

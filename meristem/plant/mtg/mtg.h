// SPDX-License-Identifier: Apache-2.0
// Plants as multiscale tree graphs (MTG), the tables in which botanists code and digitise them: each line names an
// entity (plant, axis, growth unit, internode) by how it is joined to another one, and gives values for it.
//
// The form is that of the MTG user guide, section "File syntax", form A: scales and classes, `/` for parts, `<` for
// successors and `+` for branches, columns that indent, `^` for what stands above in the same column, `<<` and `++` for
// runs of entities, `<.<` and `+.+` for runs that share values, `*` for a later look at the same entity (its values
// replace the earlier ones), aliases. Rules that a DESCRIPTION sets up are not enforced, only their names are checked.
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

/// How an entity is joined to the one that bears it.
enum class MtgEdge : std::uint8_t { none, successor, branch };

/// A kind of entity; each belongs to one scale. Scale 0 is the whole scene, higher scales are finer.
struct MtgClass {
  std::string name;
  int scale = 0;
};

/// A column of values.
struct MtgFeature {
  std::string name;
  std::string type;  ///< as the file says: INT, REAL, ALPHA, DD/MM/YY, ...
  bool is_number = false;
};

/// The values of entities, a row for each line of the file that has some.
struct MtgValues {
  struct Cell {
    std::uint32_t feature, begin, size;  ///< `size` bytes of `text` from `begin`
  };
  struct Row {
    MtgVertex first, last;   ///< the entities that it is about, both included
    std::size_t begin, end;  ///< the row's cells
  };
  std::vector<Row> rows;
  std::vector<Cell> cells;
  std::string text;
};

/// Entities in the order of the file. Vertex 0 is the scene, the only one of scale 0; whatever an entity belongs to or
/// hangs on comes before it.
struct MtgTree {
  std::vector<MtgClass> classes;
  std::vector<MtgFeature> features;
  // One entry per vertex.
  std::vector<std::uint32_t> type;  ///< index into `classes`
  std::vector<std::int32_t> index;  ///< the number in its label, or -1
  std::vector<MtgVertex> complex;   ///< the whole that it is a part of, one scale coarser; kNoVertex for the scene
  std::vector<MtgVertex> parent;    ///< entity of the same scale that bears this one, or kNoVertex
  std::vector<MtgEdge> edge;        ///< to its parent
  std::vector<std::uint32_t> line;  ///< line of the file, from 1
  MtgValues values;

  std::size_t vertex_count() const { return type.size(); }
  int scale(MtgVertex vertex) const { return classes[type[vertex]].scale; }
  /// The finest scale that has entities.
  int finest_scale() const;
  /// The class and number of an entity: "S12".
  std::string label(MtgVertex vertex) const;

  /// The index of a feature by name.
  std::optional<std::uint32_t> find_feature(std::string_view name) const;
  /// A feature's value for every vertex, NaN where there is none or where it is not a number.
  std::vector<double> numbers(std::uint32_t feature) const;
  /// A feature's value for every vertex as written, empty where there is none; parts of `values.text`.
  std::vector<std::string_view> texts(std::uint32_t feature) const;
};

/// Reads the text of an MTG file. Throws one InputError with all faults (up to the limit) that have line and column in
/// `file`; entities past `limits.nodes` are one. Cost and memory are linear in the text and the entities.
MtgTree read_mtg(std::string_view text, const std::string& file, const Limits& limits);

}  // namespace meristem

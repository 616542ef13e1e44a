// SPDX-License-Identifier: Apache-2.0
// Reads plants from multiscale tree graphs (MTG), the tables that botanists use to code and digitise plants. Each line
// names an entity (plant, axis, growth unit, internode), states how it is joined to another entity, and gives values.
//
// The syntax is form A of the MTG user guide, section "File syntax". It has scales and classes; `/` for parts, `<` for
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

using MtgVertex = std::uint32_t;                     ///< index of an entity
inline constexpr MtgVertex kNoVertex = 0xffffffffU;  ///< marks a missing entity

/// How an entity is joined to its parent of the same scale.
enum class MtgEdge : std::uint8_t { none, successor, branch };

/// A kind of entity. Each class belongs to one scale. Scale 0 is the whole scene; higher scales are finer.
struct MtgClass {
  std::string name;  ///< letters, as in the file
  int scale = 0;     ///< 0 for the whole scene; higher is finer
};

/// A column of values.
struct MtgFeature {
  std::string name;        ///< as in the file
  std::string type;        ///< type name from the file: INT, REAL, ALPHA, DD/MM/YY, ...
  bool is_number = false;  ///< true if values of the type are numbers
};

/// The values of entities, with one row for each line of the file that has values.
struct MtgValues {
  /// One value of a row.
  struct Cell {
    std::uint32_t feature;  ///< index into MtgTree::features
    std::uint32_t begin;    ///< first byte of the value in `text`
    std::uint32_t size;     ///< bytes of the value
  };
  /// The values that one line of the file gives to one entity or to a run of entities.
  struct Row {
    MtgVertex first;    ///< first entity with these values
    MtgVertex last;     ///< last entity with these values
    std::size_t begin;  ///< first of the row's cells
    std::size_t end;    ///< behind the last of the row's cells
  };
  std::vector<Row> rows;    ///< in the order of the file; a later row replaces values of an earlier one
  std::vector<Cell> cells;  ///< cells of all rows
  std::string text;         ///< text of all cells
};

/// Entities in the order of the file. Vertex 0 is the scene, the only vertex of scale 0. The complex and the parent of
/// a vertex come before it.
struct MtgTree {
  std::vector<MtgClass> classes;     ///< declared classes; entity types are indices into this list
  std::vector<MtgFeature> features;  ///< declared features
  // One entry per vertex.
  std::vector<std::uint32_t> type;  ///< index into `classes`
  std::vector<std::int32_t> index;  ///< the number in its label, or -1
  std::vector<MtgVertex> complex;   ///< the coarser entity that contains it, one scale up; kNoVertex for the scene
  std::vector<MtgVertex> parent;    ///< the entity of the same scale that bears it, or kNoVertex
  std::vector<MtgEdge> edge;        ///< how it is joined to its parent
  std::vector<std::uint32_t> line;  ///< line of the file, from 1
  MtgValues values;                 ///< values of the features

  std::size_t vertex_count() const { return type.size(); }  ///< number of entities, the scene included
  /// Returns the scale of an entity's class.
  int scale(MtgVertex vertex) const { return classes[type[vertex]].scale; }
  /// Returns the finest scale that has entities.
  int finest_scale() const;
  /// Returns the class and number of an entity, such as "S12". Without a number, returns the class alone.
  std::string label(MtgVertex vertex) const;

  /// Returns the index of the feature with this name, or nothing if it does not exist.
  std::optional<std::uint32_t> find_feature(std::string_view name) const;
  /// Returns a feature's value for every vertex; NaN if it is missing or not a number.
  std::vector<double> numbers(std::uint32_t feature) const;
  /// Returns a feature's value for every vertex as written, empty if it is missing. The texts point into `values.text`.
  std::vector<std::string_view> texts(std::uint32_t feature) const;
};

/// Reads the text of an MTG file. Throws one InputError with all errors (up to the limit), each with line and column in
/// `file`. More entities than `limits.nodes` are an error. Cost and memory: linear in the text and the entities.
MtgTree read_mtg(std::string_view text, const std::string& file, const SizeLimits& limits);

}  // namespace meristem

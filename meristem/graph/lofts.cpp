// SPDX-License-Identifier: Apache-2.0
// Sections are joined into chains. Each chain is described in the frame of its first section, in units of its own size;
// equal chains then differ only by rounding. A chain is stored in a drawer by three weighted sums over its description,
// because equal chains have nearly equal sums. A chain is compared only with chains in its own and the neighbouring
// drawers. Full drawers accept no more chains, so in a crowd of slightly different chains some equal ones may get a
// mesh each.
#include "meristem/graph/lofts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

namespace {

constexpr double kSame = 1e-4;      // largest difference between equal chains, as a share of the chain's size
constexpr double kRounding = 3e-7;  // rounding of 32-bit numbers, as a share of a point's distance from the origin
constexpr std::size_t kMaxInDrawer = 4;
constexpr double kDrawer = 5e-4;    // width of a drawer, in units of the weighted sums
constexpr std::size_t kGrain = 16;  // chains that one thread meshes at a time

/// The sections of one surface from base to tip.
struct Chain {
  std::vector<std::uint32_t> sections;
  bool is_side = false;  ///< true: its first section belongs to another surface
  Frame frame;           ///< rigid frame of the first section
  float size = 0;        ///< metres
};

/// Points and directions of a section, relative to its chain's frame and size.
using Description = std::array<double, 12>;
/// Number of a drawer: three whole numbers.
using Drawer = std::array<double, 3>;

class SectionJoiner {
 public:
  SectionJoiner(std::span<const SurfaceSection> sections, const Graph& graph, Progress& progress)
      : sections_(sections), graph_(graph), progress_(progress) {}

  std::vector<SurfacePiece> run(std::uint64_t mesh_bytes) {
    make_chains();
    find_equals();
    check_bytes(mesh_bytes);
    std::vector<std::vector<SurfacePiece>> made(distinct_.size());
    progress_.begin("joining surfaces", distinct_.size());
    parallel_for(distinct_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) made[k] = make_pieces(chains_[distinct_[k]]);
      progress_.advance(end - begin);
    });
    for (std::size_t k = 0; k < chains_.size(); ++k) place(chains_[k], chains_[distinct_[kind_[k]]], made[kind_[k]]);
    std::vector<SurfacePiece> pieces;
    for (std::vector<SurfacePiece>& of_chain : made) {
      for (SurfacePiece& piece : of_chain) {
        if (piece.mesh == nullptr) continue;
        count_bytes(mesh_bytes += piece.mesh->bytes(), piece.component);
        pieces.push_back(std::move(piece));
      }
    }
    return pieces;
  }

 private:
  static const LoftSection& outline(const SurfaceSection& section) { return section.outline->section; }
  static bool is_ring(const SurfaceSection& section) {
    return outline(section).is_closed && !outline(section).is_point();
  }

  void make_chains() {
    constexpr std::uint32_t kNone = 0xffffffffU;
    const auto count = static_cast<std::uint32_t>(sections_.size());
    std::unordered_map<std::uint64_t, std::uint32_t> number;
    for (std::uint32_t k = 0; k < count; ++k) number.try_emplace(sections_[k].id, k);
    std::vector<std::uint32_t> parent(count, kNone), next(count, kNone);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto found = number.find(sections_[k].parent);
      if (found == number.end()) continue;
      parent[k] = found->second;
      if (next[parent[k]] == kNone) next[parent[k]] = k;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
      if (parent[k] != kNone && next[parent[k]] == k) continue;
      Chain chain{.is_side = parent[k] != kNone};
      if (chain.is_side) chain.sections.push_back(parent[k]);
      for (std::uint32_t section = k; section != kNone; section = next[section]) chain.sections.push_back(section);
      const SurfaceSection& first = sections_[chain.sections[0]];
      if (chain.sections.size() == 1 && !(is_ring(first) && first.is_capped)) continue;
      measure(chain);
      if (chain.size > 0) chains_.push_back(std::move(chain));
    }
  }

  void measure(Chain& chain) const {
    const Frame& first = sections_[chain.sections[0]].frame;
    chain.frame = frame_along(first.origin, first.heading(), first.upper());
    for (const std::uint32_t k : chain.sections) {
      const Frame& frame = sections_[k].frame;
      float widest = 0;
      for (int axis = 0; axis < 3; ++axis) widest = std::max(widest, glm::length(frame.axes[axis]));
      const float reach = glm::distance(frame.origin, first.origin) + widest * sections_[k].outline->extent;
      chain.size = std::max(chain.size, reach);
    }
  }

  /// Returns the frame of the chain's k-th section, relative to the chain's frame.
  Frame inner_frame(const Chain& chain, std::size_t k) const {
    const Frame& frame = sections_[chain.sections[k]].frame;
    const Mat3 back = glm::transpose(chain.frame.axes);
    return {back * frame.axes, back * (frame.origin - chain.frame.origin)};
  }

  Description description(const Chain& chain, std::size_t k) const {
    const Frame inner = inner_frame(chain, k);
    const double extent = sections_[chain.sections[k]].outline->extent;
    Description numbers{};
    for (int axis = 0; axis < 3; ++axis) {
      numbers[static_cast<std::size_t>(axis)] = inner.origin[axis] / chain.size;
      for (int column = 0; column < 3; ++column) {
        numbers[static_cast<std::size_t>(3 + 3 * axis + column)] = extent * inner.axes[axis][column] / chain.size;
      }
    }
    return numbers;
  }

  /// Returns true if a new piece of the surface begins at the chain's k-th section.
  bool begins_piece(const Chain& chain, std::size_t k) const {
    if (k == 0) return true;
    const SurfaceSection& section = sections_[chain.sections[k]];
    const SurfaceSection& before = sections_[chain.sections[k - 1]];
    return section.component != before.component || section.tint != before.tint;
  }

  /// Returns a hash of the properties that equal chains share exactly.
  std::uint64_t kind_of(const Chain& chain) const {
    std::uint64_t kind = chain.is_side ? 1 : 0;
    for (std::size_t k = 0; k < chain.sections.size(); ++k) {
      const SurfaceSection& section = sections_[chain.sections[k]];
      const RandomKey key = RandomKey(kind).child(section.outline->key).child(section.component);
      kind = key.child((section.is_capped ? 2 : 0) + (begins_piece(chain, k) ? 1 : 0)).bits();
    }
    return kind;
  }

  static double remoteness(const Chain& chain) { return glm::length(DVec3(chain.frame.origin)) / chain.size; }

  /// Returns true if two chains of one kind are equal up to rounding.
  bool are_equal(const Chain& a, const Chain& b) const {
    const double same = std::max(kSame, kRounding * std::max(remoteness(a), remoteness(b)));
    // Begins at the tip, where the differences along the chain have added up.
    for (std::size_t k = a.sections.size(); k-- > 0;) {
      const Description of_a = description(a, k), of_b = description(b, k);
      for (std::size_t i = 0; i < of_a.size(); ++i) {
        if (!(std::abs(of_a[i] - of_b[i]) < same)) return false;
      }
    }
    return true;
  }

  /// Returns the weighted sums of a chain, in widths of a drawer.
  Drawer drawer_of(const Chain& chain) const {
    const RandomKey weights(chain.sections.size());
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < chain.sections.size(); ++k) {
      const Description numbers = description(chain, k);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::uint64_t index = 2 * (numbers.size() * k + i);
        sum[0] += (weights.uniform(index, 0) - 0.5) * numbers[i];
        sum[1] += (weights.uniform(index, 1) - 0.5) * numbers[i];
        sum[2] += (weights.uniform(index + 1, 0) - 0.5) * numbers[i];
      }
    }
    const double width = kDrawer * std::sqrt(static_cast<double>(chain.sections.size()));
    Drawer drawer{};
    for (std::size_t k = 0; k < 3; ++k) drawer[k] = std::floor(sum[k] / width);
    return drawer;
  }

  /// Finds for each chain the first chain that is equal to it.
  void find_equals() {
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> files;
    for (std::uint32_t k = 0; k < chains_.size(); ++k) {
      if (k % 1024 == 0) progress_.check();
      const Chain& chain = chains_[k];
      const std::uint64_t kind = kind_of(chain);
      const Drawer own = drawer_of(chain);
      const auto key = [&](const Drawer& drawer) {
        return shape_key({drawer[0], drawer[1], drawer[2], static_cast<double>(kind >> 32),
                          static_cast<double>(kind & 0xffffffffU)});
      };
      auto equal = static_cast<std::uint32_t>(distinct_.size());
      for (int near = 0; near < 27; ++near) {
        const auto found = files.find(key({own[0] + near % 3 - 1, own[1] + near / 3 % 3 - 1, own[2] + near / 9 - 1}));
        if (found == files.end()) continue;
        for (const std::uint32_t candidate : found->second) {
          if (candidate < equal && are_equal(chains_[distinct_[candidate]], chain)) equal = candidate;
        }
      }
      kind_.push_back(equal);
      if (equal < distinct_.size()) continue;
      distinct_.push_back(k);
      std::vector<std::uint32_t>& drawer = files[key(own)];
      if (drawer.size() < kMaxInDrawer) drawer.push_back(equal);
    }
  }

  /// Throws InputError if the meshes will certainly exceed the limit of bytes. Called before any mesh is made.
  void check_bytes(std::uint64_t mesh_bytes) const {
    constexpr std::uint64_t kOfVertex = 2 * sizeof(Vec3) + sizeof(Vec2);
    constexpr std::uint64_t kOfTriangle = 3 * sizeof(std::uint32_t);
    for (const std::uint32_t chain : distinct_) {
      for (const std::uint32_t k : chains_[chain].sections) {
        const std::uint64_t points = outline(sections_[k]).points.size();
        mesh_bytes += points * kOfVertex + (points - 1) * kOfTriangle;
        count_bytes(mesh_bytes, sections_[k].component);
      }
    }
  }

  void count_bytes(std::uint64_t bytes, ComponentIndex component) const {
    if (bytes <= graph_.limits.mesh_bytes) return;
    throw_limit("bytes of surfaces", static_cast<double>(bytes), graph_.limits.mesh_bytes, "mesh_bytes",
                "components." + graph_.components[component].id);
  }

  /// Returns the chain's meshes, in the frame of its first section. A piece without triangles has no mesh.
  std::vector<SurfacePiece> make_pieces(const Chain& chain) const {
    std::vector<LoftSection> skin;
    bool is_open = false;
    for (std::size_t k = 0; k < chain.sections.size(); ++k) {
      const SurfaceSection& section = sections_[chain.sections[k]];
      const bool is_end = (k == 0 && !chain.is_side) || k + 1 == chain.sections.size();
      is_open = is_open || (!outline(section).is_closed && !outline(section).is_point()) ||
                (is_end && is_ring(section) && !section.is_capped);
      const Frame inner = inner_frame(chain, k);
      LoftSection& moved = skin.emplace_back(outline(section));
      for (Vec3& point : moved.points) point = inner.point(point);
    }
    is_open = is_open || skin.size() == 1;
    const LoftCaps caps{.first = !chain.is_side && sections_[chain.sections.front()].is_capped,
                        .last = sections_[chain.sections.back()].is_capped};
    Loft loft = make_loft(skin, caps);
    std::vector<SurfacePiece> pieces;
    for (std::size_t begin = 0; begin < skin.size();) {
      std::size_t end = begin + 1;
      while (end < skin.size() && !begins_piece(chain, end)) ++end;
      SurfacePiece& piece = pieces.emplace_back();
      piece.component = sections_[chain.sections[begin]].component;
      piece.is_open = is_open;
      Mesh mesh = part_of(loft.mesh, loft.first_triangle[begin], loft.first_triangle[end]);
      lay_picture(graph_.components[piece.component].base().texture, mesh);
      if (!mesh.triangles.empty()) piece.mesh = std::make_shared<const Mesh>(std::move(mesh));
      begin = end;
    }
    return pieces;
  }

  static Mesh part_of(Mesh& whole, std::uint32_t begin, std::uint32_t end) {
    if (begin == 0 && end == whole.triangle_count()) return std::move(whole);
    Mesh part;
    std::unordered_map<std::uint32_t, std::uint32_t> number;
    for (std::uint32_t t = begin; t < end; ++t) {
      std::array<std::uint32_t, 3> triangle = whole.triangles[t];
      for (std::uint32_t& vertex : triangle) {
        const auto [found, is_new] = number.try_emplace(vertex, static_cast<std::uint32_t>(part.vertex_count()));
        if (is_new) {
          part.positions.push_back(whole.positions[vertex]);
          part.normals.push_back(whole.normals[vertex]);
          part.uvs.push_back(whole.uvs[vertex]);
        }
        vertex = found->second;
      }
      part.triangles.push_back(triangle);
    }
    return part;
  }

  /// Adds an organ for each piece of a chain that is equal to `model`.
  void place(const Chain& chain, const Chain& model, std::vector<SurfacePiece>& pieces) const {
    Frame frame = chain.frame;
    if (&chain != &model) frame.axes *= chain.size / model.size;
    std::size_t piece = 0;
    for (std::size_t k = 0; k < chain.sections.size(); ++k) {
      if (!begins_piece(chain, k)) continue;
      const SurfaceSection& section = sections_[chain.sections[k]];
      // Several chains may begin with one section, so the next section tells them apart.
      const std::uint64_t next = chain.sections.size() > 1 ? sections_[chain.sections[1]].id : 0;
      pieces[piece].organs.push_back({.frame = frame,
                                      .tint = section.tint,
                                      .birth = section.birth,
                                      .individual = section.individual,
                                      .name = RandomKey(section.id).child(next).bits()});
      pieces[piece++].deformations.push_back(section.deformation);
    }
  }

  std::span<const SurfaceSection> sections_;
  const Graph& graph_;
  Progress& progress_;
  std::vector<Chain> chains_;
  std::vector<std::uint32_t> distinct_;  // chains without an equal one before them
  std::vector<std::uint32_t> kind_;      // by chain: index of its equal among the distinct chains
};

}  // namespace

std::vector<SurfacePiece> join_sections(std::span<const SurfaceSection> sections, const Graph& graph,
                                        std::uint64_t mesh_bytes, Progress& progress) {
  if (sections.empty()) return {};
  return SectionJoiner(sections, graph, progress).run(mesh_bytes);
}

}  // namespace meristem

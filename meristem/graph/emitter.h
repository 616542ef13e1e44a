// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/graph/animation.h"
#include "meristem/graph/component_member.h"
#include "meristem/graph/minimum_counts.h"
#include "meristem/graph/organ_list.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/site_list.h"
#include "meristem/graph/table/count.h"
#include "meristem/graph/table/plant_source.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/table/varying.h"
#include "meristem/graph/trimmed_stem.h"
#include "meristem/grow/growth_trace.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

struct ComponentBase;
struct EmitterContext;

/// Returns a key for geometry that instances with these numbers share.
std::uint64_t shape_key(std::initializer_list<double> numbers);

/// A stem, with the facts that its children need.
struct EmittedStem {
  Skeleton skeleton;                           ///< the grown skeleton, world space
  std::shared_ptr<const Surface> surface;      ///< surface options, never null
  std::shared_ptr<const Placement> branching;  ///< placement of its branches, for keys that links do not give; may be
                                               ///< null
  Site site;                                ///< site of the instance that made the stem, with a key of the stem's own
  bool visible = true;                      ///< false: only its children are visible
  Vec3 tint{1};                             ///< linear factors on the material's colour
  std::unique_ptr<const Skeleton> moved{};  ///< visible skeleton if `place` moves it; else null
  float moved_scale = 1;                    ///< size of the moved skeleton relative to the original
  /// Number of the root on which each node stands, if each root is a plant of its own. Else empty.
  std::vector<std::uint32_t> root_of_node{};
  std::shared_ptr<const TrimmedStem> trimmed{};  ///< the whole stem, if `skeleton` is its trimmed rest; null: not
                                                 ///< trimmed
  std::shared_ptr<const GrowingStem> growing{};  ///< set if the stem is shown at a step of its growth; `trimmed` is
                                                 ///< then set too

  std::uint64_t id() const { return site.key.bits(); }  ///< Returns the stem's id, which is Site::stem of sites on it.
  /// Returns the deformation of the stem, or null.
  const std::shared_ptr<const Deformation>& deformation() const { return deformation_at(site); }
  /// Returns Site::individual of sites on the root with this number.
  std::uint64_t individual_of_root(std::uint32_t root) const {
    return root == 0 ? site.individual : site.key.child("root").child(root).bits();
  }
  /// Returns Site::individual of sites on this node.
  std::uint64_t individual_at(NodeIndex node) const {
    return root_of_node.empty() ? site.individual : individual_of_root(root_of_node[node]);
  }
};

/// The points of a section, in its own frame.
struct SectionOutline {
  std::uint64_t key = 0;  ///< outlines of one component with equal keys are equal
  LoftSection section;    ///< points of the section
  float extent = 0;       ///< from the origin to the farthest point, metres
};

/// A section of a surface. Surfaces are joined after all sections have been emitted.
struct EmittedSection {
  std::shared_ptr<const SectionOutline> outline;     ///< not null
  Frame frame;                                       ///< frame of the outline, in world space
  bool is_capped = true;                             ///< true: a flat face closes a ring at the end of its surface
  std::uint64_t id = 0;                              ///< never 0
  std::uint64_t parent = 0;                          ///< id of the section that it continues, or 0
  Vec3 tint{1};                                      ///< linear factors on the material's colour
  float birth = 0;                                   ///< growth step at which it appeared
  std::uint64_t individual = 0;                      ///< as in Site
  std::shared_ptr<const Deformation> deformation{};  ///< deformation of the section, or null
};

/// The parts that the instances of one block have emitted. They depend only on the component, its instances and the
/// scene.
struct Emitted {
  /// A mesh that organs of the block share.
  struct EmittedPrototype {
    std::uint64_t key = 0;             ///< key that the component gave
    std::shared_ptr<const Mesh> mesh;  ///< not null
    bool is_blade = false;             ///< true: has the material of blades
  };
  /// A plant that begins with one of the instances.
  struct Founded {
    std::uint64_t id = 0;                              ///< id of the plant
    Vec3 foot{0};                                      ///< position of its base, metres
    std::shared_ptr<const Deformation> deformation{};  ///< deformation of its base, or null
    std::uint32_t row = kNoRow;                        ///< row of the table that placed it
  };
  /// The deformation of the block's organs, from this organ up to the organ of the next entry.
  struct DeformedFrom {
    std::size_t organ = 0;                           ///< index of the organ in the block
    std::shared_ptr<const Deformation> deformation;  ///< null: not deformed
  };
  std::vector<EmittedPrototype> prototypes;  ///< meshes that organs share
  OrganList organs;                        ///< organs; their prototypes and individuals are numbered within this block
  std::vector<DeformedFrom> deformed;      ///< empty if no organ is deformed
  std::vector<Founded> founded;            ///< plants that begin with instances of the block
  std::vector<std::uint64_t> individuals;  ///< ids of the plants to which organs belong
  std::vector<EmittedSection> sections;    ///< sections of surfaces
  std::vector<EmittedStem> stems;          ///< stems, in the order in which they were emitted
  SiteList child_sites;                    ///< with the key and depth of the parent
  SiteList branch_sites;                   ///< sites for the children of branch links
  SiteList named_sites;                    ///< sites for components that the instances place
  std::vector<std::uint32_t> site_names;   ///< number of the name of each named site
  /// A whole plant of another document.
  struct PlacedPlant {
    Frame frame;                                       ///< from the plant's world to the world
    std::shared_ptr<const PlantSource> source;         ///< not null
    PlantRequest request;                              ///< values and seed
    float birth = 0;                                   ///< growth step at which it appeared
    bool is_visible = true;                            ///< false: not visible
    std::shared_ptr<const Deformation> deformation{};  ///< deformation of the plant, or null
    std::uint32_t row = kNoRow;                        ///< row of the table that placed it
    std::uint64_t name = 0;                            ///< as in Planting::Place
  };
  std::vector<PlacedPlant> plants;  ///< whole plants
  int growth_steps = 0;             ///< largest number of growth steps of an instance
};

/// Returns the key for the positions of children on a stem with this key.
inline RandomKey key_of_places(RandomKey stem) { return stem.child("branching"); }

/// Collects the parts that the instances of one block emit. One thread uses one emitter; blocks are merged in their
/// order.
///
/// An instance whose frame has shrunk to nothing emits nothing, and neither do its children. Throws InputError for
/// frames that are not finite. Also throws InputError if the sites for children exceed the limit of instances, the
/// stems the limit of nodes, or the meshes the limit of bytes.
class Emitter : private Emitted {
 public:
  /// `context` must outlive the emitter.
  explicit Emitter(EmitterContext& context) : context_(&context) {}

  // For components.

  /// Emits geometry at `local` in the instance's frame (moved by its `place`). Instances of one component with equal
  /// `key` share a mesh, which one of them makes. The key, together with all that the instances have in common, must
  /// therefore determine the whole mesh. `tint` has linear factors on the instance's colour.
  void organ(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint = Vec3(1));
  /// Emits a flat shape with the component type's material of blades. The parameters are as for `organ`.
  void blade(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint = Vec3(1));
  /// Skips one organ index, so that later organs keep their index when this organ does not exist at the current time.
  void no_organ() { ++organs_of_instance_; }
  /// Emits a whole plant at `local` in the instance's frame (moved by its `place`). Equal requests of equal sources are
  /// grown once.
  void plant(const Frame& local, std::shared_ptr<const PlantSource> source, PlantRequest request);
  /// Emits a section of a surface at `local` in the instance's frame (moved by its `place`), once per instance.
  /// Sections of children by child and leaf links continue the surface. Instances of one component with equal `key`
  /// share the outline, which one of them makes.
  void section(const Frame& local, std::uint64_t key, bool is_capped, FunctionRef<LoftSection()> make);
  /// Emits a skeleton in world space. The instance's `place` moves the skeleton, but not its children. `branching`, if
  /// given, is the placement of children by branch links, for keys that the links do not give. A trim body of the
  /// surroundings trims the skeleton by `trim`; later calls use the nodes of the whole skeleton. If the document's
  /// plants grow over time and the type supports it, the stem is shown at its clock's time, with a thickness by
  /// `pipe_exponent`.
  void stem(Skeleton skeleton, const Surface& surface, const Placement* branching = nullptr,
            TrimMode trim = TrimMode::cut, double pipe_exponent = 2);
  /// Declares that the instance's stems have already grown up to its clock's time. The time then cuts nothing off them.
  void stands_as_grown() { stands_as_grown_ = true; }
  /// Sets the growth step at which the last site of named_site appeared. Used if stems grow over time and the
  /// instance's stems have already grown.
  void born(double step);
  /// Returns true if the instance's stems grow over time.
  bool grows_in_time() const;
  /// Returns the step, with a fraction, at which the instance shows a growth of `last` steps. This is the shown step of
  /// the document, or the step of the clock if stems grow over time, or else `last`. take_grown() returns the skeleton
  /// of that step.
  double grown_to(double last);
  /// Returns the growth steps per second and the seconds that shed branches stay. Used if stems grow over time.
  const Animation& animation() const;
  /// Emits an invisible skeleton for the children of branch links.
  void unseen_stem(Skeleton skeleton, TrimMode trim = TrimMode::cut);
  /// Returns the position of a frame, in world space, on the rest of the last emitted stem. The frame stands on `node`
  /// of the whole stem. Returns nothing if that part was trimmed away. Returns the frame unchanged for kNoNode.
  std::optional<Frame> on_stem_left(NodeIndex node, const Frame& frame) const;
  /// Returns the remaining share of the length of the last emitted stem, which must be a single axis. Returns 1 if it
  /// is whole.
  float length_left() const;
  /// Emits a site for children, relative to the instance's frame. Its length and radius are relative to the frame, too.
  /// Several calls multiply the children. Without a call, children stand in the instance's frame, unless `no_children`
  /// was called.
  void child_site(const Frame& local, float length = 0, float radius = 0);
  /// Emits a site for children at the tip of the last emitted stem, which must be a single axis. The frame, the stem's
  /// length and the radius at the tip are in world space and belong to the whole stem.
  void tip_site(const Frame& frame, float length, float radius);
  /// Makes sites only by `child_site`: for components whose number of children may be 0.
  void no_children() { has_child_sites_ = true; }
  /// Returns a number for each of `count` children of the instance, in the struct's unit. Expressions use the
  /// children's i and n and own random numbers; everything else belongs to the instance.
  std::vector<double> per_child(const PerChild& number, std::uint32_t count) const;
  /// Announces that `count` sites will be emitted, before anything is made for them. Throws InputError if they exceed
  /// the limit.
  void expect_children(std::uint64_t count);
  /// Like `expect_children`, for a count of the instance's parameters, which may have a fraction. The site of the last
  /// child is scaled by the fractional part. Returns the number of sites to emit. If the count has keys, each child
  /// appears when the count reaches its number.
  std::uint32_t expect_parts(const ComponentMember<Count>& count);
  /// Begins a clock for all descendants of the instance. It starts `delay` seconds after the instance appears, by the
  /// instance's own clock, and runs at `speed`. Returns true if it has started.
  bool begin_clock(double delay, double speed);
  /// Emits a site for the children of branch links that differs from the sites of child links. Without a call, and for
  /// components without stems, these children stand at the sites of child links.
  void branch_site(const Frame& local, float u, float length, float radius);
  /// Emits a site for the children of branch links in world space, on the last emitted stem. It stands at the share
  /// `along` of the segment that ends in `node`.
  void branch_site_on_stem(const Frame& frame, float u, float length, float radius, NodeIndex node, float along);

  /// Emits a site in world space for a component that the instance places. `name` is its index in the type's `placed`.
  /// `node` is a node of the last emitted stem, or kNoNode.
  void named_site(std::uint32_t name, const Frame& frame, float length, float radius, NodeIndex node);

  /// Gives these numbers to the last site of child_site or named_site, under the names that the type's `gives` lists.
  /// All descendants can use them.
  void give(std::span<const double> numbers, bool to_named);
  /// Sets the row of a table that has placed the last site of child_site or named_site.
  void from_row(std::uint32_t row, bool is_named);

  /// Returns the key for the positions of children on the next emitted stem, if that has a `branching`.
  RandomKey places_on_next_stem() const { return key_of_places(site_.key.child("stem").child(stems_of_instance_)); }

  /// Sets the surroundings (light, gravity, deformation, trim body) of all descendants of this instance. Affects sites
  /// and stems emitted after this call. The surroundings may depend only on the instance's parameters and site.
  void surround(Surroundings said);

  /// Returns the scene in which the plant grows.
  const Scene& scene() const;
  /// Returns the surroundings that the components above have set.
  const Surroundings& surroundings() const;
  /// Returns the directions toward the light and down, for any position in the instance's surroundings. Components use
  /// them to bend.
  const Directions& directions() const;
  /// Returns the limits of the document.
  const Limits& limits() const;
  const std::string& component() const;  ///< id, for errors
  /// Returns true if a member of the component's parameters, or a part of it, differs from instance to instance.
  template <class M>
  bool varies(const ComponentMember<M>& member) const {
    return KnownMembers(varyings()).varies(member);
  }
  /// Returns the progress of the expansion, for a cancel.
  Progress& progress() const;
  /// Returns the time of the instance's clock, seconds.
  double time() const;
  /// Returns the component's key, for random numbers that its instances share. Meshes that depend on it must include it
  /// in their key.
  RandomKey component_key() const;
  /// Returns the grown skeleton of this instance. Only for components that grow, and once per instance.
  Skeleton take_grown();
  /// Returns the growth of the instance that this one shows (Showing) on the same parent. Returns null if the component
  /// does not use that growth (ComponentDefinition::watches_growth).
  const GrowthTrace* watched_growth() const { return watched_.get(); }

  // For the graph.

  /// Calls `expand` for one instance, unless it is omitted; `index` counts within the block.
  void instance(const ComponentBase& base, const Site& site, std::size_t index, FunctionRef<void(const Site&)> expand);
  /// Sets the skeletons of the block's instances, which take_grown() returns in turn.
  void set_grown(std::vector<Skeleton> skeletons) { grown_ = std::move(skeletons); }
  /// Sets the growth that watched_growth() returns.
  void set_watched(std::shared_ptr<const GrowthTrace> watched) { watched_ = std::move(watched); }

  /// Returns everything that was emitted. Must be called once per emitter.
  Emitted take();

 private:
  std::span<const Varying> varyings() const;
  void begin_instance(const ComponentBase& base, const Site& site);
  void end_instance();
  void finish_sites(SiteList& sites, std::size_t first, bool has_parts);
  void add_organ(const Frame& local, std::uint64_t key, bool is_blade, FunctionRef<Mesh()> make, Vec3 tint);
  void note_deformation();
  void number_named_sites();
  const Varying* keys_of_parts() const;
  void tell_part(Site& site) const;
  bool is_individual() const { return site_.individual == site_.key.bits(); }
  void tell_roots_apart(EmittedStem& stem);
  void offer_child(const Frame& frame, float length, float radius);
  std::optional<StemPosition> left_of(StemPosition whole) const;
  void put_on_stem(StemPosition whole, Site& site) const;
  std::shared_ptr<const TrimmedStem> trimmed_stem(Skeleton skeleton, TrimMode trim, const GrowingStem* growing,
                                                  double pipe_exponent) const;
  std::uint32_t number_of_individual();
  std::uint64_t next_name() { return site_.key.child("organ").child(organs_of_instance_++).bits(); }
  void add_site(SiteList& sites, const Frame& frame, float u, float length, float radius);
  std::shared_ptr<const Surface> shared_surface(Surface surface);
  void count_sites();
  [[noreturn]] void throw_too_many_children() const;
  void count_nodes(std::uint64_t more);
  std::shared_ptr<const Mesh> shared_mesh(std::uint64_t key, FunctionRef<Mesh()> make);

  EmitterContext* context_;
  std::size_t instance_ = 0;
  Site site_;             // site of the present instance, with the instance's own frame
  Frame geometry_frame_;  // the instance's own frame, moved by `place`
  Vec3 tint_{1};
  std::shared_ptr<const Surroundings> surroundings_;  // surroundings of the present instance; null: not set
  const ComponentBase* base_ = nullptr;               // parameters of the present instance
  std::uint64_t parent_section_ = 0;                  // section that the instance stands on
  std::uint64_t section_ = 0;                         // section that the instance has emitted
  bool is_placed_ = false;
  bool visible_ = true;
  bool has_child_sites_ = false;
  bool stands_as_grown_ = false;
  std::size_t first_child_ = 0;
  std::size_t first_branch_ = 0;
  std::size_t first_named_ = 0;
  std::uint32_t stems_of_instance_ = 0;
  std::uint32_t organs_of_instance_ = 0;
  std::uint64_t uncounted_ = 0;                  // number of sites that are not yet in the context's count
  const Varying* keyed_parts_ = nullptr;         // keys of the present instance's count of parts, or null
  std::optional<ComponentMember<Count>> parts_;  // the present instance's count of parts, if it has announced one
  std::uint64_t expected_ = 0;                   // the present instance's number of children, if it has announced it
  std::unordered_map<std::uint64_t, std::uint32_t> prototype_by_key_;
  std::unordered_map<std::uint64_t, std::uint32_t> individual_by_id_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const SectionOutline>> outline_by_key_;
  std::vector<Skeleton> grown_;
  std::shared_ptr<const GrowthTrace> watched_;
  std::shared_ptr<const Placement>
      branching_;                           // placement of the stem emitted last, since most stems have an equal one
  std::shared_ptr<const Surface> surface_;  // surface of the stem emitted last, since most stems have an equal one
};

}  // namespace meristem

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
#include "meristem/graph/placement.h"
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

/// A key for geometry that instances with these numbers share.
std::uint64_t shape_key(std::initializer_list<double> numbers);

/// A stem with what its children need to know.
struct EmittedStem {
  Skeleton skeleton;                           ///< the grown skeleton, world space
  Surface surface;                             ///< surface options
  std::shared_ptr<const Placement> branching;  ///< where its branches stand, as far as links do not say; may be null
  Site site;                      ///< site of the instance that made the stem, with a key of the stem's own
  bool visible = true;            ///< false: only its children are seen
  Vec3 tint{1};                   ///< linear factors on the material's colour
  std::optional<Skeleton> moved;  ///< what is seen instead of the skeleton where `place` moves it
  float moved_scale = 1;          ///< how many times larger it is there
  /// Number of the root that each node stands on, where each root is a plant of its own; else empty.
  std::vector<std::uint32_t> root_of_node{};
  std::shared_ptr<const TrimmedStem> trimmed{};  ///< of which `skeleton` is what is left; null: it is whole
  std::shared_ptr<const GrowingStem> growing{};  ///< it stands as at a step of its growth, and so is `trimmed`; or null

  std::uint64_t id() const { return site.key.bits(); }  ///< Site::stem of sites on it
  /// Returns the deformation of the stem, or null.
  const std::shared_ptr<const Deformation>& deformation() const { return deformation_at(site); }
  /// What Site::individual says of sites on the root of this number, and on this node.
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

/// A section of a surface that is put together when all have been emitted.
struct EmittedSection {
  std::shared_ptr<const SectionOutline> outline;     ///< not null
  Frame frame;                                       ///< frame of the outline, in world space
  bool is_capped = true;                             ///< a ring is closed by a flat face where its surface ends
  std::uint64_t id = 0;                              ///< never 0
  std::uint64_t parent = 0;                          ///< id of the section that it continues, or 0
  Vec3 tint{1};                                      ///< linear factors on the material's colour
  float birth = 0;                                   ///< growth step at which it appeared
  std::uint64_t individual = 0;                      ///< as in Site
  std::shared_ptr<const Deformation> deformation{};  ///< deformation of the section, or null
};

/// What the instances of one block have emitted. It depends on the component, its instances and the scene alone, and
/// not on what else there is.
struct Emitted {
  /// A mesh that organs of the block share.
  struct EmittedPrototype {
    std::uint64_t key = 0;             ///< key that the component gave
    std::shared_ptr<const Mesh> mesh;  ///< not null
    bool is_blade = false;             ///< true: has the material of blades
  };
  /// A plant that begins with one of the instances, with its id.
  struct Founded {
    std::uint64_t id = 0;                              ///< id of the plant
    Vec3 foot{0};                                      ///< position of its base, metres
    std::shared_ptr<const Deformation> deformation{};  ///< deformation of its base, or null
    std::uint32_t row = kNoRow;                        ///< row of the table that placed it
  };
  /// From that organ of the block on, up to the next of these.
  struct DeformedFrom {
    std::size_t organ = 0;                           ///< index of the organ in the block
    std::shared_ptr<const Deformation> deformation;  ///< null: none
  };
  std::vector<EmittedPrototype> prototypes;  ///< meshes that organs share
  std::vector<Organ> organs;  ///< the prototypes and individuals that organs name are numbered within this block
  std::vector<DeformedFrom> deformed;                       ///< empty where no organ is
  std::vector<Founded> founded;                             ///< plants that begin with instances of the block
  std::vector<std::uint64_t> individuals;                   ///< ids of those that the organs belong to
  std::vector<EmittedSection> sections;                     ///< sections of surfaces
  std::vector<EmittedStem> stems;                           ///< stems, in the order in which they were emitted
  std::vector<Site> child_sites;                            ///< with the key and depth of the instance that offers them
  std::vector<Site> branch_sites;                           ///< sites for the children of branch links
  std::vector<std::pair<std::uint32_t, Site>> named_sites;  ///< with the number of the name
  /// A whole plant that is grown of a document of its own.
  struct PlacedPlant {
    Frame frame;                                       ///< from the plant's world to the world
    std::shared_ptr<const PlantSource> source;         ///< not null
    PlantRequest request;                              ///< values and seed
    float birth = 0;                                   ///< growth step at which it appeared
    bool is_visible = true;                            ///< false: not seen
    std::shared_ptr<const Deformation> deformation{};  ///< deformation of the plant, or null
    std::uint32_t row = kNoRow;                        ///< row of the table that placed it
    std::uint64_t name = 0;                            ///< as in Planting::Place
  };
  std::vector<PlacedPlant> plants;  ///< whole plants
  int growth_steps = 0;             ///< the most that one of the instances has taken
};

/// The key for the positions of children on a stem with this key.
inline RandomKey key_of_places(RandomKey stem) { return stem.child("branching"); }

/// Takes what the instances of one block emit. One thread uses one emitter; blocks are merged in their order.
///
/// An instance whose frame has shrunk to nothing emits nothing, nor do its children. Throws InputError for frames
/// that are not finite, when the sites for children pass the limit of instances, the stems the limit of nodes, or the
/// meshes the limit of bytes.
class Emitter : private Emitted {
 public:
  /// `context` outlives the emitter.
  explicit Emitter(EmitterContext& context) : context_(&context) {}

  // For components.

  /// Geometry at `local` in the instance's frame (moved by its `place`). Instances of one component with equal `key`
  /// share what one of them makes, so the key and what all instances have in common must tell the whole mesh. `tint`
  /// has linear factors on the instance's colour.
  void organ(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint = Vec3(1));
  /// A flat shape, given as `organ` takes it, in the component type's material of blades.
  void blade(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint = Vec3(1));
  /// Says that an organ or a blade is not there at this time, so that those after it keep their names.
  void no_organ() { ++organs_of_instance_; }
  /// A whole plant at `local` in the instance's frame (moved by its `place`). Equal requests of equal sources are grown
  /// once.
  void plant(const Frame& local, std::shared_ptr<const PlantSource> source, PlantRequest request);
  /// A section of a surface at `local` in the instance's frame (moved by its `place`), once per instance. Where
  /// children by child and leaf links give sections too, their surface is one with it. Instances of one component with
  /// equal `key` share what one of them makes.
  void section(const Frame& local, std::uint64_t key, bool is_capped, FunctionRef<LoftSection()> make);
  /// A skeleton in world space. The instance's `place` moves it, but not its children.
  /// `branching`, if given, says where the children of branch links stand, as far as the links do not. A body that the
  /// surroundings give trims it as `trim` says; the nodes that the calls below name are those of the whole skeleton. In
  /// documents whose plants grow over time, a stem of a type that does so stands as at its clock's time, wood by
  /// `pipe_exponent`.
  void stem(Skeleton skeleton, const Surface& surface, const Placement* branching = nullptr,
            TrimMode trim = TrimMode::cut, double pipe_exponent = 2);
  /// Says that the instance has grown its stems as they are at its clock's time: nothing more is cut off them by time.
  void stands_as_grown() { stands_as_grown_ = true; }
  /// Says at which step the site that was offered last by named_site has come about; where stems grow over time, and
  /// the instance stands as it has grown.
  void born(double step);
  /// Whether the instance's stems grow over time.
  bool grows_in_time() const;
  /// How far a growth of `last` steps has come in what the instance shows: to the step at which the document is looked
  /// at, or, where stems grow over time, to the clock's, with a fraction; `last` if neither. What take_grown() gives is
  /// of that step already.
  double grown_to(double last);
  /// Steps that the document's growth takes per second, and seconds that shed branches stay; where stems grow over
  /// time.
  const Animation& animation() const;
  /// An invisible skeleton, for the children of branch links.
  void unseen_stem(Skeleton skeleton, TrimMode trim = TrimMode::cut);
  /// Where a frame in world space that stands on `node` of the stem emitted last stands on what is left of it, or
  /// nothing where it is gone; as it is for kNoNode.
  std::optional<Frame> on_stem_left(NodeIndex node, const Frame& frame) const;
  /// Share of the length that is left of the stem emitted last, which is a single axis; 1 where it is whole.
  float length_left() const;
  /// A site for children, relative to the instance's frame, as are the length and radius that they see; called n times
  /// it multiplies them. Without a call, children stand in the instance's frame, unless `no_children` was called.
  void child_site(const Frame& local, float length = 0, float radius = 0);
  /// A site for children at the tip of the stem emitted last, which is a single axis: its frame, the stem's length and
  /// the radius there, all in world space and of the whole stem.
  void tip_site(const Frame& frame, float length, float radius);
  /// Children stand only where `child_site` says: for components whose number of children may be 0.
  void no_children() { has_child_sites_ = true; }
  /// The values of a number for each of `count` children of the instance, in the struct's unit. Expressions see the
  /// children's i and n and draw random numbers of their own; all else that they see is the instance's.
  std::vector<double> per_child(const PerChild& number, std::uint32_t count) const;
  /// Says that `count` sites will be offered, before anything is made for them. Throws InputError where they are more
  /// than may be.
  void expect_children(std::uint64_t count);
  /// The same for a count of the instance's parameters, of which the last child is to have come to be by the fraction
  /// alone: its site gets smaller by that. Returns how many sites to offer. Where the count has keys, each child
  /// appears when the count reaches it.
  std::uint32_t expect_parts(const Count& count);
  /// Begins a clock for all that hangs on the instance: it starts `delay` seconds after the instance has appeared, by
  /// the clock that the instance itself has, and runs at `speed`. Returns whether it has started.
  bool begin_clock(double delay, double speed);
  /// A site for the children of branch links where it differs from those of child links. Without a call, and for
  /// components that make no stems, these stand where the children of child links do.
  void branch_site(const Frame& local, float u, float length, float radius);
  /// A site for the children of branch links in world space, on the stem emitted last: at the share `along` of the
  /// segment that ends in `node`.
  void branch_site_on_stem(const Frame& frame, float u, float length, float radius, NodeIndex node, float along);

  /// A site in world space for the component that the instance itself places, by its number in the type's `placed`;
  /// on `node` of the stem emitted last, or kNoNode.
  void named_site(std::uint32_t name, const Frame& frame, float length, float radius, NodeIndex node);

  /// Gives these numbers to the site that was offered last, by child_site or named_site, under the names that the
  /// type's `gives` lists; all descendants see them.
  void give(std::span<const double> numbers, bool to_named);
  /// Says which row of a table has placed the site that was offered last, by child_site or named_site.
  void from_row(std::uint32_t row, bool is_named);

  /// The key for the positions of children on the stem that is emitted next, if it brings its branching.
  RandomKey places_on_next_stem() const { return key_of_places(site_.key.child("stem").child(stems_of_instance_)); }

  /// Changes what all that hangs on the instance is told of the space around it: `said` is what its surroundings
  /// say, with the changes. It holds for the sites and stems that the instance emits from then on. What it is made of
  /// are the instance's parameters and site and nothing else.
  void surround(Surroundings said);

  /// The scene that the plant grows in.
  const Scene& scene() const;
  /// What the components above say of the space that the instance stands in.
  const Surroundings& surroundings() const;
  /// The directions toward the light and down, at any position of the instance's surroundings; components ask them
  /// where they bend.
  const Directions& directions() const;
  /// The limits of the document.
  const Limits& limits() const;
  const std::string& component() const;  ///< id, for errors
  /// Whether what stands at this byte offset from the beginning of the component's struct, a number or a list, differs
  /// from instance to instance.
  bool varies(std::size_t offset) const;
  /// The progress of the expansion, for a cancel.
  Progress& progress() const;
  /// What the clock of the instance shows, seconds.
  double time() const;
  /// The component's key, for what its instances have in common. Meshes that depend on it need it in their key.
  RandomKey component_key() const;
  /// The skeleton that this instance has grown; only for components that grow, and once per instance.
  Skeleton take_grown();
  /// The growth of the instance that this one shows (Showing) on the same parent, where the component watches it
  /// (ComponentDefinition::watches_growth); else null.
  const GrowthTrace* watched_growth() const { return watched_.get(); }

  // For the graph.

  /// Calls `expand` for one instance, unless it is omitted; `index` counts within the block.
  void instance(const ComponentBase& base, const Site& site, std::size_t index, FunctionRef<void(const Site&)> expand);
  /// Sets the skeletons of the block's instances, which take_grown() returns in turn.
  void set_grown(std::vector<Skeleton> skeletons) { grown_ = std::move(skeletons); }
  /// Sets the growth that watched_growth() returns.
  void set_watched(std::shared_ptr<const GrowthTrace> watched) { watched_ = std::move(watched); }

  /// All that was emitted, once an emitter.
  Emitted take() { return std::move(static_cast<Emitted&>(*this)); }

 private:
  void begin_instance(const ComponentBase& base, const Site& site);
  void end_instance();
  void add_organ(const Frame& local, std::uint64_t key, bool is_blade, FunctionRef<Mesh()> make, Vec3 tint);
  void note_deformation();
  void number_named_sites();
  void tell_parts(std::vector<Site>& sites, std::size_t first) const;
  bool is_individual() const { return site_.individual == site_.key.bits(); }
  void tell_roots_apart(EmittedStem& stem);
  void offer_child(const Frame& frame, float length, float radius);
  std::optional<StemPosition> left_of(StemPosition whole) const;
  void put_on_stem(StemPosition whole, Site& site) const;
  std::shared_ptr<const TrimmedStem> trimmed_stem(Skeleton skeleton, TrimMode trim, const GrowingStem* growing,
                                                  double pipe_exponent) const;
  std::uint32_t number_of_individual();
  std::uint64_t next_name() { return site_.key.child("organ").child(organs_of_instance_++).bits(); }
  void add_site(std::vector<Site>& sites, const Frame& frame, float u, float length, float radius);
  void count_sites();
  [[noreturn]] void throw_too_many_children() const;
  void count_nodes(std::uint64_t more);
  std::shared_ptr<const Mesh> shared_mesh(std::uint64_t key, FunctionRef<Mesh()> make);

  EmitterContext* context_;
  std::size_t instance_ = 0;
  Site site_;             // site of the present instance, with the instance's own frame
  Frame geometry_frame_;  // that frame moved by `place`
  Vec3 tint_{1};
  std::shared_ptr<const Surroundings> surroundings_;  // of the present instance; null: nothing is said
  const ComponentBase* base_ = nullptr;               // parameters of the present instance
  std::uint64_t parent_section_ = 0;                  // section that the instance stands on
  std::uint64_t section_ = 0;                         // section that the instance has given
  bool is_placed_ = false;
  bool visible_ = true;
  bool has_child_sites_ = false;
  bool stands_as_grown_ = false;
  std::size_t first_child_ = 0;
  std::size_t first_branch_ = 0;
  std::size_t first_named_ = 0;
  std::uint32_t stems_of_instance_ = 0;
  std::uint32_t organs_of_instance_ = 0;
  std::uint64_t uncounted_ = 0;   // sites not yet in the context's count
  const Count* parts_ = nullptr;  // of the present instance, where it has said so
  std::uint64_t expected_ = 0;    // children of the present instance, where it has said so
  std::unordered_map<std::uint64_t, std::uint32_t> prototype_by_key_;
  std::unordered_map<std::uint64_t, std::uint32_t> individual_by_id_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const SectionOutline>> outline_by_key_;
  std::vector<Skeleton> grown_;
  std::shared_ptr<const GrowthTrace> watched_;
  std::shared_ptr<const Placement>
      branching_;  // placement of the stem emitted last, since most stems have an equal one
};

}  // namespace meristem

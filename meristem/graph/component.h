// SPDX-License-Identifier: Apache-2.0
// A component type has a name, a parameter table and a function that expands one instance. The p-graph knows no
// component by name. A Registry holds the types.
//
//   struct Spike : ComponentBase { double length = 1; };
//
//   ComponentType spike() {
//     return define_component<Spike>({
//         .traits = {.name = "spike", .doc = "A cone."},
//         .parameters = Table<Spike>("a spike", "A cone.")
//                           .number("length", &Spike::length, {.unit = Unit::metre, .min = 0}, "Base to apex."),
//         .expand = [](const Spike& spike, const Site&, OrganSink& organs, SiteSink& sites) {
//           organs.add(Frame{}, shape_key({spike.length}), [&] { return make_cone(0.1, spike.length, 8); });
//           sites.add(Frame{.origin = {0, spike.length, 0}});
//         },
//     });
//   }
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/graph/component_traits.h"
#include "meristem/graph/emitter.h"
#include "meristem/graph/minimum_counts.h"
#include "meristem/graph/table/selection.h"
#include "meristem/graph/table/table.h"
#include "meristem/graph/table/varying.h"
#include "meristem/graph/texture_parameters.h"
#include "meristem/grow/stand.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// A scale, a rotation and a translation, applied in this order. The rotation rolls about y, then pitches about x, then
/// yaws about z (radians).
struct InstanceTransform {
  Vec3 translate{0};  ///< metres
  Vec3 rotate{0};     ///< radians about x, y and z
  Vec3 scale{1};      ///< factors along x, y and z

  /// Returns the transform as a frame.
  Frame frame() const;
};

/// Parameters that all components have.
struct ComponentBase {
  std::optional<Vec3> colour;          ///< colour of the material; unset: the component type's own
  std::vector<Vec3> colours;           ///< colours of instances, instead of `colour`: each instance has one colour, or
                                       ///< a mixture of two neighbours
  std::optional<double> colour_at;     ///< position in `colours`, 0 the first and 1 the last; unset: random
  std::optional<double> variety;       ///< variation of lightness and tone among instances
  TextureParameters texture;           ///< texture of the geometry; may be empty
  std::optional<double> roughness;     ///< 0 mirror-like to 1 matt; unset: the component type's own
  std::optional<double> translucency;  ///< share of light that passes through; unset: the component type's own
  double opacity = 1;                  ///< share of light that does not pass straight through; lower: like glass
  InstanceTransform place;             ///< moves this component's geometry only
  InstanceTransform frame;             ///< moves the coordinate system with all descendants
  double phototropism = 0;             ///< share of the turn toward the light; negative: away from the light
  double gravitropism = 0;             ///< share of the turn straight down; negative: straight up
  int recursion = 1;  ///< instances of this component in a row that a link back makes, including the first
  std::optional<InstanceSelection> omit;  ///< instances without geometry
  std::optional<InstanceSelection> only;  ///< all other instances have no geometry
  bool omit_keeps_children = false;       ///< true: the children of an omitted instance stay
  bool hidden = false;                    ///< no geometry; children stay
};

/// Further parameters of components that compete with others while they grow.
struct GrowingComponent : ComponentBase {
  bool alone = false;  ///< grows in a stand of its own
};

/// Returns the frame of an instance at a site with the frame `site`. The frame is moved by the component's own frame,
/// then turned by gravity and light.
Frame instance_frame(const ComponentBase& base, const Frame& site, Tropism tropism, const Directions& directions);

/// Returns the rows of ComponentBase, which follow each component's own rows.
const ParameterTable& component_base_table();
/// Returns the names of the rows of ComponentBase that change only the look and position of the component's geometry.
const std::vector<std::string>& look_names();
/// Returns the rows of GrowingComponent. They follow a component's own rows and precede the rows of ComponentBase.
const ParameterTable& growing_component_table();

struct Prototype;

/// The data that a growing component may use.
struct GrowContext {
  const Scene& scene;            ///< light, obstacles and fields
  const Directions& directions;  ///< at the site of the instance
  const SizeLimits& limits;      ///< limits of the document
  const std::string& component;  ///< id, for errors
  Stand& stand;                  ///< the stand that the component will grow in
  Progress& progress;            ///< for stages and for a cancel
  bool keeps_fallen = false;     ///< true: shed parts are recorded, because the growth will be shown over time
  TraceRequest request{};        ///< parts of its growth to record
};

/// A component that another component places without a link of the document.
struct PlacedComponent {
  std::string id;         ///< id of the component
  bool is_needed = true;  ///< false: the document may lack the component
  std::string hint;       ///< hint for messages on a likely mistake: "or longer names ..."; may be empty
};

/// The names of the values that a component gives its descendants.
struct GivenNames {
  std::vector<std::string> names;  ///< in the order of the numbers
  /// Names that a user may expect, each with the reason why it is missing. The reason completes a sentence that begins
  /// with the name.
  std::vector<std::pair<std::string, std::string>> refused{};
};

/// A component type: its facts, its parameters and its functions, with the struct of parameters hidden behind `void`.
struct ComponentType : ComponentTraits {
  ParameterTable parameters;  ///< own rows, followed by the rows of ComponentBase

  std::function<std::shared_ptr<void>()> make_parameters;            ///< a struct with the defaults
  std::function<const ComponentBase&(const void* parameters)> base;  ///< the ComponentBase of a struct of parameters
  /// Returns the surface of its stems. Null for components without such a parameter.
  std::function<const SurfaceOptions&(const void* parameters)> surface;
  /// Returns the shape that the uvs of its geometry cover. Null if the uvs cover no particular shape.
  std::function<TextureShape(const void* parameters)> texture_shape;
  /// Returns true if the surface is a thin sheet, which is visible from both sides. Null: as `material` says.
  std::function<bool(const void* parameters)> is_sheet;
  /// Lists the components that it places without a link in the document. Null if there are none.
  std::function<std::vector<PlacedComponent>(const void* parameters)> placed;
  /// Returns the names of the values that it gives its descendants (SiteSink::give). Null if it gives none.
  std::function<GivenNames(const void* parameters)> gives;
  /// Returns the minimum counts of each instance. Null if nothing is known.
  std::function<MinimumCounts(const void* parameters, const KnownMembers& known)> minimum_counts;
  /// Returns the minimum number of triangles of each visible instance. Null if nothing is known.
  std::function<double(const void* parameters, const KnownMembers& known)> minimum_triangles;
  /// Expands a block of instances.
  std::function<void(const Prototype&, std::span<const Site>, Emitter&)> expand;
  /// Returns true if it shows the growth of the component that it shows. Null if it never does.
  std::function<bool(const void* parameters)> watches_growth;
  /// Returns true if each instance grows in a stand of its own. Null for components that compete with none.
  std::function<bool(const void* parameters)> grows_alone;
  /// Plants one instance in a stand. Null for components that do not grow.
  std::function<std::unique_ptr<Grower>(const Prototype&, const Site&, double time, const GrowContext&)> grow;
};

/// One component of a document: a type with its parameters.
struct Prototype {
  std::string id;                       ///< id in the document
  const ComponentType* type = nullptr;  ///< not null
  std::shared_ptr<void> parameters;     ///< values that do not vary
  std::vector<Varying> varyings;        ///< parameters that differ from instance to instance
  /// Hash of everything that the document contains about the component. Unset if unknown; its results are then not
  /// cached.
  std::optional<std::uint64_t> fingerprint{};
  std::optional<std::uint64_t> growth_fingerprint{};  ///< of everything that the component's growth depends on
  bool depends_on_time = true;                        ///< whether an expression or a key of the component may use the
                                                      ///< time
  bool growth_depends_on_time = true;                 ///< whether the component's growth may depend on the time
  std::string shown{};                                ///< id of the component that it shows, or empty
  std::vector<std::uint32_t>
      given_slots{};  ///< slots of the values that it gives its children by name: indices into Graph::site_names

  /// Returns the id from which its instances derive their random numbers.
  const std::string& drawn_as() const { return shown.empty() ? id : shown; }
  /// Returns the parameters that all components have.
  const ComponentBase& base() const { return type->base(parameters.get()); }
};

/// Returns the names of rows of a growing component that its growth does not read. If only these rows change, the grown
/// plants stay valid.
std::vector<std::string> rows_after_growth(const ComponentType& type);

/// Sets the component's fingerprints. `value` is its value in the document, `constants` are the document's variables,
/// and `files` are the files that were read with the value.
void set_fingerprints(Prototype& prototype, const Value& value, const ConstantTable& constants,
                      std::span<const NamedFile> files, const SizeLimits& limits);

/// Throws an InputError if an instance's parameters break a rule of their table. Parameters may vary, so each instance
/// is checked.
void check_rules(const ComponentType& type, const std::string& id, const void* instance, const SizeLimits& limits);

/// The function of a component type that expands one instance with parameters P. After the parameters and the site it
/// takes what it needs, in any order: `const InstanceContext&`, `OrganSink&`, `StemSink&` and `SiteSink&`, or
/// `Emitter&` for all of them.
template <class P>
class ExpandFunction {
 public:
  ExpandFunction() = default;
  /// A function.
  template <class... Needed>
  ExpandFunction(void (*function)(const P&, const Site&, Needed&...))  // NOLINT(google-explicit-constructor)
      : function_(reinterpret_cast<void (*)()>(function)),
        call_([](void (*erased)(), const P& parameters, const Site& site, Emitter& out) {
          const auto own = reinterpret_cast<void (*)(const P&, const Site&, Needed&...)>(erased);
          own(parameters, site, out.template get<Needed>()...);
        }) {}
  /// A lambda without captures.
  template <class Lambda>
  requires std::is_class_v<Lambda> && requires(Lambda lambda) { +lambda; }
  ExpandFunction(Lambda lambda) : ExpandFunction(+lambda) {}  // NOLINT(google-explicit-constructor)

  /// Expands one instance with these parameters at `site`.
  void operator()(const P& parameters, const Site& site, Emitter& out) const {
    call_(function_, parameters, site, out);
  }

 private:
  void (*function_)() = nullptr;
  void (*call_)(void (*)(), const P&, const Site&, Emitter&) = nullptr;
};

/// Defines a component type with parameter struct P, which derives from ComponentBase.
template <class P>
struct ComponentDefinition {
  ComponentTraits traits;  ///< facts about the type
  Table<P> parameters;     ///< rows of the parameters
  /// Makes one instance's geometry and the sites of its children, relative to the instance's own frame.
  ExpandFunction<P> expand;
  /// For components that grow: plants one instance at its site. After the growth, `StemSink::take_grown` returns the
  /// skeleton in `expand`. P derives from GrowingComponent if the component competes with others.
  std::unique_ptr<Grower> (*grow)(const P& parameters, const Site& site, const GrowContext& context) = nullptr;
  /// Returns the shape that the uvs of its geometry cover, for textures that follow a shape.
  TextureShape (*texture_shape)(const P& parameters) = nullptr;
  bool (*is_sheet)(const P& parameters) = nullptr;  ///< see ComponentType
  /// Lists the components that `expand` places with `SiteSink::add_named`, in the order of the numbers used there.
  std::vector<PlacedComponent> (*placed)(const P& parameters) = nullptr;
  /// For components that show another one: returns true if they use the other component's growth through
  /// `InstanceContext::watched_growth`.
  bool (*watches_growth)(const P& parameters) = nullptr;
  /// Returns the names of the values that `expand` gives with `SiteSink::give`.
  GivenNames (*gives)(const P& parameters) = nullptr;
  /// Returns the minimum counts of each instance, so that too many instances are refused before any is made.
  /// `parameters` has plain values; its members that differ from instance to instance must not be used (see `known`).
  MinimumCounts (*minimum_counts)(const P& parameters, const KnownMembers& known) = nullptr;
  /// Returns the minimum number of triangles of each visible instance at full detail, as `minimum_counts` does. May
  /// take as long as making one instance's mesh.
  double (*minimum_triangles)(const P& parameters, const KnownMembers& known) = nullptr;
};

/// Makes a component type from a definition. Adds the rows that all components have.
template <class P>
ComponentType define_component(ComponentDefinition<P> definition) {
  static_assert(std::is_base_of_v<ComponentBase, P>);
  ComponentType type{std::move(definition.traits)};
  if constexpr (std::is_base_of_v<GrowingComponent, P>) {
    std::move(definition.parameters).template include<GrowingComponent>(growing_component_table());
    type.grows_alone = [](const void* parameters) { return static_cast<const P*>(parameters)->alone; };
  }
  std::move(definition.parameters).template include<ComponentBase>(component_base_table()).elsewhere({"type"});
  if (!type.has_geometry) std::move(definition.parameters).without(look_names(), "it has no geometry of its own");
  if (type.is_whole_plant) {
    std::move(definition.parameters)
        .without({"colour", "colours", "colour_at", "variety", "texture", "roughness", "translucency", "opacity",
                  "phototropism", "gravitropism"},
                 "the plant has the looks and the growth of its own document");
  }
  type.parameters = std::move(definition.parameters);
  if (definition.grow != nullptr) type.has_twigs = true;
  type.make_parameters = [] { return std::static_pointer_cast<void>(std::make_shared<P>()); };
  if constexpr (requires(const P& parameters) { static_cast<const SurfaceOptions&>(parameters.surface); }) {
    type.surface = [](const void* parameters) -> const SurfaceOptions& {
      return static_cast<const P*>(parameters)->surface;
    };
  }
  type.base = [](const void* parameters) -> const ComponentBase& { return *static_cast<const P*>(parameters); };
  type.expand = [expand = definition.expand](const Prototype& prototype, std::span<const Site> sites, Emitter& out) {
    P instance = *static_cast<const P*>(prototype.parameters.get());
    const VaryingValues values(prototype.varyings, sites, out.document_time());
    for (std::size_t k = 0; k < sites.size(); ++k) {
      values.apply(k, &instance);
      out.instance(instance, sites[k], k, [&](const Site& site) { expand(instance, site, out); });
    }
  };
  if (definition.grow != nullptr) {
    type.grow = [grow = definition.grow](const Prototype& prototype, const Site& site, double time,
                                         const GrowContext& context) {
      P instance = *static_cast<const P*>(prototype.parameters.get());
      VaryingValues(prototype.varyings, std::span(&site, 1), time).apply(0, &instance);
      check_rules(*prototype.type, prototype.id, &instance, context.limits);
      Site own = site;
      own.frame = instance_frame(instance, site.frame, prototype.type->tropism, context.directions);
      std::unique_ptr<Grower> grower = grow(instance, own, context);
      grower->place = own.frame;
      return grower;
    };
  }
  if (definition.watches_growth != nullptr) {
    type.watches_growth = [watches = definition.watches_growth](const void* parameters) {
      return watches(*static_cast<const P*>(parameters));
    };
  }
  if (definition.placed != nullptr) {
    type.placed = [placed = definition.placed](const void* parameters) {
      return placed(*static_cast<const P*>(parameters));
    };
  }
  if (definition.gives != nullptr) {
    type.gives = [gives = definition.gives](const void* parameters) {
      return gives(*static_cast<const P*>(parameters));
    };
  }
  if (definition.minimum_counts != nullptr) {
    type.minimum_counts = [counts = definition.minimum_counts](const void* parameters, const KnownMembers& known) {
      return counts(*static_cast<const P*>(parameters), known);
    };
  }
  if (definition.minimum_triangles != nullptr) {
    type.minimum_triangles = [triangles = definition.minimum_triangles](const void* parameters,
                                                                        const KnownMembers& known) {
      return triangles(*static_cast<const P*>(parameters), known);
    };
  }
  if (definition.is_sheet != nullptr) {
    type.is_sheet = [is_sheet = definition.is_sheet](const void* parameters) {
      return is_sheet(*static_cast<const P*>(parameters));
    };
  }
  if (definition.texture_shape != nullptr) {
    type.texture_shape = [shape = definition.texture_shape](const void* parameters) {
      return shape(*static_cast<const P*>(parameters));
    };
  }
  return type;
}

/// The component types that documents may name.
class Registry {
 public:
  /// `types` have distinct names.
  explicit Registry(std::vector<ComponentType> types) : types_(std::move(types)) {}
  /// Returns the type of this name, or null.
  const ComponentType* find(std::string_view name) const;
  /// Returns the type of the camera, the root of every graph.
  const ComponentType& camera() const;
  std::span<const ComponentType> types() const { return types_; }  ///< in the order given
  std::vector<std::string> names() const;                          ///< names of the types, in the same order

 private:
  std::vector<ComponentType> types_;
};

}  // namespace meristem

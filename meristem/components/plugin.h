// SPDX-License-Identifier: Apache-2.0
// Component types from shared libraries that programs load at run time. A plug-in contains its own copy of the Meristem
// library. The types' tables and functions are passed to the program, so both sides must have equal versions and
// layouts. This is checked before any other call of the plug-in.
//
//   #include "meristem/components/plugin.h"
//
//   MERISTEM_PLUGIN(thorn_component(), burr_component())
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meristem/base/version.h"
#include "meristem/graph/component.h"

namespace meristem {

/// Version of the interface between plug-in and program. It is increased when the meaning of passed data changes
/// without a change of layout.
inline constexpr int kPluginInterface = 1;

/// Returns the properties in which a plug-in and a program must agree: the version, the compiler's interface, and the
/// sizes of passed types. It is inline in the header, so that each side computes it with its own compiler.
inline std::string plugin_interface() {
  std::string text = "Meristem " + std::string(version()) + ", plug-ins " + std::to_string(kPluginInterface) +
                     ", C++ interface " + std::to_string(__GXX_ABI_VERSION) + ", layout";
  for (const std::size_t size : {sizeof(ComponentType), sizeof(ParameterTable), sizeof(Parameter), sizeof(MemberType),
                                 sizeof(ParameterReader), sizeof(Varying), sizeof(Site), sizeof(Emitter),
                                 sizeof(GrowContext), sizeof(Scene), sizeof(SurfaceOptions), sizeof(SizeLimits)}) {
    text += ' ' + std::to_string(size);
  }
  return text;
}

/// Returns the component types of a plug-in file, which stays loaded until the program ends. Throws InputError if the
/// file does not exist (with the nearest name), is no plug-in, or has another interface.
std::vector<ComponentType> load_plugin(const std::string& path);

/// Returns `known` followed by the types of a plug-in. Throws InputError as load_plugin() does, and if a type's name is
/// already used.
Registry with_plugin(const Registry& known, const std::string& path);

}  // namespace meristem

/// Makes a shared library a plug-in with these types. Use it once per library, outside all namespaces.
#define MERISTEM_PLUGIN(...)                                                                       \
  extern "C" __attribute__((visibility("default"))) const char* meristem_plugin_interface() {      \
    static const std::string text = meristem::plugin_interface();                                  \
    return text.c_str();                                                                           \
  }                                                                                                \
  extern "C" __attribute__((visibility("default"))) void meristem_plugin_components(void* types) { \
    for (meristem::ComponentType & type : std::vector<meristem::ComponentType>{__VA_ARGS__}) {     \
      static_cast<std::vector<meristem::ComponentType>*>(types)->push_back(std::move(type));       \
    }                                                                                              \
  }

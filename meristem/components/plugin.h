// SPDX-License-Identifier: Apache-2.0
// Component types from shared libraries that programs load by name. A plug-in has its own copy of the library; what
// passes between it and the program are the types' tables and functions, so both must be of one version and layout,
// which is checked before anything else of the plug-in is called.
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

/// Raised whenever what passes between plug-in and program means something else than before, although the layout is
/// the same.
inline constexpr int kPluginInterface = 1;

/// What a plug-in and a program must agree in: the version, the compiler's interface, and the sizes of what passes
/// between them. In the header, so that each side says it as it was compiled.
inline std::string plugin_interface() {
  std::string text = "Meristem " + std::string(version()) + ", plug-ins " + std::to_string(kPluginInterface) +
                     ", C++ interface " + std::to_string(__GXX_ABI_VERSION) + ", layout";
  for (const std::size_t size : {sizeof(ComponentType), sizeof(ParameterTable), sizeof(Parameter), sizeof(MemberType),
                                 sizeof(ParameterReader), sizeof(Varying), sizeof(Site), sizeof(Emitter),
                                 sizeof(GrowContext), sizeof(Scene), sizeof(Surface), sizeof(Limits)}) {
    text += ' ' + std::to_string(size);
  }
  return text;
}

/// The types of the plug-in in a file, which stays loaded as long as the program runs. Throws InputError for a file
/// that is not there (with the nearest name), that is no plug-in, or whose interface is another one.
std::vector<ComponentType> load_plugin(const std::string& path);

/// `known` with the types of a plug-in behind them. Throws InputError as load_plugin does, and where a type's name is
/// taken.
Registry with_plugin(const Registry& known, const std::string& path);

}  // namespace meristem

/// What makes a shared library a plug-in: the types that it has. Once per library, outside of all namespaces.
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

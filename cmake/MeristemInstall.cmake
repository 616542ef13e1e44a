# SPDX-License-Identifier: Apache-2.0
# `cmake --install`: public headers, static libraries, the package that find_package(meristem) reads, and the program.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/meristem)

get_property(exported_targets GLOBAL PROPERTY MERISTEM_EXPORTED_TARGETS)
foreach(target IN LISTS exported_targets)
  get_target_property(header_sets ${target} INTERFACE_HEADER_SETS)
  set(headers "")
  foreach(set IN LISTS header_sets)
    list(APPEND headers FILE_SET ${set} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endforeach()
  install(TARGETS ${target} EXPORT meristem-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${headers})
endforeach()
install(EXPORT meristem-targets NAMESPACE meristem:: DESTINATION ${package_dir})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/meristem-config.cmake.in
                              ${PROJECT_BINARY_DIR}/meristem-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may break what a program relies on.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/meristem-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/meristem-config.cmake ${PROJECT_BINARY_DIR}/meristem-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/MeristemDependencies.cmake
        DESTINATION ${package_dir})

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET meristem_cli)
  install(TARGETS meristem_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/meristem
          FILES_MATCHING PATTERN "*.json" PATTERN "*.obj")
endif()

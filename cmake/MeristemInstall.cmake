# SPDX-License-Identifier: Apache-2.0
# `cmake --install`: public headers, static libraries, the files for find_package(meristem) and pkg-config, and the
# program. Components: development, program, licence, and python, which is installed only if it is named.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/meristem)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

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
# Before 1.0 a minor version may break programs that use the library.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/meristem-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/meristem-config.cmake ${PROJECT_BINARY_DIR}/meristem-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/MeristemDependencies.cmake
        DESTINATION ${package_dir})

# A static library must come before the libraries that it uses, so the rooms are listed from the last to the first.
get_property(rooms GLOBAL PROPERTY MERISTEM_ROOM_LIST)
list(REVERSE rooms)
list(TRANSFORM rooms REPLACE "meristem::" "-lmeristem_")
list(JOIN rooms " " pkgconfig_rooms)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
           OUTPUT_VARIABLE pkgconfig_prefix)
configure_file(${PROJECT_SOURCE_DIR}/cmake/meristem.pc.in ${PROJECT_BINARY_DIR}/meristem.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/meristem.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT licence)
if(TARGET meristem_cli)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
  install(TARGETS meristem_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/meristem
          FILES_MATCHING PATTERN "*.json" PATTERN "*.obj" PATTERN "*.csv")

  # The man page and the completion scripts of shells, printed by the program.
  set(printed ${PROJECT_BINARY_DIR}/printed)
  function(install_printed name destination)
    add_custom_command(OUTPUT ${printed}/${name}
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${printed}
                       COMMAND meristem_cli completion ${ARGN} > ${printed}/${name}
                       DEPENDS meristem_cli VERBATIM)
    set_property(GLOBAL APPEND PROPERTY MERISTEM_PRINTED ${printed}/${name})
    install(FILES ${printed}/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/${destination})
  endfunction()
  install_printed(meristem bash-completion/completions bash)
  install_printed(_meristem zsh/site-functions zsh)
  install_printed(meristem.fish fish/vendor_completions.d fish)
  install_printed(meristem.1 man/man1 --man)
  get_property(files GLOBAL PROPERTY MERISTEM_PRINTED)
  add_custom_target(meristem_printed ALL DEPENDS ${files})
endif()
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME "")

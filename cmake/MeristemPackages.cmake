# SPDX-License-Identifier: Apache-2.0
# Debian packages of the installed components (`./dev package`): the program, the library and the Python module.
set(MERISTEM_PACKAGE_CONTACT "The Meristem authors <packages@meristem.invalid>" CACHE STRING
    "Who makes Debian packages of this build, as in Name <address>: the field Maintainer")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "Meristem")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "${MERISTEM_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Rights of folders must not depend on the umask of the user.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME meristem)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS xdg-utils)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "grows plants from text documents
Meristem reads a short text document, grows a plant from it by one of five
growth models, and writes 3D models, pictures, measures, laser scans and data
sets of it. The package has the command line, the studio in the browser, and
documents of plants and gardens.")

# The libraries are static, so a program that links them also links the libraries that they use.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmeristem-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libglm-dev, libfmt-dev, libtbb-dev, libembree-dev, libjpeg62-turbo-dev, libpng-dev, libturbojpeg0-dev, libqhull-dev, libxxhash-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "grows plants from text documents - C++ library
Headers, static libraries, the CMake package and the pkg-config file of the
C++20 library, which does everything that the program meristem does.")

if(MERISTEM_PYTHON_MODULE)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_python "${MERISTEM_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-meristem)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${MERISTEM_PYTHON_MINOR}~), python3 (<< 3.${next_python}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/postinst"
      "${PROJECT_SOURCE_DIR}/cmake/debian/prerm")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "grows plants from text documents - Python module
The module gives plants as numpy arrays, measures and scans them, fits
documents to measurements, and makes data sets on many cores or machines.")
endif()

# The day of the release stands in CHANGELOG.md.
file(STRINGS ${PROJECT_SOURCE_DIR}/CHANGELOG.md release REGEX "^## ${PROJECT_VERSION} - " LIMIT_COUNT 1)
string(REGEX REPLACE ".* - " "" release_day "${release}")
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date --utc --date=${release_day} "+%a, %d %b %Y"
                OUTPUT_VARIABLE release_day OUTPUT_STRIP_TRAILING_WHITESPACE)
# The packages are for the release that builds them, whose libraries they need.
cmake_host_system_information(RESULT MERISTEM_DEBIAN_RELEASE QUERY DISTRIB_VERSION_CODENAME)
if(NOT MERISTEM_DEBIAN_RELEASE)
  set(MERISTEM_DEBIAN_RELEASE unstable)
endif()
configure_file(cmake/debian/changelog.in debian/changelog.Debian @ONLY)
configure_file(CHANGELOG.md debian/changelog COPYONLY)
set(CPACK_MERISTEM_DOCUMENTS ${PROJECT_SOURCE_DIR}/cmake/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.Debian
    ${PROJECT_BINARY_DIR}/debian/changelog)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish_trees.cmake)
include(CPack)

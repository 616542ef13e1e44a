# SPDX-License-Identifier: Apache-2.0
# Everything comes from packages of Debian 12 or 13; `./dev` installs them. Also included by the installed package's config.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(glm)
find_dependency(fmt 9)
find_dependency(TBB)
# A requested version would exclude the next major version. Debian 12 has Embree 3.13, Debian 13 has 4.3.
find_dependency(embree)
if(embree_VERSION VERSION_LESS 3.13 OR embree_VERSION VERSION_GREATER_EQUAL 5)
  message(FATAL_ERROR "Meristem needs Embree 3.13 or 4, but ${embree_DIR} has ${embree_VERSION}")
endif()
# For meristem/base/embree.h, because several versions may be installed side by side.
set_property(TARGET embree APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS MERISTEM_EMBREE=${embree_VERSION_MAJOR})
find_dependency(PNG)
find_dependency(Qhull 8)
find_dependency(PkgConfig)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(JPEG REQUIRED IMPORTED_TARGET libjpeg)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)

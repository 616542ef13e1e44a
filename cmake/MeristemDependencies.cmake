# SPDX-License-Identifier: Apache-2.0
# Everything comes from Debian 12 packages; `./dev` installs them. Also included by the installed package's config.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(glm)
find_dependency(fmt 9)
find_dependency(TBB)
find_dependency(embree 3.13)
find_dependency(PNG)
find_dependency(Qhull 8)
find_dependency(PkgConfig)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)

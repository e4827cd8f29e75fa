# An overlay port of the header-only library: vcpkg install restrip --overlay-ports=packaging/vcpkg
# It takes the source tree that it lies in.
get_filename_component(SOURCE_PATH ${CURRENT_PORT_DIR}/../../.. ABSOLUTE)
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS -DRESTRIP_BUILD_PROGRAMS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME restrip CONFIG_PATH lib/cmake/restrip)
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug ${CURRENT_PACKAGES_DIR}/lib)
file(INSTALL ${CMAKE_CURRENT_LIST_DIR}/usage DESTINATION ${CURRENT_PACKAGES_DIR}/share/restrip)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)

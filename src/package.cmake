# cpack --config build/CPackConfig.cmake: a package of Debian 12 that needs no compiler.

# The package's folders are the system's, which needs none of the files that make a workspace of a
# prefix; catkin puts them where it was told to install when it configured.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/leave_out_workspace.cmake @ONLY CONTENT [[
set(prefix ${CPACK_TEMPORARY_DIRECTORY}@CMAKE_INSTALL_PREFIX@)
file(GLOB files ${prefix}/*setup* ${prefix}/env.sh ${prefix}/.catkin ${prefix}/.rosinstall)
file(REMOVE ${files})
if(NOT "@CMAKE_INSTALL_PREFIX@" STREQUAL "/usr")
  file(REMOVE_RECURSE ${prefix})
endif()
]])

# roslaunch looks for launch files in every folder below the checkout.
file(WRITE ${CMAKE_BINARY_DIR}/leave_no_copy.cmake "file(REMOVE_RECURSE \${CPACK_TEMPORARY_DIRECTORY}/usr)\n")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ros-lattice-impact)
set(CPACK_PACKAGE_VERSION ${lattice_impact_VERSION})
set(CPACK_PACKAGE_CONTACT "lattice_impact maintainers <maintainers@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates the impact of a soft elastic disk on a wall")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_BINARY_DIR}/leave_out_workspace.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_BINARY_DIR}/leave_no_copy.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-roslaunch, python3-std-msgs, rosbash")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib, python3-numpy, python3-rosbag")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, python3-meshio, rviz")
include(CPack)

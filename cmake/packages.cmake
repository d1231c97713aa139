# Debian packages by cpack, from the preset `packages`, which installs below /usr (docs/packages.md).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The FoamSim authors <foamsim@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL)

# foamsim_package(component name section description [DEPENDS packages...] [RECOMMENDS packages...]): the component of
# `cmake --install` as a package. What its programs need of shared libraries is found by dpkg-shlibdeps.
function(foamsim_package component name section description)
  cmake_parse_arguments(P "" "" "DEPENDS;RECOMMENDS" ${ARGN})
  string(TOUPPER ${component} C)
  list(JOIN P_DEPENDS ", " depends)
  list(JOIN P_RECOMMENDS ", " recommends)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${C}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${C}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${C}_DESCRIPTION "${description}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${C}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${C}_PACKAGE_RECOMMENDS "${recommends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${C}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} RENAME copyright COMPONENT ${component})
endfunction()

if(MPI_CXX_FOUND)
  set(mpi libopenmpi-dev)
endif()
foamsim_package(
  programs foamsim science
  "soap films and foams by vortex sheets\nThe programs foamsim and multitracker, manuals, scenes and plot scripts."
  RECOMMENDS python3-matplotlib)
foamsim_package(
  development libfoamsim-dev libdevel
  "soap films and foams by vortex sheets: libraries\nHeaders, static libraries and targets for find_package(FoamSim)."
  DEPENDS libeigen3-dev libsuitesparse-dev libboost-dev libtbb-dev libhwy-dev libcli11-dev libtomlplusplus-dev
          nlohmann-json3-dev libembree-dev libpng-dev voro++-dev ${mpi})
if(TARGET _foamsim)
  math(EXPR next_minor "${FOAMSIM_PYTHON_MINOR} + 1")
  foamsim_package(
    python python3-foamsim python
    "soap films and foams by vortex sheets: import foamsim\nSimulations, meshes as NumPy arrays, effects in Python."
    DEPENDS "python3 (>= 3.${FOAMSIM_PYTHON_MINOR})" "python3 (<< 3.${next_minor})" python3-numpy)
endif()
include(CPack)

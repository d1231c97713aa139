# Voro++, which Debian 12 ships without a CMake package: target Voro::Voro.
find_path(Voro_INCLUDE_DIR voro++/voro++.hh)
find_library(Voro_LIBRARY voro++)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Voro REQUIRED_VARS Voro_LIBRARY Voro_INCLUDE_DIR)
mark_as_advanced(Voro_INCLUDE_DIR Voro_LIBRARY)

if(Voro_FOUND AND NOT TARGET Voro::Voro)
  add_library(Voro::Voro UNKNOWN IMPORTED)
  set_target_properties(Voro::Voro PROPERTIES IMPORTED_LOCATION "${Voro_LIBRARY}"
                                              INTERFACE_INCLUDE_DIRECTORIES "${Voro_INCLUDE_DIR}")
endif()

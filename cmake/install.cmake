# What `cmake --install` puts where, in three components (cmake/packages.cmake makes a Debian package of each): programs with
# manuals, completion (foamsim_add_manual), plot scripts and scenes; libraries, headers and exported targets for
# find_package(FoamSim); `import foamsim` (Python/CMakeLists.txt).
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FoamSim)

install(TARGETS foamsim_program multitracker_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
install(DIRECTORY plots assets/scenes assets/sweeps DESTINATION ${CMAKE_INSTALL_DATADIR}/foamsim COMPONENT programs
        PATTERN __pycache__ EXCLUDE)

install(TARGETS base console lostopos lostopos_run multitracker foamsim_velocity foamsim_shapes foamsim foamsim_studies foamsim_sweep
                foamsim_statistics foamsim_render foamsim_web foamsim_app
        EXPORT FoamSimTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
foreach(folder Base LosTopos MultiTracker FoamSim)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
          FILES_MATCHING PATTERN "*.h" PATTERN app EXCLUDE)
endforeach()
install(FILES FoamSim/app/run_program.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/FoamSim/app COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/generated/FoamSim/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/FoamSim COMPONENT development)
install(EXPORT FoamSimTargets NAMESPACE foamsim:: DESTINATION ${config_dir} COMPONENT development)
configure_package_config_file(cmake/FoamSimConfig.cmake.in ${PROJECT_BINARY_DIR}/FoamSimConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FoamSimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/FoamSimConfig.cmake ${PROJECT_BINARY_DIR}/FoamSimConfigVersion.cmake
              cmake/FindCHOLMOD.cmake cmake/FindVoro.cmake DESTINATION ${config_dir} COMPONENT development)

# Settings shared by every target of the project.

# The headers that nearly every source includes, parsed once for all targets: half of the time of a build from nothing.
# FLAGS: the compiler's, as of the targets that use them.
function(foamsim_precompile_headers name)
  cmake_parse_arguments(P "" "FLAGS" "HEADERS;LIBS" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/generated/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Owner of precompiled headers.\n")
  add_library(${name} OBJECT ${source})
  foamsim_configure_target(${name} FLAGS "${P_FLAGS}")
  target_link_libraries(${name} PRIVATE ${P_LIBS})
  target_precompile_headers(${name} PRIVATE ${P_HEADERS})
endfunction()

# Warnings, floating-point contract and instrumentation: the same for libraries, programs and tests.
# -ffp-contract=off keeps a*b+c two roundings everywhere, which the exact predicates rely on and which makes results the
# same bits from one compiler setting to the next.
# PRECOMPILED: whose precompiled headers the target uses. FLAGS: the compiler's, after all others.
function(foamsim_configure_target target)
  cmake_parse_arguments(C "" "PRECOMPILED;FLAGS" "" ${ARGN})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -ffp-contract=off)
  # Where sources are compiled together (CMAKE_UNITY_BUILD): from nothing in 60% of the time, a change in about twice.
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 12)
  # Precompiled headers fit only targets with the same flags, and programs would get -fPIE where libraries get -fPIC.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(${target} PRIVATE -fPIC)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Winvalid-pch>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 sees sizes that cannot occur in the copies of small_vector and of std::string.
    target_compile_options(${target} PRIVATE -Wno-stringop-overread -Wno-stringop-overflow -Wno-array-bounds
                                             -Wno-restrict)
    # Garbage that is collected from 128 MB on is a tenth of the time; without, 1.19 GB instead of 1.03 at the peak.
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=524288)
  endif()
  if(FOAMSIM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FOAMSIM_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage)
    target_link_options(${target} PUBLIC --coverage)
  endif()
  target_compile_options(${target} PRIVATE ${C_FLAGS})
  if(C_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${C_PRECOMPILED})
  endif()
endfunction()

# foamsim_sources(target folder_or_file...): the sources in the folders, subfolders included. A new file is compiled
# without an edit here, so that an effect or a scene is one file.
function(foamsim_sources target)
  foreach(place ${ARGN})
    if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${place})
      file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${place}/*.cpp)
      target_sources(${target} PRIVATE ${found})
    elseif(place MATCHES "\\.cpp$")
      target_sources(${target} PRIVATE ${place})
    endif()
  endforeach()
endfunction()

# foamsim_add_library(target [PLAIN] SOURCES_IN folder_or_file... [BUT_FOR folder...]): a library with public headers
# found as <Folder/sub/header.h>. PLAIN: it stands below what is precompiled. BUT_FOR: subfolders that are libraries.
function(foamsim_add_library target)
  cmake_parse_arguments(L "PLAIN" "" "SOURCES_IN;BUT_FOR" ${ARGN})
  add_library(${target} STATIC)
  foamsim_sources(${target} ${L_SOURCES_IN})
  get_target_property(sources ${target} SOURCES)
  foreach(folder ${L_BUT_FOR})
    file(GLOB_RECURSE others CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    list(REMOVE_ITEM sources ${others})
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
  if(L_PLAIN)
    foamsim_configure_target(${target})
  else()
    foamsim_configure_target(${target} PRECOMPILED library_headers)
  endif()
  if(FOAMSIM_FUZZ)
    # As -fsanitize=fuzzer-no-link, which refuses precompiled headers that are made without it.
    target_compile_options(${target} PRIVATE -fsanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table)
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# foamsim_add_program(target name SOURCES_IN folder_or_file... LIBS ...): a program called `name`.
function(foamsim_add_program target name)
  cmake_parse_arguments(P "" "" "SOURCES_IN;LIBS" ${ARGN})
  add_executable(${target})
  foamsim_sources(${target} ${P_SOURCES_IN})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  foamsim_configure_target(${target} PRECOMPILED library_headers)
  target_link_libraries(${target} PRIVATE ${P_LIBS})
endfunction()

# foamsim_add_manual(target name): the program's manual page and completion scripts, printed by itself, and where they are
# installed.
function(foamsim_add_manual target name)
  set(folder ${PROJECT_BINARY_DIR}/share)
  set(files ${folder}/${name}.1 ${folder}/bash/${name} ${folder}/zsh/_${name})
  file(MAKE_DIRECTORY ${folder}/bash ${folder}/zsh)
  add_custom_command(OUTPUT ${files}
                     COMMAND ${target} generate man > ${folder}/${name}.1
                     COMMAND ${target} generate bash > ${folder}/bash/${name}
                     COMMAND ${target} generate zsh > ${folder}/zsh/_${name}
                     DEPENDS ${target} COMMENT "Manual page and completion scripts of ${name}" VERBATIM)
  add_custom_target(${name}_manual ALL DEPENDS ${files})
  install(FILES ${folder}/${name}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
  install(FILES ${folder}/bash/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
  install(FILES ${folder}/zsh/_${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT programs)
endfunction()

foamsim_precompile_headers(
  library_headers
  HEADERS
    <algorithm>
    <array>
    <cmath>
    <cstdint>
    <filesystem>
    <functional>
    <map>
    <memory>
    <numbers>
    <optional>
    <span>
    <string>
    <string_view>
    <vector>
    <Eigen/Core>
    <Eigen/Geometry>
    <boost/container/small_vector.hpp>
    <tbb/parallel_for.h>
    <tbb/blocked_range.h>
  LIBS Eigen3::Eigen Boost::headers TBB::tbb)

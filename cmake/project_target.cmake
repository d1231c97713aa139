# Settings shared by every target of the project.

# Warnings, floating-point contract and instrumentation: the same for libraries, programs and tests.
# -ffp-contract=off keeps a*b+c two roundings everywhere, which the exact predicates rely on and which makes results the
# same bits from one compiler setting to the next.
function(foamsim_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 sees sizes that cannot occur in the copies of Boost's small_vector and in std::string's operator+.
    target_compile_options(${target} PRIVATE -Wno-stringop-overread -Wno-restrict)
  endif()
  if(FOAMSIM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FOAMSIM_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage)
    target_link_options(${target} PUBLIC --coverage)
  endif()
endfunction()

# A library with public headers found as <Folder/sub/header.h>; sources are added per folder by target_sources.
function(foamsim_add_library target namespace)
  add_library(${target} STATIC)
  add_library(${namespace}::${target} ALIAS ${target})
  foamsim_configure_target(${target})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

option(TOOLPACE_BUILD_STUDIO "Build the Qt 6 workbench" ON)
option(TOOLPACE_BUILD_PYTHON "Build the Python module, where pybind11 is" ON)
option(TOOLPACE_BUILD_TESTS "Build the tests" ON)
option(TOOLPACE_BUILD_BENCH "Build the benchmarks" OFF)
option(TOOLPACE_BUILD_EXAMPLES "Build the example programs" ON)
option(TOOLPACE_BATCHES "Compile the sources of a library in batches: half the work, and a change costs its whole batch" ON)
option(TOOLPACE_WERROR "Treat warnings as errors" OFF)
option(TOOLPACE_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(TOOLPACE_TSAN "Build with ThreadSanitizer" OFF)
option(TOOLPACE_BUILD_FUZZERS "Build the libFuzzer targets (clang)" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# Same input, same bytes: no fused multiply-add, no reassociation.
add_compile_options(-ffp-contract=off)

if(TOOLPACE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(TOOLPACE_TSAN)
  add_compile_options(-fsanitize=thread)
  add_link_options(-fsanitize=thread)
endif()

# Warnings belong to our own targets and are not exported to users of the library.
add_library(toolpace_warnings INTERFACE)
target_compile_options(toolpace_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow
                       $<$<BOOL:${TOOLPACE_WERROR}>:-Werror>
                       # GCC's -Wconversion leaves signs alone in C++.
                       $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
                       # GCC 12 sees overlap, overflow and lack of a value in std::string where there is none (its bugs 105651, 105329,
                       # 105762, 105562).
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds;-Wno-maybe-uninitialized>)

# A second build takes seconds where ccache is there. It caches what uses precompiled headers only when told that their macros
# and times are no concern; here they are the same for all that share one.
find_program(TOOLPACE_CCACHE ccache)
if(TOOLPACE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${TOOLPACE_CCACHE})
endif()

# What nearly every file of the core includes, or includes by way of another: compiled once a build.
set(TOOLPACE_CORE_PCH <Eigen/Core> <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <memory> <optional> <string>
                      <string_view> <tl/expected.hpp> <vector>)

# Debian's own Python, which the packages of scripts/packages.txt belong to, rather than another one in the search path.
if(EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that runs the tests")
endif()
if(TOOLPACE_BUILD_FUZZERS)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# toolpace_compile_in_batches(TARGET), after its last source: batches hold files of one folder, whose names in unnamed
# namespaces must then differ.
set(TOOLPACE_BATCH_FILES 8)
function(toolpace_compile_in_batches target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TOOLPACE_BATCHES} UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    if(NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    string(MD5 folder "${folder}")
    math(EXPR batch "${files_${folder}} + 0")
    math(EXPR files_${folder} "${batch} + 1")
    math(EXPR batch "${batch} / ${TOOLPACE_BATCH_FILES}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}_${batch}")
  endforeach()
endfunction()

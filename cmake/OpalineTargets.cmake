# One static library a folder: opaline_library(core SOURCES a.cpp PUBLIC fmt::fmt PRIVATE ...) is opaline_core,
# for others opaline::core.

add_library(opaline_warnings INTERFACE)
target_compile_options(opaline_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wno-missing-field-initializers -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(opaline_warnings INTERFACE -Wno-restrict)  # false positives, GCC bug 105651
endif()
if(OPALINE_SANITIZE)
  target_compile_options(opaline_warnings INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    -Wno-maybe-uninitialized)
  target_link_options(opaline_warnings INTERFACE -fsanitize=address,undefined)
endif()

# Lets a target include what is in a folder as "<folder>/...", and nothing beside that folder.
function(opaline_include_folder target scope folder)
  get_filename_component(name ${folder} NAME)
  set(root ${CMAKE_CURRENT_BINARY_DIR}/include)
  file(MAKE_DIRECTORY ${root})
  file(CREATE_LINK ${folder} ${root}/${name} SYMBOLIC)
  target_include_directories(${target} ${scope} ${root})
endfunction()

function(opaline_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(opaline_${name} STATIC ${ARG_SOURCES})
  add_library(opaline::${name} ALIAS opaline_${name})
  opaline_include_folder(opaline_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(opaline_${name} PUBLIC opaline_headers ${ARG_PUBLIC} PRIVATE opaline_warnings ${ARG_PRIVATE})
endfunction()

# What only talks to people or checks the library waits more for its compiler than for itself.
function(opaline_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Reading the test library takes longer than compiling most tests: it is read once, for all of them.
function(opaline_precompile_test_library)
  file(CONFIGURE OUTPUT test_library.cpp CONTENT "")
  add_library(opaline_test_library OBJECT ${CMAKE_CURRENT_BINARY_DIR}/test_library.cpp)
  target_link_libraries(opaline_test_library PRIVATE opaline_warnings GTest::gtest GTest::gmock)
  opaline_compile_quickly(opaline_test_library)
  target_precompile_headers(opaline_test_library PRIVATE <gtest/gtest.h>)
endfunction()

# opaline_test(core SOURCES a_test.cpp LIBRARIES opaline_core)
function(opaline_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE opaline_warnings ${ARG_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  opaline_compile_quickly(test_${name})
  target_precompile_headers(test_${name} REUSE_FROM opaline_test_library)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(test_${name} PRIVATE OPALINE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. NO_PRETTY_VALUES DISCOVERY_TIMEOUT 120 PROPERTIES TIMEOUT 600)
endfunction()

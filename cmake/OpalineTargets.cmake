# One static library a folder: opaline_library(core SOURCES a.cpp PUBLIC fmt::fmt PRIVATE ...) is opaline_core,
# for others opaline::core.

add_library(opaline_warnings INTERFACE)
target_compile_options(opaline_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wno-missing-field-initializers -Werror)
# In a unity build the names of a file are seen by those that are read after it.
set(unity_warnings $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local;-Wno-subobject-linkage>)
target_compile_options(opaline_warnings INTERFACE
  $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,${unity_warnings},-Wshadow>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(opaline_warnings INTERFACE -Wno-restrict)  # false positives, GCC bug 105651
endif()
if(OPALINE_FUZZ)
  target_compile_options(opaline_warnings INTERFACE
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(opaline_warnings INTERFACE -fsanitize=address,undefined)
endif()
# Apart, for examples, which are compiled with nobody's warnings but their own.
add_library(opaline_sanitizers INTERFACE)
target_link_libraries(opaline_warnings INTERFACE opaline_sanitizers)
if(OPALINE_SANITIZE)
  target_compile_definitions(opaline_sanitizers INTERFACE OPALINE_SANITIZED)
endif()
if(OPALINE_SANITIZE STREQUAL "thread")
  target_compile_options(opaline_sanitizers INTERFACE -fsanitize=thread -fno-omit-frame-pointer -Wno-tsan)
  target_link_options(opaline_sanitizers INTERFACE -fsanitize=thread)
elseif(OPALINE_SANITIZE)
  target_compile_options(opaline_sanitizers INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    -Wno-maybe-uninitialized)
  target_link_options(opaline_sanitizers INTERFACE -fsanitize=address,undefined)
  add_library(opaline_kept_modules SHARED ${PROJECT_SOURCE_DIR}/tools/keep_modules.cpp)
  target_link_libraries(opaline_sanitizers INTERFACE opaline_kept_modules)
endif()

# Lets a target include what is in a folder as "<folder>/...", and nothing beside that folder. Of a folder in a folder of
# src/ both are named.
function(opaline_include_folder target scope folder)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/src OUTPUT_VARIABLE name)
  if(name MATCHES "^\\.\\.")
    get_filename_component(name ${folder} NAME)
  endif()
  set(root ${CMAKE_CURRENT_BINARY_DIR}/include)
  get_filename_component(parent ${root}/${name} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${folder} ${root}/${name} SYMBOLIC)
  target_include_directories(${target} ${scope} ${root})
endfunction()

# Notes a static library and what it links, for opaline_whole_library(). Its objects make shared libraries too.
function(opaline_part target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  list(FILTER ARGN EXCLUDE REGEX "^opaline_")
  set_property(GLOBAL APPEND PROPERTY OPALINE_PARTS ${target})
  set_property(GLOBAL APPEND PROPERTY OPALINE_LINKED ${ARGN})
endfunction()

function(opaline_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(opaline_${name} STATIC ${ARG_SOURCES})
  add_library(opaline::${name} ALIAS opaline_${name})
  opaline_include_folder(opaline_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(opaline_${name} PUBLIC opaline_headers ${ARG_PUBLIC} PRIVATE opaline_warnings ${ARG_PRIVATE})
  opaline_part(opaline_${name} ${ARG_PUBLIC} ${ARG_PRIVATE})
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

add_custom_target(opaline_quick_tests)  # what `make quick` runs

# opaline_test(core QUICK SOURCES a_test.cpp LIBRARIES opaline_core): one program of GoogleTest's. With SHARDS n its
# cases are dealt out to n processes that may run beside each other; a process for each case would open a device and make
# pipelines for each. What is QUICK is run by `make quick` too.
function(opaline_test name)
  cmake_parse_arguments(ARG "QUICK" "SHARDS" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE opaline_warnings ${ARG_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  opaline_compile_quickly(test_${name})
  target_precompile_headers(test_${name} REUSE_FROM opaline_test_library)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(test_${name} PRIVATE OPALINE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(NOT ARG_SHARDS)
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES TIMEOUT 1800)
  else()
    foreach(shard RANGE 1 ${ARG_SHARDS})
      math(EXPR index "${shard} - 1")
      add_test(NAME ${name}.${shard} COMMAND test_${name})
      set_tests_properties(${name}.${shard} PROPERTIES TIMEOUT 1800 COST 50
        ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${index}")
    endforeach()
  endif()
  if(ARG_QUICK)
    add_dependencies(opaline_quick_tests test_${name})
    set_tests_properties(${name} PROPERTIES LABELS quick)
  endif()
endfunction()

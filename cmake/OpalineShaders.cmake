# opaline_shaders(<target> <file>...): compiles <name>.<stage>.glsl to SPIR-V and embeds it in the
# static library <target>, declared in "shaders/shaders.h" as opaline::shaders::<name>_<stage>
# (folders are part of the name, joined by _: gather/dsm.frag.glsl is gather_dsm_frag). An entry
# <file>:<variant> is the file with VARIANT defined: boundary/beams.comp.glsl:ray_queries is
# boundary_beams_ray_queries_comp.

find_program(GLSLC glslc REQUIRED)

function(opaline_shaders target)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/generated/shaders/shaders.h)
  set(declarations "// Made by cmake/OpalineShaders.cmake.\n#pragma once\n\n#include <cstdint>\n#include <span>\n\nnamespace opaline::shaders {\n\n// Names follow the files'. NOLINTBEGIN\n")
  set(sources)
  foreach(entry ${ARGN})
    string(REGEX MATCH "^(.*)\\.(vert|frag|comp)\\.glsl(:([a-z_]+))?$" matched ${entry})
    if(NOT matched)
      message(FATAL_ERROR "A shader is named <name>.<vert|frag|comp>.glsl[:<variant>], not ${entry}")
    endif()
    set(file ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}.glsl)
    set(stage ${CMAKE_MATCH_2})
    set(define)
    set(variant)
    if(CMAKE_MATCH_4)
      set(variant _${CMAKE_MATCH_4})
      string(TOUPPER ${CMAKE_MATCH_4} define)
      set(define -D${define})
    endif()
    string(REPLACE "/" "_" name "${CMAKE_MATCH_1}${variant}_${stage}")
    set(words ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}.inc)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}.cpp)
    add_custom_command(OUTPUT ${words}
      COMMAND ${GLSLC} -fshader-stage=${stage} --target-env=vulkan1.3 -O -Werror -mfmt=num ${define}
              -I ${CMAKE_CURRENT_SOURCE_DIR} -I ${PROJECT_SOURCE_DIR}/src/shaders -MD -MF ${words}.d -o ${words} ${CMAKE_CURRENT_SOURCE_DIR}/${file}
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file} DEPFILE ${words}.d
      COMMENT "Compiling shader ${entry}" VERBATIM)
    file(GENERATE OUTPUT ${source} CONTENT
      "#include \"shaders/shaders.h\"\n\nnamespace opaline::shaders {\n\nnamespace {\nconstexpr std::uint32_t words[] = {\n#include \"${words}\"\n};\n}  // namespace\n\nconst std::span<const std::uint32_t> ${name}(words);\n\n}  // namespace opaline::shaders\n")
    set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${words})
    string(APPEND declarations "extern const std::span<const std::uint32_t> ${name};\n")
    list(APPEND sources ${source})
  endforeach()
  string(APPEND declarations "// NOLINTEND\n\n}  // namespace opaline::shaders\n")
  file(CONFIGURE OUTPUT ${header} CONTENT "${declarations}" @ONLY)
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/generated)
  target_link_libraries(${target} PUBLIC opaline_shader_headers)
endfunction()

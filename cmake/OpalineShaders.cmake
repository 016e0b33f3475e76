# opaline_shaders(<target> <file>...): compiles <name>.<stage>.glsl to SPIR-V and embeds it in the
# static library <target>. "shaders/<name>.<stage>.h" (less folders of the name up to shaders/) is made
# beside, see cmake/shader_interface.py: boundary/beams.comp.glsl is opaline::shaders::BoundaryBeams, and
# scatter/surface.vert.glsl ScatterSurfaceVert. An entry <file>:<variant> after its file is the same
# with VARIANT defined. Files with lib/texels.glsl also have the variant storage.

find_program(GLSLC glslc REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# boundary/beams, comp -> BoundaryBeams
function(opaline_shader_type result name stage)
  if(NOT stage STREQUAL comp)
    string(APPEND name _${stage})
  endif()
  string(REGEX MATCHALL "[a-z0-9]+" words "${name}")
  set(type)
  foreach(word ${words})
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} first)
    string(APPEND type ${first}${rest})
  endforeach()
  set(${result} ${type} PARENT_SCOPE)
endfunction()

# Whether a file includes lib/texels.glsl, at whatever remove; FOLDERs are where includes are looked for.
function(opaline_reads_texels result file) # FOLDER...
  get_property(known GLOBAL PROPERTY opaline_reads_texels_${file})
  if("${known}" STREQUAL "")
    set(known FALSE)
    get_filename_component(beside ${file} DIRECTORY)
    file(STRINGS ${file} includes REGEX "^#include \".*[.]glsl\"")
    foreach(include ${includes})
      string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" include ${include})
      if(include STREQUAL lib/texels.glsl)
        set(known TRUE)
        break()
      endif()
      unset(path)  # as it is in the file that includes this one
      find_file(path ${include} PATHS ${beside} ${ARGN} NO_CACHE NO_DEFAULT_PATH REQUIRED)
      opaline_reads_texels(known ${path} ${ARGN})
      if(known)
        break()
      endif()
    endforeach()
    set_property(GLOBAL PROPERTY opaline_reads_texels_${file} ${known})
  endif()
  set(${result} ${known} PARENT_SCOPE)
endfunction()

function(opaline_shaders target)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(interface ${PROJECT_SOURCE_DIR}/cmake/shader_interface.py)
  set(shared)
  foreach(folder shaders/shared paper/shaders/shared)  # of structs that C++ knows too
    list(APPEND shared ${folder}=${PROJECT_SOURCE_DIR}/src/${folder})
  endforeach()
  set(groups ${PROJECT_SOURCE_DIR}/src/shaders/binding_groups.h)
  set(folders ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src/shaders ${PROJECT_SOURCE_DIR}/src)
  list(TRANSFORM folders PREPEND -I OUTPUT_VARIABLE include)
  set(files)
  foreach(entry ${ARGN})
    string(REGEX MATCH "^((.*)\\.(vert|frag|comp)\\.glsl)(:([a-z_]+))?$" matched ${entry})
    if(NOT matched)
      message(FATAL_ERROR "A shader is named <name>.<vert|frag|comp>.glsl[:<variant>], not ${entry}")
    endif()
    if(NOT CMAKE_MATCH_5)
      set(file ${CMAKE_MATCH_1})
      list(APPEND files ${file})
      set(variants_${file} "=")
      opaline_reads_texels(reads ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${folders})
      if(reads)
        list(APPEND variants_${file} "=storage")
      endif()
    else()
      list(APPEND variants_${CMAKE_MATCH_1} "=${CMAKE_MATCH_5}")
    endif()
  endforeach()

  set(sources)
  set(layouts)
  foreach(file ${files})
    string(REGEX MATCH "^(.*shaders/)?(.*)\\.(vert|frag|comp)\\.glsl$" matched ${file})
    set(path ${CMAKE_MATCH_2})
    set(stage ${CMAKE_MATCH_3})
    opaline_shader_type(type ${path} ${stage})
    set(header ${generated}/shaders/${path}.${stage}.h)
    set(layout ${generated}/${type}.layouts.h)
    set(modules)
    set(unoptimised)
    foreach(variant ${variants_${file}})
      string(SUBSTRING ${variant} 1 -1 variant)
      set(define)
      set(name ${type})
      if(variant)
        string(TOUPPER -D${variant} define)
        string(APPEND name _${variant})
      endif()
      set(words ${generated}/${name}.inc)
      set(spirv ${generated}/${name}.spv)
      set(source ${generated}/${name}.cpp)
      set(compile ${GLSLC} -fshader-stage=${stage} --target-env=vulkan1.3 -Werror ${define}
        ${include})
      add_custom_command(OUTPUT ${words} ${spirv}
        COMMAND ${compile} -O -mfmt=num -MD -MF ${words}.d -o ${words} ${CMAKE_CURRENT_SOURCE_DIR}/${file}
        COMMAND ${compile} -O0 -o ${spirv} ${CMAKE_CURRENT_SOURCE_DIR}/${file}
        DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file} DEPFILE ${words}.d
        COMMENT "Compiling shader ${file} ${variant}" VERBATIM)
      file(GENERATE OUTPUT ${source} CONTENT
        "#include <cstdint>\n#include <span>\n\nnamespace opaline::shaders {\n\nnamespace {\nconstexpr std::uint32_t code${name}[] = {\n#include \"${words}\"\n};\n}  // namespace\n\nextern const std::span<const std::uint32_t> words${name};\nconst std::span<const std::uint32_t> words${name}(code${name});\n\n}  // namespace opaline::shaders\n")
      set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${words})
      list(APPEND sources ${source})
      list(APPEND modules ${variant}=words${name}=${spirv})
      list(APPEND unoptimised ${spirv})
    endforeach()
    add_custom_command(OUTPUT ${header} ${layout}
      COMMAND ${Python3_EXECUTABLE} ${interface} --type ${type} --shared ${shared} --groups shaders=${groups} --header ${header} --layouts ${layout} ${modules}
      DEPENDS ${interface} ${groups} ${unoptimised} COMMENT "Reading the interface of ${file}" VERBATIM)
    list(APPEND sources ${header} ${layout})
    string(APPEND layouts "#include \"${layout}\"\n")
  endforeach()
  # Holds shared structs to the layouts that shaders give them.
  file(CONFIGURE OUTPUT ${generated}/layouts.cpp CONTENT "${layouts}" @ONLY)
  add_library(${target} STATIC ${sources} ${generated}/layouts.cpp)
  target_include_directories(${target} PUBLIC ${generated})
  target_link_libraries(${target} PUBLIC opaline_gpu opaline_shader_headers)  # what those headers include
  opaline_part(${target})
endfunction()

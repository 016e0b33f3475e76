# The one library that other projects link, and how it is installed.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# opaline::opaline, static or shared as BUILD_SHARED_LIBS has it, of the objects of all libraries made so far. Inside,
# every folder stays a static library of its own, so that the compiler sees who includes whom.
function(opaline_whole_library)
  get_property(parts GLOBAL PROPERTY OPALINE_PARTS)
  add_library(opaline_library)
  add_library(opaline::opaline ALIAS opaline_library)
  foreach(part ${parts})
    target_sources(opaline_library PRIVATE $<TARGET_OBJECTS:${part}>)
  endforeach()

  # Of libraries that are headers alone nothing is left to link.
  get_property(linked GLOBAL PROPERTY OPALINE_LINKED)
  list(REMOVE_DUPLICATES linked)
  set(libraries)
  foreach(library ${linked})
    get_target_property(type ${library} TYPE)
    get_target_property(behind ${library} INTERFACE_LINK_LIBRARIES)
    if(NOT type STREQUAL INTERFACE_LIBRARY OR behind)
      list(APPEND libraries ${library})
    endif()
  endforeach()
  set_property(GLOBAL PROPERTY OPALINE_LIBRARIES ${libraries})

  target_include_directories(opaline_library PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(opaline_library PUBLIC cxx_std_20)
  target_link_libraries(opaline_library PUBLIC Vulkan::Headers
    PRIVATE ${libraries})
  if(OPALINE_SANITIZE)
    target_link_libraries(opaline_library PRIVATE $<BUILD_INTERFACE:opaline_warnings>)
  endif()
  set_target_properties(opaline_library PROPERTIES
    OUTPUT_NAME opaline EXPORT_NAME opaline LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endfunction()

# What a linker is told to find libraries that CMake found, and those behind them.
function(opaline_linker_flags result)
  set(left ${ARGN})
  set(seen)
  set(flags)
  while(left)
    list(POP_FRONT left library)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" library "${library}")
    if(NOT TARGET ${library} OR library IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${library})
    foreach(property IMPORTED_LOCATION IMPORTED_LOCATION_RELEASE IMPORTED_LOCATION_RELWITHDEBINFO IMPORTED_LOCATION_NONE)
      get_target_property(file ${library} ${property})
      if(file)
        get_filename_component(folder ${file} DIRECTORY)
        get_filename_component(name ${file} NAME)
        string(REGEX REPLACE "^lib(.*)\\.(so|a)[.0-9a-z]*$" "-l\\1" name ${name})
        if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
          list(APPEND flags -L${folder})
        endif()
        list(APPEND flags ${name})
        break()
      endif()
    endforeach()
    get_target_property(behind ${library} INTERFACE_LINK_LIBRARIES)
    if(behind)
      list(APPEND left ${behind})
    endif()
  endwhile()
  list(REMOVE_DUPLICATES flags)
  list(JOIN flags " " flags)
  set(${result} "${flags}" PARENT_SCOPE)
endfunction()

# What an outside project needs: headers, library, CMake package, pkg-config file, pages and licences.
function(opaline_install)
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Opaline)
  install(TARGETS opaline_library EXPORT opaline COMPONENT library)
  install(EXPORT opaline NAMESPACE opaline:: FILE OpalineTargets.cmake DESTINATION ${package} COMPONENT library)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/opaline ${PROJECT_BINARY_DIR}/include/opaline
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library FILES_MATCHING PATTERN "*.h")

  # Whoever links a static library links what is behind it.
  get_property(libraries GLOBAL PROPERTY OPALINE_LIBRARIES)
  get_target_property(type opaline_library TYPE)
  set(needed Vulkan::Headers)
  set(OPALINE_LIBS_PRIVATE)
  if(type STREQUAL STATIC_LIBRARY)
    list(APPEND needed ${libraries})
    opaline_linker_flags(OPALINE_LIBS_PRIVATE ${libraries})
    string(APPEND OPALINE_LIBS_PRIVATE " -lstdc++ -lm -pthread")
  endif()
  list(TRANSFORM needed REPLACE "::.*" "")
  list(REMOVE_DUPLICATES needed)
  list(TRANSFORM needed PREPEND "find_dependency(")
  list(TRANSFORM needed APPEND ")")
  list(JOIN needed "\n" OPALINE_FIND_DEPENDENCIES)

  set(made ${PROJECT_BINARY_DIR}/package)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/OpalineConfig.cmake.in ${made}/OpalineConfig.cmake
    INSTALL_DESTINATION ${package})
  write_basic_package_version_file(${made}/OpalineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${made}/OpalineConfig.cmake ${made}/OpalineConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindWebP.cmake DESTINATION ${package} COMPONENT library)

  file(RELATIVE_PATH OPALINE_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/opaline.pc.in ${made}/opaline.pc @ONLY)
  install(FILES ${made}/opaline.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
  # Libraries of headers alone are compiled in, so their licences go along, where the system keeps them.
  file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/compiled_in.txt compiled_in REGEX "^[a-z]")
  foreach(name ${compiled_in})
    install(FILES /usr/share/doc/${name}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences RENAME ${name}.txt
      COMPONENT documents OPTIONAL)
  endforeach()
endfunction()

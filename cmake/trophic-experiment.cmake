# trophic_add_experiment(NAME SOURCES... [BACKENDS mujoco ode] [ANALYZE] [WITHOUT_MPI] [WITHOUT_LIVE]): a program of trophic/command, with ANALYZE
# also of the command analyze (component analysis), linked with the engines that are named, or with every one that was found, and with MPI and a live page, where they were found; with the compiled libraries where there are, else from headers. Manifests and --version name
# the revision of the project's sources and the flags of the build.

function(trophic_add_experiment name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "ANALYZE;WITHOUT_MPI;WITHOUT_LIVE" "" "BACKENDS")
  set(kind "")
  if(TARGET trophic::command_compiled)
    set(kind _compiled)
  endif()
  if(NOT "BACKENDS" IN_LIST ARGN)
    foreach(backend mujoco ode)
      if(TARGET trophic::${backend}${kind})
        list(APPEND arg_BACKENDS ${backend})
      endif()
    endforeach()
  endif()
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE trophic::command${kind})
  foreach(backend IN LISTS arg_BACKENDS)
    target_link_libraries(${name} PRIVATE trophic::${backend}${kind})
  endforeach()
  if(TARGET trophic::mpi${kind} AND NOT arg_WITHOUT_MPI)
    target_link_libraries(${name} PRIVATE trophic::mpi${kind})
  endif()
  if(TARGET trophic::live AND kind AND NOT arg_WITHOUT_LIVE)
    target_link_libraries(${name} PRIVATE trophic::live)
  endif()
  if(arg_ANALYZE)
    if(NOT TARGET trophic::analysis)
      message(FATAL_ERROR "trophic_add_experiment(${name} ... ANALYZE): needs find_package(trophic COMPONENTS command_compiled analysis)")
    endif()
    target_link_libraries(${name} PRIVATE trophic::analysis)
  endif()
  trophic_link_provenance(${name})
endfunction()

# trophic_link_provenance(NAME): what trophic/command/provenance.hpp tells of the program. The revision is looked up at every build; its file is
# compiled again, and the program is linked again, only when it changed.
function(trophic_link_provenance name)
  string(MAKE_C_IDENTIFIER "trophic_provenance_of_${PROJECT_NAME}" provenance)
  if(NOT TARGET ${provenance})
    set(revision ${PROJECT_BINARY_DIR}/trophic_provenance/source_revision.cpp)
    add_custom_target(
      ${provenance}_look_up_revision
      BYPRODUCTS ${revision}
      COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DFILE=${revision} 
              -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/source-revision.cmake
      COMMENT "Looking up the source revision" VERBATIM)
    add_library(${provenance} OBJECT ${revision})
    add_dependencies(${provenance} ${provenance}_look_up_revision)
    string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
    string(REGEX REPLACE " +" " " build "${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
    string(STRIP "${build}" build)
    target_compile_definitions(${provenance} PRIVATE "TROPHIC_BUILD=\"${build}\"")
  endif()
  target_sources(${name} PRIVATE $<TARGET_OBJECTS:${provenance}>)
  add_dependencies(${name} ${provenance})
endfunction()

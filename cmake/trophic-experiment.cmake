# trophic_add_experiment(NAME SOURCES...): a program with the command line of trophic/experiment.hpp. Manifests and --version name the revision of
# the project's sources and the flags of the build.
function(trophic_add_experiment name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE trophic::command)
  trophic_link_provenance(${name})
endfunction()

# trophic_revision_of(SYMBOL TARGET FILE): a target that writes, at every build, a C++ file with the revision of the project's sources as SYMBOL, only
# if it changed.
function(trophic_revision_of symbol target file)
  add_custom_target(
    ${target}
    BYPRODUCTS ${file}
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DSYMBOL=${symbol} -DFILE=${file} -P
            ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/source-revision.cmake
    COMMENT "Looking up the source revision" VERBATIM)
endfunction()

# trophic_link_provenance(NAME): what trophic/command/provenance.hpp tells of the program.
function(trophic_link_provenance name)
  string(MAKE_C_IDENTIFIER "trophic_provenance_of_${PROJECT_NAME}" provenance)
  if(NOT TARGET ${provenance})
    set(revision ${PROJECT_BINARY_DIR}/trophic_provenance/source_revision.cpp)
    trophic_revision_of(trophic_source_revision ${provenance}_look_up_revision ${revision})
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

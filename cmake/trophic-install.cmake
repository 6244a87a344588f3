# Installs headers, libraries, models, programs and conformance suites with a CMake package: find_package(trophic COMPONENTS mujoco
# ode command compiled mujoco_compiled ode_compiled conformance).
include(CMakePackageConfigHelpers)
set(trophic_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trophic)

# One export file per component, so that a user without an engine can still load the core.
function(trophic_install_component component target)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "HEADERS" "")
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  set(file_sets "")
  get_target_property(sets ${target} INTERFACE_HEADER_SETS)
  foreach(set IN LISTS sets)
    if(set)
      list(APPEND file_sets FILE_SET ${set} DESTINATION ${arg_HEADERS})
    endif()
  endforeach()
  install(TARGETS ${target} EXPORT trophic-${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${file_sets})
  install(EXPORT trophic-${component} NAMESPACE trophic:: DESTINATION ${trophic_cmake_dir} FILE trophic-${component}.cmake)
endfunction()

trophic_install_component(trophic trophic HEADERS ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET trophic_conformance)
  trophic_install_component(conformance trophic_conformance HEADERS ${CMAKE_INSTALL_DATADIR}/trophic/tests)
endif()
foreach(component command mujoco ode compiled mujoco_compiled ode_compiled)
  if(TARGET trophic::${component})
    trophic_install_component(${component} trophic_${component} HEADERS ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
endforeach()

if(TROPHIC_BUILD_EXAMPLES)
  install(TARGETS trophic_program predator_prey worlds RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_BINARY_DIR}/installed_verbs/ DESTINATION ${CMAKE_INSTALL_BINDIR} USE_SOURCE_PERMISSIONS)
endif()
if(TARGET trophic_ecologies)
  install(TARGETS trophic_ecologies LIBRARY DESTINATION ${CMAKE_INSTALL_DATADIR}/trophic/python COMPONENT python)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/trophic)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/python DESTINATION ${CMAKE_INSTALL_DATADIR}/trophic FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN py.typed PATTERN "*.j2" PATTERN "*.ipynb")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
get_property(trophic_mujoco_version GLOBAL PROPERTY TROPHIC_MUJOCO_VERSION)
set(TROPHIC_INSTALLED_MODELS ${CMAKE_INSTALL_DATADIR}/trophic/models)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/trophic-config.cmake.in ${PROJECT_BINARY_DIR}/trophic-config.cmake
                              INSTALL_DESTINATION ${trophic_cmake_dir} PATH_VARS TROPHIC_INSTALLED_MODELS)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/trophic-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/trophic-config.cmake ${PROJECT_BINARY_DIR}/trophic-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/trophic-python.cmake ${PROJECT_SOURCE_DIR}/cmake/python-module.cpp.in
              ${PROJECT_SOURCE_DIR}/cmake/trophic-experiment.cmake ${PROJECT_SOURCE_DIR}/cmake/source-revision.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindODE.cmake ${PROJECT_SOURCE_DIR}/cmake/FindRandom123.cmake
              ${PROJECT_SOURCE_DIR}/cmake/trophic-build-type.cmake ${PROJECT_SOURCE_DIR}/cmake/trophic-find-mujoco.cmake ${PROJECT_SOURCE_DIR}/cmake/trophic-versions.cmake
        DESTINATION ${trophic_cmake_dir})

# For builds without CMake: pkg-config --cflags --libs trophic, or trophic-header-only; with an engine, trophic-mujoco or trophic-ode. The
# files find their prefix from where they lie.
file(RELATIVE_PATH TROPHIC_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
foreach(name trophic trophic-header-only)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
foreach(engine mujoco ode)
  if(TARGET trophic::${engine}_compiled)
    get_target_property(requires trophic_${engine}_compiled TROPHIC_PC_REQUIRES)
    get_target_property(libs trophic_${engine}_compiled TROPHIC_PC_LIBS)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/trophic-engine.pc.in ${PROJECT_BINARY_DIR}/trophic-${engine}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/trophic-${engine}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  endif()
endforeach()
# The installed header by which programs find the models, wherever the prefix is moved to.
set(trophic_header_folder trophic/habitat/load)
file(RELATIVE_PATH TROPHIC_HEADER_TO_MODELS ${CMAKE_INSTALL_FULL_INCLUDEDIR}/${trophic_header_folder} ${CMAKE_INSTALL_FULL_DATADIR}/trophic/models)
configure_file(${PROJECT_SOURCE_DIR}/cmake/installed_model_dir.hpp.in ${PROJECT_BINARY_DIR}/installed_model_dir.hpp @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/installed_model_dir.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${trophic_header_folder})

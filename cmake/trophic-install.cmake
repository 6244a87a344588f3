# Installs headers, models, programs and conformance suites with a CMake package:
# find_package(trophic COMPONENTS command mujoco ode conformance).
include(CMakePackageConfigHelpers)
set(trophic_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trophic)

# One export file per component, so that a user without an engine can still load the core.
function(trophic_install_component component target)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "HEADERS" "")
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  install(TARGETS ${target} EXPORT trophic-${component} FILE_SET HEADERS DESTINATION ${arg_HEADERS})
  install(EXPORT trophic-${component} NAMESPACE trophic:: DESTINATION ${trophic_cmake_dir} FILE trophic-${component}.cmake)
endfunction()

trophic_install_component(trophic trophic HEADERS ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET trophic_conformance)
  trophic_install_component(conformance trophic_conformance HEADERS ${CMAKE_INSTALL_DATADIR}/trophic/tests)
endif()
if(TARGET trophic_command)
  trophic_install_component(command trophic_command HEADERS ${CMAKE_INSTALL_INCLUDEDIR})
endif()
foreach(backend mujoco ode)
  if(TARGET trophic::${backend})
    get_target_property(target trophic::${backend} ALIASED_TARGET)
    trophic_install_component(${backend} ${target} HEADERS ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
endforeach()

if(TROPHIC_BUILD_EXAMPLES)
  install(TARGETS trophic_program predator_prey ablations RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/trophic)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/trophic-config.cmake.in ${PROJECT_BINARY_DIR}/trophic-config.cmake
                              INSTALL_DESTINATION ${trophic_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/trophic-config-version.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/trophic-config.cmake ${PROJECT_BINARY_DIR}/trophic-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/trophic-experiment.cmake ${PROJECT_SOURCE_DIR}/cmake/source-revision.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindODE.cmake ${PROJECT_SOURCE_DIR}/cmake/FindRandom123.cmake
        DESTINATION ${trophic_cmake_dir})

# What pip installs (pyproject.toml): the target trophic_wheel and the component wheel. Programs and module are linked from the same objects once
# without engines, into the folder kinematic, and once with MuJoCo, into mujoco-VERSION, where they find the library of MuJoCo's own wheel beside trophic.

# trophic_wheel_mujoco(): sets mujoco_ROOT to the wheel of MuJoCo that pip installed for this build, or else leaves MuJoCo out.
macro(trophic_wheel_mujoco)
  find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import importlib.util as u; found = u.find_spec('mujoco'); print(found.submodule_search_locations[0] if found else '')"
                  OUTPUT_VARIABLE mujoco_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT mujoco_ROOT)
    message(STATUS "trophic: the wheel has no MuJoCo backend, it needs: pip install mujoco")
    set(TROPHIC_BACKEND_MUJOCO OFF)
  endif()
endmacro()

# trophic_wheel_add(FOLDER OBJECTS...): the programs and the module once more, with more objects, in the folder of that name.
function(trophic_wheel_add folder)
  foreach(target trophic_program predator_prey worlds trophic_ecologies)
    if(NOT TARGET ${target})
      continue()
    endif()
    set(copy ${target}_${folder})
    get_target_property(libraries ${target} LINK_LIBRARIES)
    list(FILTER libraries EXCLUDE REGEX "pybind11|Python")  # has headers alone
    get_target_property(options ${target} LINK_OPTIONS)
    set(names OUTPUT_NAME)
    if(target STREQUAL "trophic_ecologies")
      add_library(${copy} MODULE EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${target}> ${ARGN})
      set(names PREFIX SUFFIX)
      set_target_properties(${copy} PROPERTIES OUTPUT_NAME ${target})
    else()
      add_executable(${copy} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${target}> ${ARGN})
    endif()
    foreach(name IN LISTS names)
      get_target_property(its ${target} ${name})
      set_target_properties(${copy} PROPERTIES ${name} "${its}")
    endforeach()
    target_link_libraries(${copy} PRIVATE ${libraries})
    target_link_options(${copy} PRIVATE -Wl,--as-needed)
    if(options)
      target_link_options(${copy} PRIVATE ${options})
    endif()
    trophic_link_provenance(${copy})
    set_target_properties(
      ${copy} PROPERTIES LINKER_LANGUAGE CXX BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$<$<NOT:$<STREQUAL:${folder},kinematic>>:$ORIGIN/../../../mujoco>"
                         RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/wheel/${folder} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/wheel/${folder})
    add_dependencies(trophic_wheel ${copy})
    install(TARGETS ${copy} RUNTIME DESTINATION ${folder} COMPONENT wheel EXCLUDE_FROM_ALL LIBRARY DESTINATION ${folder} COMPONENT wheel EXCLUDE_FROM_ALL)
  endforeach()
  install(DIRECTORY ${PROJECT_BINARY_DIR}/wheel/verbs/ DESTINATION ${folder} USE_SOURCE_PERMISSIONS COMPONENT wheel EXCLUDE_FROM_ALL)
endfunction()

# trophic_wheel(): the target and the component.
function(trophic_wheel)
  add_custom_target(trophic_wheel)
  # The list of engines that is linked first replaces that of trophic::command.
  add_library(trophic_no_engines OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tools/command/backends.cpp)
  target_link_libraries(trophic_no_engines PRIVATE trophic::compiled trophic_own_flags)
  target_include_directories(trophic_no_engines PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(trophic_no_engines PRIVATE TROPHIC_WHEEL)
  trophic_position_independent(trophic_no_engines)
  trophic_wheel_add(kinematic $<TARGET_OBJECTS:trophic_no_engines>)
  if(TROPHIC_WHEEL AND TARGET trophic::mujoco)
    get_property(version GLOBAL PROPERTY TROPHIC_MUJOCO_VERSION)
    trophic_wheel_add(mujoco-${version})
  endif()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION share/trophic COMPONENT wheel EXCLUDE_FROM_ALL)
endfunction()

# Finds the Open Dynamics Engine, which ships no CMake package of its own. Defines ODE::ODE.
find_path(ODE_INCLUDE_DIR ode/ode.h)
find_library(ODE_LIBRARY ode)
mark_as_advanced(ODE_INCLUDE_DIR ODE_LIBRARY)
if(ODE_INCLUDE_DIR AND EXISTS "${ODE_INCLUDE_DIR}/ode/version.h")
  file(STRINGS "${ODE_INCLUDE_DIR}/ode/version.h" ODE_VERSION REGEX "define dODE_VERSION")
  string(REGEX MATCH "[0-9.]+" ODE_VERSION "${ODE_VERSION}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  ODE
  REQUIRED_VARS ODE_LIBRARY ODE_INCLUDE_DIR
  VERSION_VAR ODE_VERSION REASON_FAILURE_MESSAGE "Debian and Ubuntu have it as libode-dev")
if(ODE_FOUND AND NOT TARGET ODE::ODE)
  add_library(ODE::ODE UNKNOWN IMPORTED)
  set_target_properties(ODE::ODE PROPERTIES IMPORTED_LOCATION "${ODE_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES
                                                                               "${ODE_INCLUDE_DIR}")
endif()

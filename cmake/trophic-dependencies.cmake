# trophic_find(PACKAGE APT [arguments of find_package]): looks for a package and remembers it when it is not there.
macro(trophic_find package apt)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    set_property(GLOBAL APPEND PROPERTY trophic_missing_packages ${package})
    set_property(GLOBAL APPEND PROPERTY trophic_missing_apt ${apt})
  endif()
endmacro()

# Ends the configuration with one message that names everything missing and the command that installs it on Debian.
function(trophic_stop_if_missing)
  get_property(packages GLOBAL PROPERTY trophic_missing_packages)
  get_property(apt GLOBAL PROPERTY trophic_missing_apt)
  if(packages)
    list(JOIN packages ", " packages)
    list(JOIN apt " " apt)
    message(FATAL_ERROR "trophic: not found: ${packages}. On Debian or Ubuntu: apt-get install ${apt}")
  endif()
endfunction()

# trophic_leave_out(CHOICE TEXT): says why a part is not built, and leaves the calling CMakeLists.txt. CHOICE is the value of its option:
# ON makes it an error.
macro(trophic_leave_out choice text)
  if("${choice}" STREQUAL "ON")
    message(FATAL_ERROR "trophic: ${text}")
  endif()
  message(STATUS "trophic: ${text}")
  return()
endmacro()

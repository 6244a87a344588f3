# trophic_find_version(PACKAGE MINIMUM BELOW [arguments of find_package]): finds any version, and sets PACKAGE_FOUND to false and
# PACKAGE_REFUSED to a sentence if its version is not in [MINIMUM, BELOW); an empty BELOW is no bound. find_package's own ranges end at a major version
# in packages that promise SameMajorVersion, as Eigen's do.
macro(trophic_find_version package minimum below)
  set(${package}_REFUSED "")
  find_package(${package} QUIET ${ARGN})
  trophic_check_version(${package} "${minimum}" "${below}" "${${package}_DIR}")
endmacro()

# trophic_check_version(PACKAGE MINIMUM BELOW PLACE): the same for a package that was looked for otherwise.
macro(trophic_check_version package minimum below place)
  if(${package}_FOUND AND (${package}_VERSION VERSION_LESS "${minimum}" OR (NOT "${below}" STREQUAL "" AND NOT ${package}_VERSION VERSION_LESS "${below}")))
    set(${package}_REFUSED "${package} ${${package}_VERSION} in ${place}: must be at least ${minimum}")
    if(NOT "${below}" STREQUAL "")
      string(APPEND ${package}_REFUSED " and below ${below}")
    endif()
    set(${package}_FOUND FALSE)
  endif()
endmacro()

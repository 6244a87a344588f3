# trophic_existing_includes(TARGET): takes include folders that do not exist out of an imported target, which CMake would refuse.
# Debian's MuJoCo package names one that it does not ship.
function(trophic_existing_includes target)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder IN LISTS folders)
    if(NOT EXISTS ${folder})
      list(REMOVE_ITEM folders ${folder})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${folders}")
endfunction()

# trophic_find_mujoco(): mujoco::mujoco for the folder that asks, and mujoco_FOUND.
macro(trophic_find_mujoco)
  find_package(mujoco 2.2 QUIET)
  if(mujoco_FOUND)
    trophic_existing_includes(mujoco::mujoco)
  endif()
endmacro()

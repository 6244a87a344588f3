# Says once that a build without a type is not optimised: CMake's default ran MuJoCo 7.6 times slower.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  get_property(trophic_warned GLOBAL PROPERTY TROPHIC_WARNED_OF_BUILD_TYPE)
  if(NOT trophic_warned)
    message(WARNING "trophic: CMAKE_BUILD_TYPE is empty, so nothing is optimised and simulations run several times slower; "
                    "give -DCMAKE_BUILD_TYPE=Release")
    set_property(GLOBAL PROPERTY TROPHIC_WARNED_OF_BUILD_TYPE ON)
  endif()
endif()

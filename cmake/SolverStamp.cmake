# adore_solver_stamp(<target>): compiles the hash of everything that results depend on into <target>: the sources of the
# solver, its data, compiler and flags. runs/solver_stamp.hpp has it.
function(adore_solver_stamp target)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/solver_stamp.cpp)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/core/*.cpp ${CMAKE_SOURCE_DIR}/core/*.hpp)
  list(FILTER sources EXCLUDE REGEX "/core/python/")
  file(GLOB data CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/resources/*.json)
  list(APPEND sources ${data})
  string(REPLACE ";" "\n" lines "${sources}")
  set(list ${CMAKE_CURRENT_BINARY_DIR}/solver_stamp.files)
  file(CONFIGURE OUTPUT ${list} CONTENT "${lines}" @ONLY)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set(compiler "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${ADORE_PORTABLE_MATH}")
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DLIST=${list} "-DCOMPILER=${compiler}" -DROOT=${CMAKE_SOURCE_DIR} -DOUTPUT=${generated}
            -P ${CMAKE_SOURCE_DIR}/cmake/stamp_files.cmake
    DEPENDS ${sources} ${list} ${CMAKE_SOURCE_DIR}/cmake/stamp_files.cmake
    COMMENT "Hashing the solver" VERBATIM)
  target_sources(${target} PRIVATE ${generated})
  set_source_files_properties(${generated} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

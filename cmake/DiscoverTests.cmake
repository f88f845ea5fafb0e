# adore_discover_tests(<program> [TIMEOUT <s>] [SLOW_TIMEOUT <s>] [ENVIRONMENT <NAME=value>...]): every test case of a
# Catch2 program as a CTest test. Its tags become its labels. The program is asked once, after it is linked.
function(adore_discover_tests program)
  cmake_parse_arguments(ARG "" "TIMEOUT;SLOW_TIMEOUT" "ENVIRONMENT" ${ARGN})
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${program}_tests.cmake)
  add_custom_command(TARGET ${program} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DNAME=${program} -DOUTPUT=${list}
            -DTIMEOUT=${ARG_TIMEOUT} -DSLOW_TIMEOUT=${ARG_SLOW_TIMEOUT} "-DENVIRONMENT=${ARG_ENVIRONMENT}"
            -P ${CMAKE_SOURCE_DIR}/cmake/list_tests.cmake
    BYPRODUCTS ${list} VERBATIM)
  # A program that was not built has one test, which says so.
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${program}_include.cmake)
  file(WRITE ${include} "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n"
                        "  add_test(${program}_NOT_BUILT ${program}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()

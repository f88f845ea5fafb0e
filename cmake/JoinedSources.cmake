# With ADORE_JOINED_SOURCES, the compiler reads several sources as one: headers are parsed and templates instantiated once for
# all of them.
set(ADORE_JOINED_COUNT 8)

# adore_joined(<target>): sources of a library. Names of helpers, in unnamed namespaces too, must be unique within the library.
# Left alone: sources with options of their own (by CMake).
function(adore_joined target)
  if(ADORE_JOINED_SOURCES)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${ADORE_JOINED_COUNT})
    # Classes whose members have types of the same source: no other source sees them.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# adore_joined_tests(<variable> FOLDER <folder>): replaces a list of test sources by generated files of several sources each.
# Every source stays in a namespace of its own, so helpers of tests may have equal names; the headers are included before.
# Left alone are sources with conditions of the preprocessor, options, replaced allocation or a named namespace.
function(adore_joined_tests variable)
  cmake_parse_arguments(ARG "" "FOLDER" "" ${ARGN})
  set(result)
  set(join)
  foreach(source ${${variable}})
    file(STRINGS ${source} special REGEX "^(#if|#define|namespace (adore|Catch|std))|operator (new|delete)")
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    if(special OR options)
      list(APPEND result ${source})
    else()
      list(APPEND join ${source})
    endif()
  endforeach()
  # The includes are read at configuration.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${join})
  # Files of equal size: with ten sources, two files of five.
  list(LENGTH join count)
  math(EXPR files "(${count} + ${ADORE_JOINED_COUNT} - 1) / ${ADORE_JOINED_COUNT}")
  set(number 0)
  foreach(source ${join})
    math(EXPR file "${number} % ${files}")
    file(STRINGS ${source} includes REGEX "^#include ")
    list(APPEND includes_${file} ${includes})
    # Relative, so that a compiler cache finds it from another folder.
    file(RELATIVE_PATH relative ${CMAKE_CURRENT_BINARY_DIR}/joined/${ARG_FOLDER} ${source})
    string(APPEND sources_${file} "namespace joined_${number} {\n#include \"${relative}\"\n}\n")
    math(EXPR number "${number} + 1")
  endforeach()
  set(file 0)
  while(file LESS files)
    list(REMOVE_DUPLICATES includes_${file})
    list(JOIN includes_${file} "\n" includes)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/joined/${ARG_FOLDER}/joined_${file}.cpp)
    file(CONFIGURE OUTPUT ${output} CONTENT "${includes}\n${sources_${file}}" @ONLY)
    list(APPEND result ${output})
    math(EXPR file "${file} + 1")
  endwhile()
  set(${variable} ${result} PARENT_SCOPE)
endfunction()

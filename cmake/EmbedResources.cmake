# adore_embed(<target> <name>=<file>...): compiles files into <target>, so that an installed program needs no data folder.
# base/resources.hpp finds them by name.
function(adore_embed target)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embedded_resources.cpp)
  set(files)
  foreach(pair ${ARGN})
    string(REGEX REPLACE "^[^=]*=" "" file ${pair})
    list(APPEND files ${file})
  endforeach()
  string(REPLACE ";" "|" pairs "${ARGN}")
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} "-DPAIRS=${pairs}" -DOUTPUT=${generated} -P ${CMAKE_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${files} ${CMAKE_SOURCE_DIR}/cmake/embed_files.cmake
    COMMENT "Embedding resources" VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()

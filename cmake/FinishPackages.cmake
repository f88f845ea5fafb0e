# Runs on the staged files of every package, after they are installed and before they are packed: compresses manual pages
# and the changelog as Debian wants them (no time stamp), strips what CPack does not know as a library, and removes what
# only the build of the site needs.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/*.1 ${CPACK_TEMPORARY_DIRECTORY}/changelog.Debian)
foreach(page ${pages})
  execute_process(COMMAND gzip -9n ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB_RECURSE modules ${CPACK_TEMPORARY_DIRECTORY}/_core*.so)
foreach(module ${modules})
  execute_process(COMMAND strip --strip-unneeded ${module} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB trees ${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/doc/adore-doc/html/.doctrees)
file(REMOVE_RECURSE ${trees})

# adore_portable_math: sin, exp, pow and the other double functions of musl, compiled for any x86-64, in place of those
# of the C library, which picks variants with fused multiply-add by processor and so rounds differently from machine to
# machine (decision 170). The linker takes them because this archive stands before libm; no source names them.
# Without musl the C library's functions stay, and `adore run --reproducible` says so.
set(ADORE_PORTABLE_MATH FALSE)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  find_file(ADORE_MUSL_LIBC libc.a NO_DEFAULT_PATH
            PATHS /usr/lib/x86_64-linux-musl /usr/x86_64-linux-musl/lib64 /usr/lib/musl/lib /usr/local/musl/lib
            DOC "musl's static C library (Debian: musl-dev), the source of adore_portable_math")
  if(ADORE_MUSL_LIBC)
    set(ADORE_PORTABLE_MATH TRUE)
  else()
    message(STATUS "musl not found (Debian: musl-dev): the C library's math functions are used")
  endif()
endif()

add_library(adore_portable_math INTERFACE)
if(ADORE_PORTABLE_MATH)
  set(functions sin cos sincos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 expm1 log log2 log10
                log1p pow powf cbrt hypot erf tgamma lgamma lgamma_r)  # powf: HDF5, where it is linked in
  set(helpers __sin __cos __tan __expo2 __rem_pio2 __rem_pio2_large __math_divzero __math_invalid __math_oflow
              __math_uflow __math_xflow __math_invalidf __math_oflowf __math_uflowf __math_xflowf exp_data exp2f_data
              log_data log2_data pow_data powf_data)
  execute_process(COMMAND ${CMAKE_AR} t ${ADORE_MUSL_LIBC} OUTPUT_VARIABLE members COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" members "${members}")
  set(wanted)
  foreach(name ${functions} ${helpers})
    foreach(suffix lo o)  # position independent, or the only kind there is
      if("${name}.${suffix}" IN_LIST members)
        list(APPEND wanted ${name}.${suffix})
        break()
      endif()
    endforeach()
  endforeach()
  set(folder ${CMAKE_BINARY_DIR}/portable_math)
  set(archive ${folder}/libadore_portable_math.a)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(
    OUTPUT ${archive}
    COMMAND ${CMAKE_AR} x ${ADORE_MUSL_LIBC} ${wanted}
    COMMAND ${CMAKE_COMMAND} -E rm -f ${archive}
    COMMAND ${CMAKE_AR} qc ${archive} ${wanted}
    COMMAND ${CMAKE_RANLIB} ${archive}
    WORKING_DIRECTORY ${folder} DEPENDS ${ADORE_MUSL_LIBC} COMMENT "Gathering math functions" VERBATIM)
  add_custom_target(adore_portable_math_archive DEPENDS ${archive})
  add_library(adore_portable_math_file STATIC IMPORTED)
  set_target_properties(adore_portable_math_file PROPERTIES IMPORTED_LOCATION ${archive})
  add_dependencies(adore_portable_math_file adore_portable_math_archive)
  target_link_libraries(adore_portable_math INTERFACE adore_portable_math_file)
  add_dependencies(adore_portable_math adore_portable_math_archive)
endif()

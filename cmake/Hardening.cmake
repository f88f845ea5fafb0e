# Hardening of the optimised build, as Debian's packages have it: checked copies of the C library (_FORTIFY_SOURCE), guards of the
# stack, jump targets for the processor (CET), addresses bound at the start and read-only after that. tests/hardening.py checks the
# programs. Not with sanitizers, which have their own checks. What it costs: resources/docs/hostile-input.md.
option(ADORE_HARDENING "Build programs with the compiler's and the linker's hardening" ON)
if(ADORE_HARDENING AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_NAME STREQUAL "Linux"
   AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(compile -fstack-protector-strong -fstack-clash-protection)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND compile -fcf-protection=full)
  endif()
  # It needs optimization: test programs have none (property ADORE_NOT_OPTIMIZED).
  set(fortify $<$<NOT:$<BOOL:$<TARGET_PROPERTY:ADORE_NOT_OPTIMIZED>>>:-U_FORTIFY_SOURCE>
              $<$<NOT:$<BOOL:$<TARGET_PROPERTY:ADORE_NOT_OPTIMIZED>>>:-D_FORTIFY_SOURCE=3>)
  target_compile_options(adore_options INTERFACE "$<$<CONFIG:Release>:${compile}>" "$<$<CONFIG:Release>:${fortify}>")
  target_link_options(adore_options INTERFACE
    "$<$<AND:$<CONFIG:Release>,$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>>:-pie>"
    "$<$<CONFIG:Release>:-Wl,-z,relro,-z,now,-z,noexecstack>")
endif()

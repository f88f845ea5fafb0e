# adore_precompiled(<target> FROM <set>): headers that a set of targets reads again and again, parsed once: those of other
# people's libraries, for dynamics also ours. A set is made by the first target that names it and lent to those that follow,
# which are built after it and need the same options. Sources with options of their own are left out
# (SKIP_PRECOMPILE_HEADERS). No source relies on it: every file includes what it uses, and ADORE_PRECOMPILED_HEADERS=OFF
# builds the same. Few headers: each set costs 100 MB of disk.
set(ADORE_PRECOMPILED_core <string> <vector> <Eigen/Core> <fmt/format.h>)
# And the header of all effects: a third of the time of small ones.
set(ADORE_PRECOMPILED_dynamics ${ADORE_PRECOMPILED_core} "dynamics/effect_makers.hpp")
set(ADORE_PRECOMPILED_qt <QMainWindow> <QPainter> <QString> <QWidget>)
set(ADORE_PRECOMPILED_tests <catch2/catch.hpp> <string> <vector> <filesystem> <functional> <Eigen/Geometry> <Eigen/LU>
                              <nlohmann/json.hpp>)
set(ADORE_PRECOMPILED_qt_tests ${ADORE_PRECOMPILED_tests} <QApplication> <QWidget>)

function(adore_precompiled target)
  cmake_parse_arguments(ARG "" "FROM" "" ${ARGN})
  if(NOT ADORE_PRECOMPILED_HEADERS)
    return()
  endif()
  get_property(lender GLOBAL PROPERTY ADORE_PRECOMPILED_BY_${ARG_FROM})
  if(lender)
    target_precompile_headers(${target} REUSE_FROM ${lender})
  else()
    target_precompile_headers(${target} PRIVATE ${ADORE_PRECOMPILED_${ARG_FROM}})
    set_property(GLOBAL PROPERTY ADORE_PRECOMPILED_BY_${ARG_FROM} ${target})
  endif()
endfunction()

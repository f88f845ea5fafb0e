# adore_precompiled(<target> FROM <set>): the headers of other people's libraries that a set of targets reads again and
# again, parsed once. A set is made by the first target that names it and lent to those that follow, which are built after
# it and need the same options. Sources with options of their own are left out (SKIP_PRECOMPILE_HEADERS). No source relies
# on it: every file includes what it uses, and ADORE_PRECOMPILED_HEADERS=OFF builds the same.
set(ADORE_PRECOMPILED_core <algorithm> <array> <cmath> <functional> <memory> <optional> <span> <string> <string_view>
                           <variant> <vector> <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)
set(ADORE_PRECOMPILED_command_line <CLI/CLI.hpp>)
set(ADORE_PRECOMPILED_app <CLI/CLI.hpp>)
set(ADORE_PRECOMPILED_cli <CLI/CLI.hpp> <fmt/format.h> <nlohmann/json.hpp> <Eigen/Core>)
set(ADORE_PRECOMPILED_tests <catch2/catch.hpp> <functional> <memory> <optional> <string> <vector> <Eigen/Core> <Eigen/Geometry>)
set(ADORE_PRECOMPILED_qt <QAction> <QBoxLayout> <QComboBox> <QLabel> <QMainWindow> <QPainter> <QSettings> <QString> <QWidget> <fmt/format.h>
                         ${ADORE_PRECOMPILED_core})
set(ADORE_PRECOMPILED_qt_tests ${ADORE_PRECOMPILED_tests} <QApplication> <QWidget>)
list(REMOVE_DUPLICATES ADORE_PRECOMPILED_qt)

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

# Debian packages by CPack: cmake --preset package && cmake --build --preset package && cpack --preset package.
# tests/package/run.sh builds, checks (lintian), installs, runs and removes them in a clean root.
#
#   package        component  content
#   adore          program    the command line
#   adore-apps     apps       AdrInput, AdrPlot, AGORE and the program that draws pictures
#   libadore-dev   library    the solver as a shared library, its headers and CMake files
#   python3-adore  python     the Python module
#   adore-doc      documents  the documentation site; it is in the package when ./docs.sh has built it before
include(GNUInstallDirs)

# MIME types: decks, animations and RESULTS.h5 open in the apps.
if(ADORE_WITH_QT)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/applications/adore.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT apps)
endif()
if(ADORE_WITH_PYTHON)
  install(DIRECTORY ${ADORE_PYTHON_PACKAGE} DESTINATION lib/python3/dist-packages
          COMPONENT python EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed"
          PATTERN "*.so" PATTERN "__pycache__" EXCLUDE)
endif()
install(DIRECTORY ${CMAKE_BINARY_DIR}/docs/html DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/adore-doc
        COMPONENT documents OPTIONAL EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME adore)
set(CPACK_PACKAGE_CONTACT "The Adore authors <adore@packages.debian.org>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)

set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/FinishPackages.cmake)

# adore_package(<component> <package> <title> <text>): name, description, and the files that each package must have.
set(CPACK_COMPONENTS_ALL)
macro(adore_package component package title text)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${title}\n${text}")
  install(FILES ${CMAKE_SOURCE_DIR}/resources/packages/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/packages/changelog DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          RENAME changelog.Debian COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

adore_package(program adore "dynamics of rolling bearings, command line"
  "Adore computes the statics and the dynamics of ball and roller bearings:\nloads, slip, heat, fatigue life, cage motion. The program adore reads decks,\nruns them, and writes listings and plot data.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "adore-apps")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "adore-doc, python3-adore, g++")
if(ADORE_WITH_QT)
  adore_package(apps adore-apps "dynamics of rolling bearings, desktop programs"
    "AdrInput prepares decks, AdrPlot shows charts of results, AGORE animates\na bearing. The package also has the program that draws the pictures of\n`adore plot` and `adore animate`.")
  set(CPACK_DEBIAN_APPS_PACKAGE_DEPENDS "adore (= ${PROJECT_VERSION}-1)")
  set(CPACK_DEBIAN_APPS_PACKAGE_RECOMMENDS "ffmpeg, libjs-three")
endif()
if(ADORE_SHARED_LIBRARY)
  adore_package(library libadore-dev "dynamics of rolling bearings, library for C++ programs"
    "The solver of Adore as a shared library, with its headers and files for CMake:\nfind_package(Adore).")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "nlohmann-json3-dev")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/resources/packages/libadore-dev/triggers)
endif()
if(ADORE_WITH_PYTHON)
  adore_package(python python3-adore "dynamics of rolling bearings, Python module"
    "The module adore: decks, equilibria, runs, results and calculators from Python.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/resources/packages/python3-adore/postinst
      ${CMAKE_SOURCE_DIR}/resources/packages/python3-adore/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "adore-apps, python3-pandas")
endif()
adore_package(documents adore-doc "dynamics of rolling bearings, documentation"
  "User manual, tutorials, theory and developer guide of Adore as web pages.")
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SHLIBDEPS OFF)

include(CPack)

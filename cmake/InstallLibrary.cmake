# adore_install_library(): the solver as one shared library for other people's programs, Adore::adorecore, with the headers
# of its interface: runs and studies, the deck, the readers of results, the calculators, and what these include. What the program
# links itself are the static libraries of the folders. Interface and versions: resources/docs/library.md.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(ADORE_NOT_IN_THE_SHARED_LIBRARY drawing validation)

set(ADORE_PUBLIC_HEADERS
    base/constants.hpp base/errors.hpp base/finding.hpp base/interrupted.hpp base/version.hpp base/write_folder.hpp bearing/grade_oil.hpp bearing/life_inputs.hpp bearing/lubrication.hpp
    calculators/adapter.hpp calculators/calculator_description.hpp calculators/calculators.hpp
    deck/deck.hpp deck/defaults.hpp deck/difference.hpp deck/deck_text_with_comments.hpp deck/no_part.hpp deck/schema.hpp deck/templates.hpp
    deck/unit_change.hpp deck/units.hpp
    runs/check.hpp runs/deck_request.hpp runs/deck_story.hpp runs/equilibrium.hpp runs/measured_run.hpp runs/option_file.hpp
    runs/output_folder.hpp runs/plan.hpp runs/reproducible.hpp runs/run.hpp
    studies/accuracy.hpp studies/sweep.hpp studies/verify.hpp
    results/accuracy_errors.hpp results/convert.hpp results/h5_reader.hpp results/key_results.hpp results/batch_means.hpp results/mean_errors.hpp results/quantities.hpp results/sol_file.hpp
    results/static_tables.hpp results/table.hpp user/adore_user.h user/plug_in.hpp)

function(adore_install_library)
  get_property(parts GLOBAL PROPERTY ADORE_LIBRARY_PARTS)
  get_property(links GLOBAL PROPERTY ADORE_LIBRARY_LINKS)
  list(REMOVE_DUPLICATES links)
  list(TRANSFORM links REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")
  set(objects)
  foreach(part ${parts})
    get_target_property(type ${part} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      list(APPEND objects $<TARGET_OBJECTS:${part}>)
    endif()
  endforeach()
  add_library(adore_shared SHARED ${objects})
  add_library(Adore::adorecore ALIAS adore_shared)
  set_target_properties(adore_shared PROPERTIES OUTPUT_NAME adorecore EXPORT_NAME adorecore LINKER_LANGUAGE CXX
                        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(adore_shared PUBLIC cxx_std_20)
  target_link_libraries(adore_shared PRIVATE ${links} $<BUILD_INTERFACE:adore_options>
                        PUBLIC nlohmann_json::nlohmann_json)
  # Seen from outside: names of namespace adore. The math functions that are bound in (decision 170) and templates of
  # other libraries stay inside.
  set(map ${PROJECT_SOURCE_DIR}/cmake/adorecore.map)
  target_link_options(adore_shared PRIVATE -Wl,--version-script=${map} -Wl,-Bsymbolic-functions -Wl,--strip-debug
                      -Wl,--no-undefined)
  set_target_properties(adore_shared PROPERTIES LINK_DEPENDS ${map})

  list(TRANSFORM ADORE_PUBLIC_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/core/ OUTPUT_VARIABLE headers)
  target_sources(adore_shared PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/core FILES ${headers})
  target_include_directories(adore_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  install(TARGETS adore_shared EXPORT AdoreTargets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT library
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/adore COMPONENT library)

  set(place ${CMAKE_INSTALL_LIBDIR}/cmake/Adore)
  install(EXPORT AdoreTargets NAMESPACE Adore:: DESTINATION ${place} COMPONENT library)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/AdoreConfig.cmake.in ${PROJECT_BINARY_DIR}/AdoreConfig.cmake
                                INSTALL_DESTINATION ${place} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/AdoreConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/AdoreConfig.cmake ${PROJECT_BINARY_DIR}/AdoreConfigVersion.cmake
          DESTINATION ${place} COMPONENT library)
endfunction()

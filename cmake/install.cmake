# The library with its headers and CMake package, the programs, and what a desktop needs to show the workbench.
if(SKBUILD)  # a wheel holds the Python module alone
  return()
endif()
include(CMakePackageConfigHelpers)
set(TOOLPACE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/toolpace)

install(TARGETS toolpace EXPORT toolpace_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
toolpace_needed_headers(headers)
foreach(header IN LISTS headers)
  get_filename_component(room ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/core/toolpace/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/toolpace/${room}
          COMPONENT development)
endforeach()
install(EXPORT toolpace_targets FILE toolpaceTargets.cmake NAMESPACE toolpace:: DESTINATION ${TOOLPACE_CMAKE_DIR} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/toolpaceConfig.cmake.in ${PROJECT_BINARY_DIR}/toolpaceConfig.cmake
                              INSTALL_DESTINATION ${TOOLPACE_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/toolpaceConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/toolpaceConfig.cmake ${PROJECT_BINARY_DIR}/toolpaceConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindLibZip.cmake
        DESTINATION ${TOOLPACE_CMAKE_DIR} COMPONENT development)

install(TARGETS toolpace_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
if(TARGET toolpace_studio)
  install(TARGETS toolpace_studio RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT studio)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/desktop/io.github.toolpace.Toolpace.desktop
          DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT studio)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/desktop/io.github.toolpace.Toolpace.metainfo.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT studio)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/desktop/io.github.toolpace.Toolpace.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT studio)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/machines DESTINATION ${CMAKE_INSTALL_DATADIR}/toolpace COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/nc DESTINATION ${CMAKE_INSTALL_DATADIR}/toolpace COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/python DESTINATION ${CMAKE_INSTALL_DATADIR}/toolpace COMPONENT python)
foreach(package toolpace=programs toolpace-studio=studio libtoolpace-dev=development python3-toolpace=python toolpace-doc=doc)
  string(REPLACE "=" ";" package ${package})
  list(GET package 0 name)
  list(GET package 1 component)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} RENAME copyright COMPONENT ${component})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)

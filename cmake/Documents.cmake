# Installs the documents so that their links work: README, LICENSE, docs/ with the schemas, the examples, and the descriptions of
# families and operations, as a start for custom ones. Packages of sources alone have none of them.
if(EXISTS ${PROJECT_SOURCE_DIR}/docs)
  install(FILES CHANGELOG.md LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} ${in_runtime})
  install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} ${in_runtime} FILES_MATCHING REGEX "[.](md|json|csv|svg|png)$")
  install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} ${in_runtime} PATTERN CMakeLists.txt EXCLUDE)
  install(FILES tables/families.json DESTINATION ${CMAKE_INSTALL_DOCDIR}/tables ${in_runtime})
  install(DIRECTORY tables/operations DESTINATION ${CMAKE_INSTALL_DOCDIR}/tables ${in_runtime} FILES_MATCHING PATTERN "*.json")
  file(RELATIVE_PATH headers ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
  cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_DOCDIR BASE_DIRECTORY [[${CMAKE_INSTALL_PREFIX}]] OUTPUT_VARIABLE documents)
  install(CODE "set(DOCUMENTS \"\$ENV{DESTDIR}${documents}\")
set(HEADERS ${headers})
include(${PROJECT_SOURCE_DIR}/cmake/InstalledLinks.cmake)" ${in_runtime})
endif()

# What people read, laid out so that documents find each other: README, LICENSE, docs/ with the schemas, and the
# descriptions of families and operations, to start one's own from. Packages of sources alone have none of them.
if(EXISTS ${PROJECT_SOURCE_DIR}/docs)
  install(FILES CHANGELOG.md LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
  install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime FILES_MATCHING REGEX "[.](md|json|csv|svg|png)$")
  install(FILES tables/families.json DESTINATION ${CMAKE_INSTALL_DOCDIR}/tables COMPONENT runtime)
  install(DIRECTORY tables/operations DESTINATION ${CMAKE_INSTALL_DOCDIR}/tables COMPONENT runtime FILES_MATCHING PATTERN "*.json")
endif()

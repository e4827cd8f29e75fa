# The programs that make and verify tables, as targets for a user's build and as the installed component `generator`.
foreach(name IN ITEMS generate verify dump-tables)
  add_executable(restrip::${name} ALIAS restrip-${name})
  set_target_properties(restrip-${name} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS restrip-generate restrip-verify restrip-dump-tables EXPORT restripGeneratorTargets
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ${in_generator})
install(EXPORT restripGeneratorTargets NAMESPACE restrip:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/restrip ${in_generator})

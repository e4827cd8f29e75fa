# restrip in one header: the target `single_header` writes it, and beside it a stand-in for each header that is part of it,
# so that sources that include those, our tests, can be compiled against the one file (restrip::single).
find_package(Python3 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  set(RESTRIP_SINGLE_FOLDER ${PROJECT_BINARY_DIR}/single)
  set(script ${PROJECT_SOURCE_DIR}/scripts/amalgamate.py)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/runtime/include/*.hpp ${PROJECT_SOURCE_DIR}/tables/include/*.hpp)
  add_custom_command(
    OUTPUT ${RESTRIP_SINGLE_FOLDER}/restrip/restrip.hpp
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${RESTRIP_SINGLE_FOLDER}
    COMMAND Python3::Interpreter ${script} --stand-ins --out ${RESTRIP_SINGLE_FOLDER}/restrip/restrip.hpp
    DEPENDS ${script} ${headers}
    VERBATIM)
  add_custom_target(single_header ALL DEPENDS ${RESTRIP_SINGLE_FOLDER}/restrip/restrip.hpp)
  add_library(restrip_single INTERFACE)
  add_library(restrip::single ALIAS restrip_single)
  add_dependencies(restrip_single single_header)
  target_compile_features(restrip_single INTERFACE cxx_std_20)
  target_include_directories(restrip_single INTERFACE ${RESTRIP_SINGLE_FOLDER})
  install(FILES ${RESTRIP_SINGLE_FOLDER}/restrip/restrip.hpp DESTINATION ${CMAKE_INSTALL_DATADIR}/restrip COMPONENT runtime)
endif()

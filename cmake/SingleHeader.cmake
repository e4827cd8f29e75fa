# restrip in one header: the target `single_header` writes it, with a stand-in for each header that is part of it. So sources
# that include individual headers, such as the tests, can be compiled against the one file (restrip::single).
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

  # The same with tables for fans of up to six triangles, for programs that must be small; larger fans are answered like fans
  # beyond k = 8 with the shipped tables.
  if(TARGET restrip-generate)
    set(RESTRIP_SMALL_FOLDER ${PROJECT_BINARY_DIR}/small)
    add_custom_command(
      OUTPUT ${RESTRIP_SMALL_FOLDER}/single/restrip/restrip.hpp
      COMMAND restrip-generate tables --max-k 6 --threads 2 --out ${RESTRIP_SMALL_FOLDER}
      COMMAND Python3::Interpreter ${script} --tables ${RESTRIP_SMALL_FOLDER}/include --stand-ins
              --out ${RESTRIP_SMALL_FOLDER}/single/restrip/restrip.hpp
      DEPENDS restrip-generate ${RESTRIP_SINGLE_FOLDER}/restrip/restrip.hpp
      VERBATIM)
    add_custom_target(small_single_header DEPENDS ${RESTRIP_SMALL_FOLDER}/single/restrip/restrip.hpp)
  endif()
endif()

# restrip in two files, restrip.hpp and restrip.cpp: the target `two_files` writes them into RESTRIP_TWO_FILES.
find_package(Python3 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  set(RESTRIP_TWO_FILES ${PROJECT_BINARY_DIR}/two-files)
  set(script ${PROJECT_SOURCE_DIR}/scripts/amalgamate.py)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/runtime/include/*.hpp ${PROJECT_SOURCE_DIR}/runtime/src/*.?pp
       ${PROJECT_SOURCE_DIR}/tables/include/*.hpp)
  add_custom_command(
    OUTPUT ${RESTRIP_TWO_FILES}/restrip.hpp ${RESTRIP_TWO_FILES}/restrip.cpp
    COMMAND Python3::Interpreter ${script} --out ${RESTRIP_TWO_FILES}
    DEPENDS ${script} ${sources} ${PROJECT_SOURCE_DIR}/cmake/project.cmake
    VERBATIM)
  add_custom_target(two_files ALL DEPENDS ${RESTRIP_TWO_FILES}/restrip.hpp)
  install(FILES ${RESTRIP_TWO_FILES}/restrip.hpp ${RESTRIP_TWO_FILES}/restrip.cpp DESTINATION ${CMAKE_INSTALL_DATADIR}/restrip
          COMPONENT runtime)
endif()

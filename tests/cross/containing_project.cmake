# Projects that contain restrip, only configured: targets that link ours can be exported, a program in C links the C++ library,
# a shared library exports its functions although the project hides symbols, and nothing of ours is installed unless it is asked
# for. pkg-config's files name the folders that an installation has, also absolute ones.
file(REMOVE_RECURSE ${SCRATCH})
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE printed ERROR_VARIABLE printed RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${printed}")
  endif()
  string(STRIP "${printed}" printed)
  set(printed "${printed}" PARENT_SCOPE)
endfunction()
set(compilers -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_C_COMPILER=${C_COMPILER})

run(${CMAKE_COMMAND} -G "Unix Makefiles" -S ${CMAKE_CURRENT_LIST_DIR}/containing_project -B ${SCRATCH}/build -DRESTRIP_SOURCE=${ROOT} ${compilers}
    -DBUILD_SHARED_LIBS=ON -DCMAKE_CXX_VISIBILITY_PRESET=hidden -DCMAKE_VISIBILITY_INLINES_HIDDEN=ON)
file(READ ${SCRATCH}/build/CMakeFiles/c_program.dir/link.txt command)
if(NOT command MATCHES "librestrip_c[.]a.* -lstdc[+][+] -lm")
  message(FATAL_ERROR "a program in C does not link the C++ library: ${command}")
endif()
file(STRINGS ${SCRATCH}/build/restrip/runtime/CMakeFiles/restrip_objects.dir/flags.make flags REGEX "^CXX_FLAGS")
if(NOT flags OR flags MATCHES "hidden")
  message(FATAL_ERROR "the shared library hides its functions: ${flags}")
endif()
run(${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${SCRATCH}/prefix)
file(GLOB_RECURSE files RELATIVE ${SCRATCH}/prefix ${SCRATCH}/prefix/*)
if(NOT files MATCHES "^lib/cmake/terrain/[^/]*$")
  message(FATAL_ERROR "the project installed ${files}")
endif()
run(${CMAKE_COMMAND} ${SCRATCH}/build -DRESTRIP_INSTALL=ON)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${SCRATCH}/all OUTPUT_QUIET ERROR_QUIET)  # fails at a library: it is not built
if(NOT EXISTS ${SCRATCH}/all/include/restrip/live_mesh.hpp)
  message(FATAL_ERROR "RESTRIP_INSTALL installs nothing of ours")
endif()

if(PKG_CONFIG)
  # A folder of each kind: absolute, and below the prefix.
  run(${CMAKE_COMMAND} -S ${ROOT} -B ${SCRATCH}/absolute ${compilers} -DRESTRIP_BUILD_PROGRAMS=OFF -DRESTRIP_BUILD_C=ON
      -DCMAKE_INSTALL_PREFIX=${SCRATCH}/out -DCMAKE_INSTALL_LIBDIR=${SCRATCH}/lib64 -DCMAKE_INSTALL_INCLUDEDIR=include/restrip-1)
  set(ENV{PKG_CONFIG_PATH} ${SCRATCH}/absolute/runtime:${SCRATCH}/absolute/bindings/c)
  foreach(package IN ITEMS restrip restrip-c)
    run(${PKG_CONFIG} --cflags --libs ${package})
    string(REPLACE - _ library ${package})
    if(NOT printed MATCHES "^-I${SCRATCH}/out/include/restrip-1 .*-L${SCRATCH}/lib64 -l${library}$")
      message(FATAL_ERROR "${package}.pc: ${printed}")
    endif()
  endforeach()
endif()

# Builds a consumer's project, with every warning on and fatal, as an installed package or as a
# subdirectory.
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
set(arguments)
if(WAY STREQUAL "package")
  foreach(component IN ITEMS runtime c_shared c generator)
    run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix --component ${component})
  endforeach()
  run(${SCRATCH}/prefix/bin/restrip-generate rules --operation ${ROOT}/examples/own_operation.json
      --operation ${ROOT}/examples/own_cost.json --operation ${ROOT}/examples/own_family.json --out ${SCRATCH}/rules)
  list(APPEND arguments -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DRESTRIP_SOURCE=${ROOT} -DRULES=${SCRATCH}/rules/include)
elseif(WAY STREQUAL "subdirectory")
  list(APPEND arguments -DRESTRIP_SOURCE=${ROOT})
endif()
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/build -DWAY=${WAY}
    -DCMAKE_CXX_COMPILER=${COMPILER} ${arguments})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)
if(WAY STREQUAL "package")
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumer/c -B ${SCRATCH}/c ${arguments})
  run(${CMAKE_COMMAND} --build ${SCRATCH}/c)
  run(${SCRATCH}/c/c_consumer)
  run(${SCRATCH}/c/c_static_consumer)
  run(${SCRATCH}/build/own_cost)
  run(${SCRATCH}/build/own_family)
  run(${SCRATCH}/prefix/bin/restrip-verify --operation ${ROOT}/examples/own_family.json
      --certificate ${SCRATCH}/rules/certificates/operations/remove-vertex.cert
      --header ${SCRATCH}/rules/include/restrip/tables/operations/remove_vertex.hpp
      --dump-command ${SCRATCH}/build/print_own_family)
endif()

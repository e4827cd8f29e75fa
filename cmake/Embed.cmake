# restrip_embed(TARGET NAMESPACE HEADER NAME FILE…): embeds the texts of files in the target as constants NAMESPACE::NAME,
# which HEADER declares, so that its programs need no further files.
include_guard(GLOBAL)

function(restrip_embed target namespace header)
  get_filename_component(source ${header} NAME_WE)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${source}.cpp)
  set(texts "")
  while(ARGN)
    list(POP_FRONT ARGN name file)
    if(NOT file MATCHES "^${CMAKE_CURRENT_BINARY_DIR}/")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    endif()
    file(READ ${file} text)
    string(APPEND texts "const std::string_view ${name} = R\"text(${text})text\";\n")
  endwhile()
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "@header@"

namespace @namespace@ {
@texts@}  // namespace @namespace@
]])
  target_sources(${target} PRIVATE ${source})
endfunction()

# restrip_embed_families(TARGET NAMESPACE HEADER): embeds tables/families.json and a list of all files of tables/operations.
function(restrip_embed_families target namespace header)
  get_filename_component(root ${CMAKE_CURRENT_FUNCTION_LIST_DIR} DIRECTORY)
  file(GLOB files CONFIGURE_DEPENDS ${root}/tables/operations/*.json)
  set(list "")
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND list "${text},")
  endforeach()
  string(REGEX REPLACE ",$" "" list "${list}")
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/operations.json "[${list}]")
  restrip_embed(${target} ${namespace} ${header} families_text ${root}/tables/families.json operations_text
                ${CMAKE_CURRENT_BINARY_DIR}/operations.json)
endfunction()

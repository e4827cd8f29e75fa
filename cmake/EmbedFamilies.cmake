# restrip_embed_families(TARGET NAMESPACE [HEADER]): gives the target tables/families.json as NAMESPACE::families_text, which
# HEADER declares (families_text.hpp by default), so that a program of it needs no file beside it.
include_guard(GLOBAL)

function(restrip_embed_families target namespace)
  set(header families_text.hpp ${ARGN})
  list(GET header -1 header)
  set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../tables/families.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/families_text.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "@header@"

namespace @namespace@ {
const std::string_view families_text = R"json(@text@)json";
}  // namespace @namespace@
]])
  target_sources(${target} PRIVATE ${source})
endfunction()

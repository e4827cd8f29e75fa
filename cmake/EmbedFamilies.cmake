# restrip_embed_families(TARGET NAMESPACE HEADER): gives the target tables/families.json and docs/taken-names.json as
# NAMESPACE::families_text and NAMESPACE::taken_names_text, which HEADER declares, so that a program of it needs no files
# beside it.
include_guard(GLOBAL)

function(restrip_embed_families target namespace header)
  foreach(name IN ITEMS tables/families docs/taken-names)
    set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../${name}.json)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} ${name})
  endforeach()
  set(families "${tables/families}")
  set(taken_names "${docs/taken-names}")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/families_text.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "@header@"

namespace @namespace@ {
const std::string_view families_text = R"json(@families@)json";
const std::string_view taken_names_text = R"json(@taken_names@)json";
}  // namespace @namespace@
]])
  target_sources(${target} PRIVATE ${source})
endfunction()

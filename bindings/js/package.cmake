# Writes the package.json of the npm package. Version, authors and repository come from CMakeLists.txt; without a repository
# its links are left out.
function(restrip_package_json file)
  file(READ ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/package.json text)
  if(NOT RESTRIP_REPOSITORY)
    string(REGEX REPLACE "[^\n]*@RESTRIP_REPOSITORY@[^\n]*\n" "" text "${text}")
  endif()
  file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
endfunction()

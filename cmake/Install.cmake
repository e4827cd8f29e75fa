# How our parts are installed: every install() names a component by ${in_COMPONENT}.
#
# In a project that adds this folder, nothing of ours is installed with that project's files unless RESTRIP_INSTALL is set. The
# rules exist all the same, so that it can export targets that link ours, and install ours by component.
option(RESTRIP_INSTALL "Install restrip with the project that contains it" ${PROJECT_IS_TOP_LEVEL})
foreach(component IN ITEMS runtime c_shared c generator)
  set(in_${component} COMPONENT ${component})
  if(NOT RESTRIP_INSTALL)
    list(APPEND in_${component} EXCLUDE_FROM_ALL)
  endif()
endforeach()

# restrip_pkg_config(NAME COMPONENT): installs NAME.pc. It can be moved with its prefix, unless its folders are absolute.
function(restrip_pkg_config name component)
  file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
  set(prefix "\${pcfiledir}/${to_prefix}")
  if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
    set(prefix ${CMAKE_INSTALL_PREFIX})
  endif()
  foreach(folder IN ITEMS LIBDIR INCLUDEDIR)
    set(${folder} ${CMAKE_INSTALL_${folder}})
    if(NOT IS_ABSOLUTE ${${folder}})
      set(${folder} "\${prefix}/${${folder}}")
    endif()
  endforeach()
  set(url "")
  if(RESTRIP_HOMEPAGE)
    set(url "URL: ${RESTRIP_HOMEPAGE}\n")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${in_${component}})
endfunction()

# CPack runs this before it packs the files that it has staged (cmake/Packages.cmake).
execute_process(COMMAND ${CPACK_RESTRIP_DEBIAN_FILES} ${CPACK_TEMPORARY_DIRECTORY} ${CPACK_PACKAGE_VERSION} ${CPACK_RESTRIP_DATE}
                        "${CPACK_PACKAGE_CONTACT}" ${CPACK_RESTRIP_PACKAGES} COMMAND_ERROR_IS_FATAL ANY)

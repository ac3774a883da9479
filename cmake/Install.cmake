# What `cmake --install` puts where. The installed tree can be moved: the program finds its data from where it is.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME hawser)
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# Libraries at places that the loader does not search, PETSc's own folder for example. Not in the Debian package.
option(CMAKE_INSTALL_RPATH_USE_LINK_PATH "Note in the installed program where its libraries were" ON)

# From the folder of the program to its data; the folder of the build has them at share/hawser.
file(RELATIVE_PATH HAWSER_DATA ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/hawser)
set(HAWSER_SHARE ${PROJECT_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${HAWSER_SHARE}/hawser)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/scripts ${HAWSER_SHARE}/hawser/python SYMBOLIC)

install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(FILES data/line-types.yaml DESTINATION ${CMAKE_INSTALL_DATADIR}/hawser)
install(DIRECTORY scripts/hawser_post DESTINATION ${CMAKE_INSTALL_DATADIR}/hawser/python
  PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/hawser USE_SOURCE_PERMISSIONS
  PATTERN "*.h5" EXCLUDE PATTERN "*.xdmf" EXCLUDE PATTERN "__pycache__" EXCLUDE)
# Debian has a form of its own for it (cmake/Package.cmake).
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT notices)

# The distribution's own, for which scripts/install-deps installs packages; another may come first in PATH.
find_program(HAWSER_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT HAWSER_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(HAWSER_PYTHON ${Python3_EXECUTABLE})
endif()

# The manual page and the completion of bash, from what the program says with --help.
function(hawser_manual)
  set(page ${HAWSER_SHARE}/man/man1/hawser.1)
  set(completion ${HAWSER_SHARE}/bash-completion/completions/hawser)
  file(GLOB python CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/scripts/hawser_post/*.py)
  add_custom_command(OUTPUT ${page}.gz ${completion} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${HAWSER_PYTHON} -B
      ${PROJECT_SOURCE_DIR}/scripts/manual.py $<TARGET_FILE:hawser> ${page}.gz ${completion}
    DEPENDS hawser ${PROJECT_SOURCE_DIR}/scripts/manual.py ${python}
    COMMENT "Making the manual page and the completion of bash")
  add_custom_target(manual ALL DEPENDS ${page}.gz ${completion})
  install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endfunction()

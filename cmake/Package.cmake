# The Debian package, which `cpack` makes in the folder of the build; scripts/package does all of it.
find_program(HAWSER_SHLIBDEPS dpkg-shlibdeps)
find_program(HAWSER_GZIP gzip)
if(NOT HAWSER_SHLIBDEPS OR NOT HAWSER_GZIP)
  return()
endif()
set(HAWSER_MAINTAINER "The hawser authors <hawser@maintainers.example>" CACHE STRING
  "Who answers for the package: name and mail address")
set(files ${PROJECT_BINARY_DIR}/debian)

# Copyright and changelog in Debian's forms. The changelog is dated like the version it is of.
file(READ LICENSE HAWSER_LICENCE)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" found "${HAWSER_LICENCE}")
set(HAWSER_COPYRIGHT "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*Copyright [^\n]*\n+" "" HAWSER_LICENCE "${HAWSER_LICENCE}")
string(REGEX REPLACE "\n+$" "" HAWSER_LICENCE "${HAWSER_LICENCE}")
string(REGEX REPLACE "\n\n" "\n.\n" HAWSER_LICENCE "${HAWSER_LICENCE}")
string(REPLACE "\n" "\n " HAWSER_LICENCE " ${HAWSER_LICENCE}")
configure_file(cmake/debian/copyright.in ${files}/copyright @ONLY)
file(STRINGS CHANGELOG.md heading REGEX "^## \\[${PROJECT_VERSION}\\] - ")
string(REGEX REPLACE "^.* - " "" day "${heading}")
execute_process(COMMAND date --utc --rfc-email --date "${day}" OUTPUT_VARIABLE HAWSER_DATE
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
configure_file(cmake/debian/changelog.in ${files}/changelog @ONLY)
execute_process(COMMAND ${HAWSER_GZIP} -9nkf ${files}/changelog COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${files}/copyright ${files}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT debian EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hawser)
set(CPACK_PACKAGE_VENDOR "The hawser authors")
set(CPACK_PACKAGE_CONTACT ${HAWSER_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "nonlinear statics and dynamics of mooring lines, risers and hoses")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Finite-element solver for lines at sea: mooring lines, risers, pipelines and
hoses, with contact and friction between the lines and the bodies they touch.
Cases are YAML files, results are HDF5 files that ParaView opens; runs are
parallel by MPI. Reports, figures and tables are made of the results.
.
This package has the program with its Python tools, the user guide and cases.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL hawser debian)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS ${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "openmpi-bin, python3, python3-h5py, python3-matplotlib, python3-numpy, python3-scipy")
# These draw models in a browser; without them reports are made without that.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libjs-three, libjs-dygraphs")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview, chromium | firefox-esr")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)

# Writes OUTPUT from TEMPLATE with VERSION, to which the commit of the sources is added: 0.1.0+1a2b3c4d, with `-modified`
# if files differ from it. Sources without a repository have the version alone.
if(EXISTS "${SOURCES}/.git")
  execute_process(
    COMMAND git describe --always --abbrev=8 --exclude=* --dirty=-modified
    WORKING_DIRECTORY ${SOURCES}
    OUTPUT_VARIABLE commit
    ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
set(PROGRAM_VERSION ${VERSION})
if(commit)
  string(APPEND PROGRAM_VERSION "+${commit}")
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)  # does not touch a file that is equal

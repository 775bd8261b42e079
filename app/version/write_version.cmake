# cmake -P: writes OUT from IN with VERSION and the commit of SOURCE_DIR, where that is a checkout of its own. A commit that is
# the same leaves the file as it is.
if(EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND git -c safe.directory=* -C ${SOURCE_DIR} rev-parse --short=10 HEAD OUTPUT_VARIABLE commit
                  OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE result ERROR_QUIET)
  if(result EQUAL 0)
    set(COMMIT " (${commit})")
  endif()
endif()
configure_file(${IN} ${OUT} @ONLY)

# cmake -DSOURCE=DIR -DFILE=OUT -P write_commit.cmake: the commit the sources stand at, for summary.json. After linking, not
# in the program itself: a commit that changes no code makes no other program.
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE commit RESULT_VARIABLE failed
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(failed)
  set(commit unknown)
else()
  execute_process(COMMAND git -C ${SOURCE} diff --quiet HEAD -- RESULT_VARIABLE changed OUTPUT_QUIET ERROR_QUIET)
  if(changed)
    string(APPEND commit "-changed")
  endif()
endif()
file(WRITE ${FILE} "${commit}\n")

# cmake -DSOURCE=FOLDER -DSYMBOL=NAME -DFILE=OUTPUT.cpp -P source-revision.cmake: writes a C++ file with the revision of the sources as NAME,
# only if it changed; with a program's trophic_source_revision also the build that the definition TROPHIC_BUILD states. The revision is data:
# code and constants, by which trophic::program_code identifies a program, do not change with it. The revision is "unknown" if SOURCE is neither the top of a git checkout
# (an enclosing project's revision is not ours) nor trophic's own archive, into which `git archive` writes its commit.
set(revision unknown)
set(archived "$Format:%H$")
file(REAL_PATH ${SOURCE}/cmake own_scripts)
file(REAL_PATH ${CMAKE_CURRENT_LIST_DIR} scripts)
if(own_scripts STREQUAL scripts AND archived MATCHES "^[0-9a-f]+$")
  string(SUBSTRING ${archived} 0 12 revision)
endif()
find_program(GIT git)
if(GIT)
  set(ENV{GIT_OPTIONAL_LOCKS} 0)
  execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE top RESULT_VARIABLE failed
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH ${SOURCE} source)
  if(NOT failed AND top STREQUAL source)
    execute_process(COMMAND ${GIT} describe --always --dirty --abbrev=12 WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE found
                    RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      set(revision ${found})
    endif()
  endif()
endif()
set(build "")
if(SYMBOL STREQUAL "trophic_source_revision")
  set(build "extern const char* trophic_build;
const char* trophic_build = TROPHIC_BUILD;
")
endif()
set(text "extern \"C\" {
extern const char* ${SYMBOL};
char ${SYMBOL}_text[256] = \"${revision}\";
const char* ${SYMBOL} = ${SYMBOL}_text;
${build}}
")
set(before "")
if(EXISTS ${FILE})
  file(READ ${FILE} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${FILE} "${text}")
endif()

# Writes a C++ file that says which commit is built, and only where it says another than before.
# Run by every build:  cmake -D SOURCE=... -D OUT=... -P commit.cmake
#
# A source tree that is not the top of a checkout of its own, an unpacked archive say, has none. The
# checkout may be another user's than who builds.
set(git git -c safe.directory=${SOURCE} -C ${SOURCE})
execute_process(COMMAND ${git} rev-parse --show-cdup
                RESULT_VARIABLE failure OUTPUT_VARIABLE way_up
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(failure EQUAL 0 AND way_up STREQUAL "")
  execute_process(COMMAND ${git} --no-optional-locks
                          describe --always --abbrev=12 --exclude=* "--dirty= with changes"
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT commit)
  set(commit "unknown, built without git")
endif()
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[
#include "app/version.h"

namespace morskin::app {
const std::string_view commit = "@commit@";
}  // namespace morskin::app
]])

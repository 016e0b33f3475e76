#!/bin/sh
# Starts the program, with the package's own C++ runtime only where the system's will not do. lib is named
# as well, since without /proc the loader does not find it beside the program.
here=$(dirname "$(readlink -f "$0")")
program=$here/libexec/opaline
if ! "$program" --version >/dev/null 2>&1; then
  LD_LIBRARY_PATH=$here/lib:$here/lib/fallback${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
  export LD_LIBRARY_PATH
fi
exec "$program" "$@"

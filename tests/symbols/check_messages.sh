#!/bin/sh
# check_messages.sh SRC: everything that the program says goes through base/say.hpp. (A signal handler writes its own
# fixed words.)
found=$(grep -rnE '\b(fmt::v?print|v?f?printf|f?puts|fputs|putchar|fwrite|perror)[[:space:]]*\(|std::(cout|cerr|clog)|STD(OUT|ERR)_FILENO' \
  --include='*.cpp' --include='*.hpp' "$1" |
  grep -vE '^[^:]*/(base/say|base/atomic_file|farm/child_process|app/sessions/interruption|viewer/window/report)\.cpp:|isatty')
[ -z "$found" ] && exit 0
echo "these lines print beside base/say.hpp:"
echo "$found"
exit 1

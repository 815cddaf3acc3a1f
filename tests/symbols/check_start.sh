#!/usr/bin/env bash
# Fails if starting the program loads a library that few pictures need.
# usage: check_start.sh PENUMBRA
set -euo pipefail
needed=$(readelf -d "$1" | grep NEEDED)
for library in libembree libtbb libOpenEXR libImath libSDL libGL libmuparser libstdc++ libfmt libpng; do
  if grep "$library" <<< "$needed"; then
    echo "the program is linked to $library, which costs every start milliseconds"
    exit 1
  fi
done

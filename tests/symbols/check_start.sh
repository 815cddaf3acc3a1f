#!/usr/bin/env bash
# Fails if starting the program loads one of these libraries, or leaves its heap in small pages.
# usage: check_start.sh PENUMBRA LIBRARY...
set -euo pipefail
needed=$(readelf -d "$1" | grep NEEDED)
for library in "${@:2}"; do
  if grep -F "[$library" <<< "$needed"; then
    echo "the program is linked to $library, which costs every start milliseconds"
    exit 1
  fi
done
symbols=$(nm -C "$1")
if ! grep -qF "penumbra::use_large_heap()" <<< "$symbols"; then
  echo "the program is made without use_large_heap, which costs every start a hundred page faults"
  exit 1
fi

#!/usr/bin/env bash
# Fails unless Embree, OpenEXR and muParser are loaded for what needs them, and for nothing else: the loader itself
# reports which files it opens (LD_DEBUG). The window's program may not load them at its start either.
# usage: check_start.sh PENUMBRA [PENUMBRA_VIEW]
set -euo pipefail
penumbra=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

late_libraries='embree|OpenEXR|muparser'

# The late libraries that the command opens, each once, in alphabetical order.
opened_by() {
  rm -f loader.*
  LD_DEBUG=files LD_DEBUG_OUTPUT=loader "$@" > said 2>&1 || { cat said; exit 1; }
  { grep -ohE "file=lib($late_libraries)" loader.* || true; } | sed 's/file=lib//' | sort -u | tr '\n' ' '
}

# Expects the command to open these late libraries and no others.
expect() {
  local opened
  opened=$(opened_by "${@:2}")
  [ "$opened" = "$1" ] && return
  echo "${*:2}: opens '$opened' of the libraries that are loaded on first use; expected '$1'"
  exit 1
}

echo 'sphere 1 0 0 -5' > plain.cli
echo 'sphere {1 / 2} 0 0 -5' > expression.cli
# A run of triangles long enough for Embree.
awk 'BEGIN { for (i = 0; i < 5000; i++) print "begin\nvertex", i, "0 -5\nvertex", i + 1, "0 -5\nvertex", i, "1 -5\nend" }' \
  > mesh.cli

render=(render --size 8x8 --rays 1 --quiet)
expect ''          "$penumbra" --version
expect ''          "$penumbra" "${render[@]}" plain.cli -o plain.png
expect 'OpenEXR '  "$penumbra" "${render[@]}" plain.cli -o plain.exr
expect 'muparser ' "$penumbra" "${render[@]}" expression.cli -o expression.png
expect 'embree '   "$penumbra" "${render[@]}" mesh.cli -o mesh.png
if [ $# -gt 1 ]; then expect '' "$2" --help; fi

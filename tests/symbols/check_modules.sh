#!/usr/bin/env bash
# Fails unless an error found by a library that is loaded at run time becomes the program's own message and exit code.
# usage: check_modules.sh PENUMBRA
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# Expects this exit code and a line like this in what the command says.
expect() {
  local code=0 said
  said=$("${@:3}" 2>&1) || code=$?
  [ "$code" -eq "$1" ] && grep -q "$2" <<< "$said" && return
  echo "expected $1 and '$2', got $code and '$said'"
  exit 1
}

printf 'sphere {1 / 2} 0 0 -3\nlight 0 0 0 1 1 1\n' > good.cli
printf 'sphere {1 / (2 - 2)} 0 0 -3\n' > infinite.cli
printf 'sphere {1 / } 0 0 -3\n' > broken.cli
"$1" render good.cli -o good.exr --quiet --rays 1
head -c 2000 good.exr > half.exr
expect 0 'result  *same' "$1" compare good.exr good.exr
expect 4 '`half.exr` is not a valid EXR file: ' "$1" compare good.exr half.exr
expect 65 'infinite.cli:1:8: ' "$1" check infinite.cli
expect 65 'broken.cli:1:9: ' "$1" check broken.cli

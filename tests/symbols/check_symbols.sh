#!/usr/bin/env bash
# Fails if the object file of a kernel defines a global or weak symbol outside its own namespace.
set -euo pipefail
outside=$(nm -C --defined-only "$1" | grep -vE '^[0-9a-f]+ [bdrtn] ' | grep -vE ' penumbra::lanes[0-9]+::' || true)
if [ -n "$outside" ]; then
  echo "$1 defines symbols that the linker may share with other instruction sets:"
  echo "$outside"
  exit 1
fi

#!/usr/bin/env bash
# Formatting and static analysis of all sources of the project. Needs Clang's tools; prints what is wrong and fails.
set -euo pipefail
cd "$(dirname "$0")/.."

git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror

cmake --preset lint > /dev/null
cmake --build --preset lint --target generated_headers > /dev/null
run-clang-tidy -quiet -p build/lint -j "$(nproc)" "$PWD/(src|fuzz|bench)/.*\.cpp" 2>&1 |
  grep -vE '^[0-9]+ warnings (generated|treated)|^Suppressed|^Use -header-filter|^clang-tidy|^$' || true
test "${PIPESTATUS[0]}" -eq 0

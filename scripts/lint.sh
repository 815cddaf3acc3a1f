#!/usr/bin/env bash
# Checks the formatting of all sources of the project and analyses them statically, with Clang's tools. Prints what is
# wrong and fails.
set -euo pipefail
cd "$(dirname "$0")/.."

git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror

cmake --preset lint > /dev/null
report=$(mktemp)
trap 'rm -f "$report"' EXIT
if ! run-clang-tidy -quiet -p build/lint -j "$(nproc)" "$PWD/(src|fuzz|bench)/.*\.cpp" > "$report" 2>&1; then
  grep -E '(warning|error):' -A6 "$report" || tail -20 "$report"
  exit 1
fi
echo "formatting and static analysis: nothing to say"

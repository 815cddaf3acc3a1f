#!/usr/bin/env bash
# Checks the formatting of all sources of the project and analyses them statically, with Clang's tools. Prints what is
# wrong and fails.
set -euo pipefail
cd "$(dirname "$0")/.."

git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror

cmake --preset lint > /dev/null
scripts/lint_files.py build/lint src fuzz bench
echo "formatting and static analysis: nothing to say"

#!/usr/bin/env bash
# Formatting and static analysis of all sources of the project. Needs Clang's tools; prints what is wrong and fails.
set -euo pipefail
cd "$(dirname "$0")/.."

git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror

cmake --preset lint > /dev/null
scripts/lint_files.py build/lint src fuzz bench
echo "formatting and static analysis: nothing to say"

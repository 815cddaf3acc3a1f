#!/usr/bin/env bash
# Runs every fuzzer in a folder for the given number of seconds, starting from the files in fuzz/corpus. With a number
# as third argument, the inputs are the same in every run; without it (0), they differ from run to run.
set -euo pipefail
folder=$1
seconds=$2
order=${3:-0}
export folder seconds order

fuzz() {
  local fuzzer=$1 name found seeds dictionary options
  name=$(basename "$fuzzer" _fuzzer)
  found=$(mktemp -d)
  seeds=(fuzz/corpus/"$name")
  dictionary=(fuzz/"$name".dict)
  options=(-max_total_time="$seconds" -seed="$order" -timeout=10 -rss_limit_mb=4096 -print_final_stats=0 -verbosity=0)
  [ -f "${dictionary[0]}" ] && options+=(-dict="${dictionary[0]}")
  [ -d "${seeds[0]}" ] || seeds=()
  echo "fuzzing $name for $seconds s"
  "$fuzzer" "${options[@]}" -artifact_prefix="$folder/" "$found" "${seeds[@]}"
  rm -rf "$found"
}
export -f fuzz
printf '%s\0' "$folder"/*_fuzzer | xargs -0 -n 1 -P "$(nproc)" bash -euo pipefail -c 'fuzz "$1"' fuzz
echo "no fuzzer found anything"

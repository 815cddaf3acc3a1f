#!/usr/bin/env bash
# Runs every fuzzer in a folder for the given number of seconds, starting from the files in fuzz/corpus. With a number
# as third argument, the inputs are the same in every run; without it (0), they differ from run to run.
set -euo pipefail
folder=$1
seconds=$2
order=${3:-0}
for fuzzer in "$folder"/*_fuzzer; do
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
done
echo "no fuzzer found anything"

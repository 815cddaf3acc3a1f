#!/usr/bin/env bash
# Runs every fuzzer in a folder for the given number of seconds, starting from the files in fuzz/corpus. With a number
# as third argument, the inputs are the same in every run; without it (0), they differ from run to run. In the end, each
# tells how many inputs it tried.
set -euo pipefail
folder=$1
seconds=$2
order=${3:-0}
export folder seconds order

fuzz() {
  local fuzzer=$1 name found seeds dictionary options log
  name=$(basename "$fuzzer" _fuzzer)
  found=$(mktemp -d)
  seeds=(fuzz/corpus/"$name")
  dictionary=fuzz/$name.dict
  [ "$name" = render ] && dictionary=fuzz/language.dict
  options=(-max_total_time="$seconds" -seed="$order" -timeout=10 -rss_limit_mb=4096 -print_final_stats=1 -verbosity=0)
  # No picture and no small scene takes more than 512 MB at once.
  case $name in image | render) options+=(-malloc_limit_mb=512) ;; esac
  [ -f "$dictionary" ] && options+=(-dict="$dictionary")
  [ -d "${seeds[0]}" ] || seeds=()
  echo "fuzzing $name for $seconds s"
  log=$(mktemp)
  if ! "$fuzzer" "${options[@]}" -artifact_prefix="$folder/" "$found" "${seeds[@]}" 2> "$log"; then
    cat "$log" >&2
    return 1
  fi
  echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs"
  rm -rf "$found" "$log"
}
export -f fuzz
printf '%s\0' "$folder"/*_fuzzer | xargs -0 -n 1 -P "$(nproc)" bash -euo pipefail -c 'fuzz "$1"' fuzz
echo "no fuzzer found anything"

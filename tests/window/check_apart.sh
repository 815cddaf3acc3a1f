#!/usr/bin/env bash
# usage: check_apart.sh PENUMBRA SCENE
# `penumbra render` loads no windowing library, neither as a dependency nor while it runs; without a display,
# `penumbra view` says so in one line, names the command to use instead, and exits with 69.
set -euo pipefail
penumbra=$1
scene=$2
windowing='SDL|libGL|libOpenGL|libEGL|libX11|libxcb|wayland|imgui'

if ldd "$penumbra" | grep -E "$windowing"; then
  echo "the program depends on windowing libraries"
  exit 1
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$penumbra" render "$scene" --rays 16777216 -o "$folder/out.png" --quiet &
render=$!
# Once it has computed for a fifth of a second, it has loaded everything it needs.
until [ "$(cut -d' ' -f14 "/proc/$render/stat")" -gt 20 ]; do sleep 0.01; done
maps=$(cat "/proc/$render/maps")
kill "$render"
wait "$render" || true
if ! grep -q libc.so <<< "$maps" || grep -E "$windowing" <<< "$maps"; then
  echo "a render loads windowing libraries"
  exit 1
fi

code=0
env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER "$penumbra" view "$scene" > "$folder/said" 2>&1 || code=$?
cat "$folder/said"
[ "$code" -eq 69 ]
[ "$(wc -l < "$folder/said")" -eq 1 ]
grep -q "penumbra render $scene" "$folder/said"
for driver in offscreen dummy; do
  code=0
  env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=$driver "$penumbra" view "$scene" > "$folder/said" 2>&1 || code=$?
  [ "$code" -eq 69 ]
done

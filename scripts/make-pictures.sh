#!/usr/bin/env bash
# Renders the pictures of the README and the docs from the project's own scenes.
set -euo pipefail
cd "$(dirname "$0")/.."
penumbra=$1
mkdir -p docs/images
"$penumbra" render scenes/demo.cli -o docs/images/demo.png
for scene in s05a s05b s06a s06b s07a s07b s08a s08b; do
  "$penumbra" render "scenes/$scene.cli" --size 300x300 -o "docs/images/$scene.png"
done
for pattern in regular random jittered multijittered poisson halton sobol bluenoise; do
  "$penumbra" samples --sampler "$pattern" -n 64 -o "docs/images/patterns-$pattern.png"
done

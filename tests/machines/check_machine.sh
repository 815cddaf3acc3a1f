#!/usr/bin/env bash
# Fails unless the program, on a machine without the instruction set WIDER, picks the kernel ISA by itself ("none": says
# that it has none), ends without an illegal instruction, and makes the same file as here.
# usage: check_machine.sh PENUMBRA WIDE_INSTRUCTION CPU WIDER ISA
set -euo pipefail
penumbra=$1 wide_instruction=$2 cpu=$3 wider=$4 isa=$5

if ! command -v qemu-x86_64 > /dev/null; then
  echo "skipped: there is no qemu-x86_64 (Debian package qemu-user)"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Runs a command there, without QEMU's own warnings.
there() {
  local code=0
  qemu-x86_64 -cpu "$cpu" "$@" 2> "$folder/said" || code=$?
  grep -v '^qemu-x86_64: warning' "$folder/said" >&2 || true
  return "$code"
}

fail() {
  echo "$cpu: $1"
  exit 1
}

there "$wide_instruction" nothing || fail "QEMU cannot run a simple program"
# In a subshell, whose message about the signal is dropped.
if (there "$wide_instruction" "$wider") > /dev/null 2>&1; then
  fail "runs an instruction of $wider, so this test would detect nothing"
fi

cat > "$folder/shapes.cli" << 'SCENE'
image_size 24 16
rays_per_pixel 5
background .2 .3 .5
lens .05 5
disk_light -4 6 0 1.5  .5 -1 0  .8 .8 .8
diffuse .6 .6 .6  .1 .1 .1
box -20 -1.5 -20  20 -1 20
translucent .1 .2 .1  .4 .4 .4  60  .2 .1  .6 1.5 .05
sphere .7  -1.2 -.3 -4
moving_object .3 .2 0
glossy .4 .3 .2  .5 .5 .5  30  .4 .2
SCENE
cp "$folder/shapes.cli" "$folder/mesh.cli"
echo "cylinder .6  .5 -5  -1 1" >> "$folder/shapes.cli"
echo "cone -.6 -1 -5  1 .5" >> "$folder/shapes.cli"
# A ball of 4608 triangles: enough for Embree.
awk 'function vertex(i, k,  a, b) {
       a = i * 3.14159265 / n; b = k * 6.2831853 / n
       printf "vertex %.6f %.6f %.6f\n", 0.5 + sin(a) * cos(b), cos(a), -5 + sin(a) * sin(b)
     }
     BEGIN {
       n = 48
       for (i = 0; i < n; i++) {
         for (k = 0; k < n; k++) {
           print "begin"; vertex(i, k); vertex(i + 1, k); vertex(i + 1, k + 1); print "end"
           print "begin"; vertex(i, k); vertex(i + 1, k + 1); vertex(i, k + 1); print "end"
         }
       }
     }' >> "$folder/mesh.cli"

# A pattern without tables: QEMU 7.2 mistakes a gather whose indices are in the register ymm4 for one without indices.
for scene in shapes mesh; do
  render=("$penumbra" render "$folder/$scene.cli" --sampler jittered --threads 2 --quiet)
  if [ "$isa" = none ]; then
    code=0
    there "${render[@]}" -o "$folder/there.exr" || code=$?
    [ "$code" -eq 70 ] || fail "exit code $code, not the 70 of a program without a kernel for this machine"
    continue
  fi
  there "${render[@]}" -o "$folder/there.exr" --stats "$folder/stats.json" || fail "$scene: exit code $?"
  grep -q "\"isa\": \"$isa\"" "$folder/stats.json" || fail "$scene: did not pick $isa"
  if [ "$scene" = mesh ] && ! grep -q '"triangles": 4608' "$folder/stats.json"; then fail "mesh: no mesh"; fi
  "${render[@]}" -o "$folder/here.exr" --isa "$isa"
  cmp "$folder/here.exr" "$folder/there.exr" || fail "$scene: the picture differs from that of --isa $isa here"
done

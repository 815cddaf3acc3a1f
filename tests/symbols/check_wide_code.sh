#!/usr/bin/env bash
# Fails if the program has an instruction of a wide set outside the kernels for it: AVX, AVX2 and BMI belong only in
# lanes8 and lanes16, AVX-512 only in lanes16.
set -euo pipefail
objdump -d -C --no-show-raw-insn "$1" | awk '
  /^[0-9a-f]+ </ { place = $0 }
  /^ +[0-9a-f]+:\t(v[a-z0-9]+|pdep|pext|andn|bzhi|shlx|sarx|shrx|rorx|mulx|lzcnt|blsr|blsi|blsmsk|k[a-z]+[bwdq]) / {
    wide++
    if (place ~ /penumbra::lanes16::/) next
    if (place ~ /penumbra::lanes8::/ && $0 !~ /%zmm|%k[0-7]|%[xy]mm(1[6-9]|2[0-9]|3[01])/) next
    if (place != last) print "wide instructions in " place
    last = place
    outside++
  }
  END {
    if (!wide) print "no wide instruction found at all; this test would detect nothing"
    exit !wide || outside
  }'

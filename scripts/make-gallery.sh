#!/usr/bin/env bash
# Renders the pictures of docs/lecture.md into docs/images/lecture, one line for each.
#
# usage: make-gallery.sh PENUMBRA [PART-OF-NAME]    (only the pictures whose names contain that part)
set -euo pipefail
cd "$(dirname "$0")/.."
penumbra=$1
wanted=${2:-}
folder=docs/images/lecture
mkdir -p "$folder"

# A picture: its name, its scene in scenes/, and the options.
picture() {
  local name=$1 scene=$2
  shift 2
  [[ $name == *"$wanted"* ]] || return 0
  echo "$name"
  "$penumbra" render "scenes/$scene" "$@" --quiet -o "$folder/$name.png"
}

# An enlarged detail: 64 x 48 pixels of such a picture, each enlarged to a square of 5 x 5.
detail() {
  picture "$@" --crop 84,120,148,168
  [[ $1 == *"$wanted"* ]] || return 0
  python3 scripts/enlarge.py 5 "$folder/$1.png"
}

# A plot of sample points: its name and the pattern.
plot() {
  [[ $1 == *"$wanted"* ]] || return 0
  echo "$1"
  "$penumbra" samples --sampler "$2" -n 64 -o "$folder/$1.png" > /dev/null
}

# Pages 1 to 3: noise instead of artifacts
picture idea-1             billiard.cli --size 320x240 --rays 1
picture idea-64            billiard.cli --size 320x240 --rays 64

# Pages 4 to 8: patterns of points
plot    points-regular     regular
plot    points-jittered    jittered
plot    points-poisson     poisson

# Pages 6, 7 and 9: antialiasing
picture wheel-regular-4    lecture/wheel.cli --rays 4 --sampler regular
picture wheel-jittered-4   lecture/wheel.cli --rays 4 --sampler jittered
picture wheel-jittered-16  lecture/wheel.cli --rays 16 --sampler jittered

# Pages 10 to 13: the whole, and a detail
picture wheel-1            lecture/wheel.cli --rays 1 --sampler regular
picture wheel-jittered-64  lecture/wheel.cli --rays 64 --sampler jittered
detail  detail-1           lecture/wheel.cli --rays 1 --sampler regular
detail  detail-jittered-4  lecture/wheel.cli --rays 4 --sampler jittered
detail  detail-jittered-64 lecture/wheel.cli --rays 64 --sampler jittered

# Pages 15, 29, 38 and 63: the kinds of rays
picture ray-tree           lecture/ray_tree.cli --transparent-shadows

# Pages 17 to 20: reflected rays, one eye ray per pixel
picture reflection-perfect lecture/pencils_mirror.cli --rays 1
picture reflection-10      lecture/pencils_glossy.cli --rays 1 --reflection-rays 10 --sampler jittered
picture reflection-20      lecture/pencils_glossy.cli --rays 1 --reflection-rays 20 --sampler jittered
picture reflection-50      lecture/pencils_glossy.cli --rays 1 --reflection-rays 50 --sampler jittered

# Pages 21 to 24: many eye rays, each reflected once
picture glossy-perfect     lecture/globe.cli --rays 16
picture glossy-4           lecture/globe_middle.cli --rays 4
picture glossy-16          lecture/globe_middle.cli --rays 16
picture glossy-64          lecture/globe_middle.cli --rays 64

# Pages 25 to 27: the amount of jitter
picture gloss-h-10         lecture/globe_wide.cli --rays 64
picture gloss-h-45         lecture/globe_middle.cli --rays 64
picture gloss-h-400        lecture/globe_narrow.cli --rays 64

# Pages 30 to 33: transmitted rays, one eye ray per pixel; then many eye rays
picture transmission-perfect lecture/aquarium_clear.cli --rays 1
picture transmission-10    lecture/aquarium_frosted.cli --rays 1 --transmission-rays 10 --sampler jittered
picture transmission-20    lecture/aquarium_frosted.cli --rays 1 --transmission-rays 20 --sampler jittered
picture transmission-64    lecture/aquarium_frosted.cli --rays 64

# Pages 34 and 35: the amount of jitter
picture blur-h-10          lecture/aquarium_wide.cli --rays 64
picture blur-h-65          lecture/aquarium_narrow.cli --rays 64

# Pages 36 to 40: hard and soft shadows
picture shadow-hard        lecture/chair_point.cli --rays 16
picture shadow-soft        lecture/chair_disk.cli --rays 64

# Pages 41 to 45: a point; a regular set of points on the light; jittered ones
picture shadow-point       lecture/chair_point.cli --rays 1
picture shadow-regular     lecture/chair_disk.cli --rays 1 --shadow-rays 10 --sampler-light regular
picture shadow-10          lecture/chair_disk.cli --rays 1 --shadow-rays 10 --sampler jittered
picture shadow-20          lecture/chair_disk.cli --rays 1 --shadow-rays 20 --sampler jittered
picture shadow-50          lecture/chair_disk.cli --rays 1 --shadow-rays 50 --sampler jittered

# Pages 46 to 57: depth of field
picture lens-model         lecture/lens_model.cli --transparent-shadows
picture focus-pinhole      lecture/dominoes_pinhole.cli --rays 64
picture focus-near         lecture/dominoes_near.cli --rays 196
picture focus-middle       lecture/dominoes_middle.cli --rays 196
picture focus-far          lecture/dominoes_far.cli --rays 196
picture focus-thin-detail  lecture/dominoes_middle.cli --rays 196 --size 480x480 --crop 10,170,250,410
picture focus-cone-detail  lecture/dominoes_middle.cli --rays 196 --size 480x480 --crop 10,170,250,410 --lens-model cone

# Pages 58 to 61: motion blur
picture train-0            lecture/train_open.cli --rays 16 --time 0
picture train-1            lecture/train_open.cli --rays 16 --time 1
picture train-closed       lecture/train_closed.cli --rays 16
picture train-open         lecture/train_open.cli --rays 64
picture train-pan          lecture/train_pan.cli --rays 64

# Pages 60 and 64: all of it
picture billiard-sharp     billiard.cli --size 320x240 --rays 16 --time .5
picture billiard           billiard.cli

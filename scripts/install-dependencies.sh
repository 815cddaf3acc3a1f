#!/usr/bin/env bash
# Installs the Debian packages that a goal needs (build, test, lint; ci: what .ci/run needs besides; instructions: for
# bench/instructions.py; coverage: for make coverage; peers: for bench/peers; cluster: the Slurm of tests/cluster), and
# only the missing ones: if none is missing, it calls no package manager and needs no network. Only apt runs as root.
set -euo pipefail

build_packages=(g++ cmake ninja-build pkg-config libembree-dev libtbb-dev libopenexr-dev libpng-dev zlib1g-dev
                libdeflate-dev libcli11-dev libfmt-dev libmuparser-dev libxxhash-dev nlohmann-json3-dev libsdl2-dev
                libimgui-dev libgl-dev libopengl-dev fonts-inter fonts-dejavu-core)
# The window is tested on a headless X server, with software OpenGL and real key presses.
test_packages=(libgtest-dev openimageio-tools python3 xvfb xdotool xclip x11-xkb-utils libgl1-mesa-dri)
lint_packages=(clang clang-format clang-tidy libclang-rt-dev)
ci_packages=(qemu-user ccache)
instructions_packages=(valgrind)
coverage_packages=(gcovr)
peers_packages=(povray blender python3-numpy python3-openimageio python3-matplotlib)
cluster_packages=(slurm-wlm munge)

case "${1:-}" in
  build) wanted=("${build_packages[@]}") ;;
  test) wanted=("${build_packages[@]}" "${test_packages[@]}") ;;
  lint) wanted=("${build_packages[@]}" "${test_packages[@]}" "${lint_packages[@]}") ;;
  ci) wanted=("${ci_packages[@]}") ;;
  instructions) wanted=("${build_packages[@]}" "${instructions_packages[@]}") ;;
  coverage) wanted=("${build_packages[@]}" "${test_packages[@]}" "${coverage_packages[@]}") ;;
  peers) wanted=("${peers_packages[@]}") ;;
  cluster) wanted=("${build_packages[@]}" "${cluster_packages[@]}") ;;
  *)
    echo "usage: $0 build|test|lint|ci|instructions|coverage|peers|cluster" >&2
    exit 64
    ;;
esac

missing=()
for package in "${wanted[@]}"; do
  if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
    missing+=("$package")
  fi
done
[ "${#missing[@]}" -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "These packages are missing: ${missing[*]}" >&2
    echo "Install them as root: apt-get install ${missing[*]}" >&2
    exit 69
  fi
  as_root=(sudo)
fi
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"

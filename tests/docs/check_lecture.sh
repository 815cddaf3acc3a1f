#!/usr/bin/env bash
# Fails if the scenes, scripts/make-gallery.sh and docs/lecture.md do not match the program or each other.
#
# usage: check_lecture.sh PART PENUMBRA SOURCE_FOLDER
set -euo pipefail
part=$1
penumbra=$2
cd "$3"
script=scripts/make-gallery.sh
page=docs/lecture.md
faults=0

fault() {
  echo "$1"
  faults=1
}

# The commands of the script: kind, name and the rest, with single blanks.
commands() { grep -E '^(picture|detail|plot) ' "$script" | tr -s ' '; }

# Every scene can be read. Folders `parts` hold fragments, which are read with the scenes that name them.
check_scenes() {
  local scenes scene
  mapfile -t scenes < <(find scenes -name '*.cli' -not -path '*/parts/*' | sort)
  [ "${#scenes[@]}" -gt 0 ] || fault "there are no scenes"
  for scene in "${scenes[@]}"; do
    "$penumbra" check "$scene" > /dev/null || fault "$scene: see above"
  done
}

# Every picture of the script has a name of its own, a scene that exists, and options that the program knows.
check_pictures() {
  local help commands_help kind name rest word
  help=$("$penumbra" render --help)
  commands_help=$("$penumbra" --help)
  [ "$(commands | wc -l)" -gt 0 ] || fault "$script makes no pictures"
  while read -r name; do
    fault "$script makes two pictures $name"
  done < <(commands | cut -d ' ' -f 2 | sort | uniq -d)
  while read -r kind name rest; do
    if [ "$kind" = plot ]; then
      grep -qE '^ +samples ' <<< "$commands_help" || fault "$script: $name: no command samples"
      continue
    fi
    [ -f "scenes/${rest%% *}" ] || fault "$script: $name: there is no scenes/${rest%% *}"
    for word in $rest; do
      [[ $word != --* ]] || grep -qE -- "^ +(-., ?)?${word}[ :,]" <<< "$help" || fault "$script: $name: no option $word"
    done
  done < <(commands)
}

# The page shows the pictures that the script makes, all of them, with the commands that make them.
check_page() {
  local name rest kind command crop
  crop=$(sed -n 's/^ *picture "$@" \(--crop [0-9,]*\)$/\1/p' "$script")
  while read -r name; do
    commands | cut -d ' ' -f 2 | grep -xF "$name" > /dev/null || fault "$page shows $name, which $script does not make"
  done < <(grep -oE 'images/lecture/[^)]*\.png' "$page" | sed 's|.*/||; s|\.png$||' | sort -u)
  while read -r kind name rest; do
    grep -qF "(images/lecture/$name.png)" "$page" || fault "$page does not show $name"
    case $kind in
      picture) command="penumbra render scenes/$rest -o $name.png" ;;
      detail) command="penumbra render scenes/$rest $crop -o $name.png" ;;
      plot) command="penumbra samples --sampler $rest -n 64 -o $name.png" ;;
    esac
    grep -qxF "$command" "$page" || fault "$page lacks the line: $command"
  done < <(commands)
}

# The functions that the page names are in the files that it names.
check_code() {
  local step files functions file function found rows=0
  while IFS='|' read -r _ step files functions _; do
    rows=$((rows + 1))
    for function in $(grep -oE '`[a-z_]+`' <<< "$functions" | tr -d '`'); do
      found=
      for file in $(grep -oE '`src/[^`]+`' <<< "$files" | tr -d '`'); do
        [ -f "$file" ] || fault "$page: there is no $file"
        grep -qw "$function" "$file" && found=yes
      done
      [ -n "$found" ] || fault "$page:$step: no $function in$files"
    done
  done < <(grep -E '^\|.*\| \[`src/' "$page")
  [ "$rows" -gt 0 ] || fault "$page does not say where the steps are in the code"
}

case $part in
  scenes) check_scenes ;;
  pictures) check_pictures ;;
  page) check_page ;;
  code) check_code ;;
  *) fault "no part $part" ;;
esac
exit "$faults"

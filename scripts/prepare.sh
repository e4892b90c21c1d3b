# Shared by scripts/demo, scripts/test and scripts/long; sourced, not run. Works from the root of the repository.

say() { printf '== %s\n' "$*"; }

# The release that scripts/packages is read for: 12 or 13 on Debian.
debian_release() { sed -n 's/^VERSION_ID="\?\([^"]*\)"\?$/\1/p' /etc/os-release; }

# list_packages HAVING STEP...: the lines of scripts/packages for these steps, package first and then what it is for;
# HAVING is `here` for those that this release uses, `elsewhere` for those that only another one does.
list_packages() {
  local having=$1 here step release package purpose
  here=$(debian_release)
  shift
  while read -r step release package purpose; do
    [[ " $* " == *" $step "* ]] || continue
    if [[ $release == any || $release == "$here" ]]; then
      [[ $having == elsewhere ]] || echo "$package $purpose"
    else
      [[ $having == here ]] || echo "$package $purpose"
    fi
  done < <(grep -v '^#' scripts/packages)
}

# missing_packages STEP...: those for these steps that are not installed, one a line.
missing_packages() {
  local package purpose
  while read -r package purpose; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done < <(list_packages here "$@")
}

# install_packages STEP...: installs what is missing. Asks nothing, and touches apt only when something is missing.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "no dpkg here: install what scripts/packages lists for: $*"
    return
  fi
  local -a missing as_root=()
  local package purpose
  while read -r package purpose; do
    say "without $package (Debian $(debian_release) leaves it out): $purpose"
  done < <(list_packages elsewhere "$@")
  mapfile -t missing < <(missing_packages "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "not root and no sudo; run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# configure PRESET [OPTION...]
configure() {
  local -a launcher=()
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  cmake --preset "$1" --log-level=WARNING "${launcher[@]}" "${@:2}" >/dev/null
}

# lint BUILD PATHSPEC...: clang-tidy over these sources, by the units that a configured build compiles them in.
lint() {
  local build=$1 unit_of unread
  local -a sources units
  shift
  mapfile -t sources < <(git ls-files "$@" | sed "s#^#$PWD/#" | sort)
  mapfile -t units < <(sed -nE 's#^ *"file": "(.*)".*#\1#p' "$build/compile_commands.json" | sort -u)
  # A unit is a source itself or a unity source, which includes some. What the build generates need not be there yet, so
  # grep may miss a file; a source that is in no unit is told below.
  unit_of=$({ printf '%s\n' "${units[@]}" | sed 's/.*/& &/'
              { grep -Hs '^#include "/' "${units[@]}" || true; } | sed -E 's/^(.*):#include "(.*)"$/\2 \1/'; } | sort -u -k 1,1)
  unread=$(comm -23 <(printf '%s\n' "${sources[@]}") <(cut -d ' ' -f 1 <<<"$unit_of"))
  [[ -z $unread ]] || { echo "not compiled by $build, so not linted: $unread" >&2; return 1; }
  mapfile -t units < <(join <(printf '%s\n' "${sources[@]}") - <<<"$unit_of" | cut -d ' ' -f 2 | sort -u)
  say "lint of ${#sources[@]} files in ${#units[@]} units"
  # The count of warnings in system headers, one line a file, is not worth printing.
  printf '%s\n' "${units[@]}" |
    xargs -P "$(nproc)" -n 1 clang-tidy-19 -p "$build" --quiet 2> >(grep -vE '^[0-9]+ warnings? generated' >&2 || true)
}

# Shared by scripts/demo and scripts/test; sourced, not run. Works from the root of the repository.

say() { printf '== %s\n' "$*"; }

# missing_packages STEP...: those of scripts/packages for these steps that are not installed, one a line.
missing_packages() {
  local step package rest
  while read -r step package rest; do
    [[ " $* " == *" $step "* ]] || continue
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done < <(grep -v '^#' scripts/packages)
}

# install_packages STEP...: installs what is missing. Asks nothing, and touches apt only when something is missing.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "no dpkg here: install what scripts/packages lists for: $*"
    return
  fi
  local -a missing as_root=()
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

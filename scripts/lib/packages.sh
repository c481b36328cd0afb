# Sourced by the scripts: installs what is missing, from Debian and from npm. Nothing asks the network when nothing is
# missing.

# The words of the package lists given, without those that are there by other means: any node from 18 on will do.
wanted_packages() {
  local have_node=no
  if command -v node >/dev/null && command -v npm >/dev/null &&
    (($(node -p 'parseInt(process.versions.node)') >= 18)); then
    have_node=yes
  fi
  awk -v have_node="$have_node" '
    /^#/ || NF == 0 { next }
    have_node == "yes" && ($1 == "nodejs" || $1 == "npm") { next }
    { print $1 }' "$@" | sort -u
}

missing_packages() {
  wanted_packages "$@" >"$logs/.wanted"
  # shellcheck disable=SC2046
  dpkg-query -W -f '${Package} ${db:Status-Status}\n' $(cat "$logs/.wanted") 2>/dev/null |
    awk '$2 == "installed" { print $1 }' | sort -u | comm -23 "$logs/.wanted" -
}

# What puts us in root's place: nothing when we are root, else sudo (which asks for the password once, here).
become_root=()
ask_for_root() {
  if ((EUID == 0)); then return 0; fi
  if ! command -v sudo >/dev/null; then
    printf '\nInstalling needs root and there is no sudo here. As root, run:\n  apt-get update && apt-get install --no-install-recommends %s\nand then this script again.\n' "$*"
    exit 1
  fi
  become_root=(sudo env)
  if [[ -t 0 ]]; then sudo -v; else become_root=(sudo -n env); fi
}

install_packages() {
  note "$# installed"
  local apt=(apt-get -o DPkg::Lock::Timeout=120 -o Dpkg::Use-Pty=0 -y)
  "${become_root[@]}" "${apt[@]}" update || echo "The package lists could not be fetched; trying with those that are here."
  "${become_root[@]}" env DEBIAN_FRONTEND=noninteractive "${apt[@]}" install --no-install-recommends "$@"
}

nothing_to_do() { note "$*"; }

# need_packages LIST...: installs what of these lists is missing, and says so before it does.
need_packages() {
  if ! command -v dpkg-query >/dev/null; then
    printf 'These scripts install with apt and know Debian 12. On another system install what\n%s\nname, build with `cmake --preset release && cmake --build --preset release`, and start build/release/bin/mirada serve.\n' "$*"
    exit 1
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} == 0)); then
    step packages '' nothing_to_do 'all there'
    return 0
  fi
  local how='apt-get'
  if ((EUID != 0)); then how='sudo apt-get (it may ask for your password)'; fi
  printf 'Missing here, installing with %s: %s\n' "$how" "${missing[*]}"
  ask_for_root "${missing[*]}"
  step packages 'The packages above could not be installed. Is this machine online? Is it Debian 12 (bookworm) with the component
main in its apt sources? Once `apt-get update` works by hand, run this script again: it goes on from here.' \
    install_packages "${missing[@]}"
}

# hash_of PATH...: one hash over the names and contents of all files under the paths.
hash_of() {
  find "$@" -type f -not -path '*/node_modules/*' -not -path '*/dist/*' -print0 | sort -z | xargs -0 sha256sum |
    sha256sum | cut -d' ' -f1
}

install_node_modules() {
  local stamp=ui/node_modules/.mirada-lock hash
  hash="$(hash_of ui/package-lock.json) node $(node -p process.versions.modules)"
  if [[ -f $stamp && $(cat "$stamp") == "$hash" ]]; then
    note 'all there'
    return 0
  fi
  npm ci --prefix ui --no-audit --no-fund --fetch-retries=3 --fetch-timeout=60000
  printf '%s\n' "$hash" >"$stamp"
  note "$(find ui/node_modules -maxdepth 1 -mindepth 1 | wc -l) folders"
}

need_node_modules() {
  step 'editor packages' 'npm could not fetch what ui/package-lock.json names. Is this machine online, and does `npm ping` work? Behind a company
proxy npm needs the setting `cafile`. Then run this script again: it goes on from here.' \
    install_node_modules
}

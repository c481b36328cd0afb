# Sourced by the scripts: builds the programs and the editor, each only when its sources changed.

# configure PRESET: makes or renews the build folder; ninja itself notices changed CMakeLists.txt files.
configure() {
  local folder=build/$1
  if [[ ! -f $folder/build.ninja || CMakePresets.json -nt $folder/build.ninja ]]; then cmake --preset "$1"; fi
}

build_preset() {
  local done_lines
  configure "$1"
  cmake --build --preset "$1" | tee "$logs/.ninja"
  done_lines=$(grep -c '^\[[0-9]*/[0-9]*\] Building' "$logs/.ninja") || true
  note "${done_lines:-0} sources compiled"
}

build_editor() {
  local stamp=ui/dist/.built-from hash
  hash=$(hash_of ui)
  if [[ -f $stamp && $(cat "$stamp") == "$hash" ]]; then
    note 'up to date'
    return 0
  fi
  npm run --prefix ui build
  printf '%s\n' "$hash" >"$stamp"
}

need_programs() {
  step 'programs' 'The programs did not build. The lines above say where; build/logs/programs.log has everything.' \
    build_preset release
}

need_editor() {
  step 'editor' 'The editor did not build. The lines above say where; build/logs/editor.log has everything.' build_editor
}

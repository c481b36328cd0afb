# Sourced by the scripts: one line a step, with how long it took; the step's output goes to build/logs.
set -euo pipefail
called_from=$PWD
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
logs=$root/build/logs
mkdir -p "$logs"
cd "$root"

seconds_since() { awk -v a="$1" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }'; }

# note TEXT...: what the running step has to say on its line.
note() { printf '%s' "$*" >"$logs/.note"; }

# On a terminal a long step shows how far ninja is ("[12/80]") until it ends.
show_progress() {
  local name=$1 log=$2
  while sleep 1; do
    printf '\r  %-24s %s' "$name" "$({ grep -o '^\[[0-9]*/[0-9]*\]' "$log" || true; } | tail -n 1)"
  done
}

# timed NAME LOG COMMAND...: runs the command with its output in LOG and prints the line. Gives the command's status.
# To be called under `set +e` and not in a condition: only so does `set -e` hold inside the command.
timed() {
  local name=$1 log=$2 started=$EPOCHREALTIME status word progress=''
  shift 2
  : >"$logs/.note"
  printf '  %-24s ' "$name"
  if [[ -t 1 ]]; then
    show_progress "$name" "$log" &
    progress=$!
  fi
  (set -e; "$@") >"$log" 2>&1 </dev/null
  status=$?
  if [[ -n $progress ]]; then
    kill "$progress"
    wait "$progress" 2>/dev/null
    printf '\r  %-24s ' "$name"
  fi
  word=ok
  if ((status != 0)); then word=FAILED; fi
  printf '%-6s %7s s  %s\n' "$word" "$(seconds_since "$started")" "$(cat "$logs/.note")"
  return $status
}

# show_log LOG [LINES]: the end of a failed step's output, and where the rest is.
show_log() {
  printf '\n--- the end of %s\n' "${1#"$root"/}"
  tail -n "${2:-40}" "$1"
  printf -- '---\n'
}

# step NAME ADVICE COMMAND...: a step that the following ones need: when it fails the script ends with the advice.
step() {
  local name=$1 advice=$2 log status
  log=$logs/${name// /-}.log
  shift 2
  set +e
  timed "$name" "$log" "$@"
  status=$?
  set -e
  if ((status == 0)); then return 0; fi
  show_log "$log"
  printf '\n%s\n' "$advice"
  exit 1
}

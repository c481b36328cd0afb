# Sourced by scripts/test: runs parts one after the other, counts what each part's own runner counted, ends with the sum.
passed=0 failed=0 skipped=0
failed_parts=()
wanted_parts=()

# wanted PART: whether the command line asked for this part (no words there: all parts).
wanted() {
  local part
  if ((${#wanted_parts[@]} == 0)); then return 0; fi
  for part in "${wanted_parts[@]}"; do
    if [[ $part == "$1" ]]; then return 0; fi
  done
  return 1
}

# count PASSED FAILED SKIPPED: what a part's runner counted; called inside the part's command.
count() { printf '%d %d %d\n' "$1" "$2" "$3" >"$logs/.count"; }

# add_up PART LOG STATUS: a part that counted nothing is one test; one that failed without a failed test has failed once.
add_up() {
  local p=0 f=0 s=0
  if [[ -s $logs/.count ]]; then read -r p f s <"$logs/.count"; fi
  if (($3 == 0 && p + f + s == 0)); then p=1; fi
  if (($3 != 0 && f == 0)); then f=1; fi
  passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
  if ((f > 0)); then
    failed_parts+=("$1: $f failed, ${2#"$root"/}")
    show_log "$2" 80
  fi
}

# part NAME COMMAND...: one part of the tests. A failure is counted and shown, and the next part runs all the same.
part() {
  local name=$1 log=$logs/test-${1// /-}.log status
  shift
  wanted "$name" || return 0
  : >"$logs/.count"
  set +e
  timed "$name" "$log" "$@"
  status=$?
  set -e
  add_up "$name" "$log" "$status"
}

# The last line is the sum over all runners.
summary() {
  local line
  printf '\n'
  for line in "${failed_parts[@]}"; do printf 'FAILED %s\n' "$line"; done
  printf 'All logs are in build/logs. It took %s s.\n' "$(seconds_since "$1")"
  printf '%d passed, %d failed' "$passed" "$failed"
  if ((skipped > 0)); then printf ', %d skipped' "$skipped"; fi
  printf '\n'
  if ((failed > 0 || passed == 0)); then exit 1; fi
}

# Counts by the runners' own words. Each gives the status of the runner itself.
run_node_tests() {
  local report=$logs/.node-report status
  set +e
  node --test --test-reporter=tap "$@" | tee "$report"
  status=${PIPESTATUS[0]}
  set -e
  tap_number() { awk -v word="$1" '$1 == "#" && $2 == word { n = $3 } END { print n + 0 }' "$report"; }
  count "$(tap_number pass)" "$(tap_number fail)" "$(tap_number skipped)"
  note "$(cut -d' ' -f1 "$logs/.count") passed"
  return "$status"
}

run_ctest() {
  local preset=$1 report=$root/build/$1/junit.xml status
  rm -f "$report"
  set +e
  "${calm_addresses[@]}" ctest --preset "$preset" -j "$(nproc)" --output-junit "$report"
  status=$?
  set -e
  junit_number() { grep -o -m 1 "[[:space:]]$1=\"[0-9]*\"" "$report" | grep -o '[0-9]*' || echo 0; }
  local all bad idle
  all=$(junit_number tests) bad=$(junit_number failures) idle=$(($(junit_number skipped) + $(junit_number disabled)))
  count "$((all - bad - idle))" "$bad" "$idle"
  note "$((all - bad - idle)) passed"
  return "$status"
}

run_vitest() {
  local report=$logs/vitest.json status
  rm -f "$report"
  set +e
  npm run --prefix ui test -- --reporter=default --reporter=json --outputFile.json="$report"
  status=$?
  set -e
  count "$(vitest_number numPassedTests)" "$(vitest_number numFailedTests)" "$(vitest_number numPendingTests)"
  note "$(vitest_number numPassedTests) passed"
  return "$status"
}
vitest_number() { node -p "JSON.parse(require('fs').readFileSync('$logs/vitest.json')).$1 ?? 0" 2>/dev/null || echo 0; }

# ThreadSanitizer of g++ 12 cannot live with wide address randomisation; where it may be switched off, it is.
calm_addresses=()
if setarch -R true 2>/dev/null; then calm_addresses=(setarch -R); fi

# Sourced by scripts/test: the fuzzers, each for a while from its kept corpus.

# fuzz_one TARGET: what it finds goes to build/fuzz/found, with a fixed seed, so that a failure comes again.
fuzz_one() {
  local corpus=build/fuzz/corpus/$1 found=build/fuzz/found
  mkdir -p "$corpus" "$found"
  build/fuzz/bin/"fuzz_$1" -seed=1 -max_total_time="${MIRADA_FUZZ_SECONDS:-60}" -max_len=16384 -timeout=25 \
    -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 -verbosity=1 -artifact_prefix="$found/$1-" \
    "$corpus" tests/fuzz/corpus/"$1" >"$logs/fuzz-$1.log" 2>&1
}

# All at once (MIRADA_FUZZERS names fewer); the log of one that has found something is shown.
run_fuzzers() {
  local target status=0 good=0 bad=0
  local -A running=()
  configure fuzz
  cmake --build --preset fuzz
  export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
  for target in ${MIRADA_FUZZERS:-program scratch machine}; do
    fuzz_one "$target" &
    running[$target]=$!
  done
  for target in "${!running[@]}"; do
    if wait "${running[$target]}"; then
      good=$((good + 1))
      grep -E 'number_of_executed_units|new_units_added' "$logs/fuzz-$target.log" | sed "s/^/$target: /" || true
    else
      bad=$((bad + 1)) status=1
      tail -n 60 "$logs/fuzz-$target.log"
    fi
  done
  count "$good" "$bad" 0
  return "$status"
}

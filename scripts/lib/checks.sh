# Sourced by scripts/test and scripts/check: the parts that are no test program of their own.

cpp_files() { find runtime blocks src tests \( -name '*.cpp' -o -name '*.h' \) -print0 | sort -z; }

check_format() { cpp_files | xargs -0 clang-format --dry-run -Werror; }

run_browser_tests() {
  cd ui
  run_node_tests --test-concurrency=1 ../tests/e2e/*[._-]test.mjs
}

# Each source with the compiler's own command line, two at a time; every finding is an error.
check_tidy() {
  find runtime blocks src -name '*.cpp' -print0 | sort -z |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build/release --extra-arg=-Wno-unknown-warning-option
}

# What needs no compiling; scripts/check runs only this.
quick_parts() {
  part 'format' check_format
  part 'architecture' run_node_tests tests/architecture/*.test.mjs
  part 'ui check' npm run --prefix ui check
}

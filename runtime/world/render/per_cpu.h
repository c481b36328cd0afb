#pragma once

/// Compiled twice, the second time for what newer CPUs can do at once; the better one is chosen when the
/// program starts. Both give the same bits: nothing is fused (-ffp-contract=off). Sanitizers cannot live with
/// the choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MIRADA_PER_CPU [[gnu::target_clones("avx2", "default")]]
/// Becomes part of the function that is compiled twice.
#define MIRADA_INSIDE [[gnu::always_inline]] inline
#else
#define MIRADA_PER_CPU
#define MIRADA_INSIDE inline
#endif

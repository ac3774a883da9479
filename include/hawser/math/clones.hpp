// Attribute for functions compiled for several generations of x86-64 processors, of which the loader selects
// the suitable one, for the few kernels that benefit. All callees are inlined, because vectors are passed
// differently with AVX, and because small matrices would go through memory.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__AVX2__) && \
    !defined(__SANITIZE_ADDRESS__)
#define HAWSER_CLONES __attribute__((flatten, target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#elif defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define HAWSER_CLONES __attribute__((flatten))
#else
#define HAWSER_CLONES
#endif

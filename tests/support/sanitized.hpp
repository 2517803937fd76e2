#pragma once
// Whether a sanitizer watches: those reserve terabytes of address space, so that it cannot be limited.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PROVIS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define PROVIS_SANITIZED 1
#endif
#endif
#ifndef PROVIS_SANITIZED
#define PROVIS_SANITIZED 0
#endif

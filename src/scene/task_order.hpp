#pragma once
// What ThreadSanitizer cannot see for itself: that tasks come after what spawned them and before what waits
// for them. Debian's libtbb is not built for it. In every other build this is nothing.

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define PROVIS_THREAD_SANITIZER
#endif
#endif
#if defined(__SANITIZE_THREAD__)
#define PROVIS_THREAD_SANITIZER
#endif
#if defined(PROVIS_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace provis {

/// What was released at an address happened before what acquires it afterwards.
#if defined(PROVIS_THREAD_SANITIZER)
inline void tsan_acquire(void* at) { __tsan_acquire(at); }
inline void tsan_release(void* at) { __tsan_release(at); }
#else
inline void tsan_acquire(void*) {}
inline void tsan_release(void*) {}
#endif

/// Lives where tasks are spawned and waited for; races between the tasks stay visible.
class TaskOrder {
 public:
  TaskOrder() { tsan_release(&spawned_); }
  ~TaskOrder() { tsan_acquire(&ended_); }
  TaskOrder(const TaskOrder&) = delete;
  TaskOrder& operator=(const TaskOrder&) = delete;

  /// Runs a task, and returns what it returns.
  template <class Work>
  decltype(auto) task(const Work& work) {
    tsan_acquire(&spawned_);
    const AtExit release{&ended_};
    return work();
  }

 private:
  struct AtExit {
    char* at;
    ~AtExit() { tsan_release(at); }
  };

  char spawned_ = 0, ended_ = 0;  ///< only their addresses matter
};

}  // namespace provis

// CPU time of this thread. Other processes on the machine do not affect it.
#pragma once

#include <ctime>

namespace hawser::test {

inline double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace hawser::test

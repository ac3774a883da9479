#include "hawser/geometry/large_vector.hpp"

#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace hawser::detail {
namespace {

constexpr std::align_val_t kLine{64};
#ifdef __linux__
constexpr std::size_t kPage = std::size_t{2} << 20;
std::size_t pages(std::size_t bytes) { return (bytes + kPage - 1) / kPage * kPage; }
#endif

}  // namespace

// Large pages are granted where nothing has been yet: not in what the heap has used before and gives again.
void* allocate_large(std::size_t bytes) {
#ifdef __linux__
  if (bytes >= kPage) {
    const std::size_t whole = pages(bytes);
    void* const got =
        mmap(nullptr, whole + kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (got == MAP_FAILED) throw std::bad_alloc();
    char* const from = static_cast<char*>(got);
    const std::size_t before = (kPage - reinterpret_cast<std::uintptr_t>(from) % kPage) % kPage;
    if (before > 0) munmap(from, before);
    munmap(from + before + whole, kPage - before);
    madvise(from + before, whole, MADV_HUGEPAGE);  // a wish; refused, it does no harm
    return from + before;
  }
#endif
  return ::operator new(bytes, kLine);
}

void free_large(void* at, std::size_t bytes) noexcept {
#ifdef __linux__
  if (bytes >= kPage) {
    munmap(at, pages(bytes));
    return;
  }
#endif
  ::operator delete(at, kLine);
}

}  // namespace hawser::detail

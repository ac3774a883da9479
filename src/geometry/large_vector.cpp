#include "hawser/geometry/large_vector.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace hawser::detail {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20, kLine = 64;

std::align_val_t alignment(std::size_t bytes) { return std::align_val_t{bytes < kPage ? kLine : kPage}; }

}  // namespace

void* allocate_large(std::size_t bytes) {
  if (bytes < kPage) return ::operator new(bytes, alignment(bytes));
  const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
  void* at = ::operator new(whole, alignment(bytes));
#ifdef __linux__
  madvise(at, whole, MADV_HUGEPAGE);  // a wish; refused, it does no harm
#endif
  return at;
}

void free_large(void* at, std::size_t bytes) noexcept { ::operator delete(at, alignment(bytes)); }

}  // namespace hawser::detail

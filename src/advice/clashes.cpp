// Messages about clashes.
#include "hawser/advice/clashes.hpp"

#include <fmt/format.h>

namespace hawser::advice {

std::string clashes(long long count, size_t open, size_t rows) {
  const bool all = static_cast<long long>(rows) == count;
  return fmt::format("clashes: {}, {} of them still in contact{}:\n", count, open,
                     all ? "" : fmt::format("; the {} with the largest forces", rows));
}

}  // namespace hawser::advice

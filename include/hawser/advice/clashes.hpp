// Messages about clashes.
#pragma once

#include <cstddef>
#include <string>

namespace hawser::advice {

// First line of the table of clashes: number of all, of those still in contact, and of the rows of the table.
std::string clashes(long long count, size_t open, size_t rows);

}  // namespace hawser::advice

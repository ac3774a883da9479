// What is more than a line bears, of rows of the summary.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/model/case.hpp"

namespace hawser::record {

// A sentence each: a utilisation of more than 1, compression under which it buckles, strain at which steel
// yields, and what is deep inside a volume. fields: those of nodes.
std::vector<std::string> row_warnings(const model::Case& c, const std::vector<Field>& fields,
                                      const io::SummaryRow& row);

}  // namespace hawser::record

// Packing of the rows of the summary and the warnings of a rank for rank 0, and the summary as text.
#include "hawser/record/summary_rows.hpp"

#include <fmt/format.h>

#include "hawser/base/mpi.hpp"
#include "hawser/base/packed_bytes.hpp"

namespace hawser::record {
namespace {

void write(const std::vector<io::SummaryRow>& rows, const std::vector<Warning>& warnings, BytesWriter& to) {
  to.count(rows.size());
  for (const io::SummaryRow& r : rows) {
    for (const std::string* text : {&r.quantity, &r.line, &r.unit}) to.text(*text);
    for (const double x : {r.value, r.time, r.arc_length}) to.real(x);
  }
  to.count(warnings.size());
  for (const Warning& w : warnings) {
    to.text(w.text);
    to.count(w.row + 1);  // kWholeRun: 0
  }
}

// Appends the rows and warnings of a rank.
void read(BytesReader& from, std::vector<io::SummaryRow>& rows, std::vector<Warning>& warnings) {
  const size_t before = rows.size();
  for (size_t count = from.count(); count > 0; --count) {
    io::SummaryRow& r = rows.emplace_back();
    for (std::string* text : {&r.quantity, &r.line, &r.unit}) *text = from.text();
    for (double* x : {&r.value, &r.time, &r.arc_length}) *x = from.real();
  }
  for (size_t count = from.count(); count > 0; --count) {
    Warning& w = warnings.emplace_back();
    w.text = from.text();
    if (const size_t row = from.count(); row > 0) w.row = before + row - 1;
  }
}

}  // namespace

void gather_on_first(MPI_Comm comm, std::vector<io::SummaryRow>& rows, std::vector<Warning>& warnings) {
  if (ranks_of(comm) == 1) return;
  BytesWriter local;
  write(rows, warnings, local);
  rows.clear();
  warnings.clear();
  std::vector<char> all;
  GatherPlan(comm, static_cast<int>(local.bytes.size())).gather_on_first(local.bytes.data(), all);
  const std::string bytes(all.begin(), all.end());
  for (BytesReader from(bytes); !from.at_end();) read(from, rows, warnings);
}

std::string summary_table(const std::vector<io::SummaryRow>& rows) {
  std::string text = fmt::format("{:<24} {:<16} {:>14} {:<6} {:>10} {:>12}\n", "quantity", "line", "value",
                                 "unit", "time [s]", "arc [m]");
  for (const auto& r : rows)
    text += fmt::format("{:<24} {:<16} {:>14.6g} {:<6} {:>10.3f} {:>12.3f}\n", r.quantity, r.line, r.value,
                        r.unit, r.time, r.arc_length);
  return text;
}

}  // namespace hawser::record

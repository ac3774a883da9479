// Messages about the expected cost of a run.
#include "hawser/advice/cost.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "hawser/base/count_of.hpp"

namespace hawser::advice {

std::string trial_fails(const std::string& why) { return "a trial run stops: " + why; }

std::string expected_cost(double cost, const Trial& trial) {
  if (!std::isfinite(cost)) return "expected cost: not known, the trial run was too short for an estimate";
  std::string basis;
  if (trial.by_statics)
    basis = ", by the first iterations of statics";
  else if (trial.reached < trial.duration)
    basis = fmt::format(", by its first {:.2g} of {:.4g} s", trial.reached, trial.duration);
  return fmt::format("expected cost: {} CPU s{}",
                     cost < 1 ? std::string("less than 1") : fmt::format("about {:.2g}", cost), basis);
}

std::string expected_results(const ResultBytes& size, const std::string& folder) {
  constexpr double kLarge = 2e9;  // bytes
  const auto bytes = [](double n) {
    const char* units[] = {"kB", "MB", "GB", "TB"};
    size_t k = 0;
    for (n /= 1e3; n >= 1e3 && k + 1 < std::size(units); ++k) n /= 1e3;
    return fmt::format("{:.3g} {}", n, units[k]);
  };
  std::string parts;
  for (const auto& [name, n] : size.parts)
    if (n > 0.005 * size.total) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", name, bytes(n));
  std::string s = fmt::format("expected results: about {} ({})", bytes(size.total), parts);
  if (size.contact_point > 0)
    s += fmt::format(", and {:g} bytes for each point of contact at an output", size.contact_point);
  // At the end of a run the file is rewritten without spare capacity.
  if (size.available >= 0 && 2 * size.total > size.available)
    s += fmt::format(
        "\nnote: the disk of {} has {} free, and a run needs up to twice the size of its results: increase "
        "output.every, or choose another disk with -o",
        folder, bytes(size.available));
  else if (size.total > kLarge)
    s += "\nnote: fields are most of the file in most runs; output.every sets the time between them";
  return s;
}

std::string partition(std::span<const int> nodes, double imbalance, int cut_lines, int cut_elements) {
  std::string text = "partition: " + count_of(std::ssize(nodes), "rank") + ", ";
  const auto [smallest, largest] = std::minmax_element(nodes.begin(), nodes.end());
  text += nodes.size() > 8 ? fmt::format("{} to {} nodes each", *smallest, *largest)
                           : fmt::format("{} nodes", fmt::join(nodes, " + "));
  if (nodes.size() > 1)
    text += fmt::format(", on one of them {:.2f} times the mean work; {}, {}", imbalance,
                        count_of(cut_lines, "cut line"), count_of(cut_elements, "cut element"));
  return text;
}

std::string expected_memory(double bytes, bool of_each_rank) {
  return fmt::format("expected memory: about {:.2g} GB{}", 1e-9 * bytes, of_each_rank ? " on each rank" : "");
}

}  // namespace hawser::advice

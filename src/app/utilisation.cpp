// The class Utilisation: what the types on either side of a node bear, and its share that is used.
#include "hawser/app/utilisation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::app {
namespace {

constexpr const char *kTension = "utilisation", *kBending = "bend_utilisation";

}  // namespace

Utilisation::Utilisation(const model::Case& c, const LocalMesh& local) {
  for (const model::LineType& t : c.line_types) {
    tension_ |= t.breaking_load > 0;
    bending_ |= t.minimum_bend_radius > 0 && t.kind == model::LineKind::beam;
  }
  const Mesh& mesh = *local.mesh;
  for (std::size_t n = 0; n < static_cast<std::size_t>(local.owned); ++n) {
    const Node& node = mesh.nodes[static_cast<std::size_t>(local.global[n])];
    auto& breaking = breaking_.emplace_back();
    double& radius = radius_.emplace_back();
    if (node.body >= 0) continue;
    const LineSpan& line = mesh.lines[static_cast<std::size_t>(node.line)];
    for (const std::size_t side : {0u, 1u}) {
      const int i = local.global[n] - line.first_node - 1 + static_cast<int>(side);
      if (i < 0 || i >= line.elements) continue;
      const Element& e = mesh.elements[static_cast<std::size_t>(line.first_element + i)];
      const model::LineType& t = c.line_types[static_cast<std::size_t>(e.type)];
      breaking[side] = t.breaking_load > 0 ? 1 / t.breaking_load : 0;
      if (e.beam) radius = std::max(radius, t.minimum_bend_radius);
    }
  }
}

void Utilisation::add_fields(std::vector<io::ResultField>& fields) {
  const auto find = [&](const char* name) {
    const auto at = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == name; });
    return at == fields.end() ? -1 : static_cast<int>(at - fields.begin());
  };
  before_ = find("effective_tension_before"), after_ = find("effective_tension_after");
  curvature_ = find("curvature");
  if (tension_ && before_ >= 0)
    of_tension_ = static_cast<int>(fields.size()), fields.push_back({kTension, "1", 1});
  if (bending_ && curvature_ >= 0)
    of_bending_ = static_cast<int>(fields.size()), fields.push_back({kBending, "1", 1});
}

void Utilisation::fill(std::vector<std::vector<double>>& values) const {
  const auto of = [&](int field) -> std::vector<double>& { return values[static_cast<std::size_t>(field)]; };
  for (std::size_t n = 0; n < breaking_.size(); ++n) {
    if (of_tension_ >= 0)
      of(of_tension_)[n] = std::max({of(before_)[n] * breaking_[n][0], of(after_)[n] * breaking_[n][1], 0.0});
    if (of_bending_ >= 0) of(of_bending_)[n] = of(curvature_)[n] * radius_[n];
  }
}

bool Utilisation::known(int field, std::size_t node) const {
  if (field < 0) return true;
  if (field == of_tension_) return breaking_[node][0] + breaking_[node][1] > 0;
  return field != of_bending_ || radius_[node] > 0;
}

std::string overused(const io::SummaryRow& row) {
  const bool bending = row.quantity == "max bend utilisation";
  if ((!bending && row.quantity != "max utilisation") || !(row.value > 1)) return {};
  return fmt::format("line {} is {} at arc length {:.6g} m, t = {:.6g} s: its {} utilisation is {:.3g}",
                     row.line,
                     bending ? "bent more sharply than its minimum bend radius allows"
                             : "pulled with more than its breaking load",
                     row.arc_length, row.time, bending ? "bend radius" : "breaking load", row.value);
}

}  // namespace hawser::app

// The class Utilisation: limits of the types on either side of a node, and their utilisation.
#include "hawser/record/utilisation.hpp"

#include <algorithm>

namespace hawser::record {
namespace {

const Field kTension = {.name = "utilisation",
                        .unit = "1",
                        .label = "breaking load utilisation",
                        .history = Field::History::after_end_columns,
                        .statistics = true,
                        .at_stations = true,
                        .extreme = "utilisation",
                        .report = Field::Report::graph,
                        .order = 2,
                        .meaning = "effective tension over minimum breaking load",
                        .exceeded = "loaded above its minimum breaking load"};
const Field kBending = {.name = "bend_utilisation",
                        .unit = "1",
                        .label = "bend radius utilisation",
                        .history = Field::History::after_end_columns,
                        .statistics = true,
                        .at_stations = true,
                        .extreme = "bend utilisation",
                        .report = Field::Report::graph,
                        .order = 3,
                        .meaning = "minimum bend radius over actual bend radius",
                        .exceeded = "bent below its minimum bend radius"};

}  // namespace

Utilisation::Utilisation(const model::Case& c, const LocalMesh& local) {
  for (const model::LineType& t : c.line_types) {
    tension_ |= t.breaking_load > 0;
    bending_ |= t.minimum_bend_radius > 0 && t.kind == model::LineKind::beam;
  }
  const Mesh& mesh = *local.mesh;
  if (!tension_ && !bending_) return;
  breaking_.reserve(local.owned);
  radius_.reserve(local.owned);
  for (std::size_t n = 0; n < static_cast<std::size_t>(local.owned); ++n) {
    const Node& node = mesh.node(local.global[n]);
    auto& breaking = breaking_.emplace_back();
    double& radius = radius_.emplace_back();
    if (node.body >= 0) continue;
    const LineSpan& line = mesh.lines[node.line];
    for (const std::size_t side : {0u, 1u}) {
      const int i = local.global[n] - line.first_node - 1 + static_cast<int>(side);
      if (i < 0 || i >= line.elements) continue;
      const Element& e = mesh.element(line.first_element + i);
      const model::LineType& t = c.line_types[e.type];
      breaking[side] = t.breaking_load > 0 ? 1 / t.breaking_load : 0;
      if (e.beam) radius = std::max(radius, t.minimum_bend_radius);
    }
  }
}

void Utilisation::add_fields(std::vector<Field>& fields) {
  const auto find = [&](const char* name) { return find_field(fields, name); };
  before_ = find("effective_tension_before");
  after_ = find("effective_tension_after");
  curvature_ = find("curvature");
  if (tension_ && before_ >= 0) {
    of_tension_ = static_cast<int>(fields.size());
    fields.push_back(kTension);
  }
  if (bending_ && curvature_ >= 0) {
    of_bending_ = static_cast<int>(fields.size());
    fields.push_back(kBending);
  }
}

void Utilisation::fill(const Snapshot&, Values& values) {
  const auto values_of = [&](int field) -> std::vector<double>& { return values[field]; };
  for (std::size_t n = 0; n < breaking_.size(); ++n) {
    if (of_tension_ >= 0)
      values_of(of_tension_)[n] =
          std::max({values_of(before_)[n] * breaking_[n][0], values_of(after_)[n] * breaking_[n][1], 0.0});
    if (of_bending_ >= 0) values_of(of_bending_)[n] = values_of(curvature_)[n] * radius_[n];
  }
}

bool Utilisation::known(int field, std::size_t node) const {
  if (field < 0) return true;
  if (field == of_tension_) return breaking_[node][0] + breaking_[node][1] > 0;
  return field != of_bending_ || radius_[node] > 0;
}

}  // namespace hawser::record

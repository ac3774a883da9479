// Conversion of the case and its mesh to contents of the results file.
#include "hawser/record/result_parts.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/model/longest_step.hpp"
#include "hawser/model/wave_components.hpp"
#include "hawser/record/output_times.hpp"

namespace hawser::record {

Runs<int> nodes_of_lines(const Mesh& mesh) {
  Runs<int> out;
  for (const LineSpan& span : mesh.lines) out.push_back(span.nodes);
  return out;
}

std::vector<io::ResultLineLabels> result_line_labels(const model::Case& c, const Mesh& mesh) {
  std::vector<io::ResultLineLabels> out;
  out.reserve(mesh.lines.size());
  for (size_t l = 0; l < mesh.lines.size(); ++l) {
    const LineSpan& span = mesh.lines[l];
    io::ResultLineLabels& line = out.emplace_back();
    line.name = c.lines[l].name;
    line.arc.reserve(static_cast<size_t>(span.nodes));
    for (int n = 0; n < span.nodes; ++n) line.arc.push_back(mesh.node(span.first_node + n).arc);
  }
  return out;
}

io::ResultWaves result_waves(const model::Case& c) {
  io::ResultWaves out;
  const WaveField waves = model::wave_field(c.environment);
  for (const WaveComponent& w : waves.components())
    out.components.push_back({w.amplitude, w.omega, w.number, w.x, w.y, w.phase});
  out.level = c.environment.water.surface;
  out.ramp = c.environment.water.waves.ramp;
  return out;
}

io::ExpectedRows expected_rows(const model::Case& c, double steps, double checkpoint) {
  io::ExpectedRows rows;
  const model::Dynamics& d = c.dynamics;
  if (!d.enabled) return rows;
  const double longest = d.max_step > 0 ? d.max_step : model::longest_step(c).length;
  const double step = d.step > 0 ? d.step : kAutomaticSteps * longest;
  rows.outputs = 1 + std::ceil(d.duration / OutputTimes(c).every * (1 - 1e-9));
  rows.steps = 1 + (steps > 0 ? steps : d.duration / step);
  if (c.output.history_every > 0) rows.steps = std::min(rows.steps, 2 + d.duration / c.output.history_every);
  rows.checkpoint = checkpoint;
  return rows;
}

}  // namespace hawser::record

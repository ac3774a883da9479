// The class BodiesBelowBed: the largest depth of the centres of mass of floating bodies below the bed.
#include "hawser/record/bodies_below_bed.hpp"

#include <algorithm>

#include "hawser/advice/limits.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/body_motion.hpp"

namespace hawser::record {

bool BodiesBelowBed::possible(const Subject& s) {
  return s.model.environment.seabed.present && s.mesh().body_nodes() > 0;
}

void BodiesBelowBed::output(const Snapshot& s) {
  const LocalMesh& mesh = subject_.local();
  for (int n = 0; n < mesh.owned; ++n) {
    const int body = mesh.mesh->node(mesh.global[n]).body;
    if (body < 0) continue;
    const model::Seabed& bed = subject_.model.environment.seabed;
    const model::Body& b = subject_.model.bodies[body];
    const double depth = -model::height_above_bed(bed, s.at.x[n]);
    // An anchor or a pile starts below it.
    if (depth <= 0 || model::height_above_bed(bed, model::pose_at_start(b).to_space(b.mass->centre)) < 0)
      continue;
    double& deepest = deepest_[body];
    deepest = std::max(deepest, depth);
  }
}

std::vector<Warning> BodiesBelowBed::warnings(const std::vector<io::SummaryRow>&) {
  struct Below {
    int body;
    double depth;
  };
  std::vector<Below> here;
  for (const auto& [body, depth] : deepest_) here.push_back({body, depth});
  std::vector<Below> all = gather_all(subject_.comm(), here);
  std::ranges::sort(all, {}, &Below::body);
  std::vector<Warning> out;
  if (rank_of(subject_.comm()) != 0) return out;
  for (const Below& b : all)
    out.push_back({advice::below_bed(subject_.model.bodies[b.body].name, b.depth), Warning::kWholeRun});
  return out;
}

}  // namespace hawser::record

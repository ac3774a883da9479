#include "hawser/app/run_parts.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "hawser/app/version.hpp"

namespace hawser::app {

io::RunInfo run_info(const model::Case& c, const std::string& petsc_options, int ranks) {
  io::RunInfo info;
  info.case_text = c.text, info.case_path = c.path;
  info.version = kVersion, info.options = petsc_options, info.ranks = ranks;
  info.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return info;
}

std::vector<io::ResultLine> result_lines(const model::Case& c, const Mesh& mesh) {
  std::vector<io::ResultLine> out;
  for (size_t l = 0; l < mesh.lines.size(); ++l) {
    io::ResultLine line{c.lines[l].name, mesh.lines[l].first_node, mesh.lines[l].nodes, {}};
    for (int n = 0; n < line.nodes; ++n)
      line.arc.push_back(mesh.nodes[static_cast<size_t>(line.first_node + n)].arc);
    out.push_back(std::move(line));
  }
  return out;
}

std::vector<io::BodyPose> body_poses(Simulation& sim, const Kinematics& at) {
  const int bodies = sim.bodies().size();
  std::vector<double> told;
  for (int b = 0; b < bodies; ++b) {
    if (!sim.bodies().floats(b)) continue;
    const auto p = sim.body_pose(b, at);
    const Quat q = p ? p->rotation : Quat(0, 0, 0, 0);
    const Vec3 x = p ? p->position : Vec3(Vec3::Zero());
    told.insert(told.end(), {x.x(), x.y(), x.z(), q.w(), q.x(), q.y(), q.z()});
  }
  if (!told.empty())
    MPI_Allreduce(MPI_IN_PLACE, told.data(), static_cast<int>(told.size()), MPI_DOUBLE, MPI_SUM,
                  sim.system().comm());
  std::vector<io::BodyPose> out;
  const double* t = told.data();
  for (int b = 0; b < bodies; ++b) {
    if (sim.bodies().floats(b)) {
      out.push_back({{t[0], t[1], t[2]}, {t[3], t[4], t[5], t[6]}});
      t += 7;
    } else {
      const RigidPose p = sim.bodies().pose(b, at.time);
      out.push_back({p.position, p.rotation});
    }
  }
  return out;
}

io::ReadingNews news(Progress& progress) {
  return {[&progress](const std::string& title) { progress.say(title); },
          [&progress](const std::string& what, double seconds) { progress.busy(what, seconds); }};
}

}  // namespace hawser::app

// Input of the partition from the case: nodes coupled by links, radiation or contact in the start shape, and
// lines with self-contact, which stay on one rank.
#include "hawser/run/node_owners.hpp"

#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/run/line_pairs.hpp"
#include "hawser/solve/start_shape.hpp"
#include "hawser/terms/line_candidates.hpp"

namespace hawser::run {

namespace {

// Uncut lines in file order, distributed by number of nodes; bodies belong to the first rank.
NodeRanks owners_of_uncut_lines(const Mesh& mesh, int ranks) {
  NodeRanks owner;
  const long long nodes = mesh.line_nodes();
  for (const LineSpan& line : mesh.lines)
    owner.append(line.nodes, static_cast<int>(line.first_node * static_cast<long long>(ranks) / nodes));
  owner.append(mesh.body_nodes(), 0);
  return owner;
}

// Sorted pairs of elements of two lines that may touch in the start shape. Collective.
std::vector<std::pair<int, int>> near_elements(MPI_Comm comm, const model::Case& c, const Mesh& mesh,
                                               const Bodies& bodies) {
  std::vector<double> radius;
  for (const model::LineType& t : c.line_types) radius.push_back(0.5 * t.contact_diameter);
  std::vector<bool> takes_part;
  for (const model::Line& l : c.lines) takes_part.push_back(c.contact.takes_part(l));
  const int ranks = ranks_of(comm);
  const LocalMesh part = local_mesh(mesh, owners_of_uncut_lines(mesh, ranks), rank_of(comm), ranks);
  const StartShape shape = start_shape(comm, c, part, bodies);
  CandidateSettings settings;
  settings.excluded = excluded_pairs(c);
  LineCandidates candidates(comm, part, ContactRadii(std::move(radius), std::move(takes_part)),
                            std::move(settings));
  candidates.update(shape.state.at_rest(), 0);
  std::vector<std::pair<int, int>> local;
  for (const auto& [a, b] : candidates.elements())
    if (mesh.element(a).line != mesh.element(b).line) local.emplace_back(a, b);
  std::vector<std::pair<int, int>> out = gather_all(comm, local);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());  // pairs found by two ranks
  return out;
}

}  // namespace

std::vector<std::pair<int, int>> coupled_nodes(MPI_Comm comm, const model::Case& c, const Mesh& mesh,
                                               const Bodies& bodies) {
  std::vector<std::pair<int, int>> out;
  for (const std::vector<int>& group : model::radiating_groups(c))
    for (size_t i = 1; i < group.size(); ++i)
      out.emplace_back(mesh.body_node(group[i - 1]), mesh.body_node(group[i]));
  const auto node_of = [&](const model::LinkEnd& e) {
    if (!e.line.empty()) return mesh.nearest_node(c.line_index(e.line), e.arc);
    return e.body.empty() ? -1 : mesh.frame_node(c.body_index(e.body));
  };
  for (const model::Link& l : c.links)
    if (const int a = node_of(l.end_a), b = node_of(l.end_b); a >= 0 && b >= 0) out.emplace_back(a, b);
  if (!c.contact.between_lines.enabled) return out;
  for (const auto& [a, b] : near_elements(comm, c, mesh, bodies))
    for (const int m : {mesh.element(a).first, mesh.element(a).second})
      for (const int n : {mesh.element(b).first, mesh.element(b).second}) out.emplace_back(m, n);
  return out;
}

std::vector<int> uncut_lines(const model::Case& c) {
  if (!c.contact.between_lines.enabled) return {};
  const std::vector<std::pair<int, int>> excluded = excluded_pairs(c);
  std::vector<int> uncut;
  for (int l = 0; l < static_cast<int>(c.lines.size()); ++l)
    if (c.contact.takes_part(c.lines[l]) &&
        !std::binary_search(excluded.begin(), excluded.end(), std::pair(l, l)))
      uncut.push_back(l);
  return uncut;
}

NodeRanks node_owners(MPI_Comm comm, const model::Case& c, const Mesh& mesh, const Bodies& bodies,
                      int ranks) {
  if (ranks == 1) return NodeRanks::all_of(mesh.nodes());
  return partition(mesh, ranks, coupled_nodes(comm, c, mesh, bodies), uncut_lines(c));
}

}  // namespace hawser::run

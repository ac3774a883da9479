// The class System: assembly of residual and tangent from all force terms, convergence norms, and calls
// forwarded to the terms.
#include "hawser/system/system.hpp"

#include <petscvec.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "hawser/base/mpi.hpp"
#include "hawser/base/rank_independent.hpp"
#include "hawser/math/so3.hpp"
#include "logged.hpp"

namespace hawser {

System::System(MPI_Comm comm, LocalMesh mesh) : comm_(comm), mesh_(std::move(mesh)) {
  if (mesh_.element_ghosts_end == 0) {
    mesh_.element_ghosts_end = mesh_.nodes();
    mesh_.element_ghost_blocks_end = mesh_.blocks();
  }
  exchange_ = GhostExchange(comm_, mesh_);
  cut_ = line_owners(mesh_).cut;
  for (int n = 0; n < mesh_.owned; ++n)
    if (const int line = mesh_.node(n).line; local_lines_.empty() || local_lines_.back() != line)
      local_lines_.push_back(line);
  std::set_union(cut_.begin(), cut_.end(), local_lines_.begin(), local_lines_.end(),
                 std::back_inserter(lines_));
  size_arrays();
  tied_nodes_ = TiedNodes(mesh_, {}, {});
  longest_element_ = std::max(longest_element_, mesh_.mesh->longest_element());
  // The moment on a floating body is compared with a force times at least one metre.
  if (mesh_.mesh->line_nodes() < mesh_.mesh->nodes()) longest_element_ = std::max(longest_element_, 1.0);
}

// Sizes the arrays that are indexed by local block.
void System::size_arrays() {
  const size_t blocks = mesh_.blocks();
  turn_of_.assign(blocks, -1);
  int turns = 0;
  square_of_block_.resize(blocks);
  for (int n = 0; n < mesh_.nodes(); ++n) {
    const size_t b = mesh_.block[n];
    const bool rotates = mesh_.rotates(n);
    if (rotates) turn_of_[b + 1] = turns++;
    const auto line = std::lower_bound(lines_.begin(), lines_.end(), mesh_.node(n).line);
    if (line == lines_.end() || *line != mesh_.node(n).line) continue;  // all of it is on other ranks
    const auto place = static_cast<int>(line - lines_.begin());
    square_of_block_[b] = 2 * place;
    if (rotates) square_of_block_[b + 1] = 2 * place + 1;
  }
  force_.resize(3 * blocks, 0);
  if (mesh_.mesh->any_cable()) mean_.resize(3 * blocks, 0);
  squares_.resize(blocks, 0);
  retraction_.resize(turns);
}

void System::add(std::unique_ptr<ForceTerm> term) {
  static const PetscClassId id = [] {
    PetscClassId c = 0;
    check(PetscClassIdRegister("hawser terms", &c));
    return c;
  }();
  const std::string key(term->checkpoint_key());
  Events& e = events_.emplace_back();
  check(PetscLogEventRegister(("f " + key).c_str(), id, &e.force));
  check(PetscLogEventRegister(("J " + key).c_str(), id, &e.tangent));
  check(PetscLogEventRegister(("prepare " + key).c_str(), id, &e.prepare));
  if (limit_event_ < 0) check(PetscLogEventRegister("limit steps", id, &limit_event_));
  terms_.push_back(std::move(term));
  list_roles();
}

void System::list_roles() {
  const auto refill = [this]<class Role>(std::vector<Role*>& list) { list = with<Role>(); };
  std::apply([&](auto&... lists) { (refill(lists), ...); }, roles_);
  const auto& fed = listed<FedLines>();
  for (ActsOnFedLines* t : with<ActsOnFedLines>()) t->feeders_ = fed.empty() ? nullptr : fed.front();
}

void System::remove(const ForceTerm* term) {
  const auto is_it = [term](const auto& t) { return t.get() == term; };
  const auto found = std::find_if(terms_.begin(), terms_.end(), is_it);
  if (found == terms_.end()) return;
  events_.erase(events_.begin() + (found - terms_.begin()));
  terms_.erase(found);
  list_roles();
}

void System::tie(std::vector<TiedNode> nodes, BodyMotion motion) {
  tied_nodes_ = TiedNodes(mesh_, std::move(nodes), std::move(motion));
  ties_ = TiedNodeForces(mesh_, tied_nodes_);
}

bool System::gather_with_ghosts(Vec u, std::vector<double>& out) const {
  out.resize(3 * static_cast<size_t>(mesh_.blocks()));
  const int size = ranks_of(comm_);
  if (size > 1) {
    check(VecGhostUpdateBegin(u, INSERT_VALUES, SCATTER_FORWARD));
    check(VecGhostUpdateEnd(u, INSERT_VALUES, SCATTER_FORWARD));
  }
  Vec local = nullptr;
  check(VecGhostGetLocalForm(u, &local));
  PetscInt length = 0;
  check(VecGetSize(local, &length));
  if (static_cast<size_t>(length) != out.size()) throw PetscFailure("a vector of other ghosts");
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(local, &p));
  const bool others = !std::equal(out.begin(), out.end(), p);
  if (others) std::copy(p, p + out.size(), out.begin());
  check(VecRestoreArrayRead(local, &p));
  check(VecGhostRestoreLocalForm(u, &local));
  return others;
}

void System::residual(const Kinematics& trial, Vec r, std::span<const double> mean_history) {
  std::fill(force_.begin(), force_.end(), 0.0);
  const size_t owned = 3 * static_cast<size_t>(mesh_.owned_blocks);
  if (!mean_history.empty()) std::copy_n(mean_history.begin(), owned, force_.begin());
  std::fill(mean_.begin(), mean_.end(), 0.0);
  std::fill(squares_.begin(), squares_.end(), 0.0);
  Assembler assembler = Assembler::for_residual(mesh_, ties_, trial.mean.weight, {force_, mean_, squares_});
  update_fed_lines(trial);
  for (size_t i = 0; i < terms_.size(); ++i) {
    const Logged logged(events_[i].force);
    terms_[i]->evaluate(trial, assembler);
  }
  PetscScalar* p = nullptr;
  if (sends()) {  // before forces on tied nodes are added to their frames
    Vec local = nullptr;
    check(VecGhostGetLocalForm(r, &local));
    check(VecGetArray(local, &p));
    std::copy(force_.begin(), force_.end(), p);
    check(VecRestoreArray(local, &p));
    check(VecGhostRestoreLocalForm(r, &local));
    check(VecGhostUpdateBegin(r, ADD_VALUES, SCATTER_REVERSE));
    check(VecGhostUpdateEnd(r, ADD_VALUES, SCATTER_REVERSE));
    check(VecGetArray(r, &p));
    std::copy_n(p, owned, force_.begin());
    check(VecRestoreArray(r, &p));
  }
  ties_.move(trial);
  ties_.add_forces(force_, squares_);
  check(VecGetArray(r, &p));
  std::copy_n(force_.begin(), owned, p);
  const auto& held = tied_nodes_.held();
  for (size_t b = 0; b < owned / 3; ++b)
    if (held[b])
      for (size_t c = 0; c < 3; ++c)
        if (held[b] >> c & 1) p[3 * b + c] = 0;
  check(VecRestoreArray(r, &p));
}

void System::tangent(const Kinematics& trial, Weights weights, const std::vector<double>& u, bool convex,
                     Mat J) {
  for (size_t b = 0; b < turn_of_.size(); ++b)
    if (turn_of_[b] >= 0) retraction_[turn_of_[b]] = right_jacobian(Eigen::Map<const Vec3>(u.data() + 3 * b));
  check(MatZeroEntries(J));
  const LocalBlocks blocks(J);
  ties_.move(trial);
  Assembler assembler = Assembler::for_tangent(mesh_, ties_, trial.mean.weight, weights, convex,
                                               {J, blocks, retraction_, turn_of_, tied_nodes_.held()});
  update_fed_lines(trial);
  for (size_t i = 0; i < terms_.size(); ++i) {
    const Logged logged(events_[i].tangent);
    terms_[i]->evaluate(trial, assembler);
  }
  ties_.add_geometric_stiffness(force_, convex, assembler);
  const auto& held = tied_nodes_.held();
  const bool shifted = weights.shift_position != 0 || weights.shift_rotation != 0;
  for (int b = 0; b < mesh_.owned_blocks; ++b) {
    if (!held[b] && !shifted) continue;
    const double shift = turn_of_[b] >= 0 ? weights.shift_rotation : weights.shift_position;
    double* diagonal = blocks.at(b, b);
    for (int c = 0; c < 3; ++c) diagonal[4 * c] += held[b] >> c & 1 ? 1 : shift;
  }
  check(MatAssemblyBegin(J, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(J, MAT_FINAL_ASSEMBLY));
}

ResidualNorms System::norms(Vec r) const {
  // By place in lines_: sums of squares of residual forces and moments, then of their contributions.
  std::vector<double> s(4 * lines_.size(), 0);
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(r, &p));
  for (int b = 0; b < mesh_.owned_blocks; ++b) {
    double* sum = s.data() + 4 * (square_of_block_[b] / 2) + square_of_block_[b] % 2;
    sum[0] += p[3 * b] * p[3 * b] + p[3 * b + 1] * p[3 * b + 1] + p[3 * b + 2] * p[3 * b + 2];
    sum[2] += squares_[b];
  }
  check(VecRestoreArrayRead(r, &p));
  const auto sums_of = [&](int line) {
    const auto place = std::lower_bound(lines_.begin(), lines_.end(), line) - lines_.begin();
    return std::span(s).subspan(4 * static_cast<size_t>(place), 4);
  };
  std::vector<double> of_cut;
  for (const int l : cut_) of_cut.insert(of_cut.end(), sums_of(l).begin(), sums_of(l).end());
  if (!cut_.empty()) sum(of_cut);
  for (size_t i = 0; i < cut_.size(); ++i) std::copy_n(&of_cut[4 * i], 4, sums_of(cut_[i]).begin());
  std::vector<ResidualNorms> worst(1);
  double largest = -1;
  int line = 0;  // index of the worst line
  for (const int l : local_lines_) {
    const std::span<const double> sum = sums_of(l);
    const ResidualNorms n{rank_independent(std::sqrt(sum[0])),
                          rank_independent(std::sqrt(sum[1])),
                          rank_independent(std::sqrt(sum[2])),
                          rank_independent(std::sqrt(sum[3])),
                          round_off_,
                          longest_element_,
                          l < std::ssize(mesh_.mesh->lines) ? mesh_.mesh->lines[l].length : 1};
    const double size = n.relative();
    if (size > largest || !std::isfinite(size)) {
      worst[0] = n;
      largest = std::isfinite(size) ? size : HUGE_VAL;
      line = l;
    }
  }
  largest_of_ranks(
      comm_, worst, [largest](const ResidualNorms&) { return largest; }, line);
  return worst[0];
}

namespace {
// If only moments act, there are hardly any forces, and vice versa. Each scale is therefore at least the
// other one, converted by the length of the line and by a millimetre.
double force_size(const ResidualNorms& n) { return std::max(n.force_scale, n.moment_scale / n.span); }
double moment_size(const ResidualNorms& n) { return std::max(n.moment_scale, 1e-3 * n.force_scale); }
}  // namespace

bool ResidualNorms::finite() const {
  return std::isfinite(force) && std::isfinite(moment) && std::isfinite(force_scale) &&
         std::isfinite(moment_scale) && std::isfinite(round_off);
}

bool ResidualNorms::small(double tolerance) const {
  return finite() && force <= tolerance * force_size(*this) + 4 * round_off &&
         moment <= tolerance * moment_size(*this) + 4 * round_off * arm;
}

double ResidualNorms::relative() const {
  const auto ratio = [](double r, double noise, double size) {
    const double above = std::max(r - noise, 0.0);
    return above > 0 || !std::isfinite(r) ? above / std::max(size, 1e-300) : 0.0;
  };
  return std::max(ratio(force, 4 * round_off, force_size(*this)),
                  ratio(moment, 4 * round_off * arm, moment_size(*this)));
}

bool System::limit_axial_stiffness(double max_stiffness) {
  bool changed = false;
  for (HasAxialStiffness* t : listed<HasAxialStiffness>()) changed |= t->limit_axial_stiffness(max_stiffness);
  return on_any_rank(comm_, changed);
}

void System::restore_sections() {
  for (HasAxialStiffness* t : listed<HasAxialStiffness>()) t->restore_sections();
}

double System::axial_stiffness() const {
  double largest = 0;
  for (const HasAxialStiffness* t : listed<HasAxialStiffness>())
    largest = std::max(largest, t->axial_stiffness());
  return all_reduce(comm_, MPI_MAX, largest);
}

double System::dead_load() const {
  double sum = 0;
  for (const ScalesResiduals* t : listed<ScalesResiduals>()) sum += t->dead_load();
  all_reduce(comm_, MPI_SUM, sum);
  return rank_independent(sum);
}

bool System::adapt_stiffness(const Kinematics& equilibrium) {
  bool again = false;
  for (AdaptsStiffness* t : listed<AdaptsStiffness>()) again = t->adapt_stiffness(equilibrium) || again;
  return again;
}

bool System::raise_stiffness_where_blocked(const Kinematics& trial) {
  bool again = false;
  for (AdaptsStiffness* t : listed<AdaptsStiffness>())
    again = t->raise_stiffness_where_blocked(trial) || again;
  return again;
}

void System::revert_stiffness() {
  for (AdaptsStiffness* t : listed<AdaptsStiffness>()) t->revert_stiffness();
}

void System::prepare(const Kinematics& from, double h) {
  update_fed_lines(from);
  for (size_t i = 0; i < terms_.size(); ++i) {
    const Logged logged(events_[i].prepare);
    terms_[i]->prepare(from, h);
  }
  update_round_off(from, h);
}

void System::update_round_off(const Kinematics& from, double h) {
  double square = 0;
  for (const ScalesResiduals* t : listed<ScalesResiduals>()) square += t->round_off(from, h);
  all_reduce(comm_, MPI_SUM, square);
  round_off_ = rank_independent(std::sqrt(square));
}

void System::commit(const Kinematics& accepted) {
  update_fed_lines(accepted);
  for (auto& t : terms_) t->commit(accepted);
  update_fed_lines(accepted);
}

Energy System::energy(const Kinematics& state) const {
  Energy e;
  for (const auto& t : terms_) e += t->energy(state);
  return e;
}

FieldRegistry System::fields() const {
  FieldRegistry r;
  for (const auto& t : terms_) t->fields(r);
  return r;
}

}  // namespace hawser

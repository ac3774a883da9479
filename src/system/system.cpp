#include "hawser/system/system.hpp"

#include <petscvec.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "hawser/math/so3.hpp"

namespace hawser {

System::System(MPI_Comm comm, LocalMesh mesh) : comm_(comm), mesh_(std::move(mesh)) {
  is_rotation_.assign(static_cast<size_t>(mesh_.blocks()), 0);
  for (int n = 0; n < mesh_.nodes(); ++n)
    if (mesh_.rotates(n)) is_rotation_[static_cast<size_t>(mesh_.block[static_cast<size_t>(n)]) + 1] = 1;
  force_.assign(3 * static_cast<size_t>(mesh_.blocks()), 0);
  retraction_.assign(static_cast<size_t>(mesh_.blocks()), Mat3::Identity());
  supports_ = Supports(mesh_, {}, {});
  for (const Element& e : mesh_.mesh->elements) longest_element_ = std::max(longest_element_, e.length);
}

void System::add(std::unique_ptr<ForceTerm> term) {
  static const PetscClassId id = [] {
    PetscClassId c = 0;
    check(PetscClassIdRegister("hawser terms", &c));
    return c;
  }();
  const std::string name(term->name());
  PetscLogEvent event = 0;
  check(PetscLogEventRegister(("f " + name).c_str(), id, &event));
  residual_event_.push_back(event);
  check(PetscLogEventRegister(("J " + name).c_str(), id, &event));
  tangent_event_.push_back(event);
  terms_.push_back(std::move(term));
}

void System::support(std::vector<Support> supports, BodyMotion motion) {
  supports_ = Supports(mesh_, std::move(supports), std::move(motion));
}

VecHandle System::create_vector() const {
  std::vector<PetscInt> ghosts(mesh_.global_block.begin() + mesh_.owned_blocks, mesh_.global_block.end());
  VecHandle v;
  check(VecCreateGhostBlock(comm_, 3, 3 * mesh_.owned_blocks, PETSC_DETERMINE,
                            static_cast<PetscInt>(ghosts.size()), ghosts.data(), v.out()));
  return v;
}

MatHandle System::create_matrix() const {
  // Block columns of every owned row: the node itself and its chain neighbours.
  std::vector<std::set<int>> near(static_cast<size_t>(mesh_.owned_blocks));
  auto couple = [&](int a, int b) {
    for (int i = 0; i <= mesh_.rotates(a); ++i)
      for (int j = 0; j <= mesh_.rotates(b); ++j) {
        const int row = mesh_.block[static_cast<size_t>(a)] + i;
        if (row < mesh_.owned_blocks)
          near[static_cast<size_t>(row)].insert(mesh_.block[static_cast<size_t>(b)] + j);
      }
  };
  for (int n = 0; n < mesh_.owned; ++n) couple(n, n);
  for (const LocalElement& e : mesh_.elements) couple(e.first, e.second), couple(e.second, e.first);
  std::vector<PetscInt> own(near.size()), other(near.size());
  for (size_t r = 0; r < near.size(); ++r)
    for (int c : near[r]) ++(c < mesh_.owned_blocks ? own : other)[r];

  MatHandle A;
  check(MatCreate(comm_, A.out()));
  const PetscInt n = 3 * mesh_.owned_blocks;
  check(MatSetSizes(A.get(), n, n, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(A.get(), MATBAIJ));
  check(MatSetBlockSize(A.get(), 3));
  check(MatXAIJSetPreallocation(A.get(), 3, own.data(), other.data(), nullptr, nullptr));
  check(MatSetOption(A.get(), MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
  return A;
}

void System::gather(Vec u, std::vector<double>& out) const {
  out.resize(3 * static_cast<size_t>(mesh_.blocks()));
  int size = 1;
  MPI_Comm_size(comm_, &size);
  if (size > 1) {
    check(VecGhostUpdateBegin(u, INSERT_VALUES, SCATTER_FORWARD));
    check(VecGhostUpdateEnd(u, INSERT_VALUES, SCATTER_FORWARD));
  }
  Vec local = nullptr;
  check(VecGhostGetLocalForm(u, &local));
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(local, &p));
  std::copy(p, p + out.size(), out.begin());
  check(VecRestoreArrayRead(local, &p));
  check(VecGhostRestoreLocalForm(u, &local));
}

void System::residual(const Kinematics& trial, Vec r) {
  std::fill(force_.begin(), force_.end(), 0.0);
  Sink sink;
  sink.force_ = &force_;
  sink.owned_blocks_ = mesh_.owned_blocks;
  sink.is_rotation_ = &is_rotation_;
  for (size_t i = 0; i < terms_.size(); ++i) {
    check(PetscLogEventBegin(residual_event_[i], nullptr, nullptr, nullptr, nullptr));
    terms_[i]->evaluate(trial, sink);
    check(PetscLogEventEnd(residual_event_[i], nullptr, nullptr, nullptr, nullptr));
  }
  force_square_ = sink.force_square_, moment_square_ = sink.moment_square_;
  PetscScalar* p = nullptr;
  check(VecGetArray(r, &p));
  const size_t n = 3 * static_cast<size_t>(mesh_.owned_blocks);
  std::copy(force_.begin(), force_.begin() + static_cast<std::ptrdiff_t>(n), p);
  const auto& held = supports_.held();
  for (size_t b = 0; b < n / 3; ++b)
    if (held[b])
      for (size_t c = 0; c < 3; ++c)
        if (held[b] >> c & 1) p[3 * b + c] = 0;
  check(VecRestoreArray(r, &p));
}

void System::tangent(const Kinematics& trial, Weights weights, const std::vector<double>& u, bool convex,
                     Mat J) {
  for (size_t b = 0; b < is_rotation_.size(); ++b)
    if (is_rotation_[b]) retraction_[b] = right_jacobian(Eigen::Map<const Vec3>(u.data() + 3 * b));
  check(MatZeroEntries(J));
  Sink sink;
  sink.matrix_ = J;
  sink.weights_ = weights;
  sink.convex_ = convex;
  sink.owned_blocks_ = mesh_.owned_blocks;
  sink.global_block_ = &mesh_.global_block;
  sink.retraction_ = &retraction_;
  sink.is_rotation_ = &is_rotation_;
  sink.held_ = &supports_.held();
  for (size_t i = 0; i < terms_.size(); ++i) {
    check(PetscLogEventBegin(tangent_event_[i], nullptr, nullptr, nullptr, nullptr));
    terms_[i]->evaluate(trial, sink);
    check(PetscLogEventEnd(tangent_event_[i], nullptr, nullptr, nullptr, nullptr));
  }
  const auto& held = supports_.held();
  const bool shifted = weights.shift_position != 0 || weights.shift_rotation != 0;
  for (int b = 0; b < mesh_.owned_blocks; ++b) {
    const size_t i = static_cast<size_t>(b);
    if (!held[i] && !shifted) continue;
    const double shift = is_rotation_[i] ? weights.shift_rotation : weights.shift_position;
    double diagonal[9] = {};
    for (int c = 0; c < 3; ++c) diagonal[4 * c] = held[i] >> c & 1 ? 1 : shift;
    const PetscInt row = mesh_.global_block[i];
    check(MatSetValuesBlocked(J, 1, &row, 1, &row, diagonal, ADD_VALUES));
  }
  check(MatAssemblyBegin(J, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(J, MAT_FINAL_ASSEMBLY));
}

ResidualNorms System::norms(Vec r) const {
  double s[4] = {0, 0, force_square_, moment_square_};
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(r, &p));
  for (int b = 0; b < mesh_.owned_blocks; ++b)
    for (int c = 0; c < 3; ++c)
      s[is_rotation_[static_cast<size_t>(b)] ? 1 : 0] += p[3 * b + c] * p[3 * b + c];
  check(VecRestoreArrayRead(r, &p));
  MPI_Allreduce(MPI_IN_PLACE, s, 4, MPI_DOUBLE, MPI_SUM, comm_);
  return {std::sqrt(s[0]), std::sqrt(s[1]), std::sqrt(s[2]), std::sqrt(s[3]), round_off_, longest_element_};
}

bool ResidualNorms::small(double tolerance) const {
  return force <= tolerance * force_scale + 4 * round_off &&
         moment <= tolerance * std::max(moment_scale, 1e-3 * force_scale) + 4 * round_off * arm;
}

double ResidualNorms::relative() const {
  constexpr double tiny = 1e-300;
  return std::max(force / std::max(force_scale, tiny),
                  moment / std::max({moment_scale, 1e-3 * force_scale, tiny}));
}

void System::soften(double factor) {
  for (auto& t : terms_) t->soften(factor);
}

double System::axial_stiffness() const {
  double most = 0;
  for (const auto& t : terms_) most = std::max(most, t->axial_stiffness());
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return most;
}

double System::dead_load() const {
  double sum = 0;
  for (const auto& t : terms_) sum += t->dead_load();
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return sum;
}

double System::longest_step(const Kinematics& committed) const {
  double h = std::numeric_limits<double>::infinity();
  for (const auto& t : terms_) h = std::min(h, t->longest_step(committed));
  MPI_Allreduce(MPI_IN_PLACE, &h, 1, MPI_DOUBLE, MPI_MIN, comm_);
  return h;
}

void System::prepare(const Kinematics& committed, double h) {
  for (auto& t : terms_) t->prepare(committed, h);
}

void System::expect(const Kinematics& committed, double h) {
  double square = 0;
  for (const auto& t : terms_) square += t->round_off(committed, h);
  MPI_Allreduce(MPI_IN_PLACE, &square, 1, MPI_DOUBLE, MPI_SUM, comm_);
  round_off_ = std::sqrt(square);
}

void System::commit(const Kinematics& accepted) {
  for (auto& t : terms_) t->commit(accepted);
}

Energy System::energy(const Kinematics& at) const {
  Energy e;
  for (const auto& t : terms_) e += t->energy(at);
  return e;
}

FieldRegistry System::fields() const {
  FieldRegistry r;
  for (const auto& t : terms_) t->fields(r);
  return r;
}

}  // namespace hawser

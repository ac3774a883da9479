// Adds forces and tangents of terms to residual and matrix. A term only names its local 3-blocks; the
// Assembler applies the weights of the integrator, the retraction, ghosts, constraints and the layout of the
// matrix.
#pragma once

#include <petscmat.h>

#include <cassert>
#include <span>
#include <vector>

#include "hawser/kernels/stencil.hpp"
#include "hawser/math/types.hpp"
#include "hawser/system/local_blocks.hpp"
#include "hawser/system/tied_node_forces.hpp"

namespace hawser {

// J = wK K T + wC C + wM M, where T is the right Jacobian of the step's rotation increments, plus a shift of
// the free diagonal: N/m on positions, N m on rotations. `stabilisation`, 0 to 1, is used by statics far from
// the solution, where slack or sliding lines would have no stiffness: K takes this share of the axial
// stiffness of slack cables, and it shifts sliding friction by this share from its derivative to its secant.
struct Weights {
  double K = 1, C = 0, M = 0;
  double shift_position = 0, shift_rotation = 0;
  double stabilisation = 0;
};

// A force on blocks, as a view of a vector that outlives it; default: none.
class ForceView {
 public:
  ForceView() = default;
  template <class Vector>
  ForceView(const Eigen::MatrixBase<Vector>& f) : data_(f.derived().data()), size_(f.size()) {
    static_assert(Vector::IsVectorAtCompileTime);
  }
  const double* data() const { return data_; }
  Eigen::Index size() const { return size_; }

 private:
  const double* data_ = nullptr;
  Eigen::Index size_ = 0;
};

// Derivatives of a force on blocks, as a view of a row-major matrix that outlives it, or of whole rows of
// one; default, or of an empty matrix: none.
class DerivativeView {
 public:
  DerivativeView() = default;
  template <class Matrix>
  DerivativeView(const Eigen::MatrixBase<Matrix>& A)
      : data_(A.size() > 0 ? A.derived().data() : nullptr), rows_(A.rows()), columns_(A.cols()) {
    static_assert(Matrix::IsRowMajor);
    assert(A.size() == 0 || A.derived().outerStride() == columns_);
  }
  const double* data() const { return data_; }
  // True if there are no derivatives, or they have this size.
  bool none_or_sized(Eigen::Index rows, Eigen::Index columns) const {
    return !data_ || (rows_ == rows && columns_ == columns);
  }

 private:
  const double* data_ = nullptr;
  Eigen::Index rows_ = 0, columns_ = 0;
};

class Assembler {
 public:
  // Adds nothing.
  Assembler() = default;
  // The arrays of a residual, to which terms add. They outlive the assembler.
  struct Residual {
    std::vector<double>& force;    // 3 * local blocks
    std::vector<double>& mean;     // 3 * local blocks, sum of mean forces without their weight
    std::vector<double>& squares;  // by block: sum of squares of the contributions to owned rows
  };
  // The matrix of a tangent and what its entries need. They outlive the assembler.
  struct Tangent {
    Mat matrix;
    const LocalBlocks& blocks;               // of the matrix
    const std::vector<Mat3>& retraction;     // of rotations
    const std::vector<int>& turn_of;         // by local block: index into `retraction`; -1: a position
    const std::vector<unsigned char>& held;  // by local block: bit c set when component c is prescribed
  };
  // mean_weight: StepMean::weight of the trial.
  static Assembler for_residual(const LocalMesh& mesh, const TiedNodeForces& ties, double mean_weight,
                                const Residual& to);
  static Assembler for_tangent(const LocalMesh& mesh, const TiedNodeForces& ties, double mean_weight,
                               const Weights& weights, bool convex, const Tangent& to);

  bool needs_force() const { return force_ != nullptr; }
  bool needs_tangent() const { return matrix_ != nullptr; }
  // True far from a static solution: terms exclude negative geometric stiffness.
  bool convex() const { return convex_; }

  // Adds the force f (3n) on n local 3-blocks and its derivatives K, C and M (3n x 3n). K is the derivative
  // by the configuration, for rotations by material increments at the trial rotation; C and M are those by
  // (v, w) and (a, alpha). Without needs_force() f is ignored, without needs_tangent() the derivatives.
  void add(std::span<const int> blocks, ForceView f, DerivativeView K = {}, DerivativeView C = {},
           DerivativeView M = {}) {
    add(blocks, blocks, f, K, C, M);
  }
  // Force on the blocks `rows` and its derivatives by the motion of the blocks `columns`, such as the force
  // on one body due to the motion of another.
  void add(std::span<const int> rows, std::span<const int> columns, ForceView f, DerivativeView K,
           DerivativeView C, DerivativeView M);
  // Force on one block, with derivatives or null.
  void add(int block, const Vec3& f, const Mat3* K = nullptr, const Mat3* C = nullptr,
           const Mat3* M = nullptr);
  // Force on the positions a and b, where f depends on their difference alone: the residual
  // gets -f at a and +f at b. k and c are the derivatives of f by x_b - x_a and v_b - v_a, or null.
  void add_between(int a, int b, const Vec3& f, const Mat3* k, const Mat3* c);
  // As add_between, with a force f that is the mean over the step (StepMean) and its derivative k by x_b -
  // x_a. Both enter with the weight of StepMean. In statics and at the start of the motion that weight is 1:
  // the force is then no mean and enters as by add_between. f is also summed, without the weight, for
  // System::mean_forces().
  void add_mean_between(int a, int b, const Vec3& f, const Mat3* k);
  // For masses that couple positions, with the force f on both. M is `diagonal` times the identity on the
  // diagonal and `shared` times it off the diagonal.
  void add_masses(int a, int b, const Vec6& f, double diagonal, double shared);
  // Weights for kernels that apply them to their derivatives themselves and call add_weighted().
  const Weights& weights() const { return weights_; }
  // Adds the force on two positions and the sum J of its weighted derivatives. False: nothing is added,
  // because an end is tied to a frame, for which add() needs the derivatives one by one.
  [[nodiscard]] bool add_weighted(int a, int b, const Vec6& f, const Mat6& J);
  // While this is on, contributions to rows of other ranks are kept and sent to their owners, which do not
  // compute them themselves.
  void send(bool on) { sending_ = on; }

 private:
  // True if derivatives by a block also act on a frame.
  bool tied(int block) const { return ties_->tied(block); }
  void add_force(int block, double x, double y, double z);
  void put(std::span<const int> rows, std::span<const int> columns, double* J);
  void add_tied(std::span<const int> rows, std::span<const int> columns, DerivativeView K, DerivativeView C,
                DerivativeView M);
  void add_nonlocal(int row, int column, const double* J, int m);

  const TiedNodeForces* ties_ = nullptr;
  double mean_weight_ = 1;
  int owned_blocks_ = 0;
  // of a residual
  std::vector<double>*force_ = nullptr, *mean_ = nullptr, *squares_ = nullptr;
  // of a tangent
  Mat matrix_ = nullptr;
  const LocalBlocks* blocks_ = nullptr;
  Weights weights_;
  bool convex_ = false, sending_ = false;
  const std::vector<int>* global_block_ = nullptr;
  const std::vector<Mat3>* retraction_ = nullptr;
  const std::vector<int>* turn_of_ = nullptr;
  const std::vector<unsigned char>* held_ = nullptr;
};

}  // namespace hawser

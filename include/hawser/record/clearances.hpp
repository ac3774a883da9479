// Smallest distances of lines to other lines and to volumes at every accepted step.
#pragma once

#include <mpi.h>

#include <memory>
#include <vector>

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/io/results.hpp"
#include "hawser/kernels/axis_clearance.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

class Clearances : public Recording {
 public:
  // The subject must outlive the object.
  explicit Clearances(const Subject& subject);

  // One series per clearance of the case: to a line `clearance`, `arc_length`, `other_arc_length`; to a
  // volume `clearance`, `arc_length` and the nearest `point` of its surface, space axes.
  void declare(Declarations& to) override;
  // Complete on rank 0, empty elsewhere.
  void rows(const Snapshot& s, Rows& to) override;

 private:
  struct Best {
    double clearance = 0;
    double arc = 0;                   // m
    Vec3 other_place = Vec3::Zero();  // m; to a line: its arc length first
  };
  struct Shaped {
    int element = 0;  // of the mesh
    double radius = 0;
    BezierAxis axis;
  };
  // Elements of a part of a line and the tree of their bounding boxes.
  struct Tree {
    std::vector<Shaped> elements;  // in the order of element numbers
    BoxTree boxes;
    double radius = 0;  // m, largest
    Tree() = default;
    explicit Tree(std::vector<Shaped> shapes);
  };
  // Lower bound `lower_bound` [m] of the distance of an element to a volume, valid while its axis has not
  // moved in the body's frame. Affects the cost but not the result.
  struct Cache {
    BezierAxis axis;
    double lower_bound = 0;
    bool known = false;
  };

  std::vector<Shaped> local_shapes(int line, const Kinematics& state) const;
  Tree of_all_ranks(const Tree& local) const;
  Best to_line(const Tree& a, const Tree& b) const;
  Best to_volume(const std::vector<Shaped>& elements, const Surface& surface, const io::BodyPose& pose,
                 std::vector<Cache>& cache) const;
  double arc(int element, double xi) const;

  MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& mesh_;
  const std::vector<std::shared_ptr<const Surface>>& surfaces_;
  std::vector<std::vector<Cache>> cache_;  // by clearance, for local_shapes()
};

}  // namespace hawser::record

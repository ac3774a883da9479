// Histories of single numbers at every step: touchdown points, force terms, feeders and steps.
#pragma once

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {
class Feeders;
}  // namespace hawser

namespace hawser::record {

// Touchdown points of each line. The subject must outlive all classes of this file.
class TouchdownHistory : public Recording {
 public:
  explicit TouchdownHistory(const Subject& subject) : subject_(subject) {}
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
};

// Series that force terms declare.
class TermHistory : public Recording {
 public:
  explicit TermHistory(const Subject& subject);
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  std::vector<HasSeries*> terms_;
};

// Series of each fed line end.
class FeederHistory : public Recording {
 public:
  explicit FeederHistory(const Subject& subject);
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
  const Feeders* feeders_;  // null: none
};

// Length and iterations of the steps.
class StepHistory : public Recording {
 public:
  explicit StepHistory(const Subject& subject) : subject_(subject) {}
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
};

}  // namespace hawser::record

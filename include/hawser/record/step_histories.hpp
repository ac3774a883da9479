// Histories of a few numbers at every step: touchdown points, those of force terms, feeders, energies and the
// steps themselves.
#pragma once

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/touchdown.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {
class Feeders;
}  // namespace hawser

namespace hawser::record {

// Of each line. The subject outlives these all.
class TouchdownHistory : public Recording {
 public:
  explicit TouchdownHistory(const Subject& subject);
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
  Touchdowns touchdowns_;
};

// What force terms declare by themselves.
class TermHistory : public Recording {
 public:
  explicit TermHistory(const Subject& subject);
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  std::vector<HasSeries*> terms_;
};

// Of each end that is fed.
class FeederHistory : public Recording {
 public:
  explicit FeederHistory(const Subject& subject);
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
  const Feeders* feeders_;  // null: there are none
};

// The sums of the audit.
class EnergyHistory : public Recording {
 public:
  explicit EnergyHistory(const Subject& subject) : subject_(subject) {}
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
};

// Length and iterations of steps.
class StepHistory : public Recording {
 public:
  explicit StepHistory(const Subject& subject) : subject_(subject) {}
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
};

}  // namespace hawser::record

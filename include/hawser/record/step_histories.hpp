// Histories of a few numbers at every step: touchdown points, links, feeders, energies and the steps
// themselves.
#pragma once

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/touchdown.hpp"

namespace hawser {
class Feeders;
class Links;
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

// Of each link of the case.
class LinkHistory : public Recording {
 public:
  explicit LinkHistory(const Subject& subject);
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  const Subject& subject_;
  const Links* links_;  // null: there are none
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

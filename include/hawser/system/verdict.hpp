// The result of every check of a converged step, or of a trial of statics: accept, try a shorter one, prepare
// again (rebuild the list of candidates) and retry, or stop. Contact, candidates, impacts, local error and
// Newton's iteration all return it.
#pragma once

#include "hawser/advice/step_findings.hpp"

namespace hawser {

struct Verdict {
  // In order of severity.
  enum class Kind {
    accept,
    shorter,        // retry with a shorter step
    prepare_again,  // the preparation of the step is out of date: prepare again and retry
    stop            // no step, however short, can help
  };
  Kind kind = Kind::accept;
  advice::StepFinding because;  // advice::clause() makes the text

  bool accepted() const { return kind == Kind::accept; }
};

}  // namespace hawser

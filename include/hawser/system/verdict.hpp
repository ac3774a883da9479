// What is decided about a converged step, or a trial of statics: the one word that contact, candidates,
// impacts, local error and Newton's iteration all speak.
#pragma once

#include <string>

namespace hawser {

struct Verdict {
  // Each outweighs those before it.
  enum class Kind {
    accept,
    shorter,       // retry with a shorter step
    prepare_anew,  // what was prepared for the step is out of date: prepare again and retry
    stop           // no step, however short, can help
  };
  Kind kind = Kind::accept;
  std::string because;  // a clause for the user

  bool accepted() const { return kind == Kind::accept; }
};

}  // namespace hawser

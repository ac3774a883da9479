// Keys of the analyses: statics and dynamics.
#include "schema_build.hpp"

namespace hawser::model::schema_build {

Key statics() {
  return one_of(
      {"statics", &Case::statics},
      {boolean({"", &Statics::enabled}),
       map("",
           {boolean({"enabled", &Statics::enabled}, "find the equilibrium before dynamics", or_else("true")),
            number({"tolerance", &Statics::tolerance}, none, "residual over the size of the internal forces",
                   above(0), at_most(1e-2), or_else("1e-8")),
            boolean({"contact_friction", &Statics::contact_friction},
                    "friction of volumes, between lines and of bodies on each other acts in statics too, "
                    "against the way "
                    "from where the case puts them; else it acts from the equilibrium without it on",
                    or_else("false")),
            integer({"max_iterations", &Statics::max_iterations}, "Newton iterations of a stage",
                    in_range(1, 1e6), or_else("500")),
            word({"dynamic_relaxation", &Statics::relaxation},
                 {{"auto", Relaxation::automatic},
                  {"always", Relaxation::always},
                  {"never", Relaxation::never}},
                 "lets lines come to rest from the start shape by a damped motion, for slack and floating "
                 "lines, before Newton's iteration: where that alone fails (`auto`), `always` or `never`",
                 or_else("auto")),
            integer({"relaxation_steps", &Statics::relaxation_steps}, "steps of that motion at most",
                    in_range(1, 1e7), or_else("5000"))})},
      "Static equilibrium at t = 0; `false` starts dynamics from the start shape.", or_else("true"));
}

Key dynamics() {
  return map(
      {"dynamics", &Case::dynamics, set(&Case::dynamics, &Dynamics::enabled, true)},
      {number({"duration", &Dynamics::duration}, time, "simulated time", above(0), required),
       one_of({"step", &Dynamics::step}, {word("", {"auto"}), number("", time, above(0))}, "time step",
              or_else("auto")),
       number({"max_step", &Dynamics::max_step}, time, "largest automatic step", above(0),
              or_else_note("chosen by the program")),
       number({"min_step", &Dynamics::min_step}, time, "smallest step, below which the run stops", above(0),
              or_else_note("chosen by the program")),
       boolean({"resolve_impacts", &Dynamics::resolve_impacts},
               "at an impact a step that is fixed is divided as an automatic one would be: 22 in "
               "a period of the contact, ending at the touch; `false`: it stays as it is",
               or_else("true")),
       number({"rho_infinity", &Dynamics::rho_infinity}, none,
              "spectral radius at high frequency of the generalized-alpha method; 1: no numerical damping",
              in_range(0, 1), or_else("0.8")),
       number({"tolerance", &Dynamics::tolerance}, none, "residual over the size of the internal forces",
              above(0), at_most(1e-2), or_else("1e-8")),
       number({"error_tolerance", &Dynamics::error_tolerance}, length,
              "local error of a step in automatic stepping", above(0),
              or_else_note("a hundredth of the diameter of each line"))},
      "Motion in time; without this key only statics is run.");
}

}  // namespace hawser::model::schema_build

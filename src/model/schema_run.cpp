// Keys of the analyses: statics and dynamics.
#include "schema_build.hpp"

namespace hawser::model::schema_build {

Key statics() {
  return one_of(
      {"statics", &Case::statics},
      {boolean({"", &Statics::enabled}),
       map("",
           {boolean({"enabled", &Statics::enabled}, "find the equilibrium before dynamics", or_else("true")),
            number({"tolerance", &Statics::tolerance}, none, "residual relative to the internal forces",
                   above(0), at_most(1e-2), or_else("1e-8")),
            boolean(
                {"contact_friction", &Statics::contact_friction},
                "friction with volumes, between lines and between bodies acts in statics as well, "
                "against the motion from the start positions of the case; `false`: it acts in dynamics "
                "only, from the equilibrium without friction",
                or_else_note(
                    "`true` if statics finds no equilibrium without friction, or if bodies start at rest on "
                    "others and nothing else supports them")),
            integer({"max_iterations", &Statics::max_iterations},
                    "largest number of Newton iterations in a stage", in_range(1, 1e6), or_else("1000")),
            word({"dynamic_relaxation", &Statics::relaxation},
                 {{"auto", Relaxation::automatic},
                  {"always", Relaxation::always},
                  {"never", Relaxation::never}},
                 "damped motion that brings slack and floating lines from the start shape to rest before "
                 "Newton's iteration: `auto`, if Newton's iteration alone fails; `always`; `never`",
                 or_else("auto")),
            integer({"relaxation_steps", &Statics::relaxation_steps},
                    "largest number of steps of that motion; without friction at most 150 if friction of "
                    "contact can bring lines to rest after it",
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
               "divides a fixed step at an impact as an automatic one: 25 steps in a period of the contact, "
               "one of which ends at the first touch; also where a cable comes taut to its largest tension "
               "so far; "
               "`false`: the step stays as given",
               or_else("true")),
       number({"rho_infinity", &Dynamics::rho_infinity}, none,
              "spectral radius at high frequency of the generalized-alpha method; 1: no numerical damping",
              in_range(0, 1), or_else("0.8")),
       number({"tolerance", &Dynamics::tolerance}, none, "residual relative to the internal forces", above(0),
              at_most(1e-2), or_else("1e-8")),
       number({"error_tolerance", &Dynamics::error_tolerance}, length, "local error of an automatic step",
              above(0), or_else_note("1 % of the diameter of each line"))},
      "Motion in time; without this key the program computes statics only.");
}

}  // namespace hawser::model::schema_build

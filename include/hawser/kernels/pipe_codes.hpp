// Strength of steel pipes during installation: local buckling under combined loads by DNV-ST-F101 (2021),
// tension or bending with pressure by API RP 1111 (2015). Every check is fulfilled up to 1. Formulas, sources
// and limits: docs/theory/pipe-codes.md.
#pragma once

namespace hawser {

// Steel and section of a pipe, and the factors of its strength.
struct PipeSteel {
  double outer = 0, wall = 0;             // m, diameter and nominal thickness of the steel
  double modulus = 207e9, poisson = 0.3;  // Pa; -
  double smys = 0, smts = 0;              // Pa, specified minimum yield stress and tensile strength
  double material_factor = 0.96;          // alpha_U
  double fabrication = 0.85;              // alpha_fab: seamless 1, UO 0.93, UOE 0.85
  double safety_class = 1.04;             // gamma_SC,LB: low 1.04, medium 1.14, high 1.26
  double ovality = 0.015;                 // (D_max - D_min) / D
  bool cold_expanded = true;              // for API RP 1111: UOE

  double slenderness() const { return outer / wall; }
};

// gamma_C of functional loads by the location of the pipe: between its supports, on the seabed, elsewhere.
struct PipeConditions {
  double supports = 1, span = 1, seabed = 1;
};

struct PipeLoads {
  double moment_2 = 0, moment_3 = 0;  // N m, about the section's axes
  double tension = 0;                 // N, effective
};

// Design loads, DNV-ST-F101 table 4-4: magnitude of gamma_F gamma_C F + gamma_E (now - F), with F the
// functional loads at rest.
struct PipeDesign {
  double moment = 0, tension = 0;  // N m, N
};

class PipeCodes {
 public:
  explicit PipeCodes(const PipeSteel& steel);

  // DNV-ST-F101 5.4.6, load controlled, equations 5.19 and 5.28, from design loads. Pressures in Pa.
  double local_buckling(const PipeDesign& loads, double outside, double inside) const;
  // The larger result of the load combinations a and b.
  double local_buckling(const PipeLoads& rest, const PipeLoads& now, double condition, double outside,
                        double inside) const;
  // Largest design tension of both combinations over that at yield; the formula holds up to kMaxPulled.
  double pulled(const PipeLoads& rest, const PipeLoads& now, double condition) const;

  // API RP 1111 4.3.2.2: bending strain and external pressure.
  double bending_and_pressure(double strain, double outside, double inside) const;
  // API RP 1111 4.3.1.1 and 4.3.1.2: effective tension and pressure.
  double tension_and_pressure(double tension, double outside, double inside) const;

  double outer() const { return steel_.outer; }
  double plastic_moment() const { return moment_; }    // N m, M_p
  double plastic_tension() const { return tension_; }  // N, S_p
  double flow_stress() const { return flow_; }         // alpha_c
  double burst() const { return burst_; }              // Pa, p_b
  double collapse() const { return collapse_; }        // Pa, p_c

 private:
  PipeSteel steel_;
  double factor_;  // gamma_m gamma_SC,LB
  double hardening_, flow_, moment_, tension_, burst_, collapse_;
  double api_burst_, api_collapse_, api_yield_;  // Pa, Pa, N
};

// Ranges of validity: |S_Sd| / S_p and D/t for the formula of combined loads, D/t for API RP 1111.
inline constexpr double kMaxPulled = 0.4, kMinSlender = 15, kMaxSlender = 45, kMaxSlenderApi = 50;

// Yield stress and tensile strength of a grade of API 5L (PSL 2), Pa: "X65".
struct PipeGrade {
  const char* name;
  double smys, smts;
};
inline constexpr PipeGrade kPipeGrades[] = {
    {"X42", 290e6, 415e6}, {"X46", 320e6, 435e6}, {"X52", 360e6, 460e6}, {"X56", 390e6, 490e6},
    {"X60", 415e6, 520e6}, {"X65", 450e6, 535e6}, {"X70", 485e6, 570e6}, {"X80", 555e6, 625e6}};

}  // namespace hawser

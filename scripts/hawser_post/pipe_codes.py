"""Code checks of steel pipes in addition to the fields of the program: the simplified laying criteria of
DNV-ST-F101. docs/theory/pipe-codes.md has the formulas; those of the fields are in src/kernels/pipe_codes.cpp."""

# API 5L (PSL 2): specified minimum yield stress, Pa.
YIELD = {f"X{name}": smys * 1e6 for name, smys in
         ((42, 290), (46, 320), (52, 360), (56, 390), (60, 415), (65, 450), (70, 485), (80, 555))}
# Limits of overbend strain by the simplified criteria: static (I), and dynamic (II).
OVERBEND_STRAIN = {"X52": (0.00205, 0.0026), "X60": (0.0023, 0.0029), "X65": (0.0025, 0.00305), "X70": (0.0027, 0.00325)}
SAGBEND_STRESS = 0.87  # fraction of the yield stress with alpha_U, equivalent stress, dynamic

"""Checks of steel pipes by codes: local buckling of DNV-ST-F101, its simplified criteria for laying, API RP 1111. Loads are
numbers or arrays: moments in N m, tensions in N, pressures in Pa; every check is met where it is at most 1, but for what a
function says otherwise. docs/theory/pipe-codes.md has the formulas."""
from dataclasses import dataclass

import numpy as np

# API 5L (PSL 2): specified minimum yield stress and tensile strength, Pa.
GRADES = {f"X{name}": (smys * 1e6, smts * 1e6) for name, smys, smts in
          ((42, 290, 415), (46, 320, 435), (52, 360, 460), (56, 390, 490), (60, 415, 520), (65, 450, 535), (70, 485, 570),
           (80, 555, 625))}
# Load effect factors of the ultimate limit state, combinations a (system) and b (local): functional, environmental.
COMBINATIONS = {"a": (1.2, 0.7), "b": (1.1, 1.3)}
RELIEVING = 1 / 1.1  # the functional factor where functional loads make the sum smaller
# gamma_C of functional loads; what is neither, on a stinger and in a free span, has 1.
UNEVEN_SEABED = 1.07
RESISTANCE = 1.15  # gamma_m
SAFETY_CLASSES = {"low": 1.04, "medium": 1.14, "high": 1.26}  # gamma_SC,LB
FABRICATION = {"seamless": 1.0, "UO": 0.93, "UOE": 0.85}  # alpha_fab
SLENDER, MOST_PULLED = (15, 45), 0.4  # D/t, and |S_Sd| of S_p, of which the formulas for combined loads are
API_MOST_SLENDER = 50  # D/t, of bending with external pressure
# Strain of the overbend by the simplified criteria: static (I), and with motion (II).
OVERBEND_STRAIN = {"X52": (0.00205, 0.0026), "X60": (0.0023, 0.0029), "X65": (0.0025, 0.00305), "X70": (0.0027, 0.00325)}
SAGBEND_STRESS = 0.87  # of the yield stress, equivalent, with motion


@dataclass
class Steel:
    """A pipe's steel and how its strength is judged."""
    smys: float  # Pa
    smts: float
    modulus: float = 207e9  # Pa
    poisson: float = 0.3
    safety_class: str = "low"
    fabrication: str = "UOE"
    ovality: float = 0.015  # (D_max - D_min) / D, 0.005 at least
    material_factor: float = 0.96  # alpha_U

    @property
    def yields(self):
        return self.smys * self.material_factor

    @property
    def breaks(self):
        return self.smts * self.material_factor


def flow_stress_factor(steel, slender):
    """alpha_c: what strain hardening adds to the plastic capacities, by D/t."""
    beta = hardening_share(slender)
    return 1 - beta + beta * steel.breaks / steel.yields


def hardening_share(slender):
    return np.clip((60 - slender) / 90, 0, 0.5)


def plastic(steel, outer, wall):
    """S_p [N] and M_p [N m]."""
    return steel.yields * np.pi * (outer - wall) * wall, steel.yields * (outer - wall) ** 2 * wall


def burst_pressure(steel, outer, wall):
    """p_b [Pa]."""
    return 2 * wall / (outer - wall) * np.minimum(steel.yields, steel.breaks / 1.15) * 2 / np.sqrt(3)


def elastic_collapse(modulus, poisson, outer, wall):
    """Pa, of a round pipe."""
    return 2 * modulus * (wall / outer) ** 3 / (1 - poisson**2)


def collapse_pressure(steel, outer, wall):
    """p_c [Pa]: the smallest positive root of (p_c - p_el) (p_c² - p_p²) = p_c p_el p_p f_0 D/t."""
    elastic = elastic_collapse(steel.modulus, steel.poisson, outer, wall)
    plastic_one = steel.yields * FABRICATION[steel.fabrication] * 2 * wall / outer
    oval = max(steel.ovality, 0.005) * outer / wall
    roots = np.roots([1, -elastic, -(plastic_one**2 + elastic * plastic_one * oval), elastic * plastic_one**2])
    real = roots[np.abs(roots.imag) < 1e-9 * elastic].real
    return float(real[real > 0].min())


def design_load(combination, functional, environmental, condition):
    """Size of gamma_F gamma_C F + gamma_E E, of vectors along the last axis; the larger of that and the one where functional
    loads relieve. The checks rise with the size of each load, so that the larger is the worse."""
    usual, gamma_e = combination
    return np.fmax(*(np.linalg.norm(gamma_f * condition * functional + gamma_e * environmental, axis=-1)
                     for gamma_f in (usual, RELIEVING)))


def local_buckling(steel, outer, wall, moment, tension, outside, inside):
    """Combined loading, load controlled, with design loads `moment` and effective `tension`: DNV-ST-F101 (2021) 5.4.6,
    equations 5.19 where the pressure inside is the larger, 5.28 where that outside is."""
    slender = outer / wall
    axial, bending = plastic(steel, outer, wall)
    factor, capacity = RESISTANCE * SAFETY_CLASSES[steel.safety_class], flow_stress_factor(steel, slender)
    loads = (factor * np.abs(moment) / (capacity * bending) + (factor * tension / (capacity * axial)) ** 2) ** 2
    burst, beta = burst_pressure(steel, outer, wall), hardening_share(slender)
    over = (inside - outside) / burst
    weaker = np.where(over < 2 / 3, 1 - beta, 1 - 3 * beta * (1 - over))  # alpha_p
    within = (weaker * over / capacity) ** 2
    without = (factor * (outside - inside) / collapse_pressure(steel, outer, wall)) ** 2
    return loads + np.where(over > 0, within, without)


def api_bending_and_pressure(steel, outer, wall, strain, outside, inside):
    """API RP 1111 (2015) 4.3.2.2: bending strain under external pressure, eps/eps_b + (Po - Pi)/(f_c P_c) up to
    g = 1/(1 + 20 delta), the strain 3.33 times (installation). f_c = f_o/g: without bending this is the check of external
    pressure alone, (Po - Pi) up to f_o P_c (4.3.2.1), f_o 0.7, of cold expanded pipe 0.6."""
    yield_pressure = 2 * steel.smys * wall / outer
    elastic = elastic_collapse(steel.modulus, steel.poisson, outer, wall)
    collapse = yield_pressure * elastic / np.hypot(yield_pressure, elastic)
    share = 0.6 if steel.fabrication == "UOE" else 0.7
    # The code's ovality is (D_max - D_min) / (D_max + D_min), half of DNV's.
    left = 1 / (1 + 10 * steel.ovality)
    return 3.33 * strain * 2 * outer / wall / left + np.maximum(outside - inside, 0) / (share * collapse)


def api_tension_and_pressure(steel, outer, wall, tension, outside, inside):
    """API RP 1111 (2015) 4.3.1.2: pressure and effective tension together, over 0.9, and the tension alone over 0.6 of
    that at yield (4.3.1.1): the larger."""
    inner = outer - 2 * wall
    burst = 0.45 * (steel.smys + steel.smts) * np.log(outer / inner)
    pulled = np.abs(tension) / (steel.smys * np.pi / 4 * (outer**2 - inner**2))
    return np.maximum(np.hypot((inside - outside) / burst, pulled) / 0.9, pulled / 0.6)

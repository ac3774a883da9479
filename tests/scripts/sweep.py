#!/usr/bin/env python3
"""Runs the program with every key of the schema set to values that are NaN, far too large, empty, or of another form.

    tests/scripts/sweep.py [--program FILE] [--checker FILE] [--runs] [--only PATH] [--jobs N]

Each key is part of one of the cases below, or is added to a map of them that may have it. Each such case is checked
(`check --quick`, many in one process), and with --runs the accepted cases are run. Required: no crash; at most 120 s;
exit code 0 or 2, for a run also 3 or 4; for an error one sentence that names the case; no `nan` or `inf` in the output
of a check; and no change of a file that existed before. Prints the cases that fail this."""
import argparse
import json
import os
import queue
import re
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from pathlib import Path

import h5py

ROOT = Path(__file__).resolve().parent.parent.parent
VALUES = ("nan", "inf", "1e300", "-1e300", "1e60", "-1e60", "1e-60", "0", "''", "[]", "{}")
PATIENCE = 120.0  # s
# Cases that should be refused or short, but whose runs take longer: a soil without resistance, a volume of
# extreme size, steps as short as this error tolerance requires.
TOO_LONG = (("lines.*.buried.[].resistance.normal", "1e-60"), ("volumes.*.shape.capsule.radius", "1e60"), ("dynamics.error_tolerance", "1e-60"))

TABLES = {
    "bed.xyz": "-200 -200 -50\n200 -200 -50\n-200 200 -52\n200 200 -52\n",
    "bed.obj": "v -200 -200 -50\nv 200 -200 -50\nv 200 200 -50\nv -200 200 -50\nf 1 2 3\nf 1 3 4\n",
    "box.obj": "".join(f"v {x} {y} {z}\n" for z in (1, 3) for y in (-2, 2) for x in (-2, 2)) + "".join(
        f"f {a} {b} {c}\n" for a, b, c in ((1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5), (3, 7, 8), (3, 8, 4),
                                           (1, 5, 7), (1, 7, 3), (2, 4, 8), (2, 8, 6))),
    "flow.txt": "0 0.8 0 0\n60 0.4 0.6 0.1\n120 -0.4 0.6 -0.1\n180 -0.8 0 0\n", "two.txt": "0 1\n10 2\n", "motion.txt": "0 0 0 0\n5 0.1 0 0\n10 0 0 0\n", "spectrum.txt": "0.05 0\n0.1 4\n0.2 1\n",
    "barge.1": "".join(f"{p} {k} {k} {a}{b}\n" for p, b in ((0, ""), (4, " 0.2"), (8, " 0.3"), (12, " 0.1")) for k, a in
                       ((1, 0.1), (2, 0.2), (3, 1.0), (4, 5.0), (5, 9.0), (6, 4.0))),
    "barge.hst": "3 3 0.2\n4 4 1.5\n5 5 8\n",
    "barge.3": "".join(f"{p} {d} {k} 0.1 0 0.1 0\n" for p in (4, 8, 12) for d in (0, 90, 180, 270) for k in range(1, 7)),
    "barge.8": "".join(f"{p} {d} {d} {k} 0.01 0 0.01 0\n" for p in (4, 8, 12) for d in (0, 90, 180, 270) for k in (1, 2, 6)),
    "unit.yaml": "hawser: 1\nbodies: {float: {position: [0, 0, -5]}}\nlines: {leg: {sections: [{type: wire, length: 60, elements: 4}], "
                 "end_a: {anchor: [30, 0, -40]}, end_b: {body: float, at: [0, 0, 0]}}}\n",
    "places.txt": "600 300\n700 300 20\n",
    "ship.rao": "".join(f"{p} {d}" + " 0.3 90" * 6 + "\n" for d in (0, 90, 180) for p in (4, 8, 12)),
}  # fmt: skip


def write_coefficients(folder):
    """A buoy in the layouts of BEMIO and Capytaine, with one heading."""
    omega, freedoms = [0.5, 1.0, 2.0], ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
    at = range(3)
    added, damping = ([[[float(i == j) * (least + k) for k in at] for j in range(6)] for i in range(6)] for least in (10, 1))
    stiff = [[float(i == j and i in (2, 3, 4)) * 20 for j in range(6)] for i in range(6)]
    heave, ahead = [0, 0, 20.0, 0, 0, 0], [10.0, 10.0, 0, 0, 0, 0]  # in phase with the crest, and before it
    re, im = ([[[x for _ in at]] for x in part] for part in (heave, ahead))
    with h5py.File(folder / "buoy.h5", "w") as file:
        for name, value in (("scaled", 0), ("rho", 1000), ("g", 9.81), ("w", omega), ("wave_dir", [0])):
            file["simulation_parameters/" + name] = value
        file["body1/properties/cg"] = [0.0, 0, 0]
        for name, value in (("added_mass/all", added), ("added_mass/inf_freq", added), ("radiation_damping/all", damping),
                            ("linear_restoring_stiffness", stiff), ("excitation/re", re), ("excitation/im", im)):
            file["body1/hydro_coeffs/" + name] = [[row[0] for row in r] for r in value] if name.endswith("inf_freq") else value
    by_omega = lambda matrix: [[[matrix[i][j][k] * 1000 for i in range(6)] for j in range(6)] for k in at]
    with h5py.File(folder / "buoy.nc", "w") as file:
        for name, value in (("omega", omega), ("wave_direction", [0.0]), ("radiating_dof", freedoms), ("influenced_dof", freedoms),
                            ("complex", ["re", "im"])):
            file[name] = value
            file[name].make_scale(name)
        for name, along, value in (
                ("rho", (), 1000.0), ("g", (), 9.81), ("added_mass", ("omega", "radiating_dof", "influenced_dof"), by_omega(added)),
                ("radiation_damping", ("omega", "radiating_dof", "influenced_dof"), by_omega(damping)),
                ("hydrostatic_stiffness", ("radiating_dof", "influenced_dof"), [[1e4 * x for x in row] for row in stiff]),
                ("excitation_force", ("complex", "omega", "wave_direction", "influenced_dof"), [[[[1e4 * x for x in part]] for _ in at] for part in (heave, [-x for x in ahead])])):
            file[name] = value
            for d, dimension in enumerate(along):
                file[name].dims[d].attach_scale(file[dimension])


# Common part of the cases: a mooring line, a pipe, a hanging rope, bodies, volumes, a link.
COMMON = """
hawser: 1
title: sweep
environment:
  gravity: 9.81
  water: {density: 1025, depth: 50, surface: 0}
  current: {speed: 0.5, direction_deg: 20, exponent: 0.2, ramp: 0, time_factor: {rows: [[0, 1], [10, 2]]}}
  wind: {speed: 10, direction_deg: 0, height: 10, exponent: 0.1, density: 1.2, ramp: 0, time_factor: {rows: [[0, 1], [10, 2]]},
         gusts: {spectrum: iso, components: 20, seed: 1, ramp: 1}}
  waves: {regular: {height: 2, period: 8, direction_deg: 0, phase_deg: 0}, ramp: 1, stretching: wheeler}
  seabed: {depth: 50, slope_deg: 1, slope_direction_deg: 0, normal_stiffness: {per_area: 1e5}, damping: 10, smoothing: 0.01,
           suction: {limit: 100, length: 0.1}, friction_in_statics: as_laid,
           friction: {axial: 0.5, lateral: 0.6, kinetic: {axial: 0.4, lateral: 0.5}, blend_speed: 0.1,
                      mobilisation_length: {axial: 0.01, lateral: 0.02}}}
line_types:
  chain: {library: chain-studless, diameter: 0.08, grade: R4}
  wire: {outer_diameter: 0.06, contact_diameter: 0.06, mass_per_length: 15, bending: false, EA: {table: [[0.01, 5e5]]},
         breaking_load: 2e6, minimum_bend_radius: 1, displaced_diameter: 0.06, drag_diameter: 0.06, Cd_normal: 1.2, Cd_axial: 0.1,
         Ca_normal: 1, Ca_axial: 0, stiffness_damping: 0.01, marine_growth: {thickness: 0.01, density: 1300}}
  pipe: {pipe: {outer_diameter: 0.2, wall_thickness: 0.01, material: {E: 2e11, density: 7850, poisson: 0.3}, grade: X65, safety_class: low,
                fabrication: UOE, ovality: 0.015, material_factor: 0.96, condition_factor: {supports: 0.8, span: 1, seabed: 1},
                coatings: [{thickness: 0.003, density: 900}]},
         contents: {density: 800, pressure: 1e6}, thermal_expansion: 1.2e-5}
  hose: {outer_diameter: 0.2, weight: {in_air: 500, submerged: 200, full_of: 0.1, water_density: 1025}, EA: 1e7, EI: [1e4, 1e4], GJ: 1e4,
         GA: 1e7, rotary_inertia: [0.2, 0.1, 0.1], contents: {inner_diameter: 0.1, density: flooded}}
  bent: {outer_diameter: 0.1, mass_per_length: 30, EA: 1e8, EI: {table: [[0.1, 2000], [1, 10000]]}, GJ: 1e4}
bodies:
  vessel: {position: [0, 0, 0], rotation_deg: [0, 0, 0],
           motion: {harmonic: {amplitude: [0.1, 0, 0.1], rotation_amplitude_deg: [0, 0, 0], period: 8, phase_deg: [0, 0, 0],
                               rotation_phase_deg: [0, 0, 0]}, ramp: 1,
                    drift: {offset: [0, 0, 0], rotation_deg: [0, 0, 0], ramp: 0,
                            harmonic: {amplitude: [0.1, 0, 0], period: 60}, table: {rows: [[0, 0, 0, 0], [10, 1, 0, 0]], interpolation: spline}}}}
  buoy: {position: [40, 30, -5], floating: {mass: 1000, inertia: [500, 500, 500], products_of_inertia: [0, 0, 0], centre_of_mass: [0, 0, 0],
         weight: true, velocity: [0, 0, 0], angular_velocity: [0, 0, 0], stiffness: [1e4, 1e4, 1e4], damping: [100, 100, 100], turning_stiffness: [1e4, 1e4, 1e4], turning_damping: [100, 100, 100],
         stiffness_matrix: [[1e4, 0, 0, 0, 10, 0], [0, 1e4, 0, 0, 0, 0], [0, 0, 1e4, 0, 0, 0], [0, 0, 0, 1e4, 0, 0], [10, 0, 0, 0, 1e4, 0], [0, 0, 0, 0, 0, 1e4]],
         damping_matrix: [[100, 0, 0, 0, 10, 0], [0, 100, 0, 0, 0, 0], [0, 0, 100, 0, 0, 0], [0, 0, 0, 100, 0, 0], [10, 0, 0, 0, 100, 0], [0, 0, 0, 0, 0, 100]],
         in_water: {volume: 1.2, height: 1.5, centre_of_buoyancy: [0, 0, 0], drag_area: [1, 1, 1], Cd: [1, 1, 1], centre_of_drag: [0, 0, 0], Ca: [0.5, 0.5, 0.5]}}}
  clump: {on: {line: riser, at: 30}}
volumes:
  post: {shape: {cylinder: {from: [30, 40, -20], to: [30, 40, 5], radius: 1}}, normal_stiffness: {per_length: 1e5}, smoothing: 0.001,
         relative_damping: 0.1, friction: {axial: 0.3, lateral: 0.3, kinetic: {axial: 0.2, lateral: 0.2}, blend_speed: 0.1, mobilisation_length: {axial: 0.01,
         lateral: 0.01}, return: radial}}
  deck: {mesh: box.obj, scale: 1, closed: required, sign: automatic, smooth: false, crease_angle_deg: 40, body: vessel, active: {box: [[-5, -5, 0], [5, 5, 5]]}}
lines:
  mooring:
    sections: [{type: chain, length: 40, elements: 6, grading: 1}, {type: wire, length: 40, element_length: 8}]
    end_a: {anchor: [70, 0, -50.9]}
    end_b: {body: vessel, at: [3, 0, -1], no_contact_within: 0.5}
    masses: [{at: 20, mass: 100, volume: 0.05, drag_area: 0.1, Ca: 0.5}]
    loads: [{per_length: [0, 1, 0], from: 0, to: 10, ramp: 0}, {at: 15, force: [0, 10, 0], ramp: 1}]
    start: auto
  riser:
    sections: [{type: pipe, length: 55, elements: 8}]
    end_a: {body: vessel, at: [0, 5, -2], direction: [0.3, 0.3, -1], rotational_stiffness: 1e5}
    end_b: {anchor: [20, 25, -45]}
    bend_stiffeners: [{at: end_a, towards: end_b, EI: [[0, 1e6], [2, 1e4]]}]
    temperature_change: 20
    loads: [{at: 20, force: [0, 1, 0], moment: [1, 0, 0]}]
  tail:
    sections: [{type: wire, length: 12, elements: 4}]
    end_a: {body: buoy, at: [0, 0, 1]}
    end_b: {anchor: [40, 38, 0]}
links:
  spring: {end_a: {body: vessel, at: [0, -5, 0]}, end_b: {body: buoy, at: [0, 0, 0]}, stiffness: 10, rest_length: 60, damping: 1, tension_only: true}
  tether: {end_a: {line: riser, at: 20}, end_b: {anchor: [10, 30, -20]}, stiffness: 10}
contact: {method: line, rolling: false, penetration_warning: 0.1,
          between_lines: {self: false, normal_stiffness: auto, friction: 0.2, mobilisation_length: 0.01, smoothing: 0.001, relative_damping: 0.1,
                          exclude: [[mooring, tail]], pairs: [{lines: [mooring, riser], normal_stiffness: {per_length: 1e5}, friction: 0.1,
                                    mobilisation_length: 0.01, smoothing: 0.001, relative_damping: 0.1}]}}
statics: {enabled: true, tolerance: 1e-8, contact_friction: false, max_iterations: 200, dynamic_relaxation: auto, relaxation_steps: 2000}
dynamics: {duration: 1, step: auto, max_step: 0.2, min_step: 1e-7, resolve_impacts: true, rho_infinity: 0.8, tolerance: 1e-8,
           error_tolerance: 0.01}
output: {file: out.h5, every: 0.5, checkpoint_every: 0.5, format: [hdf5], single_precision: false, history_every: 1, touchdowns: true, statistics: true,
         statistics_from: 0, clearances: [{line: mooring, other_line: riser, name: gap}, {line: riser, volume: post, name: off}],
         clashes: {merge_gap: 0.1, merge_length: 1, rows: 100},
         histories: [{line: mooring, at: end_b, name: top}, {body: vessel}, {volume: post}]}
"""
# Parts of other cases that replace or extend it, by dotted key; null removes the key.
VARIANTS = (
    {},
    {"environment.current": "{profile: [{depth: 0, speed: 1, direction_deg: 0}, {depth: 40, speed: 0.2}], time_factor: {file: two.txt}}",
     "environment.waves": "{jonswap: {hs: 2, tp: 8, direction_deg: 0, seed: 1, components: 10, spreading: 2, gamma: 3.3}}",
     "environment.seabed": "{grid: {file: bed.xyz, depths: false}, normal_stiffness: {per_length: 1e4}}",
     "bodies.vessel.motion": "{rao: {file: ship.rao, phase: lag, symmetry: none}}",
     "contact.between_lines.normal_stiffness": "{per_area: 1e6}", "volumes.post.normal_stiffness": "{per_point: 1e5}",
     "bodies.buoy.floating.in_water.added_mass": "[100, 100, 100]", "bodies.buoy.floating.in_water.Ca": "null"},
    {"environment.waves": "{pierson_moskowitz: {hs: 2, tp: 8, direction_deg: 0, seed: 1, components: 10, spreading: 0}}",
     "environment.seabed": "{mesh: {file: bed.obj, scale: 1, smooth: true, crease_angle_deg: 40}, "
     "normal_stiffness: {table: [[0.1, 1e4], [0.2, 3e4]], per: length}, friction: 0.3}",
     "bodies.vessel.motion": "{velocity: [0.1, 0, 0], rotation: {axis: [0, 0, 1], rate: 0.01}}",
     "volumes.post.normal_stiffness": "{per_area: 1e5}", "contact.between_lines.normal_stiffness": "{per_length: 1e5}",
     "volumes.post.shape": "{box: {centre: [30, 40, -5], size: [2, 2, 2], rotation_deg: [0, 0, 0]}}",
     "contact.between_lines.pairs": "[{lines: [mooring, riser], normal_stiffness: {per_area: 1e6}}]",
     "lines.mooring.end_a.anchor": "[70, 0, -49.9]", "contact.lines": "[mooring, riser]", "contact.volumes": "[post]"},
    {"environment.waves": "{spectrum: {rows: [[0.05, 0], [0.1, 4], [0.2, 1]], frequency: hz, direction_deg: 0, seed: 1, components: 10, spreading: 0}}",
     "bodies.vessel.motion": "{table: {rows: [[0, 0, 0, 0], [10, 1, 0, 0]], interpolation: linear}}",
     "volumes.post.shape": "{sphere: {centre: [30, 40, -5], radius: 2}}", "volumes.post.normal_stiffness": "{allowed_penetration: 0.01}"},
    {"environment.waves": "{spectrum: {file: spectrum.txt}}", "bodies.vessel.motion": "{table: {file: motion.txt}}",
     "volumes.post.shape": "{capsule: {from: [30, 40, -5], to: [30, 45, -5], radius: 1}}",
     "volumes.post.normal_stiffness": "{table: [[0.01, 1e4], [0.02, 3e4]], per: length}", "volumes.post.smoothing": "null",
     "volumes.post.friction": "0.3"},
    {"environment.waves": "{components: [{height: 1, period: 6, direction_deg: 0, phase_deg: 0}, {height: 1, period: 9}]}",
     "bodies.vessel.motion": "{rao: {rows: [[8, 0, 1, 0, 0, 0, 1, 90, 0, 0, 1, 0, 0, 0]]}}",
     "volumes.post.shape": "{torus: {centre: [30, 40, -5], axis: [0, 0, 1], radius: 3, tube_radius: 0.5}}"},
    {"environment.waves": "{stokes: {height: 2, period: 8, direction_deg: 0, phase_deg: 0, current: 0, current_is: euler}}",
     "environment.current": "null", "volumes.post.shape": "{plane: {point: [0, 0, -60], normal: [0, 0, 1]}}",
     "bodies.vessel.motion.drift": "null", "bodies.vessel.motion.harmonic.amplitude": "[0, 0, 0]"},
    # Joints, soil, plastic and bent pipes, targets, start shapes.
    {"line_types.hard": "{outer_diameter: 0.2, mass_per_length: 60, EA: 1e9, EI: 1e7, GJ: 1e7, plasticity: {ramberg_osgood: {yield_moment: 2e5, A: 0.4, "
     "B: 12}}}",
     "line_types.soft": "{outer_diameter: 0.2, mass_per_length: 60, EA: 1e9, GJ: 1e7, plasticity: {table: [[0.02, 2e5], [0.1, 2.5e5]]}}",
     "lines.yielding": "{sections: [{type: hard, length: 10, elements: 4}, {type: soft, length: 10, elements: 4}], "
     "end_a: {anchor: [-30, 60, -20]}, end_b: free}",
     "lines.mooring.target": "{tension: 40e3, at: end_b, section: 2, between: [35, 50]}", "joints": "{knot: {start: [30, 0, -30], rigid: false}}",
     "lines.left": "{sections: [{type: bent, length: 15, elements: 4}], end_a: {anchor: [30, -20, -30]}, end_b: {joint: knot}}",
     "lines.right": "{sections: [{type: wire, length: 15, elements: 4}], end_a: {joint: knot}, end_b: {anchor: [30, 12, -30]}}",
     "lines.laid": "{sections: [{type: hose, length: 20, elements: 5}], end_a: {anchor: [-60, -60, -49]}, end_b: {anchor: [-60, -40.1, -48.9]}, start: {points: [[-60, -60, -49], [-60, -40.1, -48.9]]}, "
     "buried: [{from: 0, to: 10, resistance: {axial: 1e4, normal: 1e4}, mobilisation_length: {axial: 0.01, normal: 0.02}}]}"},
    {"lines.mooring.target": "{declination_deg: 40, at: end_b}", "volumes.post.shape": "{tube: {path: [[30, 40, 5], [30, 40, -10], [30, 50, -10], [40, 50, -10]], bend_radius: [3, 4], inner_radius: 0.25, wall_thickness: 0.05}}"},
    {"lines.mooring.target": "{touchdown: 15, at: end_b}", "lines.riser.temperature_change": "[[0, 20], [55, 10]]"}, {"lines.mooring.target": "{laid_length: 15}", "volumes.post.shape": "{tube: {path: [[30, 40, 5], [30, 40, -10], [30, 50, -10]], bend_radius: 3, inner_radius: 0.25, wall_thickness: 0.05}}"},
    # Platforms.
    {"bodies.barge": "{position: [200, 0, 0], floating: {mass: 5e5, inertia: [2e7, 6e7, 7e7], centre_of_mass: [0, 0, 1], "
     "loads: [{force: [100, 0, 0], moment: [0, 0, 10], at: [1, 0, 2], axes: body}, {table: {rows: [[0, 1, 0, 0], [10, 2, 0, 0]]}}], "
     "wind: {rows: [[0, 0.8, 0, 0], [60, 0.4, 0.6, 0.1], [120, -0.4, 0.6, -0.1], [180, -0.8, 0, 0]], angles: to, frontal_area: 100, "
     "lateral_area: 200, length: 40, at: [0, 0, 10], height: 10}, current: {file: flow.txt, angles: to, length: 40, draught: 3, at: [0, 0, -2]}, "
     "hydrodynamics: {wamit: barge, length_scale: 10, body: 1, origin_in_file: [0, 0, 0], displaced_volume: 500, gravity_in_stiffness: false, "
     "place: [200, 0, 0], heading_deg: 0, follow_period: 60, symmetry: none, excitation: true, second_order: newman, quadratic_damping: [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]], "
     "stiffness: [[1e3, 0, 0, 0, 0, 0], [0, 1e3, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e3]], damping: [[1e3, 0, 0, 0, 0, 0], [0, 1e3, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e3]], "
     "wave_drift_damping: {rows: [[5, 10, 20, 1e3], [10, 5, 10, 500]]}}, "
     "positioning: {place: [200, 0, 0], heading_deg: 0, proportional: [1e3, 1e3, 1e5], derivative: [1e4, 1e4, 1e6], integral: [10, 10, 1e3], "
     "filter_period: 20, max_force: 1e5, max_moment: 1e6}}}"},
    {"bodies.barge": "{position: [200, 0, 0], floating: {mass: 4000, inertia: [2e3, 6e3, 7e3], hydrodynamics: {bemio: buoy.h5}}}",
     "bodies.float": "{position: [230, 0, 0], floating: {mass: 4000, mass_matrix: {about: [0, 0, 0], rows: [[4000, 0, 0, 0, 10, 0], "
     "[0, 4000, 0, -10, 0, 0], [0, 0, 4100, 0, 0, 0], [0, -10, 0, 2e3, 0, 0], [10, 0, 0, 0, 6e3, 0], [0, 0, 0, 0, 0, 7e3]]}, "
     "hydrodynamics: {capytaine: buoy.nc}}}"},
    {"bodies.spar": "{position: [260, 0, 0], floating: {mass: 5e4, inertia: [1e6, 1e6, 1e5], centre_of_mass: [0, 0, -4], "
     "hull: {volumes: [column], wave_pressure: true}, "
     "members: [{from: [0, 0, -8], to: [0, 0, 2], diameter: 3, Cd: 1, Ca: 1, axial_Cd: 1, axial_Ca: 1}]}}",
     "volumes.column": "{shape: {cylinder: {from: [0, 0, -8], to: [0, 0, 2], radius: 1.5}}, body: spar, normal_stiffness: {per_point: 1e5}}"},
    {"farm": "{of: unit.yaml, name: T, heading_deg: 10, at: [[400, 300], [500, 300, 20]]}"}, {"farm": "{of: unit.yaml, at: {A: [400, 300]}}"},
    {"farm": "{of: unit.yaml, rows: {rows: 1, columns: 2, spacing: [100, 100], from: [400, 300], direction_deg: 10, stagger: 50}}"},
    {"farm": "[{of: unit.yaml, rows: {rows: 2, columns: 2, spacing: [100, 100], from: [400, 300], direction_deg: 10, stagger: 50}}, "
     "{of: unit.yaml, name: U, file: places.txt}]"},
    # Feeders, events, stages.
    {"lines.mooring.masses": "null", "lines.mooring.loads": "null", "bodies.clump": "null", "contact": "null", "output.clearances": "null",
     "lines.mooring.sections": "[{type: chain, length: 100, elements: 20}]",
     "lines.mooring.end_b": "{body: vessel, at: [3, 0, -1], feed: {stock: 15, tension: 3e4, dead_band: [2e4, 5e4], speed_per_tension: 1e-5, max_speed: 1}}",
     "links.spring": "{end_a: {body: vessel, at: [0, -5, 0]}, end_b: {body: buoy, at: [0, 0, 0]}, force_table: [[-1, -100], [1, 100]], rest_length: 60, "
     "damping_table: [[-1, -10], [1, 10]]}",
     "stages": "[one, two]",
     "events": "[{friction: {enabled: true}, stage: one}, {contact: {volume: post, enabled: false}, stage: two}, "
     "{name: cut, cut: {line: tail, at: 6}, time: 0.3}, {name: gone, release: {line: riser, end: end_b}, after: cut, delay: 0.1}, "
     "{attach: {line: riser, end: end_b, body: vessel, at: [10, 5, -40], within: 50, clamped: false}, after: gone, delay: 0.1}, "
     "{feed: {line: mooring, end: end_b, tension: 2e4, dead_band: [1e4, 3e4], speed_per_tension: 1e-5, max_speed: 1}, "
     "when: {tension: {line: mooring, at: end_b, above: 5e5}}}, "
     "{feed: {line: mooring, end: end_b, speed: 0.1, ramp: 0.1}, when: {paid_out: {line: mooring, end: end_b, above: 0.1}}}, "
     "{contact: {volume: post, enabled: true}, when: {position: {body: vessel, axis: z, above: 0.05}}}]"},
    {"lines.mooring.masses": "null", "lines.mooring.loads": "null", "bodies.clump": "null", "environment.current.ramp": "null",
     "lines.mooring.sections": "[{type: chain, length: 100, elements: 20}]",
     "lines.mooring.end_b": "{body: vessel, at: [3, 0, -1], feed: {stock: 15, speed_table: [[0, 0], [1, 0.1]]}}",
     "stages": "[one]", "events": "[{current: {factor: 0.5}, stage: one}, {cut: {line: tail, at: 6}, tension: 1e3}, "
     "{contact: {volume: post, enabled: true}, when: {position: {line: riser, at: 20, axis: z, below: -30}}}]"},
    {"lines.mooring.sections": "[{type: chain, length: 100, elements: 20}]",
     "lines.mooring.end_a": "{anchor: [70, 0, -50.9], feed: {stock: 15, speed: 0.1}}", "lines.mooring.masses": "null", "lines.mooring.loads": "null",
     "bodies.clump": "null", "stages": "[one]", "events": "[{feed: {line: mooring, end: end_a, paid_out: 1}, stage: one}]"},
    # A pipe over rollers, and start shapes from another run.
    {"supports": "{ramp: {body: vessel, line: laid, path: {from: [-30, -30, 2], direction: [-1, 0, 0], segments: [{length: 10}, {length: 20, radius: 60}]}, "
     "boxes: [{at: [0, 3], above_path: 0, type: V, roller_diameter: 0.3, roller_length: 0.6, angle_deg: 30, normal_stiffness: auto, "
     "relative_damping: 0.1, friction: {axial: 0.2, lateral: 0.2, kinetic: {axial: 0.1, lateral: 0.1}, blend_speed: 0.1, mobilisation_length: {axial: 0.01, lateral: 0.01}}}, {at: 5, type: U, roller_diameter: 0.3, roller_length: 0.6, side_height: 0.5}]}}",
     "lines.laid": "{sections: [{type: pipe, length: 110, elements: 16}], end_a: {body: vessel, at: [-28, -30, 2.3], direction: [-1, 0, 0], clamped: true}, "
     "end_b: {anchor: [-110, -30, -48]}}"},
    {"supports": "{ramp: {line: laid, boxes: [{points: [[-30, -30, 2], [-35, -30, 1.5]], type: flat, roller_diameter: 0.3, roller_length: 0.6, "
     "friction: 0.1}]}}",
     "lines.laid": "{sections: [{type: pipe, length: 110, elements: 16}], end_a: {body: vessel, at: [-28, -30, 2.3], direction: [-1, 0, 0], clamped: true}, "
     "end_b: {anchor: [-110, -30, -48]}}"},
    {"lines.riser.start": "{from: other.h5, time: 0, line: riser}"}, {"start": "{from: other.h5, time: 0}"},
)  # fmt: skip
REGULAR = "{regular: {height: 1, period: 6, direction_deg: 0, phase_deg: 0}}"
SEAS = [REGULAR] + [v["environment.waves"] for v in VARIANTS if "environment.waves" in v]  # the last one is a Stokes wave
VARIANTS += ({"environment.waves": "{sum: [" + ", ".join(SEAS[:-1]) + "]}"}, {"environment.waves": "{sum: [" + SEAS[-1] + "]}"})


def parsed(text):
    """A case as maps, lists and texts, with scalars as written."""
    import yaml

    return yaml.load(text, yaml.BaseLoader)


def written(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {written(inner)}" for key, inner in value.items()) + "}"
    return "[" + ", ".join(map(written, value)) + "]" if isinstance(value, list) else value


def cases():
    """The cases as trees."""
    for changes in VARIANTS:
        case = parsed(COMMON)
        for path, text in changes.items():
            *above, last = path.split(".")
            at = case
            for key in above:
                at = at[key]
            if text == "null":
                del at[last]
            else:
                at[last] = parsed(text)
        yield case


def forms(schema):
    """A schema, or its alternatives."""
    return [form for one in schema["anyOf"] for form in forms(one)] if "anyOf" in schema else [schema]


def keys_of(schema, path=()):
    """All keys of a schema, with `*` for names and `[]` for list indices."""
    for form in forms(schema):
        for name, inner in form.get("properties", {}).items():
            yield (*path, name)
            yield from keys_of(inner, (*path, name))
        for inner in form.get("patternProperties", {}).values():
            yield from keys_of(inner, (*path, "*"))
        if form.get("type") == "array":
            yield from keys_of(form["items"], (*path, "[]"))


def places_of(schema, value, key=(), place=()):
    """(key of the schema, place in a case, present) of everything that this part of a case has or may have; for
    lists of numbers also the first."""
    for form in forms(schema):
        if isinstance(value, dict) and form.get("type") == "object":
            for name, inner in form.get("properties", {}).items():
                yield (*key, name), (*place, name), name in value
                if name in value:
                    yield from places_of(inner, value[name], (*key, name), (*place, name))
            for inner in form.get("patternProperties", {}).values():
                for name in value:
                    yield from places_of(inner, value[name], (*key, "*"), (*place, name))
        elif isinstance(value, list) and form.get("type") == "array":
            for k, entry in enumerate(value):
                if isinstance(entry, (dict, list)):
                    yield from places_of(form["items"], entry, (*key, "[]"), (*place, k))
                elif k == 0:
                    yield (*key, "[]"), (*place, k), True


def changed(case, place, text):
    case = deepcopy(case)
    at = case
    for key in place[:-1]:
        at = at[key]
    at[place[-1]] = text
    return written(case) + "\n"


def sweep_places(schema):
    """{key: (number of a case, place)}: where each key is tried, preferably in a case that has it."""
    found = {}
    for k, case in enumerate(cases()):
        for key, place, there in places_of(schema, case):
            if key not in found or there and not found[key][2]:
                found[key] = (k, place, there)
    return found


SENTENCE = re.compile(r"\A[^\n]*(case\.yaml|unit\.yaml|bed\.|box\.|other\.h5)[^\n]*\n?\Z")
NO_NUMBER = re.compile(r"(?<![\w./])[-+]?(nan|inf)\b", re.IGNORECASE)


class Checker:
    """One process that checks cases in sequence; restarted after a crash."""

    def __init__(self, program, folder):
        self.program, self.folder, self.process = program, folder, None

    def wrong(self, place):
        """Exit code and complaint of the check of the case in a folder; an empty complaint means success."""
        if not self.process:
            self.errors = tempfile.TemporaryFile()
            self.process = subprocess.Popen([self.program, self.folder / "said.txt"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=self.errors)
        self.process.stdin.write(f"{place}\n".encode())
        self.process.stdin.flush()
        alarm = threading.Timer(PATIENCE, self.process.kill)
        alarm.start()
        answer = self.process.stdout.readline().decode("utf-8", "backslashreplace")
        alarm.cancel()
        self.errors.seek(0)
        stderr = self.errors.read().decode("utf-8", "backslashreplace")
        if not answer or stderr:
            code = self.process.wait() if not answer else answer.split()[0]
            self.end()
            return -1, f"check ends with {code} and {stderr[:300]!r}"
        code, _, sentence = answer.partition(" ")
        if code not in ("0", "2") or code == "2" and not SENTENCE.match(sentence):
            return int(code), f"check: exit code {code}: {sentence[:400]!r}"
        shown = (self.folder / "said.txt").read_text(errors="replace")
        for line in (shown + sentence).splitlines()[1:]:  # the first line is the title
            if NO_NUMBER.search(re.sub(r"'[^']*'", "", line)):  # quoted parts of the case are excluded
                return int(code), f"check prints {line[:300]!r}"
        return int(code), ""

    def end(self):
        if self.process:
            self.process.stdin.close()
            self.process.stdout.close()
            self.process.kill()
            self.process.wait()
            self.process = None


# Files written by a run, with or without `output.file`, and its printed output.
RESULTS = ("out.", "case.h5", "case.xdmf", "said.txt")


def state(folder):
    return {file.name: file.read_bytes() for file in folder.iterdir() if not file.name.startswith(RESULTS)}


def run_wrong(program, folder):
    before = state(folder)
    try:
        done = subprocess.run([program, "run", "case.yaml"], cwd=folder, capture_output=True, timeout=PATIENCE, check=False, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return f"run takes over {PATIENCE:g} s"
    stderr = done.stderr.decode("utf-8", "backslashreplace")
    if done.returncode not in (0, 2, 3, 4):
        return f"run: exit code {done.returncode}: {stderr[:400]!r}"
    if done.returncode in (2, 3) and (len(stderr.splitlines()) != 1 or not stderr.startswith("hawser: ")):
        return f"run: not one sentence: {stderr[:400]!r}"
    if done.returncode in (0, 4) and stderr:
        return f"run: on stderr {stderr[:400]!r}"
    if state(folder) != before:
        return "run: a file is other than before"
    return ""


def sweep(program, checker, runs=False, only=None, jobs=2, values=VALUES, share=1):
    """Complaints, and numbers of changed cases that were accepted and refused. share: each key is tried with
    one in `share` of the values, successive keys with different values."""
    program, checker = Path(program).resolve(), Path(checker).resolve()
    schema = json.loads(subprocess.run([program, "schema", "--json"], capture_output=True, check=True).stdout)
    all_cases, places = list(cases()), sweep_places(schema)
    missing = sorted(".".join(key) for key in keys_of(schema) if key not in places)
    complaints = [f"{key}: stands in no case of the sweep" for key in missing]
    tries = [(key, *places[key][:2], value) for n, key in enumerate(places) for value in values[n % share :: share]
             if not only or ".".join(key).startswith(only)]
    with tempfile.TemporaryDirectory(prefix="hawser-sweep-") as name:
        top = Path(name)
        for worker in range(jobs):
            (top / str(worker)).mkdir()
            for file, text in TABLES.items():
                (top / str(worker) / file).write_text(text)
            write_coefficients(top / str(worker))
        make_other(program, top, jobs)
        free = queue.SimpleQueue()
        for worker in range(jobs):
            free.put(Checker(checker, top / str(worker)))

        def one(attempt):
            key, k, place, value = attempt
            own = free.get()
            try:
                (own.folder / "case.yaml").write_text(changed(all_cases[k], place, value))
                code, complaint = own.wrong(own.folder)
                if code == 0 and not complaint and runs and (".".join(key), value) not in TOO_LONG:
                    complaint = run_wrong(program, own.folder)
            finally:
                free.put(own)
            return code, complaint and f"{'.'.join(key)} = {value} (case {k}, {'.'.join(map(str, place))}): {complaint}"

        with ThreadPoolExecutor(jobs) as pool:
            results = list(pool.map(one, tries))
            unchanged = []
            for k, case in enumerate(all_cases):
                own = free.get()
                (own.folder / "case.yaml").write_text(written(case) + "\n")
                code, complaint = own.wrong(own.folder)
                if code != 0 or complaint:
                    unchanged.append(f"case {k} as it is: {code}, {complaint or 'refused'}")
                free.put(own)
        for _ in range(jobs):
            free.get().end()
    codes = [code for code, _ in results]
    return complaints + unchanged + [c for _, c in results if c], {code: codes.count(code) for code in sorted(set(codes))}


def make_other(program, top, jobs):
    """Results of another run, used as start shapes."""
    case = parsed(COMMON)
    del case["dynamics"]
    (top / "0/case.yaml").write_text(written(case) + "\n")
    done = subprocess.run([program, "run", "case.yaml", "-q", "-o", "other.h5"], cwd=top / "0", capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr)
    for worker in range(1, jobs):
        (top / str(worker) / "other.h5").write_bytes((top / "0/other.h5").read_bytes())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    build = ROOT / "build"
    parser.add_argument("--program", default=os.environ.get("HAWSER", str(build / "hawser")))
    parser.add_argument("--checker", default=str(build / "tests/check_many"))
    parser.add_argument("--runs", action="store_true")
    parser.add_argument("--only")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    complaints, codes = sweep(given.program, given.checker, given.runs, given.only, given.jobs)
    print(*complaints, sep="\n")
    print(f"exit codes {codes}, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())

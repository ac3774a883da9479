"""Messages about the position at rest: lines below the water of a case without a seabed, platforms that rest at another height
or far from upright. `hawser run` and `hawser check` have the same."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run, write

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))

CHAIN = """\
hawser: 1
environment: {water: {depth: 200}}
line_types: {chain: {outer_diameter: 0.18, mass_per_length: 200, EA: 800 MN, bending: false}}
lines:
  chain: {sections: [{type: chain, length: 850, elements: 40}], end_a: {anchor: [-800, 0, -200]}, end_b: {anchor: [-20, 0, -14]}}
"""

# A hemisphere of 5 m, whose metacentre is at the centre of the sphere. Its mass is that of 300 m³ of water, and it displaces
# 261.8 m³ at a draught of 5 m, with a waterplane of 78.54 m²: it floats 38.2/78.54 m = 0.486 m lower.
FLOAT = """\
hawser: 1
environment: {gravity: 9.81, water: {density: 1000, depth: 100}}
bodies:
  float:
    floating:
      mass: 300000
      centre_of_mass: [0, 0, -2]
      inertia: [2.6e6, 2.6e6, 2.6e6]
      stiffness: [1e4, 1e4, 0]
      turning_stiffness: [0, 0, 1e6]
      hydrodynamics: {wamit: float, length_scale: 5, displaced_volume: 261.8}
      loads: [{moment: [0, 2e6, 0]}]
"""

BARGE = """\
hawser: 1
environment: {{water: {{density: 1025, depth: 50}}}}
bodies:
  barge: {{{place}floating: {{mass: {mass} t, centre_of_mass: [2, 0, 0.5], inertia: [4.0e6, 1.4e7, 1.5e7], hull: {{volumes: [box]}},
          members: [{{from: [0, 0, 0], to: [1, 0, 0], diameter: 0.1, Cd: 0, Ca: 0}}]}}}}
volumes: {{box: {{shape: {{box: {{centre: [0, 0, 0], size: [20, 10, 4]}}}}, body: barge}}}}
dynamics: {{duration: 0.1}}
"""

# A crate of 98 kN on a floor with friction 0.5, and a rope to an anchor at the height of its end. Rope and crate pull apart by
# less than the friction.
MODULE = """hawser: 1
environment: {water: {density: 1025, depth: 100}}
line_types: {wire: {outer_diameter: 0.03, mass_per_length: 3, EA: 20 MN, bending: false}}
bodies:
  barge: {position: [0, 0, 0], floating: {mass: 410000, inertia: [4e6, 1.4e7, 1.7e7], hull: {volumes: [deck]}}}
  module: {position: [0, 2, 3], floating: {mass: 20000, inertia: [13000, 13000, 13000], weight: true}}
volumes:
  deck: {shape: {box: {centre: [0, 0, 0], size: [20, 10, 4]}}, body: barge, friction: 0.4}
  base: {shape: {box: {centre: [0, 0, 0], size: [2, 2, 2]}}, body: module, normal_stiffness: {per_point: 2.5e6}, friction: 0.4}
lines:
  crane: {sections: [{type: wire, length: 6.3, elements: 20}], end_a: {anchor: [0, 2, 10]}, end_b: {body: module, at: [0, 0, 1]}}
dynamics: {duration: 0.1}
"""

CRATE = """\
hawser: 1
volumes:
  floor: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, friction: 0.5}
  crate: {shape: {box: {centre: [0, 0, 0], size: [2, 2, 2]}}, body: crate, normal_stiffness: {per_length: 1.0e7}, friction: 0.5}
bodies: {crate: {position: [0, 0, 1], floating: {mass: 10 t, inertia: [6667, 6667, 6667], weight: true}}}
line_types: {rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1.0e8, bending: false}}
lines:
  rope:
    sections: [{type: rope, length: 31, elements: 30}]
    end_a: {body: crate, at: [1, 0, 1]}
    end_b: {anchor: [31, 0, 9]}
contact: {lines: []}
"""


# A slender block on a slope of 20 degrees. Friction holds it there, but it topples beyond atan(1/3) = 18.4 degrees.
SLENDER = """\
hawser: 1
bodies:
  block:
    position: [-0.513, 0, 1.4095]
    rotation_deg: [0, -20, 0]
    floating: {mass: 2000, inertia: [1667, 1667, 333], weight: true}
volumes:
  slope: {shape: {plane: {point: [0, 0, 0], normal: [-0.34202014332566877, 0, 0.9396926207859083]}}, friction: 1}
  block: {shape: {box: {centre: [0, 0, 0], size: [1, 1, 3]}}, body: block, normal_stiffness: {per_point: 1.0e7}, friction: 1}
statics: {contact_friction: true}
"""


class RestMessagesTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def texts(self, case, *changes):
        """Output of `hawser check`, and of `hawser run` on one rank and on two."""
        write(self.folder, "case.yaml", case)
        settings = [word for change in changes for word in ("--set", change)]
        for command in ((HAWSER, "check"), (HAWSER, "run"), ("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2", HAWSER, "run")):
            done = run(*command, "case.yaml", *settings, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            yield done.stdout + done.stderr

    def test_line_below_the_water(self):
        below = r"note: lines\.chain: at rest \d\d(\.\d+)? m below the bottom of the water, whose depth is 200 m, since the case has no seabed: " \
                r"give 'environment: {seabed: {depth: 200}}'"
        for text in self.texts(CHAIN):
            self.assertRegex(text, below)
        slope = "since the case has no seabed: give a 'seabed' through its anchors, of which one is down there: 'depth' with 'slope_deg', or 'grid'"
        for text in self.texts(CHAIN, "lines.chain.end_a.anchor[2]=-240"):
            self.assertIn(slope, text)
        for changes in (["environment.seabed={depth: 200}"], ["lines.chain.sections[0].length=804"], ["environment.water.depth=280"]):
            for text in self.texts(CHAIN, *changes):
                self.assertNotIn("below the bottom of the water", text)

    def test_platform_at_rest(self):
        """The heel is asin(moment/(weight 2 m)) = 19.9 deg; a tenth of the moment heels it by 1.95 deg. The waterplane comes down by
        0.486 m, the centre of mass, 2 m below it, by 2 m (1 - cos 19.9 deg) less. A centre of mass 0.9 m beside the axis and 2 m below
        the origin heels it by atan(0.45), about the origin."""
        for ending in ("1", "hst"):
            shutil.copy(ROOT / f"tests/data/hemisphere.{ending}", self.folder / f"float.{ending}")
        write(self.folder, "float.3", "5 0 3 1 0 1 0\n6 0 3 1 0 1 0\n")
        lower = "warning: body float comes to rest 0.367 m lower than its initial position"
        tilted = "warning: body float comes to rest 19.9 deg from upright, and the hydrostatics and wave forces of its files are linear"
        for text in self.texts(FLOAT):
            self.assertEqual(text.count(lower), 1, text)
            self.assertEqual(text.count(tilted), 1, text)
        for text in self.texts(FLOAT, "bodies.float.floating.mass=261800", "bodies.float.floating.loads[0].moment[1]=2e5"):
            self.assertNotIn("comes to rest", text)
        for text in self.texts(FLOAT, "bodies.float.floating.mass=261800", "bodies.float.floating.loads[0].moment[1]=0",
                               "bodies.float.floating.centre_of_mass=[0.9, 0, -2]"):
            self.assertIn("warning: body float comes to rest 24.2 deg from upright", text)
            self.assertNotIn("than its initial position", text)

    def test_heel_alone(self):
        """A barge of 400 m³ whose centre of mass is 2 m ahead of its middle heels about its origin, 7.5 deg, also if it starts turned or
        heeled. 41 t more sink it by 41/1.025/200 m = 0.2 m along its axis."""
        for place in ("", "position: [3, 4, 0], rotation_deg: [0, 0, 40], ", "rotation_deg: [0, 5, 0], "):
            for text in self.texts(BARGE.format(place=place, mass=410)):
                self.assertNotIn("comes to rest", text)
            for text in self.texts(BARGE.format(place=place, mass=451)):
                self.assertRegex(text, r"warning: body barge comes to rest 0\.(19\d|2) m lower than its initial position")

    def test_hull_below_the_bottom(self):
        below = "note: volumes.box: reaches 1 m below the bottom of the water, whose depth is 1 m, where body 'barge' starts"
        case = BARGE.format(place="", mass=410)
        for text in self.texts(case, "environment.water.depth=1"):
            self.assertEqual(text.count(below), 1, text)
        for text in self.texts(case):
            self.assertNotIn("below the bottom", text)

    def test_body_moved_without_friction(self):
        """The rope hangs from the anchor and lies slack towards the crate, which slides until the rope pulls vertically: by metres."""
        moved = r"note: bodies\.crate: statics moves it by \d+(\.\d+)? m along volume floor, on which it rests, without their friction of " \
                r"0\.5; set 'statics: {contact_friction: true}' if friction holds it"
        for text in self.texts(CRATE):
            self.assertRegex(text, moved)
        for text in self.texts(CRATE, "statics={contact_friction: true}"):
            self.assertNotIn("statics moves it", text)

    def test_block_that_topples(self):
        for text in self.texts(SLENDER):
            self.assertIn("bodies.block: statics topples or rolls it on volume slope: at rest it is tilted by 90 degrees from its "
                          "initial position; if", text)

    def test_body_that_leaves_its_deck(self):
        """A module eccentric on a barge; its crane wire is slack. Without friction the barge heels, and the module slides off it
        until it hangs from the wire."""
        left = r"note: bodies\.module: statics moves it off volume deck, on which it starts, without their friction of 0\.4; " \
               r"set 'statics: {contact_friction: true}' if friction holds it there"
        for text in self.texts(MODULE):
            self.assertRegex(text, left)
            self.assertNotIn("bodies.barge: statics", text)
        for text in self.texts(MODULE, "statics={contact_friction: true}"):
            self.assertNotIn("statics moves it", text)


if __name__ == "__main__":
    unittest.main()

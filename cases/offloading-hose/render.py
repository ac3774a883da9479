"""Pictures of the hose and the ship, from above, coloured by effective tension.

    scripts/render cases/offloading-hose/offloading-hose.xdmf out/

The options of scripts/render.py apply, for example --field contact_normal_force, or --at 60 200 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# The stern from above, north up; the hose is drawn 2 m thick. Stowed, on its way, arriving, and at rest on the hull.
main(field="effective_tension", diameter=2.0, direction=[0.25, 0.25, -1.0], focus=[-15.0, -105.0, 0.0], height=190.0,
     size=[640, 560], columns=2, at=[0.0, 80.0, 140.0, 400.0])

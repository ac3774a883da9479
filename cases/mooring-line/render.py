"""Pictures of the chain, coloured by effective tension.

    scripts/render cases/mooring-line/mooring-line.xdmf out/

The options of scripts/render.py apply, for example --field seabed_force, or --at 30 35 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From the side, the chain drawn 4 m thick; at the trough and the crest of the fairlead's heave.
main(field="effective_tension", diameter=4.0, direction=[0.0, 1.0, -0.12], focus=[405.0, 0.0, -100.0], height=330.0,
     size=[1100, 420], columns=1, at=[47.5, 52.5])

"""Pictures of the buoy and its chains, coloured by effective tension.

    scripts/render cases/parted-mooring/parted-mooring.xdmf out/

The options of scripts/render.py apply, for example --at 78 84 200 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From above the side, the chains drawn 2 m thick, while the parted chain falls.
main(field="effective_tension", diameter=2.0, direction=[0.25, 1.0, -0.45], focus=[-40.0, 0.0, -40.0], height=230.0,
     size=[1100, 420], columns=1, at=[84.0])

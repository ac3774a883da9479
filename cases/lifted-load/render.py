"""Pictures of the module that swings against its fenders.

    scripts/render cases/lifted-load/lifted-load.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From the side, a little from above and behind: at rest, swinging away, and twice on the fenders.
main(direction=[-0.35, 1.0, -0.25], focus=[0.5, 0.0, 22.0], height=44.0, size=[520, 900], at=[0, 13, 17.5, 30])

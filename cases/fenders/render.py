"""Pictures of the vessel that drifts against the platform.

    scripts/render cases/fenders/fenders.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From above, a little from the side; the beginning, the first fender at work, the second, and afterwards.
main(direction=[0.0, 0.35, -1.0], focus=[6.0, 16.0, 0.0], height=75.0, size=[700, 600], at=[0, 4, 20, 40])

"""Pictures of the spar in its sea.

    scripts/render cases/spar-buoy/spar-buoy.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.25, 1.0, -0.1], focus=[0.0, 0.0, -150.0], height=370.0, size=[900, 560], at=[0, 120])

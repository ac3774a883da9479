"""Pictures of the hawser that comes to lie along a pontoon.

    scripts/render cases/barge-hawser/barge-hawser.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From above its side: at rest, lying along the side, and clear of it.
main(direction=[0.0, -1.0, -1.1], focus=[8.0, 8.0, 0.0], height=46.0, size=[900, 460], at=[0, 20, 45])

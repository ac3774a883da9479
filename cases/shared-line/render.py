"""Picture of the two platforms and their ropes.

    scripts/render cases/shared-line/shared-line.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.12, 1.0, -0.16], focus=[800.0, 0.0, -240.0], height=1180.0, size=[1400, 560], diameter=10.0, at=[390])

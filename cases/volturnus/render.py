"""Pictures of the VolturnUS-S on its chains in a storm.

    scripts/render cases/volturnus/volturnus.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.6, 1.0, -0.35], focus=[0.0, 0.0, -20.0], height=460.0, size=[900, 520], at=[1760])

"""Pictures of the supply vessel alongside the FPSO.

    scripts/render cases/side-by-side/side-by-side.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.5, 1.0, -0.6], focus=[0.0, -5.0, 2.0], height=75.0, size=[900, 520], at=[105])

"""Pictures of the FPSO on her mooring, with her risers.

    scripts/render cases/fpso/fpso.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.6, 1.0, -0.35], focus=[60.0, 20.0, -190.0], height=560.0, size=[900, 520], at=[910])

"""Pictures of the OC4 semisubmersible on its chains.

    scripts/render cases/oc4/oc4.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.6, 1.0, -0.35], focus=[0.0, 0.0, -40.0], height=330.0, size=[900, 520], at=[450])

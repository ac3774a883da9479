"""Pictures of the lay, coloured by bending moment.

    scripts/render cases/s-lay/simple.xdmf out/

The options of scripts/render.py apply, for example --field effective_tension, or --direction 0.3,1,-0.3.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# All of it at rest from the side, the pipe four times as thick as it is.
main(field="bending_moment", factor=4, direction=[0.0, 1.0, -0.12], focus=[-180.0, 0.0, -45.0], height=190.0,
     size=[1300, 560], columns=1, at=[0.0], no_names=True)

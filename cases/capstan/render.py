"""Pictures of the capstan: the rope on the drum, coloured by effective tension.

    scripts/render cases/capstan/capstan.xdmf out/
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(diameter=0.05, direction=[0.0, 1.0, -0.12], focus=[0.0, 0.0, -0.25], height=2.9, edges=True, columns=1)

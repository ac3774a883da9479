"""Mutants of a case and its files through the program, and many more checked in one process (fuzz.py; 10^4 of them,
under sanitizers, are part of scripts/test --full)."""
import os
import tempfile
import unittest
from pathlib import Path

from fuzz import fuzz, make, wrong
from support import ROOT

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))


CHECKER = Path(HAWSER).parent / "tests/check_many"


class Fuzz(unittest.TestCase):
    def fuzz(self, program, mutants, **settings):
        complaints, codes = fuzz(program, mutants=mutants, **settings)
        self.assertEqual(complaints, [])
        # Mutants are neither all refused nor all valid.
        self.assertGreater(codes.get(0, 0), mutants / 20)
        self.assertGreater(codes.get(2, 0), mutants / 20)

    def test_mutants(self):
        self.fuzz(HAWSER, 60)

    def test_mutants_in_one_process(self):
        self.fuzz(CHECKER, 1500, many=True)

    def test_a_checker_that_dies(self):
        with tempfile.TemporaryDirectory() as name:
            program = Path(name) / "program"
            for script, output in (("read x; kill -SEGV $$", "exit code -11"), ("read x; echo 1 odd; read x", "exit code 1: 'odd"),
                                 ("read x; echo 2 odd; read x", "exit code 2: 'odd"), ("read x; echo odd >&2; echo 0; read x", "odd")):
                program.write_text(f"#!/bin/bash\n{script}\n")
                program.chmod(0o755)
                complaints, _ = fuzz(program, mutants=2, jobs=1, many=True)
                self.assertEqual(len(complaints), 2, script)
                self.assertIn(output, complaints[0])

    def test_complains(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            make(0, folder)
            for script, output in (
                ("kill -SEGV $$", "exit code -11"),
                ("echo hawser: odd >&2; exit 2", "not one sentence"),
                ("echo hawser: case.yaml:1: odd >&2; echo more >&2; exit 2", "not one sentence"),
                ("echo 'x.cpp:1: runtime error: odd' >&2; exit 0", "runtime error"),
                ("sleep 5", "takes over 1 s"),
                ("exit 1", "exit code 1"),
            ):
                program = folder / "program"
                program.write_text(f"#!/bin/bash\n{script}\n")
                program.chmod(0o755)
                self.assertIn(output, wrong(str(program), "check", folder, (0, 2), 1)[1])
            program.write_text("#!/bin/bash\necho hawser: case.yaml:1: odd >&2; exit 2\n")
            self.assertEqual(wrong(str(program), "check", folder, (0, 2), 1), (2, ""))


if __name__ == "__main__":
    unittest.main()

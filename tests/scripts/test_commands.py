"""First commands of a new user work before anything is built."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from support import ROOT, run

SHELL = ["scripts/install-deps", "scripts/run", "scripts/test", "scripts/format", "scripts/render", "scripts/package",
         ".ci/run"]


class Commands(unittest.TestCase):
    def test_shell_syntax_and_mode(self):
        for script in SHELL + ["scripts/env.sh"]:
            with self.subTest(script=script):
                self.assertEqual(run("bash", "-n", ROOT / script).returncode, 0)
        for script in SHELL + ["scripts/check-includes", "scripts/check-docs"]:
            self.assertTrue(os.access(ROOT / script, os.X_OK), script)

    def test_run_without_arguments_lists_the_cases(self):
        result = run("scripts/run")
        self.assertEqual(result.returncode, 2)
        self.assertIn("Usage: scripts/run CASE", result.stdout)
        for case in ROOT.glob("cases/*/*.yaml"):
            self.assertIn(str(case.relative_to(ROOT)), result.stdout)

    def test_run_refuses_what_it_does_not_understand(self):
        for arguments, complaint in [
            (["no-such-case"], "no such case: no-such-case"),
            (["reel", "-n", "two"], "'two' is not a number of processes"),
            (["reel", "-n"], "-n needs a number"),
            (["reel", "other"], "one case at a time"),
        ]:
            with self.subTest(arguments=arguments):
                result = run("scripts/run", *arguments)
                self.assertEqual(result.returncode, 2)
                self.assertIn(complaint, result.stderr)

    def test_unknown_arguments(self):
        for script in ["scripts/install-deps", "scripts/test", "scripts/format", "scripts/package"]:
            with self.subTest(script=script):
                result = run(script, "--no-such-thing")
                self.assertEqual(result.returncode, 2)
                self.assertIn("--no-such-thing", result.stderr)
                self.assertEqual(run(script, "--help").returncode, 0)

    def test_install_deps_lists_and_notices_what_is_there(self):
        listed = run("scripts/install-deps", "--list").stdout.split()
        for package in ["petsc-dev", "libhdf5-openmpi-dev", "libmetis-dev", "g++", "cmake"]:
            self.assertIn(package, listed)
        self.assertNotIn("paraview", listed)
        self.assertIn("paraview", run("scripts/install-deps", "--list", "--view").stdout.split())
        self.assertNotIn("lintian", listed)
        self.assertIn("lintian", run("scripts/install-deps", "--list", "--package").stdout.split())

    def test_install_deps_names_what_is_missing(self):
        # An empty machine, simulated by a dpkg-query without packages, a user who needs no sudo, and an
        # apt-get that
        # records its arguments and can install only after an update (or never).
        apt = ('echo "$*" >>"$0.log"; '
               'case $1 in update) : >"$0.lists";; install) [ -e "$0.lists" ] && [ {works} = 1 ];; esac')
        for works in (1, 0):
            with self.subTest(works=works), tempfile.TemporaryDirectory() as folder:
                for name, body in [("dpkg-query", ":"), ("id", "echo 0"), ("apt-get", apt.format(works=works))]:
                    path = Path(folder) / name
                    path.write_text(f"#!/bin/sh\n{body}\n", encoding="utf-8")
                    path.chmod(0o755)
                for tool in ["bash", "sed", "tr", "grep", "env", "sh", "mktemp", "rm", "cat"]:
                    os.symlink(shutil.which(tool), Path(folder) / tool)
                result = run("scripts/install-deps", env={"PATH": folder})
                self.assertEqual(result.returncode, 1 - works, result.stderr)
                asked = (Path(folder) / "apt-get.log").read_text(encoding="utf-8").splitlines()
                self.assertIn("update -qq", asked)
                self.assertIn("--no-install-recommends", asked[-1])
                for package in run("scripts/install-deps", "--list").stdout.split():
                    self.assertIn(f" {package}", asked[-1])

    def test_env_keeps_what_is_set(self):
        text = f'. "{ROOT}/scripts/env.sh"; echo $OMP_NUM_THREADS $OMPI_ALLOW_RUN_AS_ROOT $(hawser_jobs)'
        threads, root, jobs = run("bash", "-c", text, env={**os.environ, "OMP_NUM_THREADS": "3"}).stdout.split()
        self.assertEqual((threads, root), ("3", "1"))
        self.assertGreaterEqual(int(jobs), 1)
        # A single OpenMP thread does not imply a single core.
        one = run("bash", "-c", f'. "{ROOT}/scripts/env.sh"; hawser_cores', env={**os.environ, "OMP_NUM_THREADS": "1"})
        self.assertEqual(int(one.stdout), len(os.sched_getaffinity(0)))


if __name__ == "__main__":
    unittest.main()

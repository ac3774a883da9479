"""The tree's includes point down, and scripts/check-includes finds each kind of wrong one."""
import tempfile
import unittest

from support import check_trees, run

SOUND = {
    "include/hawser/base/error.hpp": "#include <petscsys.h>\n",
    "include/hawser/math/types.hpp": "#include <Eigen/Dense>\n#include <cmath>\n",
    "include/hawser/geometry/box.hpp": '#include "hawser/math/types.hpp"\n',
    "include/hawser/model/case.hpp": '#include "hawser/math/types.hpp"\n#include <vector>\n',
    "src/run/driver.cpp": '#include "hawser/base/error.hpp"\n#include "hawser/model/case.hpp"\n#include "local.hpp"\n',
    "src/run/local.hpp": "#include <mpi.h>\n",
    "src/CMakeLists.txt": "hawser_module(math dep_eigen)\nhawser_module(geometry math dep_eigen)\n",
}
# Planted includes, and a part of the expected complaint.
WRONG = [
    ("src/mesh/a.cpp", '#include "hawser/io/reader.hpp"\n', "src/mesh/a.cpp:1: hawser/io/reader.hpp: upward"),
    ("include/hawser/state/a.hpp", "\n#include <hawser/terms/t.hpp>\n", "a.hpp:2: hawser/terms/t.hpp: upward"),
    ("src/io/a.cpp", '#include "hawser/solve/statics.hpp"\n', "do not see each other"),
    ("src/solve/a.cpp", '#include "hawser/io/xdmf.hpp"\n', "do not see each other"),
    ("src/kernels/a.cpp", '#include "hawser/base/error.hpp"\n', "kernels is to be read and used alone"),
    ("src/math/a.cpp", '#include "hawser/geometry/box.hpp"\n', "math is to be read and used alone"),
    ("src/geometry/a.cpp", "#include <fmt/format.h>\n", "nothing but Eigen"),
    ("src/geometry/b.cpp", "#  include <petscmat.h>\n", "nothing but Eigen"),
    ("include/hawser/model/a.hpp", "#include <mpi.h>\n", "neither PETSc nor MPI"),
    ("include/hawser/model/b.hpp", '#include "hawser/base/error.hpp"\n', "error.hpp -> petscsys.h: model knows"),
    ("src/advice/a.cpp", "#include <petscvec.h>\n", "advice knows neither PETSc nor MPI"),
    ("src/terms/a.cpp", '#include "../system/sink.hpp"\n', "nor a file beside it"),
    ("src/terms/b.cpp", '#include "hawser/shed/tool.hpp"\n', "no such module"),
    ("src/shed/tool.cpp", "#include <vector>\n", "not in a module"),
    ("src/CMakeLists.txt", "hawser_module(mesh model solve dep_mpi)\n", "CMakeLists.txt:1: solve: upward"),
    ("src/CMakeLists.txt", "hawser_module(math dep_petsc)\n", "math links nothing but Eigen"),
]


class Includes(unittest.TestCase):
    def test_tree(self):
        result = run("scripts/check-includes")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_wrong_files_are_found(self):
        check_trees(self, "scripts/check-includes", SOUND, WRONG)

    def test_empty_tree_fails(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertEqual(run("scripts/check-includes", root).returncode, 1)


if __name__ == "__main__":
    unittest.main()

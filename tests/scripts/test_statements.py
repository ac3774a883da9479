"""C++ sources have one statement per line: scripts/check-statements finds those joined by commas."""
import tempfile
import unittest
from pathlib import Path

from support import check_trees, run, write

SOUND = {
    "src/io/a.cpp": """// a = 1, b = 2;
#define BOTH(a, b) a = 1, b = 2;
const char* text = "a = 1, b = 2;";
int a = 0, b[2] = {0, 1}, *c = nullptr;
Vec3 low = Vec3::Zero(), high = Vec3(1, kTop, M_PI);
int f(int p, int q);
struct Both {
  int made = 0, lost = 0;
} both, other{};
enum class Kind { one, two };
const std::vector<Pair> kPairs = {{"a", 1}, {"b", 2}};
std::map<int, int> map;
std::array<int, kPairs.size()> all{}, none{};
using std::abs, std::sqrt;
Both::Both(int x) : made(x), lost{x} {}
void f(int x, int y) {
  for (int i = 0, j = 1; i < x; ++i, --j) g(i, j);
  m << 1, 2, 3;
  const auto h = [&, y](int k) -> std::pair<int, int> { return {k, y}; };
  std::sort(v.begin(), v.end(), [](int p, int q) { return p < q; });
  g(x, h<int, int>(y));
  if (const auto [p, q] = h(x); p < q) return;
  auto [s, t] = h(y);
  switch (x) {
    case 1: return g(x, y);
    default: break;
  }
}
""",
}
WRONG = [("src/io/b.cpp", f"void f() {{\n  {statement}\n}}\n", "src/io/b.cpp:2: ")
         for statement in ("a = 1, b = 2;", "if (a) b = 1, c = 2;", "for (int i = 0; i < 2; ++i) a += i, b -= i;", "g(a, b), h(c);",
                           "return (void)a, b;", "else ++a, --b;", "case 1: a = f<int, int>(b), c = 0;", "(void)a, (void)b;",
                           "g([&](int k) { a = k, b = k; });", "const auto h = [](int& k) { ++k, ++k; };", "x[0] = {1, 2}, y = 3;",
                           "std::fputs(a, b), std::fputs(c, d);",
                           "const double a = g(1), b = 2;", "auto &a = b, &c = d;", "Vec3 a(b), c(d);", "const std::array<int, 2> a{b, c}, d{};",
                           "double a, b = c;", "unsigned a = 0, b = a;")]


class Statements(unittest.TestCase):
    def test_tree(self):
        result = run("scripts/check-statements")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_joined_statements_are_found(self):
        check_trees(self, "scripts/check-statements", SOUND, WRONG)

    def test_rewriting(self):
        with tempfile.TemporaryDirectory() as root:
            write(root, "src/a.cpp", "void f() {\n  if (a) b = g(1, 2), c = 3;\n  else return d = 4, e;\n  x = 1,  // m\n  y = 2;\n}\n")
            run("scripts/check-statements", "--write", root)
            self.assertEqual((Path(root) / "src/a.cpp").read_text(encoding="utf-8"),
                             "void f() {\n  if (a) { b = g(1, 2);\n c = 3; }\n  else {  d = 4;\n return e; }\n  x = 1;  // m\n  y = 2;\n}\n")
            self.assertEqual(run("scripts/check-statements", root).returncode, 0)
            write(root, "src/a.cpp", "void f() {\n  const T &a = g(1, 2), &b = h<1, 2>();\n  for (;;) const int c = a, d = b;\n  U e(a),  // m\n      f{b};\n}\n")
            run("scripts/check-statements", "--write", root)
            self.assertEqual((Path(root) / "src/a.cpp").read_text(encoding="utf-8"),
                             "void f() {\n  const T &a = g(1, 2);\n const T &b = h<1, 2>();\n  for (;;) { const int c = a;\n"
                             " const int d = b; }\n  U e(a);  // m\n      U f{b};\n}\n")


if __name__ == "__main__":
    unittest.main()

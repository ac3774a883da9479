"""hawser view: its server delivers only the model, to browsers on this machine, for any request, and follows a file
in progress; before a run it shows the start shape."""
import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from urllib.parse import urlsplit

import h5py
import numpy as np

from support import ROOT, write
from synthetic import results_file

sys.path.insert(0, str(ROOT / "scripts"))
from hawser_post.results import Refusal  # noqa: E402
from hawser_post.viewer import blocks, libraries, served, start_shape  # noqa: E402
from hawser_post.viewer.server import ADDRESS, Server  # noqa: E402

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
REQUESTS = 10_000 if os.environ.get("HAWSER_FULL") else 600
CASE = """\
hawser: 1
environment: {water: {depth: 100}, seabed: {depth: 100}}
line_types: {chain: {library: chain-studless, diameter: 84 mm, grade: R3}}
lines:
  mooring:
    sections: [{type: chain, length: 500, elements: 40}]
    end_a: {anchor: [0, 0, -10]}
    end_b: {anchor: [480, 0, -100]}
"""


def run_of(path, outputs, nodes=50, written=None):
    """A results file of a line that rises, with `outputs` outputs, the first `written` of which are valid."""
    s = np.linspace(0, 10, nodes)
    x = np.zeros((outputs, nodes, 3))
    x[:, :, 0] = s
    x[:, :, 2] = np.arange(outputs)[:, None]
    tension = np.ones((outputs, nodes)) * np.arange(outputs)[:, None]
    results_file(path, np.arange(float(outputs)), {"line": s}, {"position": ("m", x), "effective_tension": ("N", tension)}, ended=False,
                 case="hawser: 1\ndynamics: {duration: 100 s}\n")
    if written:
        with h5py.File(path, "r+") as file:
            file["written"][0] = (written, 0)


@unittest.skipIf(libraries.missing(), libraries.missing())
class Served(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.file = self.folder / "run.h5"
        run_of(self.file, 30, written=20)
        write(self.folder, "secret.txt", "not for you")
        before, served.OFTEN = served.OFTEN, 0.0
        self.addCleanup(setattr, served, "OFTEN", before)
        self.server = Server(served.Shown(self.file))
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def ask(self, path, method="GET", host=None, key=True):
        connection = http.client.HTTPConnection(ADDRESS, self.server.server_port, timeout=30)
        try:
            connection.putrequest(method, f"/{self.server.key}/{path}" if key else path, skip_host=host is not None)
            if host is not None:
                connection.putheader("Host", host)
            connection.endheaders()
            answer = connection.getresponse()
            return answer.status, answer.read(), answer.headers
        finally:
            connection.close()

    def test_gives_page_header_and_blocks(self):
        code, page, headers = self.ask("")
        self.assertEqual((code, b"viewer.js" in page), (200, True))
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        header = json.loads(self.ask("header")[1])
        self.assertEqual((len(header["times"]), header["served"], header["lines"][0]["nodes"]), (20, True, 50))
        x = blocks.unpacked(self.ask("block/position/0")[1])
        self.assertEqual(x.shape, (20, 150))
        ends = blocks.unpacked(self.ask("block/ends/effective_tension/0")[1])
        np.testing.assert_allclose(ends, [np.arange(20), np.arange(20)], atol=1e-3)

    def test_listens_on_this_machine_only(self):
        self.assertEqual(self.server.server_address[0], "127.0.0.1")

    def test_other_hosts_other_keys_and_other_methods_are_refused(self):
        for host in ("evil.example", "127.0.0.1", f"evil.example:{self.server.server_port}", "", f"127.0.0.1:{self.server.server_port + 1}"):
            self.assertEqual(self.ask("header", host=host)[0], 403, host)
        self.assertEqual(self.ask("header", host=f"localhost:{self.server.server_port}")[0], 200)
        for path in ("/", "/header", "/wrong/header", "//header", "/%00/header"):
            self.assertEqual(self.ask(path, key=False)[0], 404, path)
        for method in ("POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE"):
            self.assertEqual(self.ask("header", method)[0], 501, method)
        self.assertEqual(self.ask("header", "HEAD")[1], b"")

    def test_nothing_outside_is_read(self):
        for path in ("../secret.txt", "..%2fsecret.txt", "%2e%2e/secret.txt", "block/../../secret.txt", "block/volume/..%2f..%2fcase/vertices",
                     "block//etc/passwd", "/etc/passwd", "block/position/99", "block/position/-1", "block/ends/position/0", "block/ends/x/0",
                     "block/ends/effective_tension/7", "block/series/../case", "secret.txt", "run.h5", "view.css/..", "..\\secret.txt",
                     "block/" + "a/" * 3000, "block/field/%c3%a9/0", "%ff%fe"):
            code, text, _ = self.ask(path)
            self.assertIn(code, (404, 414), path)
            self.assertNotIn(b"not for you", text)
            self.assertNotIn(b"root:", text)

    def test_what_is_no_request_ends_a_connection_and_nothing_else(self):
        for data in (b"\0" * 5000, b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"GET " + b"a" * 70000 + b" HTTP/1.1\r\n\r\n", b"\xff\xfe\r\n\r\n",
                     b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 500 + b"\r\n"):
            with socket.create_connection((ADDRESS, self.server.server_port), timeout=10) as open_socket:
                open_socket.sendall(data)
                open_socket.shutdown(socket.SHUT_WR)
                while True:
                    try:
                        if not open_socket.recv(65536):
                            break
                    except ConnectionResetError:
                        break
        self.assertEqual(self.ask("header")[0], 200)

    def test_many_requests(self):
        names = ["status", "header", "block/position/0", "../x", "block/field/effective_tension/0", ""]
        with ThreadPoolExecutor(24) as pool:
            codes = list(pool.map(lambda k: self.ask(names[k % len(names)])[0], range(REQUESTS)))
        self.assertEqual({code for k, code in enumerate(codes) if k % len(names) != 3}, {200})
        self.assertEqual({codes[k] for k in range(3, REQUESTS, len(names))}, {404})

    def test_a_run_is_followed(self):
        # From another process, as by the program.
        subprocess.run([sys.executable, "-c", "import h5py, sys; file = h5py.File(sys.argv[1], 'r+', locking=False); "
                        "file['written'][0] = (25, 0); file['messages'] = [b'note: of the line']", str(self.file)], check=True)
        os.utime(self.file, (time.time() + 5, time.time() + 5))
        status = json.loads(self.ask("status")[1])
        self.assertEqual((status["outputs"], status["time"], status["duration"], status["ended"]), (25, 24.0, 100.0, False))
        self.assertEqual(blocks.unpacked(self.ask("block/position/0")[1]).shape[0], 25)
        self.assertEqual(len(json.loads(self.ask("header")[1])["notes"]), 1)

    def test_another_file_in_its_place_has_another_stamp(self):
        stamp = json.loads(self.ask("status")[1])["stamp"]
        other = self.folder / "other.h5"
        run_of(other, 3, nodes=20)
        other.rename(self.file)
        status = json.loads(self.ask("status")[1])
        self.assertEqual(status["outputs"], 3)
        self.assertNotEqual(status["stamp"], stamp)

    def test_a_run_that_is_rewritten_at_its_end_keeps_its_stamp(self):
        stamp = json.loads(self.ask("status")[1])["stamp"]
        other = self.folder / "other.h5"
        run_of(other, 30)
        other.rename(self.file)
        status = json.loads(self.ask("status")[1])
        self.assertEqual((status["outputs"], status["stamp"]), (30, stamp))

    def test_a_file_that_shrinks_or_goes_is_survived(self):
        whole = self.file.read_bytes()
        for size in (len(whole) // 2, 2000, 100, 0):
            with self.file.open("r+b") as file:
                file.truncate(size)
            for name in ("status", "header", "block/position/0", "block/field/effective_tension/0"):
                self.assertIn(self.ask(name)[0], (200, 503), (size, name))
        self.file.unlink()
        self.assertIn(self.ask("header")[0], (200, 503))
        self.file.write_bytes(whole)
        code, text, _ = self.ask("header")
        self.assertEqual((code, len(json.loads(text)["times"])), (200, 20))

    def test_a_large_file_is_read_by_parts(self):
        run_of(self.folder / "large.h5", 300, 2000)
        shown = served.Shown(self.folder / "large.h5")
        header = shown.header()
        self.assertEqual(header["perBlock"], 166)
        self.assertEqual(blocks.unpacked(shown.block("position/1")).shape, (134, 6000))
        shown.close()

    def test_changes_are_of_cases(self):
        with self.assertRaisesRegex(Refusal, "--set changes a case file"):
            served.Shown(self.file, ["a=1"])

    def test_the_results_themselves_stay_as_they_are(self):
        before = self.file.read_bytes()
        for name in ("", "header", "block/position/0", "status"):
            self.ask(name)
        self.assertEqual(self.file.read_bytes(), before)


@unittest.skipIf(libraries.missing(), libraries.missing())
class Cases(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.before = os.environ.get("HAWSER")
        os.environ["HAWSER"] = HAWSER
        self.addCleanup(lambda: os.environ.update(HAWSER=self.before) if self.before else os.environ.pop("HAWSER"))
        before, served.OFTEN = served.OFTEN, 0.0
        self.addCleanup(setattr, served, "OFTEN", before)
        write(self.folder, "case.yaml", CASE)

    def test_before_a_run_there_is_the_start_shape_and_then_the_run(self):
        case = self.folder / "case.yaml"
        shown = served.Shown(case)
        self.addCleanup(shown.close)
        header = shown.header()
        self.assertEqual((shown.kind, len(header["times"]), header["fields"]), ("start", 1, []))
        self.assertRegex(header["missing"][-1], f"start shape.*: hawser run {case}$")
        x = blocks.unpacked(shown.block("position/0"))[0].reshape(3, -1).T + shown.model.centre
        np.testing.assert_allclose(x[[0, -1]], [[0, 0, -10], [480, 0, -100]], atol=2e-3)
        self.assertFalse((self.folder / "case.h5").exists())
        done = subprocess.run([HAWSER, "run", "-q", str(case)], check=False)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(shown.status()["kind"], "run")
        self.assertIn("effective_tension", [field["name"] for field in shown.header()["fields"]])
        # A changed case has its start shape again.
        write(self.folder, "case.yaml", CASE.replace("480", "470"))
        os.utime(case, (time.time() + 5, time.time() + 5))
        self.assertEqual(shown.status()["kind"], "start")

    def test_notes_of_the_check_stand_at_their_place(self):
        write(self.folder, "case.yaml", CASE + "    masses: [{at: 20, mass: 100}, {at: 400, mass: 5e6}]\n")
        shown = served.Shown(self.folder / "case.yaml")
        self.addCleanup(shown.close)
        notes = shown.header()["notes"]
        self.assertEqual([(note["kind"], re.search(r"masses\S*:", note["text"])[0]) for note in notes],
                         [("note", "masses[1]:"), ("note", "masses:")])
        self.assertEqual([note["node"] for note in notes], [32, 32])  # at 400 of 500 m in 40 elements

    def test_a_case_that_is_refused_reports_why(self):
        write(self.folder, "case.yaml", CASE.replace("elements: 40", "elements: -4"))
        with self.assertRaisesRegex(Refusal, "case.yaml:6: .*elements"):
            start_shape.notes_of(self.folder / "case.yaml")

    def test_the_command_prints_its_address_and_ends_by_ctrl_c(self):
        env = {**os.environ, "PYTHONPATH": str(ROOT / "scripts"), "PYTHONUNBUFFERED": "1"}
        run_of(self.folder / "run.h5", 3)
        with subprocess.Popen([sys.executable, "-B", "-m", "hawser_post", "view", str(self.folder / "run.h5"), "--no-browser"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=env,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as process:  # ignored in the background
            self.addCleanup(process.kill)
            self.assertEqual([process.stdout.readline().split(":")[0] for _ in range(2)], ["view", "shown"])
            address = urlsplit(process.stdout.readline().strip())
            self.assertEqual(address.hostname, "127.0.0.1")
            connection = http.client.HTTPConnection(address.hostname, address.port, timeout=20)
            connection.request("GET", address.path + "status")
            self.assertEqual(json.loads(connection.getresponse().read())["outputs"], 3)
            connection.close()
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=20)
        self.assertEqual((process.returncode, err, "ended" in out), (0, "", True))


if __name__ == "__main__":
    unittest.main()

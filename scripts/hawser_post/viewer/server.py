"""Local read-only server on 127.0.0.1 that delivers only the viewer's requests."""
import hmac
import secrets
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import unquote, urlsplit

from ..results import Refusal
from . import embedded, libraries

ADDRESS = "127.0.0.1"
MOST_AT_A_TIME = 32  # simultaneous requests
PATIENCE = 20  # s, timeout for requests of a browser
HEADERS = {
    "X-Content-Type-Options": "nosniff", "Cross-Origin-Resource-Policy": "same-origin", "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store", "X-Frame-Options": "DENY",
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
                               "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
}
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>hawser view</title>
<link rel="icon" href="data:,"><link rel="stylesheet" href="dygraph.css"><link rel="stylesheet" href="view.css"></head>
<body class="served"><main class="hawser-view" id="model" data-base="./">Reading the model ...</main>
<script src="three.js"></script><script src="controls.js"></script><script src="dygraph.js"></script><script src="viewer.js"></script>
</body></html>
"""


def files():
    """Static files: type and bytes by name."""
    script, style = "text/javascript; charset=utf-8", "text/css; charset=utf-8"
    found = {"": ("text/html; charset=utf-8", PAGE), "three.js": (script, libraries.text(libraries.THREE)),
             "controls.js": (script, libraries.text(libraries.CONTROLS)), "dygraph.js": (script, libraries.text(libraries.GRAPHS)),
             "viewer.js": (script, libraries.own()), "dygraph.css": (style, libraries.text(libraries.GRAPHS_STYLE)),
             "view.css": (style, (libraries.PAGE / "view.css").read_text(encoding="utf-8")),
             "licences": ("text/plain; charset=utf-8", libraries.notices())}
    return {name: (kind, text.encode()) for name, (kind, text) in found.items()}


class Handler(BaseHTTPRequestHandler):
    timeout = PATIENCE
    server_version, sys_version = "hawser", ""

    def do_GET(self):  # noqa: N802
        self.answer(True)

    def do_HEAD(self):  # noqa: N802
        self.answer(False)

    def answer(self, body):
        with self.server.places:
            try:
                code, kind, data = self.found()
            except (Refusal, OSError, KeyError, ValueError, RuntimeError, IndexError, TypeError) as error:
                # The file is damaged, was truncated or is being written.
                words = str(error).splitlines()[0] if str(error) else type(error).__name__
                code, kind, data = 503, "text/plain; charset=utf-8", f"the results cannot be read now ({words})".encode()
            self.send_response(code)
            for name, value in {**HEADERS, "Content-Type": kind, "Content-Length": str(len(data))}.items():
                self.send_header(name, value)
            self.end_headers()
            if body:
                self.wfile.write(data)

    def found(self):
        """Status code, type and bytes of the response."""
        plain, port = "text/plain; charset=utf-8", self.server.server_port
        if self.headers.get("Host", "") not in (f"{ADDRESS}:{port}", f"localhost:{port}"):
            return 403, plain, b"this server answers to 127.0.0.1 and localhost only"
        parts = urlsplit(self.path).path.split("/")
        if len(parts) < 3 or parts[0] or not hmac.compare_digest(parts[1].encode(), self.server.key.encode()):
            return 404, plain, b"this address is incomplete; use the whole address that hawser view has printed"
        name = "/".join(unquote(part) for part in parts[2:])
        if name in self.server.files:
            return 200, *self.server.files[name]
        if name in ("header", "status"):
            answer = getattr(self.server.shown, name)()
            return 200, "application/json", embedded.json_of(answer).encode()
        block = self.server.shown.block(name[len("block/"):]) if name.startswith("block/") else None
        return (404, plain, b"there is no file of this name") if block is None else (200, "application/octet-stream", block)

    def log_message(self, *_):
        pass


class Server(ThreadingHTTPServer):
    daemon_threads, request_queue_size = True, 256

    def __init__(self, shown, port=0):
        self.shown, self.files, self.key = shown, files(), secrets.token_urlsafe(12)
        self.places = threading.BoundedSemaphore(MOST_AT_A_TIME)
        super().__init__((ADDRESS, port), Handler)

    @property
    def address(self):
        return f"http://{ADDRESS}:{self.server_port}/{self.key}/"

    def handle_error(self, request, client_address):
        pass  # the browser has disconnected

"""hawser view: model of a case or of results in the browser."""
import webbrowser

from ..arguments import unwind_at_interrupts
from ..results import Refusal
from . import libraries
from .served import Shown
from .server import Server


def make(options):
    show(options.results, options.changes, options.port, not options.no_browser)


def show(path, changes=(), port=0, browser=True):
    """Serves until Ctrl-C."""
    if libraries.missing():
        raise Refusal(libraries.missing().rstrip("."))
    unwind_at_interrupts()
    shown = Shown(path, changes)
    try:
        server = Server(shown, port)
    except OSError as error:
        raise Refusal(f"port {port} of this machine cannot be used ({error.strerror})") from error
    what = {"run": f"{shown.path}", "start": f"the start shape of {shown.case}"}[shown.kind]
    print(f"shown: {what}\n{server.address}\nCtrl-C ends it", flush=True)
    if browser:
        webbrowser.open(server.address)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print("\nview: ended")
    finally:
        server.server_close()
        shown.close()

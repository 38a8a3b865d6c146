"""Ctrl-C at a moment that a test chooses."""

import os
import signal
import threading
import time

PATIENCE = 5.0  # [s] a test hangs; on an idle machine the exception comes in 0.1 s


class Alarm:
    """Sends SIGINT to this process, from another thread, when the run first tells its progress."""

    def __enter__(self):
        self.begun = threading.Event()
        self.thread = threading.Thread(target=self.send)
        self.thread.start()
        return self

    def send(self):
        self.begun.wait(60)
        time.sleep(0.01)  # until the engine computes again
        self.sent = time.monotonic()
        os.kill(os.getpid(), signal.SIGINT)

    def tell(self, _=None):
        self.begun.set()

    def never_returns(self, _=None):
        """An observable or a force for the run, which is to be interrupted in it."""
        time.sleep(0.2)  # in its first moments a function would be called again
        self.tell()
        end = time.monotonic() + 4 * PATIENCE
        while time.monotonic() < end:
            pass
        raise TimeoutError("nobody has interrupted this")

    def __exit__(self, kind, error, trace):
        self.late = time.monotonic() - self.sent
        self.thread.join()
        self.note = "".join(getattr(error, "__notes__", []))
        return kind is KeyboardInterrupt

"""Ctrl-C at a moment that a test chooses."""

import os
import signal
import threading
import time

PATIENCE = 5.0  # [s] a test hangs; on an idle machine the exception comes in 0.1 s


class Alarm:
    """Sends SIGINT to this process, from another thread, when the run first tells its progress."""

    def __enter__(self):
        self.begun, self.over = threading.Event(), False
        self.thread = threading.Thread(target=self.send)
        self.thread.start()
        return self

    def send(self):
        self.begun.wait()
        if self.over:
            return
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
        if not self.begun.is_set():
            self.over = True
            self.begun.set()
            self.thread.join()
            if kind is None:
                raise AssertionError("the run has ended before it told its progress")
            return False  # what it was ended by is what went wrong
        self.thread.join()
        self.late = time.monotonic() - self.sent
        self.note = "".join(getattr(error, "__notes__", []))
        return kind is KeyboardInterrupt

"""Ctrl-C at a moment that a test chooses."""

import os
import pathlib
import select
import signal
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import waiting  # noqa: E402

FIRST_MOMENTS = 0.1  # [s] interrupted in them, a function is called again; src/python/attention.hpp


def is_within(thread, function):
    """Whether a thread is in a call of a function."""
    frame = sys._current_frames()[thread.ident]
    while frame is not None and frame.f_code is not function.__code__:
        frame = frame.f_back
    return frame is not None


def a_while():
    """Long enough that a signal is likely to come meanwhile; nothing depends on it."""
    end = time.monotonic() + 0.004
    while time.monotonic() < end:
        pass


class Other:
    """Another thread, which counts. Python itself never takes the interpreter away from one thread for it."""

    def __enter__(self):
        self.count, self.over, self.interval = 0, False, sys.getswitchinterval()
        sys.setswitchinterval(3600.0)
        self.thread = threading.Thread(target=self.run)
        self.thread.start()
        return self

    def run(self):
        while not self.over:
            self.count += 1
            if self.count % 1000 == 0:
                time.sleep(0)  # lets the others on

    def goes_on_during(self, work):
        """Call a function until the other has gone on meanwhile, which it does only where the interpreter is let go."""
        def has_gone_on():
            before = self.count
            work()
            return self.count > before
        waiting.until(has_gone_on, "another thread goes on meanwhile")

    def __exit__(self, *_):
        self.over = True
        self.thread.join()
        sys.setswitchinterval(self.interval)


class Alarm:
    """Sends a signal to this process, from another thread, when the run first tells its progress."""

    def __init__(self, number=signal.SIGINT):
        self.number = number

    def __enter__(self):
        self.begun, self.over = threading.Event(), False
        self.thread = threading.Thread(target=self.send)
        self.thread.start()
        return self

    def send(self):
        self.begun.wait()
        if self.over:
            return
        waiting.until(lambda: not is_within(threading.main_thread(), Alarm.tell), "the engine computes again")
        os.kill(os.getpid(), self.number)

    def tell(self, _=None):
        self.begun.set()

    def never_returns(self, _=None):
        """An observable or a force for the run, which is to be interrupted in it."""
        time.sleep(2 * FIRST_MOMENTS)
        read, write = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
        before = signal.set_wakeup_fd(write)  # so that a signal is not missed that comes before the call that waits for it
        try:
            self.tell()
            select.select([read], [], [], waiting.PATIENCE)
            raise TimeoutError("nobody has interrupted this")
        finally:
            signal.set_wakeup_fd(before)
            os.close(read)
            os.close(write)

    def __exit__(self, kind, error, trace):
        if not self.begun.is_set():
            self.over = True
            self.begun.set()
            self.thread.join()
            if kind is None:
                raise AssertionError("the run has ended before it told its progress")
            return False  # what it was ended by is what went wrong
        self.thread.join()
        self.note = "".join(getattr(error, "__notes__", []))
        return kind is KeyboardInterrupt

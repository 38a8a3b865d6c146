"""Where progress is shown, and that nothing of it is left."""

import io
import re
import unittest
import warnings
from unittest import mock

import ljmd
import ljmd._progress
from alarm import waiting
from cases import Case, small_deck

try:
    import ipykernel  # noqa: F401
    import nbclient
    import nbformat
except ImportError:
    nbclient = None

AT_ONCE = mock.patch.object(ljmd._progress, "_PAUSE", 0.0)


class Screen(io.StringIO):
    """A terminal of one line."""

    def isatty(self) -> bool:
        return True

    def seen(self) -> str:
        line = ""
        for part in self.getvalue().split("\r"):
            line = part + line[len(part):]
        return line.rstrip()


class Shown(Case):
    def test_a_terminal_has_one_line_that_is_cleared(self):
        with AT_ONCE, mock.patch("sys.stderr", Screen()) as screen:
            with ljmd._progress.shown(True, 1000, 200) as tell:
                tell(200)
                self.assertRegex(screen.seen(), r"^ 20 %  step 200/1000  0 steps/s$")
                tell(600)
                self.assertRegex(screen.seen(), r"^ 60 %  step 600/1000  \S+ steps/s  \d+ s left$")
            self.assertEqual(screen.seen(), "")
            self.assertNotIn("\n", screen.getvalue())

    def test_elsewhere_nothing_is_written(self):
        with AT_ONCE, mock.patch("sys.stderr", io.StringIO()) as log:
            with ljmd._progress.shown(True, 1000) as tell:
                self.assertIsNone(tell)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", ljmd.RunWarning)
                small_deck().run()
            self.assertEqual(log.getvalue(), "")

    def test_what_is_over_soon_shows_nothing(self):
        with mock.patch.object(ljmd._progress, "_PAUSE", 1e9), mock.patch("sys.stderr", Screen()) as screen:
            with ljmd._progress.shown(True, 1000) as tell:
                tell(500)
            self.assertEqual(screen.getvalue(), "")

    def test_a_function_of_the_users_is_called(self):
        told = []
        with ljmd._progress.shown(told.append, 10) as tell:
            tell(3)
        self.assertEqual(told, [3])

    def test_a_notebook_has_no_empty_box(self):
        self.needs(nbclient, "nbclient with ipykernel")
        source = """
            import warnings
            import ljmd
            import ljmd._progress
            warnings.simplefilter("ignore", ljmd.RunWarning)
            ljmd._progress._PAUSE = 0.0
            deck = ljmd.Deck.fluid(atoms=108, cutoff=2.0)
            deck.stages = [ljmd.Stage("production", 5, sample=True)]
            deck.run(progress=True)
            with ljmd._progress.shown(True, 1000) as tell:
                tell(400)
                tell(500)
            """
        cell = nbformat.v4.new_code_cell(re.sub(r"^ {12}", "", source, flags=re.M))
        kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3"}}
        seen = []
        client = nbclient.NotebookClient(nbformat.v4.new_notebook(cells=[cell], metadata=kernel), timeout=waiting.PATIENCE,
                                         resources={"metadata": {"path": str(self.folder)}})
        update = client.process_message

        def process(message, *arguments):
            if message["msg_type"] in ("display_data", "update_display_data"):
                seen.append(message["content"]["data"]["text/plain"])
            return update(message, *arguments)

        with mock.patch.object(client, "process_message", process):
            client.execute()
        self.assertEqual([each for each in cell.outputs if each.output_type == "stream"], [])
        self.assertRegex(seen[0], "^ 40 %  step 400/1000")
        self.assertRegex(seen[1], "^ 50 %  step 500/1000")
        self.assertEqual(seen[2:], [""])


if __name__ == "__main__":
    unittest.main()

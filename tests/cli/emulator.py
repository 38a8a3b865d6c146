"""A terminal as far as ljmd uses one: what a person would see of the bytes that a program has written to it."""

import re
import unicodedata

TOKEN = re.compile(r"\x1b\[(\??\d*)([A-Za-z])|(.)", re.S)


def columns_of(character):
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


class Row:
    def __init__(self):
        self.cells = []  # characters; the second cell of a wide one is ""
        self.goes_on = False  # in the next row: the terminal has wrapped the line


class Terminal:
    """@param reflows  made narrower, it wraps its lines anew, as VTE, kitty and tmux do; else it cuts them off, as xterm"""

    def __init__(self, columns, rows=24, reflows=False):
        self.columns, self.rows, self.reflows = columns, rows, reflows
        self.lines = [Row()]  # those that have scrolled away, too
        self.row = self.column = 0
        self.wraps = True
        self.rest = ""

    def feed(self, text):
        text, self.rest = self.rest + text, ""
        cut = re.search(r"\x1b(\[[?\d]*)?$", text)
        if cut:
            text, self.rest = text[:cut.start()], text[cut.start():]
        for number, command, character in TOKEN.findall(text):
            if character:
                self.put(character)
            else:
                self.obey(number, command)

    def obey(self, number, command):
        cells = self.lines[self.row].cells
        if command in "hl" and number == "?7":
            self.wraps = command == "h"
        elif command in "JK" and number in ("", "0"):
            del cells[self.column:]
            self.lines[self.row].goes_on = False
            if command == "J":
                del self.lines[self.row + 1:]
        else:
            raise AssertionError(f"this terminal does not know ESC [ {number} {command}")

    def put(self, character):
        if character == "\r":
            self.column = 0
        elif character == "\n":
            self.next_row()
        elif character >= " ":
            self.write(character)
        else:
            raise AssertionError(f"this terminal does not know {character!r}")

    def write(self, character):
        wide = columns_of(character)
        if self.column + wide > self.columns:
            if self.wraps:
                self.lines[self.row].goes_on = True
                self.next_row()
                self.column = 0
            else:
                self.column = self.columns - wide
        cells = self.lines[self.row].cells
        cells.extend(" " * (self.column - len(cells)))
        cells[self.column:self.column + wide] = [character] + [""] * (wide - 1)
        self.column += wide

    def next_row(self):
        self.row += 1
        if self.row == len(self.lines):
            self.lines.append(Row())

    def resize(self, columns):
        if not self.reflows:
            for line in self.lines:
                del line.cells[columns:]
        else:
            self.reflow(columns)
        self.columns = columns
        self.column = min(self.column, columns)

    def reflow(self, columns):
        whole, place = [[]], None
        for number, line in enumerate(self.lines):
            if number == self.row:
                place = (len(whole) - 1, len(whole[-1]) + self.column)
            whole[-1] += line.cells
            if not line.goes_on and number + 1 < len(self.lines):
                whole.append([])
        self.lines = []
        for number, cells in enumerate(whole):
            first = len(self.lines)
            for start in range(0, max(len(cells), 1), columns):
                row = Row()
                row.cells, row.goes_on = cells[start:start + columns], start + columns < len(cells)
                self.lines.append(row)
            if number == place[0]:
                self.row, self.column = first + place[1] // columns, place[1] % columns
                while self.row >= len(self.lines):
                    self.lines.append(Row())

    def text(self):
        """All lines, also those that have scrolled away; a wrapped line is one. Without blanks at ends of lines."""
        lines, open_line = [], ""
        for line in self.lines:
            open_line += "".join(line.cells)
            if not line.goes_on:
                lines.append(open_line.rstrip())
                open_line = ""
        return "\n".join(lines + [open_line] * bool(open_line)).rstrip("\n") + "\n"

    def rows_shown(self):
        return ["".join(line.cells).rstrip() for line in self.lines[-self.rows:]]

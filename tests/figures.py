"""Figures that a test in Python holds against what they ought to be: a line for each, and how many passed."""

passed = 0
failed = 0


def check(name: str, value: float, expected: float, tolerance: float) -> None:
    """The value must lie within the tolerance of what is expected."""
    global passed, failed
    good = abs(value - expected) <= tolerance
    print(f"{'ok  ' if good else 'FAIL'} {name}: {value:.7g}, expected {expected:.7g} +- {tolerance:.3g}")
    passed += good
    failed += not good


def exit_code() -> int:
    """Print the count; 1 if any figure was off."""
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0

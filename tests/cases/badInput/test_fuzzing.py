"""A fixed sample of what tests/fuzzing/fuzz makes without end."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2]/"fuzzing"))

import fuzzing  # noqa: E402

COUNT = 200


def test_mistakes_end_in_a_message(tmp_path):
    fuzzing.make_bases(tmp_path)

    wrong = []
    for number in range(COUNT):
        base, done, fault = fuzzing.run(tmp_path, 1, number)
        if fault:
            wrong.append(f"{number} {base} {done}: {fault}")

    assert not wrong, "\n".join(wrong)


def test_the_bases_are_right(tmp_path):
    """Or nothing would be learnt from mistakes in them."""
    fuzzing.make_bases(tmp_path)

    for base in fuzzing.BASES:
        assert fuzzing.solve(tmp_path/base) == "", base

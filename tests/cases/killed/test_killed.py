"""Killed while it writes, the solver goes on from a whole state, or says what
to remove; tests/killTest tries every operation."""

import killing
import pytest


@pytest.fixture(scope="module", name="library")
def fixture_library(tmp_path_factory):
    return killing.compiled(tmp_path_factory.mktemp("library"))


@pytest.mark.parametrize("ranks, count", [(1, 5), (2, 2)])
def test_goes_on_or_says_what_to_remove(tmp_path, library, ranks, count):
    whole, second, numbers = killing.reference(
        tmp_path/"reference", ranks, library
    )
    base = killing.prepare(tmp_path/"base", ranks)
    rank = ranks - 1
    kill = {"KILL_IN": f"/{second}"}
    if ranks > 1:
        kill["KILL_RANK"] = str(rank)

    seen = []
    for at in killing.points(numbers[rank], count):
        case = killing.unkilled(base, tmp_path/f"at{at}")
        seen.append(killing.check(
            case, ranks, library, whole, KILL_AT=str(at), KILL_HALF="1", **kill
        ))
    print(f"{numbers} operations; killed at some: {seen}")
    assert "removed" in seen

"""The tests end: a test that hangs is ended and named, and Ctrl-C arrives wherever they are started."""

import os
import subprocess
import sys

import pytest
from conftest import ROOT

HANGS = """
import threading

def test_that_hangs():
    threading.Event().wait()
"""

CTRL_C_ARRIVES = """
import os, signal, time
import pytest

def test_ctrl_c():
    with pytest.raises(KeyboardInterrupt):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(1)
"""

# As a script does with processes that it starts in the background.
IGNORING = ["sh", "-c", 'trap "" INT; exec "$@"', "sh"]


def pytest_on(folder, code, *options, before=()):
    (folder / "test_it.py").write_text(code)
    command = [*before, sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options, "test_it.py"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "python/tests")}
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)


def test_a_test_that_hangs_is_ended_and_named(tmp_path):
    run = pytest_on(tmp_path, HANGS, "--timeout=1", "--timeout-method=thread")
    assert run.returncode != 0 and "in test_that_hangs" in run.stdout + run.stderr


def test_a_test_that_hangs_shows_where_on_several_processes_too(tmp_path):
    run = pytest_on(tmp_path, HANGS, "-n1", "--timeout=4", "--timeout-method=thread", "-o", "faulthandler_timeout=2")
    assert run.returncode != 0 and "test_that_hangs" in run.stdout and "in test_that_hangs" in run.stderr


def test_every_test_has_a_limit(request):
    assert float(request.config.getini("faulthandler_timeout")) < 300
    assert float(request.config.getini("timeout")) == 300 and request.config.getini("timeout_method") == "thread"


@pytest.mark.skipif(os.name != "posix", reason="no POSIX shell")
def test_ctrl_c_arrives_in_the_background_of_a_script(tmp_path):
    run = pytest_on(tmp_path, CTRL_C_ARRIVES, "-p", "conftest", before=IGNORING)
    assert run.returncode == 0, run.stdout + run.stderr
    without = pytest_on(tmp_path, CTRL_C_ARRIVES, before=IGNORING)
    assert without.returncode != 0  # otherwise this would test nothing

"""What is said of tests that failed."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import run_tests

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(three NONE)
enable_testing()
add_test(NAME good COMMAND ${CMAKE_COMMAND} -E echo fine)
add_test(NAME bad COMMAND sh -c "echo 'a < b & c'; exit 3")
add_test(NAME long COMMAND sh -c "seq 5000; exit 1")
add_test(NAME cases COMMAND sh -c "cat cases.txt; exit 1")
"""

# As a program of GoogleTest's writes it, which is stopped in its fourth case.
CASES = """[==========] Running 4 tests from 2 test suites.
[ RUN      ] Sum.IsRight
[       OK ] Sum.IsRight (0 ms)
[ RUN      ] Sum.IsLarge
sum_test.cpp:7: Failure
[  FAILED  ] Sum.IsLarge, where GetParam() = 3 (1 ms)
[ RUN      ] Sum.OnADevice
no device
[  SKIPPED ] Sum.OnADevice (0 ms)
[ RUN      ] Ball.IsRound
stack smashed
"""


class Failures(unittest.TestCase):
    def test_those_that_failed_with_the_end_of_their_output(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "CMakeLists.txt").write_text(PROJECT, encoding="utf-8")
            (pathlib.Path(folder) / "cases.txt").write_text(CASES, encoding="utf-8")
            subprocess.run(["cmake", "-S", folder, "-B", folder], check=True, stdout=subprocess.DEVNULL)
            report = pathlib.Path(folder) / "report.xml"
            subprocess.run(["ctest", "--test-dir", folder, "--output-junit", report], check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            failed = dict(run_tests.failures(report))
            skipped = list(run_tests.skipped_cases(report))
            passed = run_tests.passed_tests(report)
        self.assertEqual(set(failed), {"bad", "long", "cases: Sum.IsLarge", "cases: Ball.IsRound"})
        self.assertEqual(failed["cases: Sum.IsLarge"],
                         "sum_test.cpp:7: Failure\n[  FAILED  ] Sum.IsLarge, where GetParam() = 3 (1 ms)")
        self.assertEqual(failed["cases: Ball.IsRound"], "stack smashed\n(it never ended)")
        self.assertEqual(skipped, ["Sum.OnADevice"])
        self.assertEqual(passed, {"good"})
        self.assertEqual(failed["bad"], "a < b & c")
        self.assertTrue(failed["long"].endswith("\n5000"))
        self.assertEqual(len(failed["long"]), run_tests.LONGEST_OUTPUT)


if __name__ == "__main__":
    unittest.main()

"""Runs tests that are plain functions with assertions."""


def run_all(names):
    """Runs the functions whose names begin with test_ among a module's names, and prints what
    fails and what the others return.
    @return the exit code"""
    tests = {name: test for name, test in names.items() if name.startswith("test_")}
    assert tests, "no test"
    failed, said = 0, []
    for name, test in tests.items():
        try:
            said.append(test())
        except AssertionError as error:
            failed += 1
            print(f"{name}: {error or 'failed'}")
    print(", ".join([f"{len(tests) - failed} passed", f"{failed} failed", *filter(None, said)]))
    return 1 if failed else 0

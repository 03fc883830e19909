"""The course for students (sphinx -t student): its pages do not name the solutions."""

from student import without_solutions


def leave_out(app, docname, source):
    if app.tags.has("student"):
        source[0] = without_solutions(source[0])


def setup(app):
    app.connect("source-read", leave_out)
    return {"parallel_read_safe": True}

# Run by ./cs550 lab N --debug: leads to where the test fails, in the student's code or the test's.
set pagination off
set confirm off
catch throw
run
python
if gdb.selected_inferior().pid:  # else it has ended by itself
    frame = gdb.newest_frame()
    while frame and not str(frame.find_sal().symtab).startswith(("labs/", "tests/lab")):
        frame = frame.older()
    if frame:
        frame.select()
    gdb.execute("frame")
end

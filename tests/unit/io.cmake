# Sources of the tests of io/, relative to tests/; they need TRICONTACT_SOURCE_DIR.
set(TRICONTACT_IO_TESTS
    unit/io_atomic_file.cc
    unit/io_bad_cases.cc
    unit/io_case_reader.cc
    unit/io_case_writer.cc
    unit/io_disguise.cc
    unit/io_history_csv.cc
    unit/io_messages.cc
    unit/io_progress.cc
    unit/io_units.cc
    unit/io_vtk_series.cc)

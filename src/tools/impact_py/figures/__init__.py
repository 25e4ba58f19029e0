"""The figures of the report, from the CSV files of `reproduce`, `work_precision` and
`accuracy_check`."""

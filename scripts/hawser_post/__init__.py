"""What is made of a results file of hawser: figures, CSV files and a report. `python3 -m hawser_post --help`."""

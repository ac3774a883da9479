"""Figures, CSV files and reports from a results file of hawser. `python3 -m hawser_post --help`."""

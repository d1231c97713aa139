"""Reading the program's CSV files."""
import csv
import math


def read_rows(path):
    """The rows as dictionaries of text."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def number(text):
    """The number in a cell; NaN for an empty one."""
    return float(text) if text else math.nan


def column(rows, name):
    return [number(row[name]) for row in rows]

"""What doc/results keeps of a study: label, cost and results of each run, or the sentence of a failed one, without the places where the runs lie.

  python3 inputs/studies/keep_results.py runs/extremes/results.csv spheroid/extremes.csv          (into doc/results)
"""
import argparse
import csv

from runs import table_row, write_table


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", help="the results.csv of a study")
    parser.add_argument("table", help="the table to write, below doc/results")
    chosen = parser.parse_args()
    with open(chosen.results, newline="", encoding="utf-8") as file:
        write_table(chosen.table, [table_row(row) for row in csv.DictReader(file)])


if __name__ == "__main__":
    main()

"""The reader: a small strict grammar for printed formulas over declared symbols.

Whatever it does not know is a `ReaderError` with line, column and caret, never a guess.
"""

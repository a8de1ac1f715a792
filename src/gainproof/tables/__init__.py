"""Tables that users hand in as CSV files, with units in their headers."""

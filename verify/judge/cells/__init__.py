"""Statements with several real parameters: open cells, and the borders between them."""

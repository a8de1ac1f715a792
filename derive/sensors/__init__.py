"""What sensors measure, and what becomes of it in other coordinates."""

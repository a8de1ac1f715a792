"""Claims about matrices of every size: letters with shapes, decided by words and squares."""

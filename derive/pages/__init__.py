"""Pages as text: one file a derivation, and the grammar in which they are written."""

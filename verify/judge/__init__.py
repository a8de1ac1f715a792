"""The judge: reads a published formula and says whether it holds, with evidence."""
